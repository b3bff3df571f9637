//! The exponent β of the power spectrum, S(k) ~ k^-β, of wavelengths from 1.5 to 24 km.
//!
//! The plane of least squares is taken off the tile, a Hann window is laid over it both ways, and
//! its power is averaged over rings of the wave vector's length, a third of an octave wide; β is
//! the slope of the line of least squares through the logarithms of the rings (Turcotte 1997,
//! "Fractals and chaos in geology", §7). Only wave numbers of that range are transformed: long
//! waves are few, and a plain sum over a row is cheaper for them than the fast transform of all.

use super::line::falling_exponent;
use crate::math::{self, PI, TAU};
use crate::query::HeightGrid;
use rayon::prelude::*;

/// Shortest wavelength in m: shorter ones are smoothed in measured tiles of 30 to 90 m.
const SHORTEST_M: f64 = 1500.0;

/// Longest wavelength in m: longer ones are few in a tile of 60 km.
const LONGEST_M: f64 = 24_000.0;

/// Rings per octave of the wave vector's length.
const RINGS_PER_OCTAVE: f64 = 3.0;

/// Fewest rings that a line is drawn through.
const FEWEST_RINGS: usize = 4;

/// The spectral exponent of a tile; `None` of level ground, and of a tile that has fewer than four
/// rings: one that is too small or too coarse.
pub(super) fn spectral_exponent(tile: &HeightGrid) -> Option<f64> {
    let size = [
        tile.width as f64 * tile.pixel_m[0],
        tile.height as f64 * tile.pixel_m[1],
    ];
    let waves = [
        highest_wave(size[0], tile.width),
        highest_wave(size[1], tile.height),
    ];
    // Rows first, then columns: a transform of two dimensions.
    let rows = row_transforms(tile, waves[0]);
    let mut spectrum = RadialSpectrum::default();
    let roots = RootsOfUnity::new(tile.height);
    for kx in 0..=waves[0] {
        // Half of the plane of waves is enough: heights are real, so the other half mirrors it.
        let column: Vec<Complex> = rows.iter().map(|row| row[kx]).collect();
        let powers = column_powers(&column, &roots, waves[1]);
        let fx = kx as f64 / size[0];
        for (i, power) in powers.into_iter().enumerate() {
            let fy = (i as f64 - waves[1] as f64) / size[1];
            // A wave and its mirror image have the same power; those of kx = 0 are met twice.
            let weight = if kx == 0 { 0.5 } else { 1.0 };
            spectrum.add((fx * fx + fy * fy).sqrt(), power, weight);
        }
    }
    spectrum.exponent()
}

/// Real and imaginary part.
type Complex = [f64; 2];

/// The transforms of all rows up to the wave number `highest`.
fn row_transforms(tile: &HeightGrid, highest: usize) -> Vec<Vec<Complex>> {
    let plane = Plane::fitted(tile);
    (0..tile.height)
        .into_par_iter()
        .map(|y| row_transform(tile, y, &plane, highest))
        .collect()
}

/// The highest wave number of interest that a side has and its pixels resolve.
fn highest_wave(side_m: f64, pixels: usize) -> usize {
    ((side_m / SHORTEST_M) as usize).min((pixels.max(1) - 1) / 2)
}

/// A plane over a tile, counted from its middle.
struct Plane {
    /// Height at the middle in m.
    mean: f64,
    /// Rise in m per column.
    across: f64,
    /// Rise in m per row.
    down: f64,
}

impl Plane {
    /// The plane of least squares.
    fn fitted(tile: &HeightGrid) -> Self {
        let (w, h) = (tile.width as f64, tile.height as f64);
        let mut sums = [0.0; 3];
        for y in 0..tile.height {
            let v = from_middle(y, h);
            for (x, &z) in tile.row(y).iter().enumerate() {
                let z = f64::from(z);
                sums[0] += z;
                sums[1] += z * from_middle(x, w);
                sums[2] += z * v;
            }
        }
        // 1, u and v are orthogonal on the grid: each coefficient is a quotient of two sums.
        Self {
            mean: sums[0] / (w * h),
            across: sums[1] / sum_of_squares(w, h),
            down: sums[2] / sum_of_squares(h, w),
        }
    }

    /// Height above the plane of a point at height `z`, `u` columns and `v` rows from the middle.
    fn height_above(&self, z: f64, u: f64, v: f64) -> f64 {
        z - self.mean - self.across * u - self.down * v
    }
}

/// Place of pixel `i` of `n`, counted from the middle.
fn from_middle(i: usize, n: f64) -> f64 {
    i as f64 - 0.5 * (n - 1.0)
}

/// Sum of the squares of the places along a side of `n` pixels, over `other` lines of them.
fn sum_of_squares(n: f64, other: f64) -> f64 {
    (n * (n * n - 1.0) / 12.0 * other).max(1.0)
}

/// The n-th roots of unity: the factors of a discrete Fourier transform.
struct RootsOfUnity(Vec<(f64, f64)>);

impl RootsOfUnity {
    fn new(n: usize) -> Self {
        let root = |i: usize| math::sin_cos(TAU * i as f64 / n as f64);
        Self((0..n).map(root).collect())
    }

    /// Sum of `values(i)` e^(-2πi k/n).
    fn transform(&self, k: usize, values: impl Iterator<Item = Complex>) -> Complex {
        let n = self.0.len();
        let mut sum = [0.0; 2];
        let mut angle = 0;
        for [re, im] in values {
            let (sin, cos) = self.0[angle];
            sum[0] += re * cos + im * sin;
            sum[1] += im * cos - re * sin;
            // Angles are whole steps around the circle: no error adds up.
            angle += k;
            if angle >= n {
                angle -= n;
            }
        }
        sum
    }
}

/// Coefficients 0..=`waves` of a windowed row above the plane.
fn row_transform(tile: &HeightGrid, y: usize, plane: &Plane, waves: usize) -> Vec<Complex> {
    let (w, h) = (tile.width, tile.height);
    let v = from_middle(y, h as f64);
    let vertical = hann(y, h);
    let row = tile.row(y).iter().enumerate();
    // Without plane and window the jump from one edge to the other would pass for short waves.
    let windowed: Vec<f64> = row
        .map(|(x, &z)| {
            let z = plane.height_above(f64::from(z), from_middle(x, w as f64), v);
            z * vertical * hann(x, w)
        })
        .collect();
    let roots = RootsOfUnity::new(w);
    (0..=waves)
        .map(|k| roots.transform(k, windowed.iter().map(|&z| [z, 0.0])))
        .collect()
}

/// Powers of a column of coefficients at the wave numbers -`waves`..=`waves`.
fn column_powers(column: &[Complex], roots: &RootsOfUnity, waves: usize) -> Vec<f64> {
    let n = column.len();
    (0..2 * waves + 1)
        .into_par_iter()
        .map(|i| {
            let [re, im] = roots.transform((i + n - waves) % n, column.iter().copied());
            re * re + im * im
        })
        .collect()
}

/// Hann's window at the middle of pixel `i` of `n`.
fn hann(i: usize, n: usize) -> f64 {
    let sin = math::sin(PI * (i as f64 + 0.5) / n as f64);
    sin * sin
}

/// Power in rings of the wave vector's length.
#[derive(Default)]
struct RadialSpectrum {
    rings: Vec<Ring>,
}

/// Weighted sums over the wave vectors of a ring.
#[derive(Clone, Copy, Default)]
struct Ring {
    weight: f64,
    power: f64,
    frequency: f64,
}

impl RadialSpectrum {
    /// Counts a wave of a frequency in 1/m.
    fn add(&mut self, frequency: f64, power: f64, weight: f64) {
        if !(1.0 / LONGEST_M..1.0 / SHORTEST_M).contains(&frequency) {
            return;
        }
        let log = math::ln(frequency * LONGEST_M);
        let ring = (RINGS_PER_OCTAVE * log / core::f64::consts::LN_2) as usize;
        if self.rings.len() <= ring {
            self.rings.resize(ring + 1, Ring::default());
        }
        let sums = &mut self.rings[ring];
        sums.weight += weight;
        sums.power += weight * power;
        sums.frequency += weight * frequency;
    }

    /// The slope, turned around, of the line of least squares through log power over log frequency.
    fn exponent(&self) -> Option<f64> {
        let points: Vec<[f64; 2]> = self.rings.iter().filter_map(Ring::log_means).collect();
        if points.len() < FEWEST_RINGS {
            return None;
        }
        falling_exponent(&points)
    }
}

impl Ring {
    /// Logarithms of mean frequency and mean power; `None` of a ring without power.
    fn log_means(&self) -> Option<[f64; 2]> {
        (self.weight > 0.0 && self.power > 0.0)
            .then(|| [self.frequency, self.power].map(|sum| math::ln(sum / self.weight)))
    }
}

#[cfg(test)]
#[path = "spectrum_tests.rs"]
mod tests;
