//! The exponent β of the power spectrum, S(k) ~ k^-β, of wavelengths from 1.5 to 24 km.
//!
//! The plane of least squares is taken off the tile, a Hann window is laid over it both ways, and
//! its power is averaged over rings of the wave vector's length, a third of an octave wide; β is
//! the slope of the line of least squares through the logarithms of the rings (Turcotte 1997,
//! "Fractals and chaos in geology", §7). Only wave numbers of that range are transformed: long
//! waves are few, and a plain sum over a row is cheaper for them than the fast transform of all.

use crate::math::{self, PI, TAU};
use crate::query::HeightGrid;
use rayon::prelude::*;

/// Wavelengths in m.
const SHORTEST: f64 = 1500.0;
const LONGEST: f64 = 24_000.0;

/// Rings per octave.
const PER_OCTAVE: f64 = 3.0;

/// Fewest rings that a line is drawn through.
const FEWEST: usize = 4;

/// The spectral exponent of a tile; `None` of level ground, and of a tile that has fewer than four
/// rings: one that is too small or too coarse.
pub fn spectral_exponent(tile: &HeightGrid) -> Option<f64> {
    let size = [
        tile.width as f64 * tile.pixel_m[0],
        tile.height as f64 * tile.pixel_m[1],
    ];
    // Wave numbers that the tile has and its pixels resolve.
    let reach =
        |side: f64, pixels: usize| ((side / SHORTEST) as usize).min((pixels.max(1) - 1) / 2);
    let waves = [reach(size[0], tile.width), reach(size[1], tile.height)];
    let plane = fitted_plane(tile);
    let rows: Vec<Vec<[f64; 2]>> = (0..tile.height)
        .into_par_iter()
        .map(|y| row_transform(tile, y, plane, waves[0]))
        .collect();
    let mut rings = Rings::default();
    let south = Turn::new(tile.height);
    for kx in 0..=waves[0] {
        let column: Vec<[f64; 2]> = rows.iter().map(|row| row[kx]).collect();
        let powers: Vec<f64> = (0..2 * waves[1] + 1)
            .into_par_iter()
            .map(|i| power(&column, &south, (i + tile.height - waves[1]) % tile.height))
            .collect();
        for (i, power) in powers.into_iter().enumerate() {
            let (fx, fy) = (kx as f64 / size[0], (i as f64 - waves[1] as f64) / size[1]);
            // A wave and its mirror image have the same power; those of kx = 0 are met twice.
            let weight = if kx == 0 { 0.5 } else { 1.0 };
            rings.add((fx * fx + fy * fy).sqrt(), power, weight);
        }
    }
    rings.exponent()
}

/// Mean, slope per column and slope per row of the plane of least squares, counted from the middle
/// of the tile.
fn fitted_plane(tile: &HeightGrid) -> [f64; 3] {
    let (w, h) = (tile.width as f64, tile.height as f64);
    let mut sums = [0.0; 3];
    for y in 0..tile.height {
        let v = y as f64 - 0.5 * (h - 1.0);
        for (x, &z) in tile.row(y).iter().enumerate() {
            let (z, u) = (f64::from(z), x as f64 - 0.5 * (w - 1.0));
            sums[0] += z;
            sums[1] += z * u;
            sums[2] += z * v;
        }
    }
    // Sums of squares of the positions; the three functions are orthogonal on the grid.
    let squares = |n: f64, other: f64| (n * (n * n - 1.0) / 12.0 * other).max(1.0);
    [
        sums[0] / (w * h),
        sums[1] / squares(w, h),
        sums[2] / squares(h, w),
    ]
}

/// One turn of the unit circle in equal steps.
struct Turn(Vec<(f64, f64)>);

impl Turn {
    fn new(n: usize) -> Self {
        Self(
            (0..n)
                .map(|i| math::sin_cos(TAU * i as f64 / n as f64))
                .collect(),
        )
    }

    /// Sum of `values(i)` e^(-2πi k/n).
    fn transform(&self, k: usize, values: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
        let n = self.0.len();
        let (mut sum, mut angle) = ([0.0; 2], 0);
        for [re, im] in values {
            let (sin, cos) = self.0[angle];
            sum[0] += re * cos + im * sin;
            sum[1] += im * cos - re * sin;
            angle += k;
            if angle >= n {
                angle -= n;
            }
        }
        sum
    }
}

/// Coefficients 0..=`waves` of a windowed row.
fn row_transform(
    tile: &HeightGrid,
    y: usize,
    [mean, across, down]: [f64; 3],
    waves: usize,
) -> Vec<[f64; 2]> {
    let (w, h) = (tile.width, tile.height);
    let v = y as f64 - 0.5 * (h as f64 - 1.0);
    let vertical = hann(y, h);
    let windowed: Vec<f64> = tile
        .row(y)
        .iter()
        .enumerate()
        .map(|(x, &z)| {
            let u = x as f64 - 0.5 * (w as f64 - 1.0);
            (f64::from(z) - mean - across * u - down * v) * vertical * hann(x, w)
        })
        .collect();
    let turn = Turn::new(w);
    (0..=waves)
        .map(|k| turn.transform(k, windowed.iter().map(|&z| [z, 0.0])))
        .collect()
}

fn power(column: &[[f64; 2]], turn: &Turn, k: usize) -> f64 {
    let [re, im] = turn.transform(k, column.iter().copied());
    re * re + im * im
}

/// Hann's window at the middle of pixel `i` of `n`.
fn hann(i: usize, n: usize) -> f64 {
    let sin = math::sin(PI * (i as f64 + 0.5) / n as f64);
    sin * sin
}

/// Power in rings of the wave vector's length.
#[derive(Default)]
struct Rings {
    /// Weight, power and length of the wave vectors of each ring.
    sums: Vec<[f64; 3]>,
}

impl Rings {
    /// Counts a wave of frequency `f` in 1/m.
    fn add(&mut self, f: f64, power: f64, weight: f64) {
        if !(1.0 / LONGEST..1.0 / SHORTEST).contains(&f) {
            return;
        }
        let ring = (PER_OCTAVE * math::ln(f * LONGEST) / core::f64::consts::LN_2) as usize;
        if self.sums.len() <= ring {
            self.sums.resize(ring + 1, [0.0; 3]);
        }
        let sums = &mut self.sums[ring];
        sums[0] += weight;
        sums[1] += weight * power;
        sums[2] += weight * f;
    }

    /// The slope, turned around, of the line of least squares through log power over log frequency.
    fn exponent(&self) -> Option<f64> {
        let points: Vec<[f64; 2]> = self
            .sums
            .iter()
            .filter(|[weight, power, _]| *weight > 0.0 && *power > 0.0)
            .map(|[weight, power, f]| [math::ln(f / weight), math::ln(power / weight)])
            .collect();
        if points.len() < FEWEST {
            return None;
        }
        let n = points.len() as f64;
        let [mx, my] = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
        let covariance: f64 = points.iter().map(|p| (p[0] - mx) * (p[1] - my)).sum();
        let variance: f64 = points.iter().map(|p| (p[0] - mx) * (p[0] - mx)).sum();
        (variance > 0.0).then(|| -covariance / variance)
    }
}
