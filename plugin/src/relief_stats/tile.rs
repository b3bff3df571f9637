//! All figures of one tile.

use super::cells::is_whole;
use super::coherence::GradientCoherence;
use super::geomorphon::GeomorphonShares;
use super::pits::pits_percent;
use super::slope::slope_stats;
use super::slope_area::slope_area_exponent;
use super::spectrum::spectral_exponent;
use super::windows::window_relief;
use crate::query::HeightGrid;
use bevy::reflect::Reflect;

/// The relief of one tile.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize)]
pub struct ReliefStats {
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
    /// Coherence of the gradient in windows of 5.93 km; as [`GradientCoherence::of`].
    pub coherence: Option<GradientCoherence>,
    /// Exponent θ of slope ~ area^-θ from 0.316 to 100 km²; as [`slope_area_exponent`].
    pub slope_area_exponent: Option<f64>,
    /// Cells of 92.6 m that lie lower than all of their neighbours, in %; as [`pits_percent`].
    pub pits_percent: Option<f64>,
    /// Shares of the ten geomorphons; as [`GeomorphonShares::of`].
    pub geomorphons: Option<GeomorphonShares>,
}

impl ReliefStats {
    /// The figures of a tile; `None` of one with fewer than 3 x 3 values, whose values are not all
    /// finite, or whose size does not fit its values.
    ///
    /// ```
    /// use bevy_pangaea::query::HeightGrid;
    /// use bevy_pangaea::relief_stats::ReliefStats;
    ///
    /// // A ramp that climbs by 100 m from pixel to pixel of 100 m.
    /// let values = (0..400).map(|i| 100.0 * (i % 20) as f32).collect();
    /// let tile = HeightGrid { width: 20, height: 20, values, pixel_m: [100.0; 2] };
    /// let stats = ReliefStats::of(&tile).ok_or("a broken tile")?;
    /// assert!((stats.slope_mean_deg - 45.0).abs() < 0.01);
    /// assert_eq!(stats.relief10_median_m, None);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn of(tile: &HeightGrid) -> Option<Self> {
        if !is_whole(tile) {
            return None;
        }
        let [low, high] = tile.range()?.map(f64::from);
        let sum: f64 = tile.values.iter().map(|&z| f64::from(z)).sum();
        let mean = sum / tile.values.len() as f64;
        let windows = window_relief(tile);
        let slope = slope_stats(tile);
        Some(Self {
            elevation_m: [low, mean, high],
            relief10_median_m: windows.map(|windows| windows.median_m),
            relief10_max_m: windows.map(|windows| windows.max_m),
            slope_mean_deg: slope.mean_deg,
            slope_p90_deg: slope.p90_deg,
            hypsometric_integral: (high > low).then(|| (mean - low) / (high - low)),
            spectral_exponent: spectral_exponent(tile),
            coherence: GradientCoherence::of(tile),
            slope_area_exponent: slope_area_exponent(tile),
            pits_percent: pits_percent(tile),
            geomorphons: GeomorphonShares::of(tile),
        })
    }
}
