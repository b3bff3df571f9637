//! Boxes of latitudes and longitudes, across the date line and up to the poles.

use super::check::{check_count, check_radius, direction_at};
use super::error::GroundError;
use super::level::raster_level;
use super::map_grid::{GridPoint, GridProjection, MapGrid};
use super::raster::MapSquare;
use bevy::math::DVec2;
use bevy::reflect::Reflect;

/// A box in plate carrée: columns and rows are equally many degrees wide and high.
///
/// ```
/// use bevy_pangaea::query::DegreeBox;
///
/// // From 170° E across the date line to 170° W.
/// let fiji = DegreeBox::new([-20.0, 170.0, -10.0, -170.0], 6_370_000.0, [200, 100])?;
/// assert_eq!(fiji.bounds(), [-20.0, 170.0, -10.0, 190.0]);
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(opaque, Clone, Debug, PartialEq)]
pub struct DegreeBox {
    bounds: [f64; 4],
    radius_m: f64,
    pixels: [usize; 2],
}

impl DegreeBox {
    /// The box from `[south, west, north, east]` in degrees with so many columns and rows of
    /// pixels, on a sphere of `radius_m`. Where `west` is greater than `east` it goes across the
    /// date line.
    ///
    /// # Errors
    /// As [`unwrapped`](Self::unwrapped); [`GroundError::Radius`]; [`GroundError::Count`] outside
    /// of 1..=16,384 columns or rows.
    pub fn new(bounds: [f64; 4], radius_m: f64, pixels: [usize; 2]) -> Result<Self, GroundError> {
        check_radius(radius_m)?;
        let bounds = Self::unwrapped(bounds)?;
        let limits = [1, MapSquare::MAX_PIXELS];
        check_count("the number of columns", pixels[0], limits)?;
        check_count("the number of rows", pixels[1], limits)?;
        Ok(Self {
            bounds,
            radius_m,
            pixels,
        })
    }

    /// The bounds `[south, west, north, east]` with `east` east of `west`, beyond 180 if need be.
    ///
    /// # Errors
    /// [`GroundError::Latitude`], [`GroundError::Longitude`]; [`GroundError::Box`] if the box has
    /// no width or height, or is wider than 360 degrees.
    pub fn unwrapped(bounds: [f64; 4]) -> Result<[f64; 4], GroundError> {
        let [south, west, north, east] = bounds;
        direction_at(south, west)?;
        direction_at(north, east)?;
        if south >= north {
            let place = format!("from latitude {south} to {north}");
            return Err(GroundError::Box(
                "must reach from south to north, not",
                place,
            ));
        }
        let mut width = east - west;
        while width < 0.0 {
            width += 360.0;
        }
        if width == 0.0 || width > 360.0 {
            let place = format!("the {width} degrees from longitude {west} to {east}");
            return Err(GroundError::Box(
                "must be more than 0 and up to 360 degrees wide, not",
                place,
            ));
        }
        Ok([south, west, north, west + width])
    }

    /// The number of rows, at least one, with which pixels are as square in degrees as can be.
    ///
    /// # Errors
    /// As [`unwrapped`](Self::unwrapped).
    pub fn rows_for(columns: usize, bounds: [f64; 4]) -> Result<usize, GroundError> {
        let [south, west, north, east] = Self::unwrapped(bounds)?;
        let rows = columns as f64 * (north - south) / (east - west);
        Ok((rows.round() as usize).max(1))
    }

    /// South, west, north and east in degrees; the east may lie beyond 180.
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// Columns and rows.
    pub fn pixels(&self) -> [usize; 2] {
        self.pixels
    }

    /// The centres of its pixels, at the level whose edges are not longer than a pixel is wide at
    /// the equator or high.
    pub fn grid(&self) -> MapGrid {
        let [south, west, north, east] = self.bounds;
        let [columns, rows] = self.pixels.map(|n| n as f64);
        let step = DVec2::new((east - west) / columns, (north - south) / rows);
        let pixel_m = self.radius_m * step.min_element().to_radians();
        MapGrid {
            projection: GridProjection::PlateCarree {
                radius_m: self.radius_m,
            },
            middle: 0.5 * DVec2::new(west + east, south + north),
            step,
            point: GridPoint::PixelCentre,
            whole: self.pixels,
            first: [0, 0],
            size: self.pixels,
            level: raster_level(self.radius_m, pixel_m),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math;

    const R: f64 = 6_370_000.0;

    fn grid(bounds: [f64; 4], pixels: [usize; 2]) -> MapGrid {
        DegreeBox::new(bounds, R, pixels).unwrap().grid()
    }

    #[test]
    fn pixels_are_centred_in_equal_parts_of_the_box() {
        let planet = grid([-90.0, -180.0, 90.0, 180.0], [36, 18]);
        assert_eq!(planet.plane(0, 0), DVec2::new(-175.0, 85.0));
        assert_eq!(planet.plane(35, 17), DVec2::new(175.0, -85.0));
        let at = math::lat_lon(planet.direction(20, 3));
        assert!((at.0 - 55.0).abs() < 1e-9 && (at.1 - 25.0).abs() < 1e-9);
    }

    #[test]
    fn boxes_go_across_the_date_line() {
        for bounds in [[-5.0, 175.0, 5.0, -175.0], [-5.0, 175.0, 5.0, 185.0]] {
            let grid = grid(bounds, [10, 10]);
            assert_eq!(grid.plane(9, 0), DVec2::new(184.5, 4.5));
            let (_, lon) = math::lat_lon(grid.direction(9, 0));
            assert!((lon + 175.5).abs() < 1e-9, "{lon}");
        }
    }

    #[test]
    fn levels_follow_the_height_and_the_width_at_the_equator() {
        // A degree is 111 km, level 7 has edges of 0.4 km.
        assert_eq!(grid([0.0, 0.0, 0.05, 0.05], [10, 10]).level(), 7);
        assert_eq!(grid([0.0, 0.0, 0.05, 0.05], [10, 40]).level(), 9);
        assert_eq!(grid([0.0, 0.0, 0.05, 0.05], [40, 10]).level(), 9);
    }

    #[test]
    fn coarse_boxes_are_no_coarser_than_the_third_level() {
        assert_eq!(grid([0.0, 0.0, 10.0, 10.0], [10, 10]).level(), 3);
    }

    #[test]
    fn rows_make_pixels_square() {
        let rows = |columns, bounds| DegreeBox::rows_for(columns, bounds).unwrap();
        assert_eq!(rows(2048, [-90.0, -180.0, 90.0, 180.0]), 1024);
        assert_eq!(rows(100, [10.0, 170.0, 15.0, -170.0]), 25);
        assert_eq!(rows(100, [0.0, 0.0, 0.1, 360.0]), 1);
    }

    #[test]
    fn boxes_that_are_none_are_refused() {
        let refused = |bounds| DegreeBox::new(bounds, R, [8, 8]).unwrap_err();
        assert_eq!(
            refused([-91.0, 0.0, 0.0, 1.0]),
            GroundError::Latitude(-91.0)
        );
        assert_eq!(
            refused([0.0, 0.0, 1.0, 361.0]),
            GroundError::Longitude(361.0)
        );
        for bounds in [
            [5.0, 0.0, 5.0, 1.0],
            [6.0, 0.0, 5.0, 1.0],
            [0.0, 7.0, 5.0, 7.0],
            [0.0, 180.0, 5.0, -180.0],
            [0.0, -200.0, 5.0, 200.0],
        ] {
            assert!(
                matches!(refused(bounds), GroundError::Box(..)),
                "{bounds:?}"
            );
        }
        let none = DegreeBox::new([0.0, 0.0, 1.0, 1.0], R, [0, 5]);
        assert!(matches!(none, Err(GroundError::Count { .. })));
    }
}
