//! The bins of a lattice: which samples lie in or near each. They never change.

use super::frame_set::insert;
use crate::ids::FrameId;
use crate::parallel;
use crate::sphere::SphereMesh;
use crate::sphere::cube::CubeGrid;
use crate::sphere::rows::Rows;
use bevy::math::DVec3;
use rayon::prelude::*;

/// Bins per unit of parallel work.
pub(super) const BINS_PER_TASK: usize = 64;

/// Reach of a sample in spacings. No point is farther from its nearest sample than the circumradius
/// of a triangle; Fibonacci triangles stay below one spacing, and random points are not resampled.
const SAMPLE_REACH: f64 = 1.1;

/// Fewest bins along the edge of a face.
const LEAST_BINS: f64 = 2.0;

/// Bins with the samples in or near each.
#[derive(Debug)]
pub(super) struct LatticeBins {
    grid: CubeGrid,
    /// Centre and radius, as a chord, of each bin.
    shape: Vec<(DVec3, f64)>,
    /// The samples in or near each bin, in order.
    near: Rows<u32>,
    /// Number of samples of the lattice.
    lattice: usize,
}

impl LatticeBins {
    /// Bins that are `width` samples wide, but no more than `most` along the edge of a face.
    pub(super) fn new(mesh: &SphereMesh, width: f64, most: f64) -> Self {
        let samples_per_edge = (mesh.len() as f64 / 6.0).sqrt();
        let grid = CubeGrid::new((samples_per_edge / width).clamp(LEAST_BINS, most) as usize);
        let shape = (0..grid.len()).map(|cell| (grid.center(cell), grid.radius(cell)));
        let near = near_pairs(mesh, grid);
        Self {
            grid,
            shape: shape.collect(),
            near: Rows::new(grid.len(), near.iter().flatten().copied()),
            lattice: mesh.len(),
        }
    }

    /// Number of bins; 0 before a lattice is known.
    pub(super) fn len(&self) -> usize {
        self.shape.len()
    }

    /// Number of samples of the lattice.
    pub(super) fn samples(&self) -> usize {
        self.lattice
    }

    #[inline]
    pub(super) fn grid(&self) -> &CubeGrid {
        &self.grid
    }

    /// Centre and radius, as a chord, of a bin.
    pub(super) fn shape(&self, cell: usize) -> (DVec3, f64) {
        self.shape[cell]
    }

    /// Marks in sets of `words` words which frames have samples in or near each bin.
    pub(super) fn mark(&self, frame: &[FrameId], words: usize, marks: &mut Vec<u64>) {
        marks.clear();
        marks.resize(self.grid.len() * words, 0);
        marks
            .par_chunks_mut(BINS_PER_TASK * words)
            .enumerate()
            .for_each(|(task, marks)| {
                for (cell, marks) in (task * BINS_PER_TASK..).zip(marks.chunks_mut(words)) {
                    for &i in self.near.row(cell) {
                        insert(marks, usize::from(frame[i as usize]));
                    }
                }
            });
    }
}

impl Default for LatticeBins {
    /// Bins of no lattice.
    fn default() -> Self {
        let grid = CubeGrid::new(1);
        Self {
            grid,
            shape: Vec::new(),
            near: Rows::new(grid.len(), core::iter::empty()),
            lattice: 0,
        }
    }
}

/// Pairs of bins and samples in or near them, in the order of samples.
fn near_pairs(mesh: &SphereMesh, grid: CubeGrid) -> Vec<Vec<(u32, u32)>> {
    let reach = SAMPLE_REACH * mesh.spacing();
    parallel::map_chunks(mesh.len(), |range| {
        // Half of the samples lie near a second bin or more.
        let mut near = Vec::with_capacity(range.len() * 3 / 2);
        for i in range {
            grid.visit_near(mesh.points()[i], reach, |cell| {
                near.push((cell as u32, i as u32));
            });
        }
        near
    })
}
