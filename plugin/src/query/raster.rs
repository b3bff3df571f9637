//! Heights on squares, for exports, statistics and pictures.

use super::check::{check_count, check_length};
use super::error::GroundError;
use super::ground::Ground;
use super::level::{LEVELS, level_for};
use super::projection::AzimuthalEquidistant;
use crate::parallel;
use bevy::math::{DVec2, DVec3};
use bevy::reflect::Reflect;
use core::sync::atomic::{AtomicUsize, Ordering};
use rayon::prelude::*;

/// Smallest side of a pixel in m.
const LEAST_PIXEL_M: f64 = 1e-3;

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
        if level > LEVELS {
            Err(GroundError::Level(level))
        } else {
            Ok(Self {
                level: Some(level),
                ..self
            })
        }
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
        let from_middle = |k: usize| (k as f64 + 0.5 - 0.5 * self.pixels as f64) * self.pixel_m();
        self.projection
            .direction(DVec2::new(from_middle(column), -from_middle(row)))
    }

    /// Its own level, or the one whose edges are not longer than a pixel.
    pub fn level(&self) -> u8 {
        self.level
            .unwrap_or_else(|| level_for(self.projection.radius_m(), self.pixel_m()))
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
    /// As [`heights`](Self::heights), and [`GroundError::Stopped`].
    pub fn heights_while(
        &self,
        ground: &(impl Ground + ?Sized),
        level: u8,
        go_on: impl Fn(usize) -> bool + Sync,
    ) -> Result<HeightGrid, GroundError> {
        let mut values = vec![0.0_f32; self.pixels * self.pixels];
        let known = AtomicUsize::new(0);
        let batches = values.par_chunks_mut(parallel::CHUNK).enumerate();
        let results = batches.map(|(batch, heights)| {
            if !go_on(known.load(Ordering::Relaxed)) {
                return Err(GroundError::Stopped);
            }
            let directions = self.directions(batch * parallel::CHUNK, heights.len());
            ground.heights(&directions, level, heights)?;
            known.fetch_add(heights.len(), Ordering::Relaxed);
            Ok(())
        });
        // Collected first: which of several errors is told must not depend on the threads.
        let results: Vec<Result<(), GroundError>> = results.collect();
        results.into_iter().collect::<Result<(), GroundError>>()?;
        Ok(HeightGrid {
            width: self.pixels,
            height: self.pixels,
            values,
            pixel_m: [self.pixel_m(); 2],
        })
    }

    /// Unit vectors of so many pixels from the `first` on, row by row.
    fn directions(&self, first: usize, count: usize) -> Vec<DVec3> {
        (first..first + count)
            .map(|i| self.direction(i % self.pixels, i / self.pixels))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;
    use crate::query::checked;

    /// Heights of 10 m per degree of a coordinate.
    enum Degrees {
        OfLatitude,
        OfLongitude,
    }

    impl Ground for Degrees {
        fn radius_m(&self) -> f64 {
            RADIUS_M
        }

        fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
            let (lat, lon) = math::lat_lon(checked(direction, level)?);
            Ok(10.0
                * match self {
                    Self::OfLatitude => lat as f32,
                    Self::OfLongitude => lon as f32,
                })
        }
    }

    const RADIUS_M: f64 = 6_370_000.0;

    fn square(lat: f64, lon: f64, side_m: f64, pixels: usize) -> MapSquare {
        let about = AzimuthalEquidistant::new(lat, lon, RADIUS_M).unwrap();
        MapSquare::new(about, side_m, pixels).unwrap()
    }

    #[test]
    fn north_is_up_and_values_are_those_of_pixel_centres() {
        let degree = RADIUS_M * math::PI / 180.0;
        let square = square(30.0, 40.0, 8.0 * degree, 8);
        let lat = square.heights(&Degrees::OfLatitude, 5).unwrap();
        assert_eq!([lat.width, lat.height, lat.values.len()], [8, 8, 64]);
        // The middle column is half a pixel off the meridian; latitudes differ by a few hundredths
        // of a degree there.
        for y in 0..8 {
            let expected = 33.5 - y as f32;
            assert!((lat.row(y)[4] / 10.0 - expected).abs() < 0.02, "{y}");
        }
        let lon = square.heights(&Degrees::OfLongitude, 5).unwrap();
        assert!(lon.row(3).windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(lat.range().unwrap()[1], lat.row(0)[4].max(lat.row(0)[3]));
    }

    #[test]
    fn whoever_asks_hears_how_far_it_is_and_may_stop() {
        let (square, ground) = (square(30.0, 40.0, 1e6, 100), Degrees::OfLongitude);
        let heard = AtomicUsize::new(0);
        let listen = |pixels| heard.fetch_max(pixels, Ordering::Relaxed) <= 10_000;
        let grid = square.heights_while(&ground, 5, listen).unwrap();
        assert_eq!(Ok(grid), square.heights(&ground, 5));
        // The last batch begins when others are known; two threads may begin it together.
        assert!((1..10_000).contains(&heard.into_inner()));
        let stopped = square.heights_while(&ground, 5, |pixels| pixels < 4000);
        assert_eq!(stopped, Err(GroundError::Stopped));
    }

    #[test]
    fn levels_follow_pixels() {
        assert_eq!(square(0.0, 0.0, 60_004.8, 648).level(), 10);
        let fine = square(0.0, 0.0, 64.0, 128);
        assert_eq!(fine.level(), 17);
        assert_eq!(fine.at_level(9).unwrap().level(), 9);
        assert_eq!(fine.at_level(18), Err(GroundError::Level(18)));
    }

    #[test]
    fn bad_squares_and_levels_are_refused() {
        let map = AzimuthalEquidistant::new(0.0, 0.0, 50_000.0).unwrap();
        for side in [0.0, -1.0, f64::NAN, f64::INFINITY, 300_000.0] {
            let refused = MapSquare::new(map, side, 16);
            assert!(matches!(refused, Err(GroundError::Length { .. })), "{side}");
        }
        for pixels in [0, 1, 20_000, usize::MAX] {
            let refused = MapSquare::new(map, 1000.0, pixels);
            assert!(matches!(refused, Err(GroundError::Count { .. })));
        }
        let refused = square(0.0, 0.0, 1e5, 9).heights(&Degrees::OfLatitude, 18);
        assert_eq!(refused, Err(GroundError::Level(18)));
    }
}
