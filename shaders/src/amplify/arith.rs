//! Integer arithmetic of the rules: products, ratios, roots and blends of Q16 shares and of grains.
//!
//! Products are taken in 64 bits, as in [`fixed`](super::fixed); every other operation is one of 32
//! bits. Nothing wraps but hashes: a sum or product beyond 32 bits is a mistake, and debug
//! assertions refuse it.

use super::fixed::{Q16, q16};

/// ⌊a·b / 2¹⁶⌋; it must fit an i32.
#[inline]
pub const fn mul_q16(a: i32, b: i32) -> i32 {
    // The shift rounds down for either sign, as WGSL's does.
    let wide = (a as i64 * b as i64) >> 16;
    debug_assert!(wide as i32 as i64 == wide);
    wide as i32
}

/// a·(1 - t) + b·t for a share t in Q16; exact at both ends, whose difference must fit an i32.
#[inline]
pub const fn mix(a: i32, b: i32, t: i32) -> i32 {
    a + mul_q16(b - a, t)
}

/// Lower and higher of two.
#[inline]
pub const fn ordered(a: i32, b: i32) -> (i32, i32) {
    if a < b { (a, b) } else { (b, a) }
}

/// The number of 0..1 in Q16 that is nearest to t.
#[inline]
pub const fn saturate(t: i32) -> i32 {
    if t < 0 {
        0
    } else if t > Q16 {
        Q16
    } else {
        t
    }
}

/// ⌊a / b⌋ in Q16 for a, b >= 0, saturated to 0..1; 1 where b is 0. Exact for b < 2²⁴, else within
/// 2⁻²² of the share.
#[inline]
pub const fn ratio(a: i32, b: i32) -> i32 {
    if a <= 0 {
        return if b <= 0 { Q16 } else { 0 };
    }
    // Saturation comes first, so that the digits below are true fractions.
    if a >= b {
        return Q16;
    }
    // Two digits of eight bits, so that the remainder never leaves 32 bits.
    // The divisor keeps 24 bits, so that a remainder has room for eight more.
    let bits = 32 - (b as u32).leading_zeros();
    let shift = bits.saturating_sub(24);
    let b = (b as u32) >> shift;
    let first = ((a as u32) >> shift) << 8;
    let second = (first % b) << 8;
    (((first / b) << 8) + second / b) as i32
}

/// A ratio of -1..1 in Q16; `whole` is not negative, and nothing is a part of 0.
#[inline]
pub const fn signed_ratio(part: i32, whole: i32) -> i32 {
    if part == 0 {
        0
    } else if part < 0 {
        -ratio(-part, whole)
    } else {
        ratio(part, whole)
    }
}

/// Where x stands between two edges, 0..1 in Q16, linear. `low` < `high`.
#[inline]
pub const fn linear_step(low: i32, high: i32, x: i32) -> i32 {
    ratio(x - low, high - low)
}

/// 3t² - 2t³ of a share in Q16; monotone, 0 at 0 and 1 at 1.
#[inline]
pub const fn smooth(t: i32) -> i32 {
    let t = saturate(t);
    mul_q16(mul_q16(t, t), 3 * Q16 - 2 * t)
}

/// The cubic Hermite step from 0 at `low` to 1 at `high`, Q16.
#[inline]
pub const fn smoothstep(low: i32, high: i32, x: i32) -> i32 {
    smooth(linear_step(low, high, x))
}

/// The parabola 0.51855 + 0.52601u - 0.03954u² is within 0.5 % of √u, u in 1..4. Its constant is in
/// Q15, as the root, its factors of u and u² in Q16 and Q19.
const ROOT_CONSTANT: u32 = 16_992;
const ROOT_SLOPE: u32 = 34_473;
const ROOT_SQUARE: u32 = 20_730;

/// ⌊√x⌋, exact.
///
/// ```
/// use pangaea_shaders::amplify::arith::isqrt;
///
/// assert_eq!([isqrt(15), isqrt(16), isqrt(u32::MAX)], [3, 4, 65_535]);
/// ```
#[inline]
pub const fn isqrt(x: u32) -> u32 {
    if x == 0 {
        return 0;
    }
    // Shifted by pairs of bits, so that the root has sixteen bits.
    let shift = x.leading_zeros() & !1;
    let y = x << shift;
    // u = y / 2³⁰ in 1..4, in Q14.
    let u = y >> 16;
    let bend = (((u * u) >> 16) * ROOT_SQUARE) >> 16;
    let guess = ROOT_CONSTANT + ((u * ROOT_SLOPE) >> 15) - bend;
    // One step of Newton's never ends below the root, and at most one above: it halves the square
    // of the guess's error, which leaves less than one of 16 bits.
    let mut root = (guess + y / guess) >> 1;
    if root > 0xffff || root * root > y {
        root -= 1;
    }
    root >> (shift / 2)
}

/// √t of a share in Q16, rounded down to a multiple of 2⁻¹⁶.
#[inline]
pub const fn sqrt_q16(t: i32) -> i32 {
    if t >= Q16 {
        return Q16;
    }
    if t <= 0 {
        return 0;
    }
    // √(t / 2¹⁶) in Q16 is √(t · 2¹⁶).
    isqrt((t as u32) << 16) as i32
}

/// t^1.5 of a share in Q16.
#[inline]
pub const fn pow_1_5(t: i32) -> i32 {
    mul_q16(t, sqrt_q16(t))
}

/// t² of a share in Q16.
#[inline]
pub const fn square(t: i32) -> i32 {
    mul_q16(t, t)
}

/// Length of a vector of components below 2³⁰, rounded; relative error below 2⁻¹³.
#[inline]
pub const fn length(x: i32, y: i32, z: i32) -> i32 {
    let [x, y, z] = [x.unsigned_abs(), y.unsigned_abs(), z.unsigned_abs()];
    // Three squares of 15-bit numbers sum to less than 2³².
    let bits = 32 - (x | y | z).leading_zeros();
    let shift = bits.saturating_sub(15);
    let [x, y, z] = [x >> shift, y >> shift, z >> shift];
    (isqrt(x * x + y * y + z * z) << shift) as i32
}

/// Coefficients of u², u⁴ and u⁶ in the polynomial of cos(πu/2); a - b + c = 1.
const COSINE_A: i32 = q16(1.23364);
const COSINE_B: i32 = q16(0.25325);
const COSINE_C: i32 = q16(0.0196);

/// cos(2πt) of a phase whose whole turn is 2¹⁶, Q16. Error below 0.001; even and periodic to the
/// last bit.
#[inline]
pub const fn cos_turn(t: i32) -> i32 {
    // Folded to a quarter: x in 0..=2¹⁴ from a crest, sign by half turns.
    let turn = t & 0xffff;
    let half = if turn > 0x8000 { Q16 - turn } else { turn };
    let (x, sign) = if half > 0x4000 {
        (0x8000 - half, -1)
    } else {
        (half, 1)
    };
    // cos(πu/2) with u = x / 2¹⁴: 1 - u²(a - u²(b - c·u²)).
    let u = x << 2;
    let u2 = square(u);
    let inner = COSINE_B - mul_q16(COSINE_C, u2);
    let outer = COSINE_A - mul_q16(inner, u2);
    sign * (Q16 - mul_q16(outer, u2))
}

crate::wgsl::shared!(
    ROOT_CONSTANT,
    ROOT_SLOPE,
    ROOT_SQUARE,
    COSINE_A,
    COSINE_B,
    COSINE_C,
);

#[cfg(test)]
#[path = "arith_tests.rs"]
mod tests;
