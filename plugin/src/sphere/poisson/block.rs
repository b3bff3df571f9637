//! A block of neighbouring bands, filled with darts on one thread.

use super::bands::{BANDS_PER_BLOCK, Band, Bands};
use crate::random::{Stream, mix};
use bevy::math::DVec3;
use core::ops::Range;

/// Darts per cell. What is free after so many is too small to be seen.
const ROUNDS: u64 = 12;

/// Rounds in which only a quarter of the cells gets a dart, or the direction of the scan would
/// show.
const SPARSE_ROUNDS: u64 = 4;

/// A block that is being filled. Cells without a point hold the zero vector.
pub(super) struct Block<'a> {
    bands: &'a Bands,
    number: usize,
    own: Vec<DVec3>,
    /// The blocks that were filled before this one.
    done: &'a [Vec<DVec3>],
}

impl<'a> Block<'a> {
    /// An empty block.
    pub(super) fn new(bands: &'a Bands, number: usize, done: &'a [Vec<DVec3>]) -> Self {
        let mut block = Self {
            bands,
            number,
            own: Vec::new(),
            done,
        };
        let cells = bands.bands[block.range()].iter().map(|band| band.cells);
        block.own = vec![DVec3::ZERO; cells.sum()];
        block
    }

    /// The bands of this block.
    fn range(&self) -> Range<usize> {
        let start = self.number * BANDS_PER_BLOCK;
        start..(start + BANDS_PER_BLOCK).min(self.bands.bands.len())
    }

    /// Throws all darts and returns the points by cell.
    pub(super) fn filled(mut self, stream: Stream) -> Vec<DVec3> {
        let bands = self.bands;
        let range = self.range();
        let meridians: Vec<_> = bands.bands[range.clone()]
            .iter()
            .map(Band::meridians)
            .collect();
        for round in 0..ROUNDS {
            for (k, meridians) in range.clone().zip(&meridians) {
                for cell in 0..bands.bands[k].cells {
                    self.throw(stream, round, k, cell, meridians);
                }
            }
        }
        self.own
    }

    /// Throws the dart of one round into a cell of band `k`, if it is empty.
    fn throw(
        &mut self,
        stream: Stream,
        round: u64,
        k: usize,
        cell: usize,
        meridians: &[(f64, f64)],
    ) {
        let band = &self.bands.bands[k];
        let slot = band.first + cell;
        if self.own[slot] != DVec3::ZERO {
            return;
        }
        // Numbered by cell and round alone, so that no dart depends on what was hit before.
        let bits = stream.bits(mix((k as u64) << 32 | cell as u64) ^ round);
        if round < SPARSE_ROUNDS && (bits ^ round) & 3 != 0 {
            return;
        }
        let u = fraction(bits >> 2);
        let v = fraction(bits >> 33);
        let dart = band.point(meridians, cell, u, v);
        let turn = (cell as f64 + u) / band.cells as f64;
        if self.is_free(k, turn, dart) {
            self.own[slot] = dart;
        }
    }

    /// Whether no point lies within the distance of a dart thrown at `turn` (of a whole one) in
    /// band `k`.
    fn is_free(&self, k: usize, turn: f64, dart: DVec3) -> bool {
        let reach = self.bands.bands[k].reach;
        // Its own band first: there a dart that is not free most often meets a point. Numbers
        // beyond the poles wrap, and name no band.
        [k, k.wrapping_sub(1), k + 1, k.wrapping_sub(2), k + 2]
            .into_iter()
            .all(|near| self.is_free_in(near, turn, reach, dart))
    }

    /// Whether no point of band `k` within `reach` turns of a dart is too close to it.
    fn is_free_in(&self, k: usize, turn: f64, reach: f64, dart: DVec3) -> bool {
        let Some(band) = self.bands.bands.get(k) else {
            return true;
        };
        let points = self.points(k / BANDS_PER_BLOCK);
        if points.is_empty() {
            return true;
        }
        let cells = &points[band.first..band.first + band.cells];
        let chord2 = self.bands.chord2;
        let taken = |p: &DVec3| *p != DVec3::ZERO && (*p - dart).length_squared() < chord2;
        // Beside a pole every cell is near.
        if reach >= 0.5 {
            return !cells.iter().any(taken);
        }
        let near = band.cells_near(turn, reach).into_iter();
        !near.flat_map(|range| &cells[range]).any(taken)
    }

    /// The points of a block; an empty list for one that is not filled yet.
    fn points(&self, block: usize) -> &[DVec3] {
        if block == self.number {
            &self.own
        } else {
            &self.done[block]
        }
    }
}

/// A number in 0..1 from the 31 lowest bits.
fn fraction(bits: u64) -> f64 {
    (bits & 0x7fff_ffff) as f64 * (1.0 / 2_147_483_648.0)
}
