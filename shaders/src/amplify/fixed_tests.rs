//! Products of halves, constants and points of the sphere.

use super::*;
use crate::amplify::arith::mul_q16;
use crate::amplify::seed::pcg;

/// The same functions in operations of 32 bits, which WGSL has.
mod halves {
    pub(super) fn mul_high(a: u32, b: u32) -> u32 {
        let [ah, bh] = [a, b].map(|x| x >> 16);
        let [al, bl] = [a, b].map(|x| x & 0xffff);
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

/// Shares of the rules, and the integers that the bits of every planet hang on.
const SHARES: [(f64, i32); 63] = [
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

/// The bits of every planet hang on these integers.
#[test]
fn constants_are_the_integers_they_always_were() {
    for (real, integer) in SHARES {
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
