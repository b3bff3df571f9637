//! Slope: the angle of the steepest descent, by differences over two pixels (over one at the edges
//! of the tile).

use crate::math;
use crate::query::HeightGrid;
use rayon::prelude::*;

/// Slopes of a tile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Mean over the pixels in degrees.
    pub mean_deg: f64,
    /// 90th percentile in degrees, interpolated between ranks.
    pub p90_deg: f64,
}

/// The slopes of a tile of at least 2 x 2 values.
pub fn slope(tile: &HeightGrid) -> Slope {
    let mut degrees: Vec<f32> = (0..tile.height)
        .into_par_iter()
        .flat_map_iter(|y| (0..tile.width).map(move |x| at(tile, x, y)))
        .collect();
    let mean_deg = degrees.iter().map(|&s| f64::from(s)).sum::<f64>() / degrees.len().max(1) as f64;
    Slope {
        mean_deg,
        p90_deg: percentile(&mut degrees, 0.9),
    }
}

fn at(tile: &HeightGrid, x: usize, y: usize) -> f32 {
    let (west, east) = (x.saturating_sub(1), (x + 1).min(tile.width - 1));
    let (north, south) = (y.saturating_sub(1), (y + 1).min(tile.height - 1));
    let rise = |a: f32, b: f32, steps: usize, pixel: f64| {
        (f64::from(b) - f64::from(a)) / (steps.max(1) as f64 * pixel)
    };
    let to_east = rise(
        tile.row(y)[west],
        tile.row(y)[east],
        east - west,
        tile.pixel_m[0],
    );
    let to_south = rise(
        tile.row(north)[x],
        tile.row(south)[x],
        south - north,
        tile.pixel_m[1],
    );
    math::atan2((to_east * to_east + to_south * to_south).sqrt(), 1.0).to_degrees() as f32
}

/// The value that a share of `values` does not exceed, interpolated between ranks; 0 of nothing.
fn percentile(values: &mut [f32], share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let rank = share * (values.len() - 1) as f64;
    let (_, &mut low, above) = values.select_nth_unstable_by(rank as usize, f32::total_cmp);
    let high = above.iter().copied().min_by(f32::total_cmp).unwrap_or(low);
    f64::from(low) + (rank - rank.floor()) * (f64::from(high) - f64::from(low))
}
