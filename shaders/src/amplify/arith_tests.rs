//! Integers against reals.

use super::*;
use crate::amplify::seed::pcg;

#[test]
fn ratios_match_reals() {
    for (a, b) in [
        (1, 3),
        (0, 7),
        (5, 5),
        (1_000_000_007, 2_000_000_011),
        (70_000, 65_537),
        (9, 2),
    ] {
        let want = (f64::from(a) / f64::from(b)).min(1.0);
        let got = f64::from(ratio(a, b)) / 65_536.0;
        assert!((got - want).abs() < 1e-4, "{a}/{b}");
    }
}

/// The root of an f64 is the exact one rounded to 53 bits, and the one below n², n < 2¹⁶, lies
/// more than 2⁻¹⁸ below n: it never rounds up to it.
#[test]
fn roots_are_exact() {
    let random = (0..2_000_000_u32).map(|k| pcg(k) >> (k % 31));
    let squares = (1..=0xffff_u32).flat_map(|n| [n * n - 1, n * n, n * n + n, n * n + 2 * n]);
    for x in squares.chain(random).chain([0, u32::MAX]) {
        assert_eq!(isqrt(x), f64::from(x).sqrt() as u32, "{x}");
    }
}

#[test]
fn curves_of_shares_match_reals() {
    for t in (0..=Q16).step_by(13) {
        let x = f64::from(t) / 65_536.0;
        assert!((f64::from(pow_1_5(t)) - x * x.sqrt() * 65_536.0).abs() < 2.1);
        assert!((f64::from(smooth(t)) - x * x * (3.0 - 2.0 * x) * 65_536.0).abs() < 4.0);
    }
}

#[test]
fn smooth_is_monotone() {
    let mut last = 0;
    for t in 0..=Q16 {
        let value = smooth(t);
        assert!(value + 1 >= last, "{t}");
        last = last.max(value);
    }
    assert_eq!(
        (smooth(0), smooth(Q16), smooth(-5), smooth(Q16 + 9)),
        (0, Q16, 0, Q16)
    );
}

#[test]
#[allow(clippy::disallowed_methods, reason = "a reference within a tolerance")]
fn cosine_is_close_and_even() {
    for t in 0..65_536 {
        let want = (f64::from(t) / 65_536.0 * std::f64::consts::TAU).cos() * 65_536.0;
        assert!(
            (f64::from(cos_turn(t)) - want).abs() < 66.0,
            "{t}: {} {want}",
            cos_turn(t)
        );
        assert_eq!(cos_turn(t), cos_turn(-t));
    }
}

#[test]
fn length_is_isotropic() {
    for v in [
        [3, 4, 0],
        [1_000_000, -2_000_000, 2_000_000],
        [1 << 29, 1 << 28, -(1 << 29)],
    ] {
        let want = v
            .map(|c| f64::from(c) * f64::from(c))
            .iter()
            .sum::<f64>()
            .sqrt();
        assert!((f64::from(length(v[0], v[1], v[2])) / want - 1.0).abs() < 2e-4);
    }
}
