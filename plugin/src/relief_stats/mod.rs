//! Relief statistics: how a piece of ground is shaped, in figures that real ground has, too.
//!
//! ```text
//! windows    range of the elevation in windows 10 km across
//! slope      mean and 90th percentile of the slope
//! spectrum   spectral exponent of wavelengths from 1.5 to 24 km
//! sites      places on a planet by what built their relief, drawn by its seed
//! ```
//!
//! The definitions are those of measured tiles of the Earth; a test holds them to published figures
//! of four tiles.

mod sites;

mod slope;

mod spectrum;

mod windows;

pub use sites::{
    CLASSES, ReliefClass, SITES, SiteInput, TILE_M, TILE_PIXELS, class_relief, medians, sites,
};
pub use slope::{Slope, slope};
pub use spectrum::spectral_exponent;
pub use windows::{WINDOW_M, WindowRelief, window_relief};

use crate::query::HeightGrid;

/// The relief of one tile.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Relief {
    /// Lowest, mean and highest elevation in m.
    pub elevation_m: [f64; 3],
    /// Median of the range of elevation in windows 10 km across, in m; `None` of a tile that is
    /// smaller.
    pub relief10_median_m: Option<f64>,
    /// Largest such range in m.
    pub relief10_max_m: Option<f64>,
    /// Mean slope in degrees.
    pub slope_mean_deg: f64,
    /// Slope in degrees that a tenth of the tile exceeds.
    pub slope_p90_deg: f64,
    /// Hypsometric integral: (mean - lowest) / (highest - lowest); `None` of level ground.
    pub hypsometric_integral: Option<f64>,
    /// Exponent β of the power spectrum k^-β from 1.5 to 24 km; `None` where the tile has no such
    /// wavelengths.
    pub spectral_exponent: Option<f64>,
}

/// Computes the figures of a tile; `None` of one with fewer than 3 x 3 values, whose values are not
/// all finite, or whose size does not fit its values.
pub fn relief(tile: &HeightGrid) -> Option<Relief> {
    let sane = tile.width >= 3 && tile.height >= 3 && tile.values.len() == tile.width * tile.height;
    let measured = tile
        .pixel_m
        .iter()
        .all(|&pixel| pixel > 0.0 && pixel.is_finite());
    if !sane || !measured || !tile.values.iter().all(|z| z.is_finite()) {
        return None;
    }
    let [low, high] = tile.range()?.map(f64::from);
    let mean = tile.values.iter().map(|&z| f64::from(z)).sum::<f64>() / tile.values.len() as f64;
    let windows = window_relief(tile);
    let slope = slope(tile);
    Some(Relief {
        elevation_m: [low, mean, high],
        relief10_median_m: windows.map(|windows| windows.median_m),
        relief10_max_m: windows.map(|windows| windows.max_m),
        slope_mean_deg: slope.mean_deg,
        slope_p90_deg: slope.p90_deg,
        hypsometric_integral: (high > low).then(|| (mean - low) / (high - low)),
        spectral_exponent: spectral_exponent(tile),
    })
}

/// The median: the mean of the two middle values of an even number. Not a number goes last; `None`
/// of nothing.
pub fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    let upper = *values.get(middle)?;
    Some(if values.len() % 2 == 1 {
        upper
    } else {
        0.5 * (values[middle - 1] + upper)
    })
}

#[cfg(all(test, feature = "dem"))]
mod tests;
