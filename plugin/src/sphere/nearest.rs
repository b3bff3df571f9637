//! The nearest sample of a direction, in constant time.
//!
//! A grid over the six faces of a cube, about two cells per sample, holds for each cell the sample
//! nearest to its centre. From there a walk moves to the nearest neighbour until none is nearer. On
//! a Delaunay triangulation such a walk ends at the nearest sample of all (Bose and Morin 2004).
//!
//! Tie policy: the least (distance, index) wins. Where four or more samples lie on one circle not
//! all of them are neighbours, so at a near tie all samples as near as that are looked at.

use super::{SphereMesh, chord_squared, cube};
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
const ROWS: usize = 16;

/// A start sample for every cell of the six faces.
#[derive(Clone, Default)]
pub(super) struct Grid {
    side: u32,
    seeds: Vec<u32>,
}

impl Grid {
    /// The grid over `mesh`, whose own grid may still be empty.
    pub(super) fn new(mesh: &SphereMesh) -> Self {
        let side = ((mesh.len() as f64 / 3.0).sqrt() as u32).max(1);
        let width = side as usize;
        let centre = |k: usize| (2.0 * k as f64 + 1.0) / f64::from(side) - 1.0;
        let axis: Vec<f64> = (0..width).map(|k| cube::unstretch(centre(k))).collect();
        let mut seeds = vec![0; 6 * width * width];
        seeds
            .par_chunks_mut(ROWS * width)
            .enumerate()
            .for_each(|(chunk, cells)| {
                let mut row_seed = 0;
                for (r, row) in cells.chunks_mut(width).enumerate() {
                    let row_index = chunk * ROWS + r;
                    let mut seed = row_seed;
                    for (column, cell) in row.iter_mut().enumerate() {
                        let face = (row_index / width) as u32;
                        let p = cube::unproject(face, axis[column], axis[row_index % width]);
                        seed = mesh.nearest_from(p.normalize(), seed);
                        *cell = seed;
                    }
                    row_seed = row.first().copied().unwrap_or(0);
                }
            });
        Self { side, seeds }
    }

    #[cfg(test)]
    pub(super) fn seeds(&self) -> &[u32] {
        &self.seeds
    }

    #[inline(always)]
    fn seed(&self, p: DVec3) -> u32 {
        let (face, u, v) = cube::project(p);
        let row = face * self.side + cube::cell(v, self.side);
        self.seeds[(row * self.side + cube::cell(u, self.side)) as usize]
    }
}

impl SphereMesh {
    /// The sample nearest to the unit vector `p`; of several, the one with the lowest index.
    #[inline]
    pub fn nearest(&self, p: DVec3) -> u32 {
        self.walk(p, self.grid.seed(p))
    }

    /// The sample nearest to the unit vector `p`, searched from the sample `hint`.
    ///
    /// Gives what [`nearest`](Self::nearest) gives. Cheaper than that if `hint` is next to `p`; the
    /// cost grows with the number of samples between.
    #[inline]
    pub fn nearest_from(&self, p: DVec3, hint: u32) -> u32 {
        self.walk(p, hint.min(self.points.len() as u32 - 1))
    }

    #[inline(always)]
    fn walk(&self, p: DVec3, start: u32) -> u32 {
        let mut at = start;
        let mut distance = chord_squared(p, self.points[at as usize]);
        while distance >= self.clearance {
            let (mut next, mut least) = (at, f64::INFINITY);
            for &j in self.rings.of(at) {
                let d = chord_squared(p, self.points[j as usize]);
                if d < least {
                    (next, least) = (j, d);
                }
            }
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
    fn better_of_tied(&self, p: DVec3, at: u32, distance: f64) -> Option<u32> {
        let limit = distance * (1.0 + NEAR_TIE);
        let mut tied = vec![at];
        let mut visited = 0;
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

#[cfg(test)]
#[path = "nearest_tests.rs"]
mod tests;
