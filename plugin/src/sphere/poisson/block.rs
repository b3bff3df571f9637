//! A block of neighbouring bands, filled with darts on one thread.

use super::bands::{BANDS_PER_BLOCK, Band, Bands};
use crate::random::{Stream, mix};
use bevy::math::DVec3;
use core::ops::Range;

/// Darts per cell. Gaps that are left after so many are too small to be seen.
const ROUNDS: u64 = 12;

/// Rounds in which only a quarter of the cells gets a dart, or the direction of the scan would
/// show.
const SPARSE_ROUNDS: u64 = 4;

/// A block that is being filled. Cells without a point hold the zero vector.
pub(super) struct Block<'a> {
    bands: &'a Bands,
    number: usize,
    own: Vec<DVec3>,
    /// The cell of this block whose point was too close to the last dart at each cell: most often
    /// it is to the next one, too. [`NO_CELL`] where none is known.
    obstacles: Vec<u32>,
    /// The blocks that were filled before this one.
    done: &'a [Vec<DVec3>],
}

/// The number that stands for no cell of a block.
const NO_CELL: u32 = u32::MAX;

impl<'a> Block<'a> {
    /// An empty block.
    pub(super) fn new(bands: &'a Bands, number: usize, done: &'a [Vec<DVec3>]) -> Self {
        let mut block = Self {
            bands,
            number,
            own: Vec::new(),
            obstacles: Vec::new(),
            done,
        };
        let cells = bands.bands[block.range()].iter().map(|band| band.cells);
        block.own = vec![DVec3::ZERO; cells.sum()];
        block.obstacles = vec![NO_CELL; block.own.len()];
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
        let known = self.own.get(self.obstacles[slot] as usize);
        if known.is_some_and(|p| self.is_too_close(p, dart)) {
            return;
        }
        let turn = (cell as f64 + u) / band.cells as f64;
        match self.obstacle(k, turn, dart) {
            Some(obstacle) => self.obstacles[slot] = obstacle,
            None => self.own[slot] = dart,
        }
    }

    /// Whether there is a point, and a dart is closer to it than it may.
    fn is_too_close(&self, p: &DVec3, dart: DVec3) -> bool {
        *p != DVec3::ZERO && (*p - dart).length_squared() < self.bands.chord2
    }

    /// The cell of a point within the distance of a dart thrown at `turn` (of a whole one) in band
    /// `k`; [`NO_CELL`] for one of another block.
    fn obstacle(&self, k: usize, turn: f64, dart: DVec3) -> Option<u32> {
        let reach = self.bands.bands[k].reach;
        // Its own band first: there a dart that is not free most often meets a point. Numbers
        // beyond the poles wrap, and name no band.
        [k, k.wrapping_sub(1), k + 1, k.wrapping_sub(2), k + 2]
            .into_iter()
            .find_map(|near| self.obstacle_in(near, turn, reach, dart))
    }

    /// The cell of a point of band `k` within `reach` turns of a dart that is too close to it.
    fn obstacle_in(&self, k: usize, turn: f64, reach: f64, dart: DVec3) -> Option<u32> {
        let band = self.bands.bands.get(k)?;
        let block = k / BANDS_PER_BLOCK;
        let points = self.points(block);
        // A block that is not filled yet.
        if points.is_empty() {
            return None;
        }
        let cells = &points[band.first..band.first + band.cells];
        let taken = |&cell: &usize| self.is_too_close(&cells[cell], dart);
        // Beside a pole every cell is near.
        let found = if reach >= 0.5 {
            (0..cells.len()).find(taken)
        } else {
            band.cells_near(turn, reach)
                .into_iter()
                .flatten()
                .find(taken)
        };
        found.map(|cell| {
            if block == self.number {
                (band.first + cell) as u32
            } else {
                NO_CELL
            }
        })
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Purpose;

    /// The points of a block whose darts know of no earlier obstacle.
    fn filled_without_memory(mut block: Block, stream: Stream) -> Vec<DVec3> {
        let bands = block.bands;
        for round in 0..ROUNDS {
            for k in block.range() {
                let meridians = bands.bands[k].meridians();
                for cell in 0..bands.bands[k].cells {
                    block.obstacles.fill(NO_CELL);
                    block.throw(stream, round, k, cell, &meridians);
                }
            }
        }
        block.own
    }

    #[test]
    fn obstacles_that_are_remembered_change_no_point() {
        let bands = Bands::new(0.1);
        let stream = Stream::new(3, Purpose::BaseMesh, 0);
        let mut done = vec![Vec::new(); bands.block_count()];
        for number in 0..bands.block_count() {
            let fast = Block::new(&bands, number, &done).filled(stream);
            let slow = filled_without_memory(Block::new(&bands, number, &done), stream);
            assert_eq!(fast, slow, "{number}");
            // Some blocks have a filled neighbour, some have none.
            if number % 3 == 0 {
                done[number] = fast;
            }
        }
        assert!(done.iter().flatten().any(|p| *p != DVec3::ZERO));
    }
}
