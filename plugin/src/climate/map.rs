//! A user's map: equirectangular, north up, longitude -180 at the left edge.
//!
//! A pixel stands for the point at its centre; between pixels values are bilinear, around the date
//! line they join, and beyond the first and last row they stay as they are.

use crate::math;
use bevy::math::DVec3;
use core::ops::RangeInclusive;
use std::sync::Arc;

/// Numbers on an equirectangular grid. Clones share them.
#[derive(Clone, Debug)]
pub struct EquirectMap {
    width: u32,
    height: u32,
    values: Arc<Vec<f32>>,
}

impl PartialEq for EquirectMap {
    fn eq(&self, other: &Self) -> bool {
        // Settings are compared in every frame, and mostly with their own clone.
        self.size() == other.size()
            && (Arc::ptr_eq(&self.values, &other.values) || self.values == other.values)
    }
}

/// Why a map was refused.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum MapError {
    /// A side is 0 or too long.
    #[error("a map of {0} x {1} pixels; sides are 1 to {max}", max = EquirectMap::MAX_SIDE)]
    Size(u32, u32),
    /// The map is not twice as wide as high.
    #[error("a map of {0} x {1} pixels is not twice as wide as high")]
    Shape(u32, u32),
    /// Number of values and size do not fit.
    #[error("{given} values for {wanted} pixels")]
    Count {
        /// Values given.
        given: usize,
        /// Pixels of the map.
        wanted: usize,
    },
    /// A value is not a number or infinite.
    #[error("the value of pixel {0} is not a finite number")]
    NotFinite(usize),
    /// A value is outside of what the map can mean.
    #[error("{what} is {value} at pixel {pixel}; it must be {allowed}")]
    Range {
        /// What the map shows.
        what: &'static str,
        /// The refused value.
        value: f32,
        /// Its pixel, counted in rows from the top.
        pixel: usize,
        /// What would be allowed.
        allowed: &'static str,
    },
}

impl EquirectMap {
    /// Longest side in pixels.
    pub const MAX_SIDE: u32 = 32_768;

    /// A map of `width` x `height` pixels, rows from the top.
    ///
    /// # Errors
    /// [`MapError`] for a size that is out of range or not 2 to 1, a wrong number of values, and
    /// values that are not finite.
    pub fn new(width: u32, height: u32, values: Vec<f32>) -> Result<Self, MapError> {
        Self::check_size(width, height)?;
        let wanted = width as usize * height as usize;
        if values.len() != wanted {
            return Err(MapError::Count {
                given: values.len(),
                wanted,
            });
        }
        match values.iter().position(|v| !v.is_finite()) {
            Some(pixel) => Err(MapError::NotFinite(pixel)),
            None => Ok(Self {
                width,
                height,
                values: Arc::new(values),
            }),
        }
    }

    /// Refuses sizes of which there is no map.
    ///
    /// # Errors
    /// [`MapError::Size`], [`MapError::Shape`].
    pub fn check_size(width: u32, height: u32) -> Result<(), MapError> {
        let side = 1..=Self::MAX_SIDE;
        if !side.contains(&width) || !side.contains(&height) {
            return Err(MapError::Size(width, height));
        }
        if width == 2 * height {
            Ok(())
        } else {
            Err(MapError::Shape(width, height))
        }
    }

    /// A map of `value(latitude, longitude)` in degrees at the centres of `2 height` x `height`
    /// pixels.
    ///
    /// # Errors
    /// As [`EquirectMap::new`].
    pub fn from_fn(height: u32, value: impl Fn(f64, f64) -> f32) -> Result<Self, MapError> {
        if height == 0 || height > Self::MAX_SIDE / 2 {
            return Err(MapError::Size(height.saturating_mul(2), height));
        }
        let step = 180.0 / f64::from(height);
        let row = |y: u32| 90.0 - (f64::from(y) + 0.5) * step;
        let column = |x: u32| (f64::from(x) + 0.5) * step - 180.0;
        let value = &value;
        let values = (0..height)
            .flat_map(|y| (0..2 * height).map(move |x| value(row(y), column(x))))
            .collect();
        Self::new(2 * height, height, values)
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Refuses a given map of `what` with a value outside of `range`, which `allowed` puts into
    /// words.
    pub(crate) fn check(
        given: Option<&Self>,
        what: &'static str,
        range: RangeInclusive<f32>,
        allowed: &'static str,
    ) -> Result<(), MapError> {
        let values = given.into_iter().flat_map(|map| map.values.iter());
        match (0..).zip(values).find(|(_, value)| !range.contains(value)) {
            Some((pixel, &value)) => Err(MapError::Range {
                what,
                value,
                pixel,
                allowed,
            }),
            None => Ok(()),
        }
    }

    /// The value at the unit direction `p`.
    pub fn at(&self, p: DVec3) -> f32 {
        let (lat, lon) = math::lat_lon(p);
        let y = ((90.0 - lat) / 180.0 * f64::from(self.height) - 0.5)
            .clamp(0.0, f64::from(self.height - 1));
        let x = (lon + 180.0) / 360.0 * f64::from(self.width) - 0.5;
        let (row, column) = (y.floor(), x.floor());
        let (v, u) = ((y - row) as f32, (x - column) as f32);
        let pixel = |dx: i64, dy: i64| {
            let x = (column as i64 + dx).rem_euclid(i64::from(self.width)) as usize;
            let y = (row as i64 + dy).clamp(0, i64::from(self.height) - 1) as usize;
            self.values[y * self.width as usize + x]
        };
        let line = |dy| pixel(0, dy) + (pixel(1, dy) - pixel(0, dy)) * u;
        line(0) + (line(1) - line(0)) * v
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_found_at_their_centres_and_join_around_the_date_line() {
        let map = EquirectMap::from_fn(18, |lat, lon| (lat + 1000.0 * lon.abs()) as f32).unwrap();
        assert_eq!(map.at(math::direction(45.0, 15.0)), 45.0 + 15_000.0);
        assert_eq!(map.at(math::direction(50.0, 15.0)), 50.0 + 15_000.0);
        assert!((map.at(math::direction(5.0, 180.0)) - (5.0 + 175_000.0)).abs() < 0.1);
        assert!((map.at(DVec3::Z) - map.at(math::direction(89.0, 0.0))).abs() < 1e-3);
    }

    #[test]
    fn broken_maps_are_refused() {
        assert_eq!(EquirectMap::new(0, 0, vec![]), Err(MapError::Size(0, 0)));
        assert_eq!(
            EquirectMap::new(3, 2, vec![0.0; 6]),
            Err(MapError::Shape(3, 2))
        );
        assert_eq!(
            EquirectMap::new(2, 1, vec![0.0]),
            Err(MapError::Count {
                given: 1,
                wanted: 2
            })
        );
        assert_eq!(
            EquirectMap::new(2, 1, vec![0.0, f32::NAN]),
            Err(MapError::NotFinite(1))
        );
        assert!(
            EquirectMap::from_fn(0, |_, _| 0.0).is_err()
                && EquirectMap::from_fn(1 << 20, |_, _| 0.0).is_err()
        );
    }
}
