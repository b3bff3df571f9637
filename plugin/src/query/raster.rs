//! Heights on squares, for exports, statistics and pictures.

use super::check::{check_count, check_length, check_level};
use super::error::GroundError;
use super::ground::Ground;
use super::level::raster_level;
use super::map_grid::{GridPoint, MapGrid};
use super::projection::AzimuthalEquidistant;
use crate::room::try_reserve;
use bevy::math::DVec3;
use bevy::reflect::Reflect;

/// Smallest side of a pixel in m.
pub(super) const LEAST_PIXEL_M: f64 = 1e-3;

/// A grid of heights in m, rows from the north, values at the centres of pixels.
#[derive(Clone, Debug, PartialEq, Reflect)]
pub struct HeightGrid {
    /// Number of columns.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// Heights in m, row by row.
    pub values: Vec<f32>,
    /// Size of a pixel in m, to the east and to the south.
    pub pixel_m: [f64; 2],
}

impl HeightGrid {
    /// Lowest and highest value; `None` of an empty grid.
    pub fn range(&self) -> Option<[f32; 2]> {
        let first = *self.values.first()?;
        Some(
            self.values
                .iter()
                .fold([first; 2], |[low, high], &z| [low.min(z), high.max(z)]),
        )
    }

    /// A row, from the west.
    pub fn row(&self, y: usize) -> &[f32] {
        &self.values[y * self.width..(y + 1) * self.width]
    }
}

/// A square of an [`AzimuthalEquidistant`] projection about its middle, north up.
///
/// ```
/// use bevy_pangaea::query::{AzimuthalEquidistant, MapSquare, PlanetGround, Rules};
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let ground = PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default())?;
/// let about = AzimuthalEquidistant::new(30.0, -12.0, 6_370_000.0)?;
/// let square = MapSquare::new(about, 2_000_000.0, 16)?;
/// let grid = square.heights(&ground, square.level())?;
/// assert_eq!((grid.width, grid.height), (16, 16));
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(opaque, Clone, Debug, PartialEq)]
pub struct MapSquare {
    projection: AzimuthalEquidistant,
    side_m: f64,
    pixels: usize,
    level: Option<u8>,
}

impl MapSquare {
    /// Most pixels to a side.
    pub const MAX_PIXELS: usize = 16_384;

    /// A square of `side_m` with `pixels` to a side about the middle of `projection`.
    ///
    /// # Errors
    /// [`GroundError::Length`] if the square is larger than the sphere, or smaller than a
    /// millimetre to a pixel; [`GroundError::Count`] outside of 2..=16,384 pixels.
    pub fn new(
        projection: AzimuthalEquidistant,
        side_m: f64,
        pixels: usize,
    ) -> Result<Self, GroundError> {
        check_count("the number of pixels", pixels, [2, Self::MAX_PIXELS])?;
        let least = pixels as f64 * LEAST_PIXEL_M;
        let most = AzimuthalEquidistant::largest_square(projection.radius_m());
        check_length("the side of the square", side_m, [least, most])?;
        Ok(Self {
            projection,
            side_m,
            pixels,
            level: None,
        })
    }

    /// The same at a level of its own, whatever its pixels are.
    ///
    /// # Errors
    /// [`GroundError::Level`] beyond the finest.
    pub fn at_level(self, level: u8) -> Result<Self, GroundError> {
        check_level(level)?;
        Ok(Self {
            level: Some(level),
            ..self
        })
    }

    /// The projection.
    pub fn projection(&self) -> &AzimuthalEquidistant {
        &self.projection
    }

    /// Side in m.
    pub fn side_m(&self) -> f64 {
        self.side_m
    }

    /// Pixels to a side.
    pub fn pixels(&self) -> usize {
        self.pixels
    }

    /// Side of a pixel in m.
    pub fn pixel_m(&self) -> f64 {
        self.side_m / self.pixels as f64
    }

    /// Unit vector of the centre of pixel (`column`, `row`), rows from the north.
    pub fn direction(&self, column: usize, row: usize) -> DVec3 {
        self.grid().direction(column, row)
    }

    /// The centres of its pixels, at its level.
    pub fn grid(&self) -> MapGrid {
        MapGrid::about(
            self.projection,
            self.pixel_m(),
            GridPoint::PixelCentre,
            [self.pixels; 2],
            self.level(),
        )
    }

    /// Its own level, or the one whose edges are not longer than a pixel; that is at least level 3.
    /// Every level shows the same land: its mean height is the same within 5 %.
    pub fn level(&self) -> u8 {
        self.level
            .unwrap_or_else(|| raster_level(self.projection.radius_m(), self.pixel_m()))
    }

    /// Heights at all pixels, in batches on all threads.
    ///
    /// # Errors
    /// As [`Ground::height`]: the error of the first batch that has one.
    pub fn heights(
        &self,
        ground: &(impl Ground + ?Sized),
        level: u8,
    ) -> Result<HeightGrid, GroundError> {
        self.heights_while(ground, level, |_| true)
    }

    /// The same for as long as `go_on` says so. It is told the number of pixels that are known
    /// before each batch, from any thread.
    ///
    /// # Errors
    /// As [`heights`](Self::heights), and [`GroundError::Stopped`]; [`GroundError::Memory`].
    pub fn heights_while(
        &self,
        ground: &(impl Ground + ?Sized),
        level: u8,
        go_on: impl Fn(usize) -> bool + Sync,
    ) -> Result<HeightGrid, GroundError> {
        let mut values = Vec::new();
        let grid = self.grid().at_level(level)?;
        grid.heights_by_bands(ground, go_on, |band| append(&mut values, band))?;
        Ok(HeightGrid {
            width: self.pixels,
            height: self.pixels,
            values,
            pixel_m: [self.pixel_m(); 2],
        })
    }
}

/// Adds a band to the values of a grid.
fn append(values: &mut Vec<f32>, band: &[f32]) -> Result<(), GroundError> {
    try_reserve(values, band.len()).map_err(|_| GroundError::Memory)?;
    values.extend_from_slice(band);
    Ok(())
}

#[cfg(test)]
#[path = "raster_tests.rs"]
mod tests;
