//! GeoTIFF (OGC 19-008r4): one band of numbers, with its place, its unit and its voids. Numbers are
//! those that GDAL reads; what is not read is refused by the name of its tag or key.
//!
//! ```text
//! tag          the tags that are read, with their names
//! structure    directories and the values of their tags; BigTIFF; both byte orders
//! sample       types of samples
//! predictor    rows of differences
//! lzw, packbits, lerc    compressions; those of `codec` besides come from crates
//! codec        blocks to rows
//! layout       strips and tiles
//! rows         the numbers of an image, a row of a block at a time
//! mask         internal masks and opacity
//! nodata       the value that marks voids
//! keys         GeoKeys
//! units        units of length and angle
//! heights      the unit of heights
//! placement    where a raster lies
//! method       projections that a file defines
//! projection   how long a map's step is on the ground
//! epsg         systems that are newer than the table of the crate
//! system       coordinate systems
//! wkt          coordinate systems as text
//! citation     such a text among the keys
//! pam          GDAL's side file NAME.EXT.aux.xml
//! metadata     GDAL's scale, offset and unit
//! side_files   what files beside it tell
//! raster       all of it
//! ```
//!
//! Read are whole numbers of 1 to 32 and of 64 bits and floating-point ones of 16, 32 and 64;
//! compressed by Deflate, LZW, PackBits, Zstandard or LERC, or not; of any size up to 100,000 a
//! side. Memory holds a row, and of masks the rows of a tile, while values are handed on.

mod tag;

mod structure;

mod sample;

mod predictor;

mod lzw;

mod packbits;

mod lerc;

mod codec;

mod layout;

mod rows;

mod mask;

mod nodata;

mod keys;

mod units;

mod heights;

mod placement;

mod method;

mod projection;

mod epsg;

mod system;

mod wkt;

mod citation;

mod pam;

mod metadata;

mod side_files;

mod raster;

pub(in crate::io) use pam::PamFile;
pub(in crate::io) use raster::RasterFile;
pub(in crate::io) use side_files::{SideFiles, files_beside};

use super::error::DemError;
use super::shrink::ShrunkRaster;
use super::tile::{Dem, check_size};
use std::io::{Read, Seek};

/// Reads a file of heights.
pub(super) fn read(source: impl Read + Seek, beside: SideFiles) -> Result<Dem, DemError> {
    let mut raster = RasterFile::open(source, beside, check_size)?;
    let metres_per_unit = raster.metres_per_unit()?.unwrap_or(1.0);
    let (pixel_m, centre) = raster.ground()?;
    let mut heights = ShrunkRaster::new(raster.size(), raster.is_turned())?;
    raster.for_each_row([metres_per_unit, 0.0], |place, row| heights.add(place, row))?;
    heights.finish(pixel_m, centre)
}

#[cfg(test)]
mod tests;
