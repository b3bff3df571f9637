//! A user's map: equirectangular, north up, longitude -180 at the left edge.
//!
//! A pixel stands for the point at its centre; between pixels values are bilinear, around the date
//! line they join, and beyond the first and last row they stay as they are.

use crate::math;
use bevy::math::DVec3;
use bevy::reflect::{Reflect, ReflectDeserialize, ReflectSerialize};
use core::ops::RangeInclusive;
use std::sync::Arc;

/// Numbers on an equirectangular grid. Clones share them.
///
/// ```
/// use bevy_pangaea::climate::EquirectMap;
/// use bevy_pangaea::math::direction;
///
/// let warm_tropics = EquirectMap::from_fn(90, |lat, _| 30.0 - lat.abs() as f32)?;
/// assert_eq!(warm_tropics.size(), [180, 90]);
/// assert!((warm_tropics.at(direction(45.0, 10.0)) - -15.0).abs() < 0.01);
/// # Ok::<(), bevy_pangaea::climate::MapError>(())
/// ```
#[derive(Clone, Debug, Reflect, serde::Serialize, serde::Deserialize)]
#[reflect(opaque, Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Pixels", into = "Pixels")]
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

/// A map as files have it: it becomes one only if size and values fit.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Pixels {
    width: u32,
    height: u32,
    values: Vec<f32>,
}

impl TryFrom<Pixels> for EquirectMap {
    type Error = MapError;

    fn try_from(pixels: Pixels) -> Result<Self, MapError> {
        Self::new(pixels.width, pixels.height, pixels.values)
    }
}

impl From<EquirectMap> for Pixels {
    fn from(map: EquirectMap) -> Self {
        Self {
            width: map.width,
            height: map.height,
            values: map.values.to_vec(),
        }
    }
}

/// Why a map was refused.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, thiserror::Error)]
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
    /// A value is outside of the range of its quantity.
    #[error("{what} is {value} at pixel {pixel}; it must be {allowed}")]
    Range {
        /// The quantity that the map shows.
        what: &'static str,
        /// The refused value.
        value: f32,
        /// Its pixel, counted in rows from the top.
        pixel: usize,
        /// The allowed range in words.
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

    /// Refuses sizes that no map can have.
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
        let mut values = Vec::with_capacity(2 * height as usize * height as usize);
        for y in 0..height {
            let latitude = 90.0 - (f64::from(y) + 0.5) * step;
            for x in 0..2 * height {
                values.push(value(latitude, (f64::from(x) + 0.5) * step - 180.0));
            }
        }
        Self::new(2 * height, height, values)
    }

    /// All values, rows from the top.
    pub fn values(&self) -> &[f32] {
        &self.values
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
        // Pixels stand for their centres, half a pixel from the edge; beyond the last row's the
        // poles take its value.
        let last_row = f64::from(self.height - 1);
        let y = ((90.0 - lat) / 180.0 * f64::from(self.height) - 0.5).clamp(0.0, last_row);
        let x = (lon + 180.0) / 360.0 * f64::from(self.width) - 0.5;
        let (row, column) = (y.floor(), x.floor());
        let across = (x - column) as f32;
        let down = (y - row) as f32;
        let above = self.between(column as i64, row as i64, across);
        let below = self.between(column as i64, row as i64 + 1, across);
        above + (below - above) * down
    }

    /// The value in a row, a share `across` of the way from a column to the next.
    fn between(&self, column: i64, row: i64, across: f32) -> f32 {
        let west = self.pixel(column, row);
        west + (self.pixel(column + 1, row) - west) * across
    }

    /// A pixel; columns join around the date line, rows end at the poles.
    fn pixel(&self, column: i64, row: i64) -> f32 {
        let x = column.rem_euclid(i64::from(self.width)) as usize;
        let y = row.clamp(0, i64::from(self.height) - 1) as usize;
        self.values[y * self.width as usize + x]
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
    fn maps_come_back_from_files_and_broken_files_are_refused() {
        let map = EquirectMap::from_fn(2, |lat, lon| (lat + lon) as f32).unwrap();
        let text = ron::to_string(&map).unwrap();
        assert_eq!(ron::from_str(&text), Ok(map));
        let torn = text.replace("width:4", "width:6");
        assert!(ron::from_str::<EquirectMap>(&torn).is_err());
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
        for height in [0, 1 << 20] {
            assert!(EquirectMap::from_fn(height, |_, _| 0.0).is_err());
        }
    }
}
