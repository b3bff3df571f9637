//! Which way water leaves every cell, and from how large an area it comes.
//!
//! Depressions are filled to the level at which they spill (priority-flood: Barnes, Lehman and
//! Mulla 2014), from the edges of the tile, where all water leaves. Water takes the steepest of the
//! eight ways down the filled ground (D8: O'Callaghan and Mark 1984); where that is level, the way
//! on which the flood came.

use super::neighbours::{NEIGHBOURS, neighbour_offsets};
use crate::query::HeightGrid;
use core::cmp::Reverse;
use std::collections::BinaryHeap;

/// The receiver of a cell at the edge.
const NO_CELL: u32 = u32::MAX;

/// The flow over the cells of a tile; columns have an entry per cell.
pub(super) struct CellFlow {
    /// Drop to the next cell by its distance; 0 at the edges of the tile and on level filled
    /// ground.
    pub slope: Vec<f32>,
    /// Cells whose water passes, itself included.
    pub upstream: Vec<u32>,
}

impl CellFlow {
    /// The flow over a tile of at least 3 x 3 cells.
    pub(super) fn of(cells: &HeightGrid) -> Self {
        let mut flood = CellFlood::new(cells);
        flood.seed_edges();
        flood.rise();
        let per_m = NEIGHBOURS.map(|step| 1.0 / step.length_m(cells.pixel_m));
        let mut slope = vec![0.0; cells.values.len()];
        let mut upstream = vec![1; cells.values.len()];
        // Lower cells are reached first: downstream comes before upstream.
        for &cell in flood.order.iter().rev() {
            let (receiver, steepest) = flood.way_down(cell, &per_m);
            slope[cell as usize] = steepest;
            if receiver != NO_CELL {
                upstream[receiver as usize] += upstream[cell as usize];
            }
        }
        Self { slope, upstream }
    }
}

/// A flood that rises from the edges of a tile.
struct CellFlood<'a> {
    cells: &'a HeightGrid,
    offsets: [usize; 8],
    /// Level of the filled ground in m; NaN where the flood has not come.
    level: Vec<f32>,
    /// The cell from which it came.
    from: Vec<u32>,
    /// Cells in the order in which they were reached.
    order: Vec<u32>,
    /// Ranks of levels in the upper halves, cells in the lower.
    shoreline: BinaryHeap<Reverse<u64>>,
}

impl<'a> CellFlood<'a> {
    fn new(cells: &'a HeightGrid) -> Self {
        let count = cells.values.len();
        Self {
            cells,
            offsets: neighbour_offsets(cells.width),
            level: vec![f32::NAN; count],
            from: vec![NO_CELL; count],
            order: Vec::with_capacity(count),
            shoreline: BinaryHeap::new(),
        }
    }

    fn seed_edges(&mut self) {
        let (width, height) = (self.cells.width, self.cells.height);
        for cell in 0..width * height {
            let (x, y) = (cell % width, cell / width);
            if x == 0 || y == 0 || x + 1 == width || y + 1 == height {
                self.reach(cell, NO_CELL, f32::NEG_INFINITY);
            }
        }
    }

    /// Reaches every cell, lowest first; equal levels go by number.
    fn rise(&mut self) {
        while let Some(Reverse(lowest)) = self.shoreline.pop() {
            let cell = lowest as u32;
            self.order.push(cell);
            let level = self.level[cell as usize];
            for by in self.offsets {
                // Steps beyond an edge end at no cell, or at another edge, which is reached.
                let next = (cell as usize).wrapping_add(by);
                if self.level.get(next).is_some_and(|level| level.is_nan()) {
                    self.reach(next, cell, level);
                }
            }
        }
    }

    /// The flood comes to a cell at a level.
    fn reach(&mut self, cell: usize, from: u32, level: f32) {
        let filled = self.cells.values[cell].max(level);
        self.level[cell] = filled;
        self.from[cell] = from;
        let key = u64::from(rank(filled)) << 32 | cell as u64;
        self.shoreline.push(Reverse(key));
    }

    /// The cell to which water goes, and how steeply; `per_m` is 1 by the distances of neighbours.
    fn way_down(&self, cell: u32, per_m: &[f32; 8]) -> (u32, f32) {
        let mut best = (self.from[cell as usize], 0.0);
        if best.0 == NO_CELL {
            return best;
        }
        for (by, per_m) in self.offsets.iter().zip(per_m) {
            let next = (cell as usize).wrapping_add(*by);
            let slope = (self.level[cell as usize] - self.level[next]) * per_m;
            if slope > best.1 {
                best = (next as u32, slope);
            }
        }
        best
    }
}

/// A number in the order of the levels.
fn rank(level: f32) -> u32 {
    let bits = level.to_bits();
    if bits >> 31 == 1 {
        !bits
    } else {
        bits | 1 << 31
    }
}

#[cfg(test)]
#[path = "flow_tests.rs"]
mod tests;
