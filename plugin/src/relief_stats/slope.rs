//! Slope: the angle of the steepest descent.

use super::gradient::gradient;
use super::quantile::percentile;
use crate::math;
use crate::query::HeightGrid;
use rayon::prelude::*;

/// Slopes of a tile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlopeStats {
    /// Mean over the pixels in degrees.
    pub mean_deg: f64,
    /// 90th percentile in degrees, interpolated between ranks.
    pub p90_deg: f64,
}

/// The slopes of a tile of at least 2 x 2 values.
pub(super) fn slope_stats(tile: &HeightGrid) -> SlopeStats {
    let mut degrees: Vec<f32> = (0..tile.height)
        .into_par_iter()
        .flat_map_iter(|y| (0..tile.width).map(move |x| slope_at(tile, x, y)))
        .collect();
    let sum: f64 = degrees.iter().map(|&s| f64::from(s)).sum();
    SlopeStats {
        mean_deg: sum / degrees.len().max(1) as f64,
        p90_deg: percentile(&mut degrees, 0.9),
    }
}

/// Slope of a pixel in degrees.
fn slope_at(tile: &HeightGrid, x: usize, y: usize) -> f32 {
    let [to_east, to_south] = gradient(tile, x, y);
    let steepest = (to_east * to_east + to_south * to_south).sqrt();
    math::atan2(steepest, 1.0).to_degrees() as f32
}
