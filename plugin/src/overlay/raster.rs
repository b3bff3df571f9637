//! A picture in memory.

use bevy::prelude::*;

/// A picture of 8 bits per channel, rows from the top.
#[derive(Clone, Debug, Default, PartialEq, Eq, Reflect)]
pub struct Raster {
    /// Pixels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green and blue of every pixel in sRGB.
    pub rgb: Vec<u8>,
}
