//! The exponent θ of the slope-area law: channels that carry more water are less steep,
//! slope ~ area^-θ (Flint 1974; Tarboton, Bras and Rodriguez-Iturbe 1991).
//!
//! Areas and slopes are those of the flow over the filled cells of 92.6 m. Logarithms of the slopes
//! are averaged in bins of the area, four to a factor of ten, from 0.316 km² (below it, slopes are
//! those of hillsides) to 100 km² (beyond it, a tile of 60 km has a few channels); θ is the slope,
//! turned around, of the line of least squares through the means.
//!
//! Limits. Level cells are left out: they are lakes, filled depressions, and the treads of stairs
//! that heights in whole metres make of valleys. Where such stairs are all that falls, as on a
//! plain, θ is near 0. Water that enters the tile from beyond its edges is missing.

use super::cells::on_cells;
use super::flow::CellFlow;
use super::line::falling_exponent;
use crate::math;
use crate::query::HeightGrid;

/// Smallest and largest area of the fit in km².
const AREAS_KM2: [f64; 2] = [0.316_227_766_016_838, 100.0];

/// Bins to a factor of ten of the area.
const BINS_PER_DECADE: f64 = 4.0;

/// Bins of the whole range.
const BINS: usize = 10;

/// Fewest cells of a bin that counts.
const FEWEST_CELLS: f64 = 10.0;

/// Fewest bins that a line is drawn through.
const FEWEST_BINS: usize = 4;

/// Fewest cells to a side of a tile.
const FEWEST_TO_A_SIDE: usize = 3;

/// The slope-area exponent θ of a tile; `None` of one that is broken, coarser than 97 m or too
/// small for four bins of areas, and of level ground.
///
/// ```
/// use bevy_pangaea::query::HeightGrid;
/// use bevy_pangaea::relief_stats::slope_area_exponent;
///
/// // Valleys 10 columns wide that fall to the south, n rows from their heads as steep as n^-1/2.
/// let height = |x: usize, n: usize| 40.0 * x.abs_diff(5) as f32 - 30.0 * (n as f32).sqrt();
/// let values = (0..10_000).map(|i| height(i % 10, i / 100)).collect();
/// let tile = HeightGrid { width: 100, height: 100, values, pixel_m: [92.6; 2] };
/// let theta = slope_area_exponent(&tile).ok_or("level ground")?;
/// assert!((theta - 0.5).abs() < 0.05);
/// # Ok::<(), &str>(())
/// ```
pub fn slope_area_exponent(tile: &HeightGrid) -> Option<f64> {
    let cells = on_cells(tile, FEWEST_TO_A_SIDE)?;
    let flow = CellFlow::of(&cells);
    let cell_km2 = cells.pixel_m[0] * cells.pixel_m[1] * 1e-6;
    let mut bins = [AreaBin::default(); BINS];
    let falling = flow
        .slope
        .iter()
        .zip(&flow.upstream)
        .filter(|(slope, _)| **slope > 0.0);
    for (&slope, &upstream) in falling {
        let area = f64::from(upstream) * cell_km2;
        if let Some(bin) = bin_of(area).and_then(|bin| bins.get_mut(bin)) {
            bin.add(area, f64::from(slope));
        }
    }
    let points: Vec<[f64; 2]> = bins.iter().filter_map(AreaBin::log_means).collect();
    (points.len() >= FEWEST_BINS).then(|| falling_exponent(&points))?
}

/// The bin of an area in km².
fn bin_of(area: f64) -> Option<usize> {
    let [least, most] = AREAS_KM2;
    let decades = math::ln(area / least) / core::f64::consts::LN_10;
    (least..most)
        .contains(&area)
        .then_some((BINS_PER_DECADE * decades) as usize)
}

/// Sums over the cells whose area is in one bin.
#[derive(Clone, Copy, Default)]
struct AreaBin {
    count: f64,
    log_area: f64,
    log_slope: f64,
}

impl AreaBin {
    fn add(&mut self, area: f64, slope: f64) {
        self.count += 1.0;
        self.log_area += math::ln(area);
        self.log_slope += math::ln(slope);
    }

    /// Mean logarithms of area and slope; `None` of few cells.
    fn log_means(&self) -> Option<[f64; 2]> {
        (self.count >= FEWEST_CELLS)
            .then(|| [self.log_area, self.log_slope].map(|sum| sum / self.count))
    }
}

#[cfg(test)]
#[path = "slope_area_tests.rs"]
mod tests;
