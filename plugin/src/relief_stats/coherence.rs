//! Coherence of the gradient: how far ridges and valleys of a piece of ground share one direction.
//!
//! ```text
//! J = Σ (g - ḡ)(g - ḡ)ᵀ over a window      structure tensor of the gradient g less its mean ḡ
//! coherence = (λ₁ - λ₂) / (λ₁ + λ₂)         λ₁ ≥ λ₂: eigenvalues of J
//! ```
//!
//! It is 1 where the ground varies one way alone, as corrugated iron does, and 0 where no direction
//! is favoured (Bigün and Granlund 1987; Jähne 1993, "Spatio-temporal image processing", §8). The
//! slope of the whole window is no fabric, so the mean gradient is taken off: an inclined plane has
//! no coherence, like level ground.
//!
//! Windows have 64 x 64 cells of 92.6 m and stand every half window, all within the tile. Gradients
//! are differences over two cells (over one at the edges of the tile). Measured mountains have
//! medians of 0.15 to 0.25, a forested plain has 0.09.

use super::cells::on_cells;
use super::gradient::gradient;
use super::quantile::percentile;
use crate::query::HeightGrid;
use bevy::reflect::Reflect;
use rayon::prelude::*;

/// Cells to a side of a window: 5.93 km.
const WINDOW: usize = 64;

/// Windows whose gradients differ from their mean by less than this (1 cm in 1 km, root mean
/// square) are planes: heights of 32 bits are no finer.
const LEAST_GRADIENT: f64 = 1e-5;

/// Coherence of the gradient over the windows of a tile.
///
/// ```
/// use bevy_pangaea::query::HeightGrid;
/// use bevy_pangaea::relief_stats::GradientCoherence;
///
/// // Ridges from north to south, one every 16 pixels.
/// let ridges = |i: usize| 50.0 * ((i % 100 % 16) as f32 - 8.0).abs();
/// let values = (0..10_000).map(ridges).collect();
/// let tile = HeightGrid { width: 100, height: 100, values, pixel_m: [92.6; 2] };
/// let found = GradientCoherence::of(&tile).ok_or("no fabric")?;
/// assert!((found.median - 1.0).abs() < 1e-9);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize)]
pub struct GradientCoherence {
    /// Median over the windows, 0 to 1.
    pub median: f64,
    /// 90th percentile over the windows, 0 to 1.
    pub p90: f64,
}

impl GradientCoherence {
    /// The coherence of a tile; `None` of one that is broken, coarser than 97 m or smaller than a
    /// window, and of one whose windows are all planes.
    pub fn of(tile: &HeightGrid) -> Option<Self> {
        let cells = on_cells(tile, WINDOW)?;
        let gradients = gradients(&cells);
        let west = starts(cells.width);
        let mut found: Vec<f32> = starts(cells.height)
            .into_par_iter()
            .flat_map_iter(|north| {
                let corners = west.iter().map(move |&west| [west, north]);
                corners.filter_map(|corner| coherence(&gradients, cells.width, corner))
            })
            .map(|coherence| coherence as f32)
            .collect();
        (!found.is_empty()).then(|| Self {
            median: percentile(&mut found, 0.5),
            p90: percentile(&mut found, 0.9),
        })
    }
}

/// Where windows begin along a side.
fn starts(side: usize) -> Vec<usize> {
    (0..=side - WINDOW).step_by(WINDOW / 2).collect()
}

/// The gradients of all cells, row by row.
fn gradients(cells: &HeightGrid) -> Vec<[f64; 2]> {
    (0..cells.height)
        .into_par_iter()
        .flat_map_iter(|y| (0..cells.width).map(move |x| gradient(cells, x, y)))
        .collect()
}

/// The coherence of a window; `None` of a plane.
fn coherence(gradients: &[[f64; 2]], width: usize, [west, north]: [usize; 2]) -> Option<f64> {
    let rows = (north..north + WINDOW).map(|y| &gradients[y * width + west..][..WINDOW]);
    let count = (WINDOW * WINDOW) as f64;
    let mut sums = [0.0; 2];
    for [x, y] in rows.clone().flatten() {
        sums[0] += x;
        sums[1] += y;
    }
    let mean = sums.map(|sum| sum / count);
    let [mut xx, mut xy, mut yy] = [0.0; 3];
    for g in rows.flatten() {
        let [x, y] = [g[0] - mean[0], g[1] - mean[1]];
        xx += x * x;
        xy += x * y;
        yy += y * y;
    }
    // Of a symmetric matrix, λ₁ + λ₂ is the trace, and this is λ₁ - λ₂.
    let difference = ((xx - yy) * (xx - yy) + 4.0 * xy * xy).sqrt();
    let least = count * LEAST_GRADIENT * LEAST_GRADIENT;
    (xx + yy > least).then(|| difference / (xx + yy))
}

#[cfg(test)]
#[path = "coherence_tests.rs"]
mod tests;
