//! Relief statistics: how a piece of ground is shaped, in figures that real ground has, too.
//!
//! ```text
//! quantile   medians and percentiles
//! windows    range of the elevation in windows 10 km across
//! slope      mean and 90th percentile of the slope
//! spectrum   spectral exponent of wavelengths from 1.5 to 24 km
//! tile       all figures of one tile
//! sites      places on a planet by the orogeny that built their relief, drawn by its seed
//! ```
//!
//! The definitions are those of measured tiles of the Earth; a test holds them to published figures
//! of four tiles.

mod quantile;

mod windows;

mod slope;

mod spectrum;

mod tile;

mod sites;

pub use sites::{
    CLASSES, ReliefClass, SITES, SiteInput, TILE_M, TILE_PIXELS, class_relief, medians, sites,
};
pub use tile::ReliefStats;

#[cfg(all(test, feature = "dem"))]
mod tests;
