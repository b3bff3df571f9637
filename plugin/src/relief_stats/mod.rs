//! Relief statistics: how a piece of ground is shaped, in figures that real ground has, too.
//!
//! ```text
//! quantile     medians and percentiles
//! line         the line of least squares through points of a power law
//! gradient     rise to the east and to the south
//! windows      range of the elevation in windows 10 km across
//! slope        mean and 90th percentile of the slope
//! spectrum     spectral exponent of wavelengths from 1.5 to 24 km
//! cells        the tile on cells of 92.6 m, for the figures that follow
//! neighbours   the eight neighbours of a cell
//! coherence    how far ridges and valleys share one direction
//! pits         cells lower than all of their neighbours
//! flow         depressions filled, steepest descent, areas upstream
//! slope_area   exponent of the slope over the area upstream
//! geomorphon   shares of ten forms of the land, and how far two tiles differ in them
//! tile         all figures of one tile
//! sites        places on a planet by the orogeny that built their relief, drawn by its seed
//! ```
//!
//! The definitions are those of measured tiles of the Earth; a test holds them to published figures
//! of four tiles.

mod quantile;

mod line;

mod gradient;

mod windows;

mod slope;

mod spectrum;

mod cells;

mod neighbours;

mod coherence;

mod pits;

mod flow;

mod slope_area;

mod geomorphon;

mod tile;

mod sites;

pub use coherence::GradientCoherence;
pub use geomorphon::{Geomorphon, GeomorphonShares};
pub use pits::pits_percent;
pub use sites::{
    ReliefClass, SITES, SiteInput, TILE_M, TILE_PIXELS, class_relief, median_of, medians, sites,
};
pub use slope_area::slope_area_exponent;
pub use tile::ReliefStats;

#[cfg(all(test, feature = "dem"))]
mod tests;
