//! Fixed-point numbers of the ground. Products are taken in 64 bits; WGSL, which has 32, builds the
//! same bits from halves.
//!
//! Directions are in units of 1 / [`ONE`] of the radius (3.1 mm on Earth), heights and lengths in
//! grains of 1 / [`GRAINS`] m (range ±2097 km), shares in Q16 (65,536 is 1).

/// A direction component of 1: 1.9 · 2³⁰, so that sums of differences stay within an i32.
pub const ONE: i32 = 2_040_109_465;

/// Grains in a metre.
pub const GRAINS: i32 = 1024;

/// 1 in Q16.
pub const Q16: i32 = 1 << 16;

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
/// nearest.
#[inline]
pub const fn weigh(w: i32, d: i32) -> i32 {
    ((w as i64 * d as i64 + 0x8000) >> 16) as i32
}

/// Difference of two directions; exact where they are less than 60° apart.
#[inline]
pub const fn difference(to: [i32; 3], from: [i32; 3]) -> [i32; 3] {
    [
        to[0].wrapping_sub(from[0]),
        to[1].wrapping_sub(from[1]),
        to[2].wrapping_sub(from[2]),
    ]
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

    /// The same functions in operations of 32 bits, as their twins in WGSL have them.
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

    #[test]
    fn halves_make_the_same_bits_as_wide_products() {
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
        let ends = ends.into_iter().flat_map(|a| ends.map(|b| (a, b)));
        let random = (0..100_000).map(|k| (pcg(k) >> (k % 23), pcg(k + 500_000) >> (k % 29)));
        for (k, (a, b)) in (0..).zip(ends.chain(random)) {
            let shift = 1 + k % 31;
            assert_eq!(mul_high(a, b), halves::mul_high(a, b), "{a} {b}");
            assert_eq!(
                mul_shift(a, b, shift),
                halves::mul_shift(a, b, shift),
                "{a} {b} {shift}"
            );
            let (a, b) = (a as i32, b as i32);
            assert_eq!(mul_q16(a, b), halves::mul_q16(a, b), "{a} {b}");
            assert_eq!(weigh(a, b), halves::weigh(a, b), "{a} {b}");
        }
    }

    #[test]
    fn lifted_points_lie_on_the_sphere() {
        for k in 0..2000_u32 {
            // A chord of up to 0.1 rad and its middle.
            // Cosine and sine of up to 0.1 rad, from a half-angle tangent.
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
