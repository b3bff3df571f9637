//! Fixed-point numbers of the ground. Products are taken in 64 bits; the twin in WGSL, which has 32,
//! builds the same bits from halves.
//!
//! Directions are in units of 1 / [`ONE`] of the radius (3.1 mm on Earth), heights and lengths in
//! grains of 1 / [`GRAINS`] m (range ±2097 km), shares in Q16 (65,536 is 1).

/// A direction component of 1: 1.9 · 2³⁰, so that sums of differences stay within an i32.
pub const ONE: i32 = 2_040_109_465;

/// Grains in a metre.
pub const GRAINS: i32 = 1024;

/// 1 in Q16.
pub const Q16: i32 = 1 << 16;

/// A real number in Q16, rounded to the nearest. For constants: results of rules are integers only.
///
/// ```
/// use pangaea_shaders::amplify::fixed::{Q16, q16};
///
/// assert_eq!(q16(1.0), Q16);
/// assert_eq!(q16(0.9), 58_982);
/// ```
pub const fn q16(real: f64) -> i32 {
    (real * Q16 as f64).round() as i32
}

/// Tangent of an angle below 45° in Q16, rounded to the nearest. For constants.
///
/// ```
/// assert_eq!(pangaea_shaders::amplify::fixed::tan_deg(20.0), 23_853);
/// ```
pub const fn tan_deg(degrees: f64) -> i32 {
    let x = degrees * (core::f64::consts::PI / 180.0);
    let mut sin = 0.0;
    let mut cos = 0.0;
    // The series of both: terms xⁿ/n! of four signs and kinds in turn.
    let mut term = 1.0;
    let mut n = 0;
    while n < 20 {
        match n % 4 {
            0 => cos += term,
            1 => sin += term,
            2 => cos -= term,
            _ => sin -= term,
        }
        n += 1;
        term *= x / n as f64;
    }
    q16(sin / cos)
}

/// A length in metres as grains, at most 2097 km.
pub const fn metres(metres: i32) -> i32 {
    metres * GRAINS
}

/// An age in millions of years in the unit of ages, 1/64 My.
pub const fn million_years(age: i32) -> i32 {
    age * 64
}

/// High word of the product of two 32-bit numbers, exact.
#[inline]
pub const fn mul_high(a: u32, b: u32) -> u32 {
    ((a as u64 * b as u64) >> 32) as u32
}

/// ⌊a·b / 2^shift⌋ for 1 <= shift <= 31, saturated at 2³¹ - 1.
#[inline]
pub const fn mul_shift(a: u32, b: u32, shift: u32) -> i32 {
    let wide = (a as u64 * b as u64) >> shift;
    if wide > i32::MAX as u64 {
        i32::MAX
    } else {
        wide as i32
    }
}

/// The product w·d of a share w of -2..2 in Q16 and a difference of directions, rounded to the
/// nearest; it must fit an i32.
#[inline]
pub const fn weigh(w: i32, d: i32) -> i32 {
    let wide = (w as i64 * d as i64 + 0x8000) >> 16;
    debug_assert!(wide as i32 as i64 == wide);
    wide as i32
}

/// Difference of two directions, which must be less than 60° apart.
#[inline]
pub const fn difference(to: [i32; 3], from: [i32; 3]) -> [i32; 3] {
    [to[0] - from[0], to[1] - from[1], to[2] - from[2]]
}

/// Fraction of 2³² / [`ONE`] = 2 + 0.10526, in 2⁻³².
const INVERSE_FRACTION: u32 = ((1_u128 << 64) / ONE as u128 - (1_u128 << 33)) as u32;

crate::wgsl::shared!(ONE, GRAINS, Q16, INVERSE_FRACTION);

/// Square of a difference of directions in 2⁻³² of the squared radius: below a quarter.
#[inline]
pub const fn square_q32(d: [i32; 3]) -> u32 {
    let mut sum = 0;
    let mut i = 0;
    while i < 3 {
        let x = d[i].unsigned_abs();
        // x · 2³² / ONE: the component in 2⁻³² of the radius.
        let x = 2 * x + mul_high(x, INVERSE_FRACTION);
        sum += mul_high(x, x);
        i += 1;
    }
    sum
}

/// Point near the sphere -> point on it. `deficit` is 1 - |p|² in 2⁻³²; corrected to its third
/// power; right to 4 units.
#[inline]
pub const fn lift(p: [i32; 3], deficit: u32) -> [i32; 3] {
    if deficit == 0 {
        return p;
    }
    // 1/sqrt(1 - e) - 1 = e/2 + 3e²/8 + 5e³/16. A deficit e is below ¼, so that thrice its square
    // fits 32 bits.
    let second = mul_high(deficit, deficit);
    let third = mul_high(second, deficit);
    let factor = deficit / 2 + second * 3 / 8 + third * 5 / 16;
    let mut out = p;
    let mut i = 0;
    while i < 3 {
        let x = p[i].unsigned_abs();
        // Rounded to the nearest by the highest bit that is lost.
        let low = x.wrapping_mul(factor);
        let step = (mul_high(x, factor) + (low >> 31)) as i32;
        out[i] = if p[i] < 0 { p[i] - step } else { p[i] + step };
        i += 1;
    }
    out
}

#[cfg(test)]
#[path = "fixed_tests.rs"]
mod tests;
