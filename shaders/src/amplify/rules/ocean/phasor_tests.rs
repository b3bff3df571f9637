//! Stripes lie across their axis, and have no steps.

use super::*;
use crate::amplify::fixed::ONE;

/// The stripes at a point, from an empty cache.
fn phasor(point: [i32; 3], axis: [i16; 3], cell: u32, waves: i32, seed: u32) -> Phasor {
    let spread = q16(0.15);
    StripeNoise {
        cell,
        waves,
        spread,
        seed,
    }
    .at(&mut PacketCache::default(), point, axis)
}

/// Most change of a stripe's height along it, of 1 in Q16.
const BREAK: i32 = Q16 / 24;

/// Energy of the noise's changes over a step of a sixteenth of a wave along a direction.
fn energy(step: [i32; 3]) -> f64 {
    let axis = [0, 32_767, 0];
    let mut sum = 0.0;
    for i in 0..60 {
        for j in 0..60 {
            let p = [ONE - 1_000_000, i * 2_600_003, j * 2_600_003];
            let q = [p[0], p[1] + step[1], p[2] + step[2]];
            let [a, b] = [p, q].map(|p| phasor(p, axis, 24, 2 * Q16, 5));
            let change = f64::from(a.cosine - b.cosine);
            sum += change * change;
        }
    }
    sum
}

#[test]
fn stripes_lie_across_their_axis() {
    let d = 1 << 19;
    assert!(
        energy([0, d, 0]) > 5.0 * energy([0, 0, d]),
        "{} {}",
        energy([0, d, 0]),
        energy([0, 0, d])
    );
}

/// Correlation of two waves a cell of 2²⁴ units at points of a distance across the stripes.
fn correlation(distance: i32) -> f64 {
    let axis = [0, 32_767, 0];
    let products = (0..3_000).map(|i| {
        let p = [ONE - 7_000_000, (i % 55) * 3_100_007, (i / 55) * 3_100_007];
        let q = [p[0], p[1] + distance, p[2]];
        let [a, b] = [p, q].map(|at| f64::from(phasor(at, axis, 24, 2 * Q16, 9).cosine));
        a * b
    });
    products.sum()
}

#[test]
fn spectrum_peaks_at_the_wavelength() {
    // Over 2²³ the phase turns once, over 2²² half.
    assert!(correlation(1 << 22) < 0.0);
    assert!(correlation(1 << 23) > 0.0);
    assert!(correlation(1 << 23) < correlation(1 << 18));
}

#[test]
fn opposite_axes_agree() {
    for i in 0..200 {
        let p = [ONE / 2 + i * 77_777, i * 1_234_567, ONE / 3];
        let (a, b) = (
            phasor(p, [9_000, 30_000, -8_000], 25, Q16, 3),
            phasor(p, [-9_000, -30_000, 8_000], 25, Q16, 3),
        );
        // Floors of negative numbers differ by a unit of a far packet.
        assert!(
            (a.cosine - b.cosine).abs() < 512 || a.presence < 3_000,
            "{a:?} {b:?}"
        );
    }
}

#[test]
fn stripes_have_no_steps() {
    // 1.5 m on Earth: the phase turns by two units of Q16, the cosine changes by 14 and
    // rounding; more where packets disagree.
    for i in 0..1_000 {
        let p = [ONE / 2 + i * 777_777, i * 1_234_567, ONE / 3 - i * 55_555];
        let at = |p| phasor(p, [9_000, 30_000, -8_000], 26, 3 * Q16, 3);
        for axis in 0..3 {
            let mut q = p;
            q[axis] += 500;
            let (a, b) = (at(p), at(q));
            assert!(
                mul_q16((a.cosine - b.cosine).abs(), a.presence) < 40,
                "{p:?} {a:?} {b:?}"
            );
        }
    }
}

/// Where all packets are far one of them would decide alone, and where another is nearer the
/// stripes would break off: there they fade. Over half a percent of a packet's reach no stripe
/// gains or loses a quarter of its height beyond what its own wave does.
#[test]
fn regions_of_packets_have_no_borders() {
    let axis = [0, 32_767, 0];
    for i in 0..40_000 {
        let p = [ONE - 1_000_000, (i % 200) * 800_003, (i / 200) * 800_003];
        // Along the stripes: their phase stays.
        let q = [p[0], p[1], p[2] + (1 << 24) / 200];
        let [a, b] = [p, q]
            .map(|at| phasor(at, axis, 24, 2 * Q16, 5))
            .map(|at| mul_q16(at.cosine, at.presence));
        assert!((a - b).abs() < BREAK, "{p:?}: {a} {b}");
    }
}

#[test]
fn a_cache_changes_no_bit() {
    let mut cache = PacketCache::default();
    let noise = StripeNoise {
        cell: 25,
        waves: Q16,
        spread: q16(0.15),
        seed: 3,
    };
    for i in 0..500 {
        let p = [ONE / 2 + i * 777_777, i * 1_234_567, ONE / 3];
        let want = phasor(p, [9_000, 30_000, -8_000], 25, Q16, 3);
        assert_eq!(noise.at(&mut cache, p, [9_000, 30_000, -8_000]), want);
    }
}

#[test]
fn bits_are_pinned() {
    let got = phasor([ONE / 2, ONE / 3, ONE / 4], [32_767, 0, 0], 24, Q16, 1);
    assert_eq!(
        got,
        Phasor {
            cosine: 24_594,
            sine: 60_748,
            presence: 15_576
        }
    );
}

#[test]
fn a_turned_axis_mirrors_the_wave() {
    for i in 0..200 {
        let p = [ONE / 2 + i * 1_777_777, i * 3_234_567, ONE / 3];
        let axes = [[9_000, 30_000, -8_000], [-9_000, -30_000, 8_000]];
        let [there, back] = axes.map(|axis| phasor(p, axis, 25, 3 * Q16, 3));
        // Phases round down, whichever way they run: it shows where packets cancel each other.
        if there.presence > Q16 / 8 {
            assert!(
                (there.cosine - back.cosine).abs() < Q16 / 100,
                "{there:?} {back:?}"
            );
            assert!(
                (there.sine + back.sine).abs() < Q16 / 100,
                "{there:?} {back:?}"
            );
        }
        let [c, s] = [there.cosine, there.sine].map(|x| f64::from(x) / 65_536.0);
        assert!((c * c + s * s - 1.0).abs() < 2e-3, "{there:?}");
    }
}
