//! A picture in memory.

use super::palette::Rgba;
use bevy::prelude::*;
use rayon::prelude::*;

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

impl Raster {
    /// A black picture.
    pub(super) fn black(width: u32, height: u32) -> Self {
        Self {
            width,
            height,
            rgb: vec![0; 3 * width as usize * height as usize],
        }
    }
}

/// Paints pictures of one size together: `places` finds what lies at the pixels of a row, `color`
/// the colour of such a place in the picture of a number.
pub(super) fn paint<P>(
    rasters: &mut [Raster],
    places: impl Fn(usize) -> Vec<P> + Sync,
    color: impl Fn(usize, &P) -> Rgba + Sync,
) {
    let rows = rows(rasters).into_par_iter().enumerate();
    rows.for_each(|(y, row)| {
        let places = places(y);
        for (k, pixels) in row.into_iter().enumerate() {
            for (out, place) in pixels.chunks_exact_mut(3).zip(&places) {
                out.copy_from_slice(&color(k, place)[..3]);
            }
        }
    });
}

/// Rows from the top, each with its pixels in every picture.
fn rows(rasters: &mut [Raster]) -> Vec<Vec<&mut [u8]>> {
    let mut rows: Vec<Vec<_>> = Vec::new();
    for raster in rasters {
        rows.resize_with(raster.height as usize, Vec::new);
        let pixels = raster.rgb.chunks_exact_mut(3 * raster.width as usize);
        for (row, pixels) in rows.iter_mut().zip(pixels) {
            row.push(pixels);
        }
    }
    rows
}
