use super::*;
use crate::math::{self, TAU};

/// A tile of 300 x 200 cells of heights `z(x, y)` in m at x cells east and y south.
fn coherence_of(z: impl Fn(f64, f64) -> f64) -> Option<GradientCoherence> {
    let height = |i: usize| z((i % 300) as f64, (i / 300) as f64) as f32;
    GradientCoherence::of(&HeightGrid {
        width: 300,
        height: 200,
        values: (0..60_000).map(height).collect(),
        pixel_m: [92.6; 2],
    })
}

/// A wave of 16 cells, in 64 cells a whole number of times, that runs east and south.
fn wave(x: f64, y: f64) -> f64 {
    math::sin(TAU * (x + y) / 16.0)
}

#[test]
fn planes_have_none() {
    assert_eq!(coherence_of(|_, _| 812.0), None);
    assert_eq!(coherence_of(|x, y| 4000.0 + 10.0 * x - 3.0 * y), None);
    assert_eq!(coherence_of(|x, y| 8000.0 + 0.1 * x + 0.3 * y), None);
}

#[test]
fn corrugations_have_one() {
    let across = coherence_of(|x, _| 100.0 * wave(x, 0.0)).unwrap();
    let oblique = coherence_of(|x, y| 100.0 * wave(x, y)).unwrap();
    // The mean gradient is taken off: a hillside as a whole does not count.
    let on_a_hillside = coherence_of(|x, y| 100.0 * wave(x, 0.0) + 50.0 * y).unwrap();
    for found in [across, oblique, on_a_hillside] {
        assert!(found.median > 0.999 && found.p90 > 0.999, "{found:?}");
    }
}

/// Waves of equal length across each other, amplitudes 1 and a: their gradients do not correlate,
/// so λ₁ : λ₂ = 1 : a².
#[test]
fn crossing_waves_have_that_of_their_amplitudes() {
    for a in [0.25, 0.5, 1.0] {
        let expected = (1.0 - a * a) / (1.0 + a * a);
        let found = coherence_of(|x, y| 100.0 * (wave(x, 0.0) + a * wave(y, 0.0))).unwrap();
        // Windows at the edges of the tile have differences over one cell.
        assert!((found.median - expected).abs() < 0.002, "{a} {found:?}");
        let turned = coherence_of(|x, y| 100.0 * (wave(x, y) + a * wave(x, -y))).unwrap();
        assert!((turned.median - expected).abs() < 0.002, "{a} {turned:?}");
    }
}

/// Cones 16 cells apart.
fn cones(x: f64, y: f64) -> f64 {
    let [east, south] = [x, y].map(|place| place.rem_euclid(16.0) - 8.0);
    -50.0 * (east * east + south * south).sqrt()
}

/// Heights that hang on no other.
fn noise(x: f64, y: f64) -> f64 {
    let seed = (x as u64 * 1_000_003 + y as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mixed = (seed ^ seed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    (mixed >> 32) as f64 * 1e-8
}

/// Cones fall to all sides; noise has a coherence of about √(π/2n) of n independent gradients.
#[test]
fn cones_and_noise_have_next_to_none() {
    let found = coherence_of(cones).unwrap();
    assert!(found.p90 < 0.02, "{found:?}");
    let found = coherence_of(noise).unwrap();
    assert!(found.median < 0.06 && found.p90 < 0.1, "{found:?}");
}

#[test]
fn small_tiles_have_none() {
    let values: Vec<f32> = (0..63 * 63).map(|i| (i * i % 17) as f32).collect();
    let tile = HeightGrid {
        width: 63,
        height: 63,
        values,
        pixel_m: [92.6; 2],
    };
    assert_eq!(GradientCoherence::of(&tile), None);
}

/// Windows are as long on finer pixels: crossing waves of 32 cells, in thirds of cells.
#[test]
fn finer_pixels_make_no_difference() {
    let wave = |pixel: usize| 100.0 * math::sin(TAU * (pixel as f64 + 0.5) / 96.0);
    let bumps = |i: usize| (wave(i % 384) + 0.5 * wave(i / 384)) as f32;
    let found = GradientCoherence::of(&HeightGrid {
        width: 384,
        height: 384,
        values: (0..384 * 384).map(bumps).collect(),
        pixel_m: [92.6 / 3.0; 2],
    });
    assert!((found.unwrap().median - 0.6).abs() < 0.002, "{found:?}");
}
