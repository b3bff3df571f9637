//! Statistics and bits of the noise.

use super::*;
use crate::amplify::fixed::ONE;
use crate::amplify::seed::{pcg, share};

/// The noise at a point, from an empty cache.
fn gradient(point: [i32; 3], cell: u32, seed: u32) -> i32 {
    super::gradient(&mut CornerCache::default(), point, cell, seed)
}

fn points(count: u32) -> impl Iterator<Item = [i32; 3]> {
    (0..count).map(|i| {
        let p = [0, 1, 2].map(|k| f64::from(share(pcg(i), k)) - 32_768.0);
        let length = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt().max(1.0);
        p.map(|c| (c / length * f64::from(ONE)) as i32)
    })
}

#[test]
fn mean_is_zero_and_spread_is_that_of_gradient_noise() {
    for cell in [24, 17, 12, 8] {
        let values: Vec<f64> = points(40_000)
            .map(|p| f64::from(gradient(p, cell, 7)) / 65_536.0)
            .collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let rms = (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt();
        assert!(mean.abs() < 0.01, "{cell}: {mean}");
        assert!((0.2..0.35).contains(&rms), "{cell}: {rms}");
        assert!(values.iter().all(|v| v.abs() < 1.1));
    }
}

#[test]
fn continuous_across_cells() {
    // Along a line through many cells, steps of a 256th of a cell: the slope of the noise is
    // below 4.
    for cell in [20, 12, 9] {
        let step = 1_i32 << (cell - 8);
        let mut last = None;
        for i in 0..4_096 {
            let value = gradient(
                [
                    1_000_003 + i * step,
                    -77_777_777 + i * step / 3,
                    9 - i * step / 2,
                ],
                cell,
                3,
            );
            if let Some(last) = last {
                let change: i32 = value - last;
                assert!(change.abs() < 4 * 256 + 8, "{cell}: {change}");
            }
            last = Some(value);
        }
    }
}

#[test]
fn slopes_are_isotropic() {
    // Mean squared differences along three axes and three diagonals agree: no direction of the
    // lattice shows.
    let cell = 16;
    let d = 1 << 13;
    let e = 4_730; // d / √3
    let axes = [
        [d, 0, 0],
        [0, d, 0],
        [0, 0, d],
        [e, e, e],
        [e, -e, e],
        [-e, e, e],
    ];
    let energies = axes.map(|a| {
        points(30_000)
            .map(|p| {
                let q = [
                    p[0].wrapping_add(a[0]),
                    p[1].wrapping_add(a[1]),
                    p[2].wrapping_add(a[2]),
                ];
                let change = f64::from(gradient(q, cell, 11) - gradient(p, cell, 11));
                change * change
            })
            .sum::<f64>()
    });
    let mean = energies.iter().sum::<f64>() / 6.0;
    assert!(
        energies.iter().all(|e| (e / mean - 1.0).abs() < 0.12),
        "{energies:?}"
    );
}

#[test]
fn octaves_are_independent() {
    let dot: f64 = points(20_000)
        .map(|p| {
            f64::from(gradient(p, 16, 1)) * f64::from(gradient(p, 16, 2)) / 65_536.0 / 65_536.0
        })
        .sum::<f64>()
        / 20_000.0;
    assert!(dot.abs() < 0.002, "{dot}");
}

#[test]
fn a_cache_changes_no_bit() {
    for cell in [1, 9, 16, 17, 30] {
        let mut cache = CornerCache::default();
        for (k, p) in (0..).zip(points(300)) {
            // Every point twice, the second time a little farther on.
            for step in [0, 1 << cell >> (k % 8)] {
                let at = p.map(|x| x.wrapping_add(step));
                assert_eq!(
                    super::gradient(&mut cache, at, cell, 5),
                    gradient(at, cell, 5)
                );
            }
        }
    }
}

/// Perlin's sixteen gradients.
const GRADIENTS: [[f64; 3]; 16] = [
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [-1.0, -1.0, 0.0],
    [1.0, 0.0, 1.0],
    [-1.0, 0.0, 1.0],
    [1.0, 0.0, -1.0],
    [-1.0, 0.0, -1.0],
    [0.0, 1.0, 1.0],
    [0.0, -1.0, 1.0],
    [0.0, 1.0, -1.0],
    [0.0, -1.0, -1.0],
    [1.0, 1.0, 0.0],
    [0.0, -1.0, 1.0],
    [-1.0, 1.0, 0.0],
    [0.0, -1.0, -1.0],
];

/// All 32-bit words.
const ALL: u128 = 1 << 32;

/// One round of the hash of a cell: each word takes in the product of the others.
fn multiply([a, b, c]: [u128; 3]) -> [u128; 3] {
    let a = (a + b * c) % ALL;
    let b = (b + c * a) % ALL;
    [a, b, (c + a * b) % ALL]
}

/// The hash of a cell in whole numbers that do not wrap, by remainders.
fn hash_by_remainders(cell: [u32; 3], seed: u32) -> u32 {
    let mut state = cell.map(|x| (u128::from(x) * 1_664_525 + 1_013_904_223) % ALL);
    state[0] ^= u128::from(seed);
    state = multiply(state).map(|x| x ^ (x / 65_536));
    let [a, b, c] = multiply(state);
    (c ^ (a / 65_536) ^ (b * 65_536 % ALL)) as u32
}

/// Gradient noise of reals at a point of the lattice's own coordinates.
fn real_noise(point: [u32; 3], cell: u32, seed: u32) -> f64 {
    let size = f64::from(1_u32 << cell);
    let at = point.map(|x| f64::from(x) / size);
    let fade = |t: f64| ((6.0 * t - 15.0) * t + 10.0) * t * t * t;
    let mut sum = 0.0;
    for corner in 0..8_u32 {
        let side = [0, 1, 2].map(|axis| corner >> axis & 1);
        let address = [0, 1, 2].map(|i| (at[i] as u32 + side[i]) % (1 << (32 - cell)));
        let gradient = GRADIENTS[(hash_by_remainders(address, seed) >> 7) as usize % 16];
        let mut weighed = 0.0;
        let mut weight = 1.0;
        for axis in 0..3 {
            let offset = at[axis].fract() - f64::from(side[axis]);
            weighed += gradient[axis] * offset;
            weight *= fade(1.0 - offset.abs());
        }
        sum += weight * weighed;
    }
    sum
}

#[test]
fn noise_is_that_of_reals() {
    for cell in [3, 9, 16, 17, 24, 30] {
        for (k, point) in (0..).zip(points(2_000)) {
            let seed = pcg(k);
            let moved = [0, 1, 2].map(|axis| {
                let origin = (seed ^ (axis * 0x9e37_79b9_u64) as u32) as u64 * 0x85eb_ca6b;
                (point[axis as usize] as u32).wrapping_add(origin as u32)
            });
            let want = real_noise(moved, cell, seed) * 65_536.0;
            let got = f64::from(gradient(point, cell, seed));
            assert!((got - want).abs() < 32.0, "{cell} {k}: {got}, not {want}");
        }
    }
}

/// The hashes are those that integers of any size give, taken modulo 2³² by hand; the noise is that
/// of reals within 2⁻¹¹, see above.
#[test]
fn bits_are_pinned() {
    assert_eq!(cell_hash(1, 2, 3, 4), 4_093_383_580);
    assert_eq!(cell_hash(u32::MAX, 0, 77, 5), 777_425_814);
    let got = [
        gradient([ONE, 0, 0], 24, 5),
        gradient([-3, 1 << 30, 77], 10, 6),
        fbm(
            &mut [CornerCache::default(); 6],
            [ONE / 3, ONE / 3, ONE / 2],
            20,
            32_768,
            9,
        ),
    ];
    assert_eq!(got, [29_333, -4_965, 4_097]);
}
