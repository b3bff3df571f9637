//! Pits: cells that lie lower than all of their eight neighbours.
//!
//! Rivers cut through what dams them up, so mountains have few: 0.1 to 0.4 % of cells of 92.6 m,
//! closed basins, lakes and flaws of the survey together. Surveys of plains have more, noise of
//! vegetation among it. Cells that are means of finer pixels in whole metres have more, too: means
//! break the ties of level ground.

use super::cells::on_cells;
use super::neighbours::neighbour_offsets;
use crate::query::HeightGrid;
use rayon::prelude::*;

/// Fewest cells to a side: one that has all neighbours.
const FEWEST_CELLS: usize = 3;

/// Pits in % of the cells of 92.6 m that have all neighbours; `None` of a tile that is broken or
/// coarser than 97 m.
///
/// ```
/// use bevy_pangaea::query::HeightGrid;
/// use bevy_pangaea::relief_stats::pits_percent;
///
/// let mut tile = HeightGrid { width: 12, height: 12, values: vec![5.0; 144], pixel_m: [92.6; 2] };
/// assert_eq!(pits_percent(&tile), Some(0.0));
/// tile.values[70] = 4.0;
/// assert_eq!(pits_percent(&tile), Some(1.0));
/// ```
pub fn pits_percent(tile: &HeightGrid) -> Option<f64> {
    let cells = on_cells(tile, FEWEST_CELLS)?;
    let [columns, rows] = [cells.width - 2, cells.height - 2];
    let offsets = neighbour_offsets(cells.width);
    let is_pit = |cell: usize| is_pit(&cells.values, cell, &offsets);
    let pits: usize = (1..=rows)
        .into_par_iter()
        .map(|y| {
            (1..=columns)
                .filter(|x| is_pit(y * cells.width + x))
                .count()
        })
        .sum();
    Some(100.0 * pits as f64 / (columns * rows) as f64)
}

/// Whether a cell that has all neighbours lies lower than they do.
fn is_pit(heights: &[f32], cell: usize, offsets: &[usize; 8]) -> bool {
    let mut around = offsets.iter().map(|&by| heights[cell.wrapping_add(by)]);
    around.all(|height| height > heights[cell])
}

#[cfg(test)]
#[path = "pits_tests.rs"]
mod tests;
