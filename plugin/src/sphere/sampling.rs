//! Spherical Fibonacci points (Swinbank and Purser 2006; González 2010; paper 000 §3).
//!
//! Sample i of n lies at z = 1 - (2i + 1)/n and longitude 2π i/Φ, Φ the golden ratio: a spiral from
//! pole to pole with cells of equal area. The spiral's own order scatters neighbours over the whole
//! array, so the points are sorted along a Hilbert curve: what is close on the sphere is close in
//! memory.

use super::cube::along_curve;
use crate::math;
use bevy::math::DVec3;

/// 2^64/Φ, rounded: multiples of the golden turn, modulo a whole turn, as 64-bit integers.
const GOLDEN_TURN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The spherical Fibonacci set of `n` points (n < 2^24), ordered along a space-filling curve.
pub(super) fn fibonacci(n: u32) -> Vec<DVec3> {
    along_curve(n, |i| spiral_point(i, n))
}

/// Point i of the spiral of `n` points.
fn spiral_point(i: u32, n: u32) -> DVec3 {
    // Multiplying first and dropping whole turns by overflow keeps 53 exact bits of the turn.
    let turn = (u64::from(i).wrapping_mul(GOLDEN_TURN) >> 11) as f64 / (1u64 << 53) as f64;
    let (sin, cos) = math::sin_cos(math::TAU * turn);
    let from_top = (2.0 * f64::from(i) + 1.0) / f64::from(n);
    let r = (from_top * (2.0 - from_top)).sqrt();
    DVec3::new(r * cos, r * sin, 1.0 - from_top)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_the_fibonacci_set() {
        let n = 1000;
        let mut by_height = fibonacci(n);
        by_height.sort_by(|a, b| b.z.total_cmp(&a.z));
        let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
        for (i, p) in by_height.iter().enumerate() {
            let z = 1.0 - (2.0 * i as f64 + 1.0) / f64::from(n);
            let (sin, cos) = math::sin_cos(math::TAU * (i as f64 / golden));
            let q = DVec3::new(cos, sin, 0.0) * (1.0 - z * z).sqrt() + DVec3::Z * z;
            assert!((*p - q).length() < 1e-12, "{i}: {p} {q}");
            assert!((p.length() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn points_balance() {
        let sum: DVec3 = fibonacci(5000).iter().sum();
        assert!(sum.length() < 0.1, "{sum}");
    }
}
