//! The procedural nodes of the compute graphs: mountains young and old, peaks, terraces, hills,
//! plateaus.
//!
//! Source: paper 002 Appendix A; the released source differs for young mountains and hills, see
//! [`Form`]. ξ and χ are uniform in 0..1 (Q16), h in grains. A node never panics and never leaves
//! 32 bits for heights within ±100 km.

use crate::amplify::arith::{mix, mul_q16, ordered, pow_1_5, ratio, saturate, smooth, square};
use crate::amplify::fixed::{Q16, metres, q16};

/// Source of a node's constants, where print and release differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Form {
    /// As printed: a young mountain's α spans half as much, and lies below the middle.
    Paper,
    /// As released: α of a young mountain spans 0..1 at the coarsest level.
    #[default]
    Release,
}

/// The paper's Δ, Q16: 1 at level 0, 0.6 from level 10 on.
#[inline]
pub const fn scale_dependency(level: u32) -> i32 {
    let level = if level < 10 { level as i32 } else { 10 };
    // 0.4 · 65,536 / 10 per level, rounded to the nearest.
    Q16 - (level * 4 * Q16 + 50) / 100
}

/// α of a young mountain, Q16: ½ + Δ/2 (ξ^1.5 - 1) as printed, ½ + Δ (ξ^1.5 - ½) as released.
#[inline]
pub fn young(form: Form, delta: i32, xi: i32) -> i32 {
    let power = pow_1_5(xi);
    match form {
        Form::Paper => Q16 / 2 + mul_q16(delta, power - Q16) / 2,
        Form::Release => Q16 / 2 + mul_q16(delta, power - Q16 / 2),
    }
}

/// α of an old mountain of a dry land, Q16: ½ + 2Δ/5 (ξ - 1).
#[inline]
pub const fn old_dry(delta: i32, xi: i32) -> i32 {
    Q16 / 2 + mul_q16(2 * delta, xi - Q16) / 5
}

/// α of an old mountain of a wet land, Q16: 1 + 3Δ/5 (ξ - 1).
#[inline]
pub const fn old_wet(delta: i32, xi: i32) -> i32 {
    Q16 + mul_q16(3 * delta, xi - Q16) / 5
}

/// Peak of a young mountain under the crust elevation C: ξ²C.
#[inline]
pub const fn peak_young(xi: i32, crust: i32) -> i32 {
    mul_q16(crust, square(xi))
}

/// Peak of an old mountain of a dry land: ξC.
#[inline]
pub const fn peak_old_dry(xi: i32, crust: i32) -> i32 {
    mul_q16(crust, xi)
}

/// Peak of an old mountain of a wet land: (1 - ξ²)C.
#[inline]
pub const fn peak_old_wet(xi: i32, crust: i32) -> i32 {
    mul_q16(crust, Q16 - square(xi))
}

/// Height of a step of terraced mountains, grains: 700 m.
pub const TERRACE_STEP: i32 = metres(700);

/// Terraces: treads at multiples of `step`, Hermite risers between them. Keeps multiples where they
/// are.
#[inline]
pub const fn terrace(height: i32, step: i32) -> i32 {
    let tread = floor_to(height, step);
    tread + mul_q16(step, smooth(ratio(height - tread, step)))
}

/// The largest multiple of `step` not above a height.
#[inline]
pub const fn floor_to(height: i32, step: i32) -> i32 {
    let down = height % step;
    if down < 0 {
        height - down - step
    } else {
        height - down
    }
}

/// Highest hill, grains: 800 m.
pub const HILL_LIMIT: i32 = metres(800);

/// How far down hills reach, as a share of the edge's length (release).
const HOLLOWS: i32 = q16(0.3);

/// How far a full plateau holds the ground at its base level (paper 002 Appendix A).
const PLATEAU_HOLD: i32 = q16(0.88);

crate::wgsl::shared!(
    FORM_PAPER = Form::Paper as u32,
    TERRACE_STEP,
    HILL_LIMIT,
    HOLLOWS,
    PLATEAU_HOLD,
);

/// Offset of hills: min(800 m, (1 - ξ²)/2 · ε)·B, ε the edge's length, or with χ < ½ a third
/// (printed) or 0.3 (released) of it downwards.
#[inline]
pub const fn hill(form: Form, xi: i32, chi: i32, length: i32, presence: i32) -> i32 {
    let epsilon = match form {
        _ if chi >= Q16 / 2 => length,
        Form::Paper => -(length / 3),
        Form::Release => -mul_q16(length, HOLLOWS),
    };
    let offset = mul_q16(epsilon, Q16 - square(xi)) / 2;
    let bounded = ordered(offset, HILL_LIMIT).0;
    mul_q16(bounded, presence)
}

/// A plateau holds a height at its base level: h' blended towards it by 0.88·P.
#[inline]
pub const fn plateau(height: i32, base: i32, presence: i32) -> i32 {
    mix(height, base, mul_q16(saturate(presence), PLATEAU_HOLD))
}

/// The draw r of a slope: ξ, on plateaus 1 - ξⁿ (release). Most draws of the latter are near 1: the
/// slope keeps its height and breaks off at its drain. `power` is ξⁿ.
#[inline]
pub const fn cliff(xi: i32, power: i32, presence: i32) -> i32 {
    mix(xi, Q16 - power, presence)
}

/// A height between two others, h = (1 - α) h₋ + α h₊, whichever of them is the higher.
#[inline]
pub const fn between(a: i32, b: i32, alpha: i32) -> i32 {
    let (low, high) = ordered(a, b);
    mix(low, high, alpha)
}

#[cfg(test)]
#[path = "nodes_tests.rs"]
mod tests;
