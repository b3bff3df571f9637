//! Relief in windows of 10 km: highest less lowest elevation.
//!
//! Windows are rectangles of whole pixels that do not exceed 10 km, placed every half window from
//! the north west corner, all within the tile.

use super::median;
use crate::query::HeightGrid;
use rayon::prelude::*;

/// Size of the windows in m.
pub const WINDOW_M: f64 = 10_000.0;

/// Relief of the windows of a tile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindowRelief {
    /// Median in m.
    pub median_m: f64,
    /// Largest in m.
    pub max_m: f64,
}

/// The relief in windows 10 km across; `None` if the tile is smaller, or a pixel larger than half a
/// window.
pub fn window_relief(tile: &HeightGrid) -> Option<WindowRelief> {
    let [columns, rows] = tile.pixel_m.map(|pixel| (WINDOW_M / pixel) as usize);
    if columns < 2 || rows < 2 || columns > tile.width || rows > tile.height {
        return None;
    }
    let starts =
        |size: usize, window: usize| (0..=size - window).step_by(window / 2).collect::<Vec<_>>();
    let west = starts(tile.width, columns);
    let ranges: Vec<f64> = starts(tile.height, rows)
        .into_par_iter()
        .flat_map_iter(|north| {
            west.iter()
                .map(move |&west| f64::from(range(tile, [west, north], [columns, rows])))
        })
        .collect();
    let max_m = ranges.iter().copied().fold(0.0, f64::max);
    Some(WindowRelief {
        median_m: median(ranges)?,
        max_m,
    })
}

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
