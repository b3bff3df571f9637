//! The nearest sample of a direction, in constant time.
//!
//! A grid over the six faces of a cube, about two cells per sample, holds for each cell the sample
//! nearest to its centre. From there a walk moves to the nearest neighbour until none is nearer. On
//! a Delaunay triangulation such a walk ends at the nearest sample of all (Bose and Morin 2004).
//!
//! Tie policy: the least (distance, index) wins. Where four or more samples lie on one circle not
//! all of them are neighbours, so at a near tie all samples as near as that are looked at.

use super::chord::chord_squared;
use super::cube;
use super::rings::NeighbourRings;
use crate::parallel::CHUNK;
use bevy::math::DVec3;
use rayon::prelude::*;

/// Relative difference of squared distances below which rounding may have hidden a nearer sample.
///
/// Much larger than any rounding error, and rare enough (about one query in a million) to cost
/// nothing.
const NEAR_TIE: f64 = 1e-6;

/// Most samples looked at in one tie. Only points off the sphere, such as its centre, have more.
const MAX_TIED: usize = 1024;

/// Rows of cells per unit of parallel work.
const ROWS_PER_TASK: usize = 16;

/// Walks over the neighbours of samples towards a direction.
#[derive(Clone, Copy)]
pub(super) struct Walk<'a> {
    pub(super) points: &'a [DVec3],
    pub(super) rings: &'a NeighbourRings,
    /// A point whose squared chord to a sample is below this has no nearer sample.
    pub(super) clearance: f64,
}

impl Walk<'_> {
    /// The sample nearest to the unit vector `p`, searched from the sample `start`.
    #[inline(always)]
    pub(super) fn nearest(self, p: DVec3, start: u32) -> u32 {
        let mut at = start;
        let mut distance = chord_squared(p, self.points[at as usize]);
        // Nearer than half of the closest two samples are apart, no other sample can be nearer.
        while distance >= self.clearance {
            let (mut next, mut least) = (at, f64::INFINITY);
            for &j in self.rings.of(at) {
                let d = chord_squared(p, self.points[j as usize]);
                if d < least {
                    (next, least) = (j, d);
                }
            }
            // No neighbour is nearer: the end, unless there is a tie.
            if least >= distance {
                if least > distance * (1.0 + NEAR_TIE) {
                    break;
                }
                let Some(better) = self.better_of_tied(p, at, distance) else {
                    break;
                };
                next = better;
                least = chord_squared(p, self.points[better as usize]);
            }
            (at, distance) = (next, least);
        }
        at
    }

    /// A sample of less (distance, index) than `at` among those about as near and connected to it.
    #[cold]
    #[inline(never)]
    fn better_of_tied(self, p: DVec3, at: u32, distance: f64) -> Option<u32> {
        let limit = distance * (1.0 + NEAR_TIE);
        let mut tied = vec![at];
        let mut visited = 0;
        // A flood over samples at the same distance: the better one may lie behind some of them.
        while visited < tied.len().min(MAX_TIED) {
            for &j in self.rings.of(tied[visited]) {
                let d = chord_squared(p, self.points[j as usize]);
                if d < distance || (d == distance && j < at) {
                    return Some(j);
                }
                if d <= limit && !tied.contains(&j) {
                    tied.push(j);
                }
            }
            visited += 1;
        }
        None
    }
}

/// A quarter of the smallest squared chord between neighbours: half way between the closest two
/// samples.
pub(super) fn clearance(points: &[DVec3], rings: &NeighbourRings) -> f64 {
    let samples = (0..points.len() as u32).into_par_iter().with_min_len(CHUNK);
    let smallest = samples
        .map(|i| nearest_neighbour(points, rings, i))
        .reduce(|| f64::INFINITY, f64::min);
    // The margin is far above rounding errors of either chord.
    0.25 * smallest * (1.0 - 1e-6)
}

/// Squared chord from sample `i` to the nearest of its neighbours.
fn nearest_neighbour(points: &[DVec3], rings: &NeighbourRings, i: u32) -> f64 {
    let chord = |&j: &u32| chord_squared(points[i as usize], points[j as usize]);
    rings.of(i).iter().map(chord).fold(f64::INFINITY, f64::min)
}

/// A sample to start a walk from, for every cell of the six faces.
#[derive(Clone)]
pub(super) struct SeedGrid {
    side: u32,
    seeds: Vec<u32>,
}

impl SeedGrid {
    /// The grid over the samples of `walk`.
    pub(super) fn new(walk: Walk) -> Self {
        let side = ((walk.points.len() as f64 / 3.0).sqrt() as u32).max(1);
        let centre = |k: u32| (2.0 * f64::from(k) + 1.0) / f64::from(side) - 1.0;
        let axis: Vec<f64> = (0..side).map(|k| cube::unstretch(centre(k))).collect();
        let width = axis.len();
        let mut seeds = vec![0; 6 * width * width];
        seeds
            .par_chunks_mut(ROWS_PER_TASK * width)
            .enumerate()
            .for_each(|(task, cells)| {
                let mut start = 0;
                for (row, cells) in (task * ROWS_PER_TASK..).zip(cells.chunks_mut(width)) {
                    seed_row(walk, &axis, row, start, cells);
                    start = cells.first().copied().unwrap_or(0);
                }
            });
        Self { side, seeds }
    }

    #[cfg(test)]
    pub(super) fn seeds(&self) -> &[u32] {
        &self.seeds
    }

    /// A sample near the direction `p`.
    #[inline(always)]
    pub(super) fn seed(&self, p: DVec3) -> u32 {
        let at = cube::stretched_project(p);
        let row = at.face * self.side + cube::stretched_cell(at.v, self.side);
        self.seeds[(row * self.side + cube::stretched_cell(at.u, self.side)) as usize]
    }
}

/// Finds the samples of one row of cells. Each search begins where the one before it ended, the
/// first at the sample `start`. `axis` holds the coordinates of the cells' centres.
fn seed_row(walk: Walk, axis: &[f64], row: usize, start: u32, cells: &mut [u32]) {
    let face = (row / axis.len()) as u32;
    let v = axis[row % axis.len()];
    let mut seed = start;
    for (cell, &u) in cells.iter_mut().zip(axis) {
        seed = walk.nearest(cube::unproject(face, u, v).normalize(), seed);
        *cell = seed;
    }
}

#[cfg(test)]
#[path = "nearest_tests.rs"]
mod tests;
