//! Weighted Voronoi cells with warped distances.
//!
//! A border lies where the distances to two centroids, less their weights, are equal. Before
//! distances are compared a sample is displaced by octaves of noise. Two short cuts change no
//! answer: a block of samples looks at the centroids near it only, and octaves are added until what
//! the rest could add would not change the owner.

use crate::noise::{Noise, octave_position};
use crate::parallel::map_chunks;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

/// Samples that share one choice of nearby centroids. Samples follow a space-filling curve, so a
/// block is compact.
const BLOCK: usize = 128;

/// Longest displacement by an octave relative to its amplitude. Few are longer; a short limit lets
/// most samples do without the finer octaves.
const LONGEST: f64 = 0.65;

/// Most octaves of a border's warp.
const MAX_OCTAVES: u32 = 7;

/// Periods of the first octave per mean spacing of the centroids: a border between two triple
/// junctions bends about once.
const PERIODS_PER_SPACING: f64 = 0.9;

/// Periods of the finest octave per spacing of the samples. Finer ones would only make specks.
const PERIODS_PER_SAMPLE: f64 = 0.3;

/// Shifts between the three components of the displacement, in periods of the noise: components
/// that look at the same place would be equal. The same as in [`Noise::vector`].
const COMPONENT_SHIFTS: [f64; 3] = [0.0, 31.7, 73.1];

/// The index of the nearest centroid of each of `samples`, with warped distances.
///
/// `weights` (chord lengths, missing ones are 0) extend a centroid's cell. `warp` is the amplitude
/// of the warp relative to the distance of the centroids, 0 for plain cells. Sorted samples are
/// fastest. Cells may have stray pieces.
pub(super) fn warped_voronoi(
    mesh: &SphereMesh,
    samples: &[u32],
    centroids: &[DVec3],
    weights: &[f64],
    noise: &Noise,
    warp: f64,
) -> Vec<u16> {
    let cells = Cells::new(mesh, centroids, weights, noise, warp);
    let parts = map_chunks(samples.len(), |range| {
        let mut part = Vec::with_capacity(range.len());
        for block in samples[range].chunks(BLOCK) {
            let near = cells.near(mesh, block);
            part.extend(block.iter().map(|&i| cells.owner(mesh.point(i), &near)));
        }
        part
    });
    parts.concat()
}

/// A centroid that may own a sample.
#[derive(Clone, Copy)]
struct Cell {
    index: u16,
    centroid: DVec3,
    weight: f64,
}

impl Cell {
    fn distance(&self, p: DVec3) -> f64 {
        (p - self.centroid).length() - self.weight
    }
}

/// All centroids, and how samples are displaced before they are compared.
struct Cells<'a> {
    cells: Vec<Cell>,
    noise: &'a Noise,
    /// Displacement of the first octave; each further one has half of it.
    amplitude: f64,
    /// Periods of the first octave per rad.
    frequency: f64,
    octaves: u32,
}

impl<'a> Cells<'a> {
    fn new(
        mesh: &SphereMesh,
        centroids: &[DVec3],
        weights: &[f64],
        noise: &'a Noise,
        warp: f64,
    ) -> Self {
        let weights = weights.iter().copied().chain(core::iter::repeat(0.0));
        let cells = (0..).zip(centroids).zip(weights);
        let spacing = mean_spacing(centroids);
        let frequency = PERIODS_PER_SPACING / spacing;
        Self {
            cells: cells
                .map(|((index, &centroid), weight)| Cell {
                    index,
                    centroid,
                    weight,
                })
                .collect(),
            noise,
            amplitude: 2.0 * warp * spacing,
            frequency,
            octaves: if warp > 0.0 {
                resolved_octaves(mesh, frequency)
            } else {
                0
            },
        }
    }

    /// How far octaves from `octave` on can displace a sample.
    fn reach(&self, octave: u32) -> f64 {
        if octave < self.octaves {
            // Each octave has half of the one before: all that follow sum to no more than its
            // own.
            2.0 * LONGEST * self.amplitude / f64::from(1 << octave)
        } else {
            0.0
        }
    }

    /// The centroids that can own any sample of a block.
    fn near(&self, mesh: &SphereMesh, block: &[u32]) -> Vec<Cell> {
        let points = block.iter().map(|&i| mesh.point(i));
        let middle = points.clone().sum::<DVec3>() / block.len() as f64;
        let radius = points.map(|p| (p - middle).length()).fold(0.0, f64::max) + self.reach(0);
        let distances = self.cells.iter().map(|c| c.distance(middle));
        let nearest = distances.fold(f64::INFINITY, f64::min);
        // From the middle to any displaced sample both distances change by the radius at most; the
        // last term outweighs rounding.
        let limit = nearest + 2.0 * radius + 1e-9;
        let cells = self.cells.iter().copied();
        cells.filter(|c| c.distance(middle) <= limit).collect()
    }

    /// The centroid among `near` that owns the sample at `p`.
    fn owner(&self, p: DVec3, near: &[Cell]) -> u16 {
        let mut at = p;
        for octave in 0.. {
            let (index, gap) = closest(at, near);
            // The nearest distance can grow by the reach, the second shrink by as much.
            let reach = self.reach(octave);
            if reach == 0.0 || gap > 2.0 * reach {
                return index;
            }
            at += self.displacement(p, octave);
        }
        // Never reached: beyond the last octave the reach is 0.
        0
    }

    /// The displacement of the sample at `p` by one octave.
    fn displacement(&self, p: DVec3, octave: u32) -> DVec3 {
        let scale = f64::from(1 << octave);
        let q = octave_position(p, self.frequency * scale, octave);
        let push = COMPONENT_SHIFTS.map(|shift| self.noise.octave(q + DVec3::splat(shift)));
        DVec3::from_array(push).clamp_length_max(LONGEST) * (self.amplitude / scale)
    }
}

/// Number of octaves that the samples can show.
fn resolved_octaves(mesh: &SphereMesh, frequency: f64) -> u32 {
    let finest = PERIODS_PER_SAMPLE / mesh.spacing();
    let resolved = |octave: &u32| frequency * f64::from(1 << octave) <= finest;
    (0..MAX_OCTAVES).take_while(resolved).count() as u32
}

/// The index of the nearest cell, and how much farther the next one is.
fn closest(p: DVec3, near: &[Cell]) -> (u16, f64) {
    let mut index = 0;
    let mut first = f64::INFINITY;
    let mut second = f64::INFINITY;
    for cell in near {
        let d = cell.distance(p);
        // Of equals the first stays, which has the lower index.
        if d < first {
            second = first;
            first = d;
            index = cell.index;
        } else if d < second {
            second = d;
        }
    }
    (index, second - first)
}

/// Mean chord from a centroid to the nearest other one; 1 where there is no other.
fn mean_spacing(centroids: &[DVec3]) -> f64 {
    let count = centroids.len();
    let mean = (0..count).map(|k| nearest_other(centroids, k)).sum::<f64>() / count as f64;
    if mean.is_finite() {
        // Centroids at one place must not make the frequency infinite.
        mean.max(1e-4)
    } else {
        1.0
    }
}

/// Chord from centroid `k` to the nearest other one; infinite where there is no other.
fn nearest_other(centroids: &[DVec3], k: usize) -> f64 {
    let others = (0..centroids.len()).filter(|&other| other != k);
    let chords = others.map(|other| (centroids[k] - centroids[other]).length());
    chords.fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests;
