//! Fixed-point numbers of the ground. Products are taken in 64 bits; WGSL, which has 32, can build
//! the same bits from halves (see the tests).
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

/// Square of a difference of directions in 2⁻³² of the squared radius: below a quarter.
#[inline]
pub const fn square_q32(d: [i32; 3]) -> u32 {
    let mut sum = 0;
    let mut i = 0;
    while i < 3 {
        // 2^32 / ONE = 2 + 0.10526; the product of 0.10526 has 32 bits after the point.
        let x = d[i].unsigned_abs();
        let x = 2 * x + mul_high(x, 452_101_823);
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
    // 1/sqrt(1 - e) - 1 = e/2 + 3e²/8 + 5e³/16.
    let second = mul_high(deficit, deficit);
    let third = mul_high(second, deficit);
    let factor = deficit / 2 + second * 3 / 8 + third * 5 / 16;
    let mut out = p;
    let mut i = 0;
    while i < 3 {
        let x = p[i].unsigned_abs();
        let low = x.wrapping_mul(factor);
        let step = (mul_high(x, factor) + (low >> 31)) as i32;
        out[i] = if p[i] < 0 { p[i] - step } else { p[i] + step };
        i += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::amplify::arith::mul_q16;
    use crate::amplify::seed::pcg;

    /// The same functions in operations of 32 bits, which WGSL has.
    mod halves {
        pub(super) fn mul_high(a: u32, b: u32) -> u32 {
            let (ah, al, bh, bl) = (a >> 16, a & 0xffff, b >> 16, b & 0xffff);
            let middle = (ah * bl) + ((al * bl) >> 16);
            let cross = al * bh + (middle & 0xffff);
            ah * bh + (middle >> 16) + (cross >> 16)
        }

        pub(super) fn mul_shift(a: u32, b: u32, shift: u32) -> i32 {
            let high = mul_high(a, b);
            if (high >> (shift - 1)) != 0 {
                return i32::MAX;
            }
            ((high << (32 - shift)) | (a.wrapping_mul(b) >> shift)) as i32
        }

        pub(super) fn mul_q16(a: i32, b: i32) -> i32 {
            let low = (a & 0xffff) as u32;
            let cross = ((b >> 16) as u32).wrapping_mul(low);
            let bottom = low.wrapping_mul((b & 0xffff) as u32) >> 16;
            (a >> 16)
                .wrapping_mul(b)
                .wrapping_add(cross as i32)
                .wrapping_add(bottom as i32)
        }

        pub(super) fn weigh(w: i32, d: i32) -> i32 {
            let low = (w & 0xffff) as u32;
            let bottom = (low.wrapping_mul((d & 0xffff) as u32) >> 1).wrapping_add(0x4000) >> 15;
            (w >> 16)
                .wrapping_mul(d)
                .wrapping_add(((d >> 16) as u32).wrapping_mul(low) as i32)
                .wrapping_add(bottom as i32)
        }
    }

    /// The bits of every planet hang on these integers.
    #[test]
    fn constants_are_the_integers_they_always_were() {
        let shares = [
            (0.00381, 250),
            (0.006, 393),
            (0.008, 524),
            (0.0196, 1_285),
            (0.02, 1_311),
            (0.02289, 1_500),
            (0.03052, 2_000),
            (0.04425, 2_900),
            (0.05, 3_277),
            (0.06104, 4_000),
            (0.06866, 4_500),
            (0.09155, 6_000),
            (0.1, 6_554),
            (0.12207, 8_000),
            (0.13733, 9_000),
            (0.15, 9_830),
            (0.15259, 10_000),
            (0.15666, 10_267),
            (0.17, 11_141),
            (0.1831, 12_000),
            (0.2, 13_107),
            (0.21362, 14_000),
            (0.24414, 16_000),
            (0.25325, 16_597),
            (0.3, 19_661),
            (0.30518, 20_000),
            (0.33, 21_627),
            (0.35, 22_938),
            (0.36621, 24_000),
            (0.38, 24_904),
            (0.39673, 26_000),
            (0.4, 26_214),
            (0.42725, 28_000),
            (0.45, 29_491),
            (0.45776, 30_000),
            (0.48, 31_457),
            (0.55, 36_045),
            (0.6, 39_322),
            (0.61035, 40_000),
            (0.64087, 42_000),
            (0.65, 42_598),
            (0.67139, 44_000),
            (0.68665, 45_000),
            (0.7, 45_875),
            (0.7019, 46_000),
            (core::f64::consts::FRAC_1_SQRT_2, 46_341),
            (0.75, 49_152),
            (0.78125, 51_200),
            (0.8, 52_429),
            (0.82397, 54_000),
            (0.85449, 56_000),
            (0.88, 57_672),
            (0.9, 58_982),
            (0.91553, 60_000),
            (0.94604, 62_000),
            (0.95, 62_259),
            (0.97656, 64_000),
            (1.2207, 80_000),
            (1.23364, 80_848),
            (1.37329, 90_000),
            (3.0, 196_608),
            (4.01001, 262_800),
            (11.42883, 749_000),
        ];
        for (real, integer) in shares {
            assert_eq!(q16(real), integer, "{real}");
        }
        for (degrees, integer) in [(3.0, 3_435), (3.5, 4_008), (20.0, 23_853)] {
            assert_eq!(tan_deg(degrees), integer, "{degrees}°");
        }
        assert_eq!((metres(3_700), million_years(200)), (3_788_800, 12_800));
    }

    /// Pairs of numbers of all sizes.
    fn pairs() -> impl Iterator<Item = (u32, u32)> {
        let ends = [
            0,
            1,
            0x7fff,
            0x8000,
            0xffff,
            0x1_0000,
            i32::MAX as u32,
            1 << 31,
            u32::MAX,
        ];
        let random = (0..100_000).map(|k| (pcg(k) >> (k % 23), pcg(k + 500_000) >> (k % 29)));
        ends.into_iter()
            .flat_map(move |a| ends.map(|b| (a, b)))
            .chain(random)
    }

    /// All products that are taken in 64 bits.
    #[test]
    fn halves_make_the_same_bits_as_wide_products() {
        let mut fitting = 0;
        for (k, (a, b)) in (0..).zip(pairs()) {
            let shift = 1 + k % 31;
            assert_eq!(mul_high(a, b), halves::mul_high(a, b), "{a} {b}");
            assert_eq!(
                mul_shift(a, b, shift),
                halves::mul_shift(a, b, shift),
                "{a} {b} {shift}"
            );
            let [a, b] = [a as i32, b as i32];
            let wide = (i64::from(a) * i64::from(b)) >> 16;
            if wide.abs() < i64::from(i32::MAX) {
                assert_eq!(mul_q16(a, b), halves::mul_q16(a, b), "{a} {b}");
                assert_eq!(weigh(a, b), halves::weigh(a, b), "{a} {b}");
                fitting += 1;
            }
        }
        assert!(fitting > 50_000, "{fitting}");
    }

    #[test]
    fn lifted_points_lie_on_the_sphere() {
        for k in 0..2000_u32 {
            // A chord of up to 0.1 rad and its middle: cosine and sine from a half-angle tangent.
            let t = f64::from(k) * 2.5e-5;
            let (cos, sin) = ((1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t));
            let one = f64::from(ONE);
            let a = [ONE, 0, 0];
            let b = [one * cos, one * sin * 0.6, one * sin * 0.8].map(|x| x.round() as i32);
            let d = difference(b, a);
            let middle = [a[0] + d[0] / 2, a[1] + d[1] / 2, a[2] + d[2] / 2];
            let p = lift(middle, square_q32(d) / 4).map(f64::from);
            let norm = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
            assert!((norm - one).abs() < 4.0, "{t}: {}", norm - one);
        }
    }
}
