//! Relief in windows of 10 km: highest less lowest elevation.
//!
//! Windows are rectangles of whole pixels that do not exceed 10 km, placed every half window from
//! the north west corner, all within the tile.

use super::quantile::median;
use crate::query::HeightGrid;
use rayon::prelude::*;

/// Size of the windows in m.
const WINDOW_M: f64 = 10_000.0;

/// Relief of the windows of a tile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct WindowRelief {
    /// Median in m.
    pub median_m: f64,
    /// Largest in m.
    pub max_m: f64,
}

/// The relief in windows 10 km across; `None` if the tile is smaller, or a pixel larger than half a
/// window.
pub(super) fn window_relief(tile: &HeightGrid) -> Option<WindowRelief> {
    let [columns, rows] = tile.pixel_m.map(|pixel| (WINDOW_M / pixel) as usize);
    if columns < 2 || rows < 2 || columns > tile.width || rows > tile.height {
        return None;
    }
    let west = starts(tile.width, columns);
    let size = [columns, rows];
    let ranges: Vec<f64> = starts(tile.height, rows)
        .into_par_iter()
        .flat_map_iter(|north| {
            west.iter()
                .map(move |&west| f64::from(range(tile, [west, north], size)))
        })
        .collect();
    let max_m = ranges.iter().copied().fold(0.0, f64::max);
    Some(WindowRelief {
        median_m: median(ranges)?,
        max_m,
    })
}

/// Where windows begin along a side: every half window, all within the tile.
fn starts(side: usize, window: usize) -> Vec<usize> {
    (0..=side - window).step_by(window / 2).collect()
}

/// Highest less lowest elevation of a window in m.
fn range(tile: &HeightGrid, [west, north]: [usize; 2], [columns, rows]: [usize; 2]) -> f32 {
    let (mut low, mut high) = (f32::INFINITY, f32::NEG_INFINITY);
    for y in north..north + rows {
        for &z in &tile.row(y)[west..west + columns] {
            low = low.min(z);
            high = high.max(z);
        }
    }
    high - low
}
