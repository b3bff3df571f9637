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

/// A height between two others, h = (1 - α) h₋ + α h₊, whichever of them is the higher.
#[inline]
pub const fn between(a: i32, b: i32, alpha: i32) -> i32 {
    let (low, high) = ordered(a, b);
    mix(low, high, alpha)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::amplify::fixed::GRAINS;

    const UNIT: f64 = 65_536.0;

    fn shares() -> impl Iterator<Item = (i32, f64)> {
        (0..=Q16).step_by(41).map(|x| (x, f64::from(x) / UNIT))
    }

    fn close(got: i32, want: f64, tolerance: f64) {
        assert!((f64::from(got) - want).abs() <= tolerance, "{got} {want}");
    }

    #[test]
    fn alphas_are_the_closed_forms() {
        for level in 0..17 {
            let delta = scale_dependency(level);
            let d = 1.0 - 0.4 * f64::from(level.min(10)) / 10.0;
            close(delta, d * UNIT, 0.51);
            for (xi, x) in shares() {
                close(
                    young(Form::Paper, delta, xi),
                    (0.5 + d / 2.0 * (x * x.sqrt() - 1.0)) * UNIT,
                    3.0,
                );
                close(
                    young(Form::Release, delta, xi),
                    (0.5 - 0.5 * d + d * x * x.sqrt()) * UNIT,
                    4.0,
                );
                close(old_dry(delta, xi), (0.5 + 0.4 * d * (x - 1.0)) * UNIT, 2.0);
                close(old_wet(delta, xi), (1.0 + 0.6 * d * (x - 1.0)) * UNIT, 2.0);
            }
        }
    }

    #[test]
    fn alphas_stay_between_the_parents() {
        for level in 0..17 {
            let delta = scale_dependency(level);
            for (xi, _) in shares() {
                for alpha in [
                    young(Form::Paper, delta, xi),
                    young(Form::Release, delta, xi),
                    old_dry(delta, xi),
                    old_wet(delta, xi),
                ] {
                    assert!((-1..=Q16 + 1).contains(&alpha), "{alpha}");
                    let height = between(3_000_000, -500_000, alpha.clamp(0, Q16));
                    assert!((-500_000..=3_000_000).contains(&height));
                }
            }
        }
    }

    #[test]
    fn peaks_are_the_closed_forms() {
        let crust = 6_000 * GRAINS;
        // A share of 2⁻¹⁶ is 94 grains of 6 km.
        for (xi, x) in shares() {
            close(peak_young(xi, crust), x * x * f64::from(crust), 95.0);
            close(peak_old_dry(xi, crust), x * f64::from(crust), 1.0);
            close(
                peak_old_wet(xi, crust),
                (1.0 - x * x) * f64::from(crust),
                95.0,
            );
        }
    }

    #[test]
    fn terraces_rise_in_steps() {
        let step = TERRACE_STEP;
        let mut last = i32::MIN;
        for height in (-3 * step..=3 * step).step_by(101) {
            let got = terrace(height, step);
            let beta = f64::from(height.rem_euclid(step)) / f64::from(step);
            let tread = f64::from(height.div_euclid(step)) * f64::from(step);
            close(
                got,
                tread + beta * beta * (3.0 - 2.0 * beta) * f64::from(step),
                60.0,
            );
            assert!(got + 40 >= last, "monotone but for rounding");
            last = got;
        }
        assert_eq!(terrace(2 * step, step), 2 * step);
        assert_eq!(terrace(-step, step), -step);
    }

    #[test]
    fn hills_are_capped_and_scale_with_presence() {
        for (xi, x) in shares() {
            for length in [400 * GRAINS, 26_000 * GRAINS] {
                let up = hill(Form::Paper, xi, Q16, length, Q16);
                close(
                    up,
                    (f64::from(length) * (1.0 - x * x) / 2.0).min(f64::from(HILL_LIMIT)),
                    410.0,
                );
                let down = hill(Form::Paper, xi, 0, length, Q16 / 2);
                close(down, -f64::from(length) * (1.0 - x * x) / 12.0, 410.0);
                assert_eq!(hill(Form::Release, xi, 0, length, 0), 0);
            }
        }
    }

    #[test]
    fn plateaus_flatten() {
        assert_eq!(plateau(5_000, 1_000, 0), 5_000);
        close(
            plateau(500_000, 100_000, Q16),
            500_000.0 - 0.88 * 400_000.0,
            7.0,
        );
    }

    #[test]
    fn bits_are_pinned() {
        assert_eq!(scale_dependency(3), 57_672);
        assert_eq!(young(Form::Release, 57_672, 40_000), 31_432);
        assert_eq!(old_wet(57_672, 12_345), 37_451);
        assert_eq!(terrace(1_000_000, TERRACE_STEP), 964_031);
    }
}
