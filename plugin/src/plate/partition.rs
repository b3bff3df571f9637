//! Initial plates: a spherical Voronoi partition with warped distances (paper 000 §3).
//!
//! The distance of a sample to a centroid is the chord from the *displaced* sample, less the
//! centroid's weight. The displacement is a vector noise of several octaves, so borders are
//! irregular at every scale; weights make a few plates large and most of them small, as on Earth.
//!
//! Policies:
//! - A sample as near to two centroids belongs to the one with the lower index.
//! - A plate is one connected region. Its largest piece stays (the one with the lowest sample among
//!   equals), others go to what surrounds them.
//! - Every plate has a sample. One that got none takes the free sample nearest to its centroid.

mod regions;
mod sites;

pub use regions::{Regions, connected_regions, keep_connected};
pub(in crate::plate) use sites::{Site, cap_radius, first_or_best, motions, sites};

use super::motion::PlateMotion;
use crate::crust::FrameId;
use crate::noise::Noise;
use crate::parallel::map_chunks;
use crate::planet::PlanetRecipe;
use crate::random::Purpose;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

/// Samples that share one choice of nearby centroids. Samples follow a space-filling curve, so a
/// block is compact.
const BLOCK: usize = 128;

/// Longest displacement by an octave relative to its amplitude. Few are longer; a short limit lets
/// most samples do without the finer octaves.
const LONGEST: f64 = 0.65;

/// Most octaves of a border's warp.
const MAX_OCTAVES: i32 = 7;

/// The motions of the initial plates and the plate of every sample.
///
/// `recipe` is valid ([`PlanetRecipe::validate`]). Plate k is the k-th of `recipe.plates`, or one
/// of `recipe.plate_count` random ones, the largest first.
pub fn initial_plates(
    recipe: &PlanetRecipe,
    mesh: &SphereMesh,
) -> (Vec<PlateMotion>, Vec<FrameId>) {
    let sites = sites(recipe);
    let centroids: Vec<_> = sites.iter().map(|site| site.centroid).collect();
    let weights: Vec<_> = sites.iter().map(|site| site.weight).collect();
    let samples: Vec<u32> = (0..mesh.len() as u32).collect();
    let noise = Noise::new(recipe.seed, Purpose::BorderWarp, 0);
    let warp = recipe.params.border_warp;
    let mut owner = warped_voronoi(mesh, &samples, &centroids, &weights, &noise, warp);
    seed_empty(mesh, &centroids, &mut owner);
    keep_connected(mesh, &samples, &mut owner);
    (motions(recipe, &sites), owner)
}

/// The index of the nearest centroid of each of `samples`, with warped distances.
///
/// `weights` (chord lengths, missing ones are 0) extend a centroid's cell: a border lies where the
/// distances less the weights are equal. `warp` is the amplitude of the warp relative to the
/// distance of the centroids, 0 for plain cells. Sorted samples are fastest. Cells may have stray
/// pieces; [`keep_connected`] removes them.
pub fn warped_voronoi(
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
    frequency: f64,
    octaves: i32,
}

impl<'a> Cells<'a> {
    fn new(
        mesh: &SphereMesh,
        centroids: &[DVec3],
        weights: &[f64],
        noise: &'a Noise,
        warp: f64,
    ) -> Self {
        let cell = |(k, &centroid): (usize, &DVec3)| {
            let weight = weights.get(k).copied().unwrap_or(0.0);
            Cell {
                index: k as u16,
                centroid,
                weight,
            }
        };
        let spacing = mean_spacing(centroids);
        let frequency = 0.9 / spacing;
        // Octaves finer than the samples would only make specks.
        let finest = 0.3 / mesh.spacing();
        let resolved = |octave: &i32| frequency * f64::from(1 << octave) <= finest;
        let octaves = if warp > 0.0 {
            (0..MAX_OCTAVES).take_while(resolved).count() as i32
        } else {
            0
        };
        let cells = centroids.iter().enumerate().map(cell).collect();
        Self {
            cells,
            noise,
            amplitude: 2.0 * warp * spacing,
            frequency,
            octaves,
        }
    }

    /// How far octaves from `octave` on can displace a sample.
    fn reach(&self, octave: i32) -> f64 {
        if octave < self.octaves {
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
        let nearest = self
            .cells
            .iter()
            .map(|c| c.distance(middle))
            .fold(f64::INFINITY, f64::min);
        let limit = nearest + 2.0 * radius + 1e-9;
        self.cells
            .iter()
            .filter(|c| c.distance(middle) <= limit)
            .copied()
            .collect()
    }

    /// The centroid among `near` that owns the sample at `p`.
    ///
    /// Octaves are added one by one until the rest cannot change the answer.
    fn owner(&self, p: DVec3, near: &[Cell]) -> u16 {
        let mut at = p;
        for octave in 0.. {
            let (index, gap) = closest(at, near);
            let reach = self.reach(octave);
            if reach == 0.0 || gap > 2.0 * reach {
                return index;
            }
            let scale = f64::from(1 << octave);
            let q = p * (self.frequency * scale) + DVec3::splat(17.3 * f64::from(octave + 1));
            let part = |shift: f64| self.noise.octave(q + DVec3::splat(shift));
            let push = DVec3::new(part(0.0), part(31.7), part(73.1));
            at += push.clamp_length_max(LONGEST) * (self.amplitude / scale);
        }
        0
    }
}

/// The index of the nearest cell, and how much farther the next one is.
fn closest(p: DVec3, near: &[Cell]) -> (u16, f64) {
    let (mut index, mut first, mut second) = (0, f64::INFINITY, f64::INFINITY);
    for cell in near {
        let d = cell.distance(p);
        if d < first {
            (second, first, index) = (first, d, cell.index);
        } else if d < second {
            second = d;
        }
    }
    (index, second - first)
}

/// Mean chord from a centroid to the nearest other one; 1 where there is no other.
fn mean_spacing(centroids: &[DVec3]) -> f64 {
    let nearest = |a: usize| {
        let others = (0..centroids.len()).filter(|&b| b != a);
        others
            .map(|b| (centroids[a] - centroids[b]).length())
            .fold(f64::INFINITY, f64::min)
    };
    let mean = (0..centroids.len()).map(nearest).sum::<f64>() / centroids.len() as f64;
    if mean.is_finite() {
        mean.max(1e-4)
    } else {
        1.0
    }
}

/// Gives each plate without a sample the nearest one to its centroid that another plate can spare.
fn seed_empty(mesh: &SphereMesh, centroids: &[DVec3], owner: &mut [u16]) {
    let mut count = vec![0_u32; centroids.len()];
    owner
        .iter()
        .for_each(|&plate| count[usize::from(plate)] += 1);
    for (plate, &centroid) in centroids.iter().enumerate() {
        if count[plate] > 0 {
            continue;
        }
        let spare = |&i: &u32| count[usize::from(owner[i as usize])] > 1;
        let far = |&i: &u32| (mesh.point(i) - centroid).length_squared();
        let samples = (0..mesh.len() as u32).filter(spare);
        if let Some(i) = samples.min_by(|a, b| far(a).total_cmp(&far(b))) {
            count[usize::from(owner[i as usize])] -= 1;
            count[plate] = 1;
            owner[i as usize] = plate as u16;
        }
    }
}

#[cfg(test)]
mod tests;
