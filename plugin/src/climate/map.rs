//! A user's map: equirectangular, north up, longitude -180 at the left edge.
//!
//! A pixel stands for the point at its centre; between pixels values are bilinear, around the date
//! line they join, and beyond the first and last row they stay as they are.
//!
//! A pixel without a value is a *void*. A place is void where the pixel that it lies in is; beside
//! voids, values are the means of the neighbours that have one, by the same weights, so that no
//! void reaches beyond its own pixels, and none is smeared over.

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
/// let here = warm_tropics.at(direction(45.0, 10.0));
/// assert!(here.is_some_and(|celsius| (celsius - -15.0).abs() < 0.01));
/// # Ok::<(), bevy_pangaea::climate::MapError>(())
/// ```
///
/// NaN stands for a void:
///
/// ```
/// use bevy_pangaea::climate::EquirectMap;
/// use bevy_pangaea::math::direction;
///
/// let north = EquirectMap::from_fn(90, |lat, _| if lat > 0.0 { 12.0 } else { f32::NAN })?;
/// assert_eq!(north.voids(), 90 * 90);
/// assert_eq!(north.at(direction(45.0, 10.0)), Some(12.0));
/// assert_eq!(north.at(direction(-45.0, 10.0)), None);
/// # Ok::<(), bevy_pangaea::climate::MapError>(())
/// ```
#[derive(Clone, Debug, Reflect, serde::Serialize, serde::Deserialize)]
#[reflect(opaque, Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Pixels", into = "Pixels")]
pub struct EquirectMap {
    width: u32,
    height: u32,
    /// NaN for voids.
    values: Arc<Vec<f32>>,
    voids: usize,
}

impl PartialEq for EquirectMap {
    fn eq(&self, other: &Self) -> bool {
        // Settings are compared in every frame, and mostly with their own clone. By bits: a void
        // equals a void.
        self.size() == other.size()
            && (Arc::ptr_eq(&self.values, &other.values) || self.bits().eq(other.bits()))
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
    /// A value is infinite.
    #[error("the value of pixel {0} is infinite")]
    Infinite(usize),
    /// No pixel has a value.
    #[error("the map has no values, only voids")]
    OnlyVoids,
    /// A void in a map that must have values everywhere.
    #[error("{what} has no value at pixel {pixel}; it must have one everywhere")]
    Void {
        /// The quantity that the map shows.
        what: &'static str,
        /// The first void, counted in rows from the top.
        pixel: usize,
    },
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

    /// A map of `width` x `height` pixels, rows from the top; NaN for voids.
    ///
    /// # Errors
    /// [`MapError`] for a size that is out of range or not 2 to 1, a wrong number of values,
    /// infinite values, and voids alone.
    pub fn new(width: u32, height: u32, values: Vec<f32>) -> Result<Self, MapError> {
        Self::check_size(width, height)?;
        let wanted = width as usize * height as usize;
        if values.len() != wanted {
            return Err(MapError::Count {
                given: values.len(),
                wanted,
            });
        }
        if let Some(pixel) = values.iter().position(|value| value.is_infinite()) {
            return Err(MapError::Infinite(pixel));
        }
        let voids = values.iter().filter(|value| value.is_nan()).count();
        if voids == wanted {
            return Err(MapError::OnlyVoids);
        }
        Ok(Self {
            width,
            height,
            values: Arc::new(values),
            voids,
        })
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

    /// Number of pixels without a value.
    pub fn voids(&self) -> usize {
        self.voids
    }

    fn bits(&self) -> impl Iterator<Item = u32> {
        self.values.iter().map(|value| value.to_bits())
    }

    /// Refuses a map of `what` with voids.
    pub(crate) fn check_whole(&self, what: &'static str) -> Result<(), MapError> {
        match self.values.iter().position(|value| value.is_nan()) {
            Some(pixel) => Err(MapError::Void { what, pixel }),
            None => Ok(()),
        }
    }

    /// Refuses a given map of `what` with a value outside of `range`, which `allowed` puts into
    /// words; voids are no values.
    pub(crate) fn check(
        given: Option<&Self>,
        what: &'static str,
        range: RangeInclusive<f32>,
        allowed: &'static str,
    ) -> Result<(), MapError> {
        let values = given.into_iter().flat_map(|map| map.values.iter());
        let is_bad = |value: &f32| !value.is_nan() && !range.contains(value);
        match (0..).zip(values).find(|(_, value)| is_bad(value)) {
            Some((pixel, &value)) => Err(MapError::Range {
                what,
                value,
                pixel,
                allowed,
            }),
            None => Ok(()),
        }
    }

    /// The value at the unit direction `p`; none where the pixel that `p` lies in is a void.
    pub fn at(&self, p: DVec3) -> Option<f32> {
        let (lat, lon) = math::lat_lon(p);
        // Pixels stand for their centres, half a pixel from the edge; beyond the last row's the
        // poles take its value.
        let last_row = f64::from(self.height - 1);
        let y = ((90.0 - lat) / 180.0 * f64::from(self.height) - 0.5).clamp(0.0, last_row);
        let x = (lon + 180.0) / 360.0 * f64::from(self.width) - 0.5;
        let (row, column) = (y.floor(), x.floor());
        let pair = |y: i64| [0, 1].map(|x| self.pixel(column as i64 + x, y));
        let corners = [pair(row as i64), pair(row as i64 + 1)];
        between(corners, (x - column) as f32, (y - row) as f32)
    }

    /// A pixel; columns join around the date line, rows end at the poles.
    fn pixel(&self, column: i64, row: i64) -> f32 {
        let x = column.rem_euclid(i64::from(self.width)) as usize;
        let y = row.clamp(0, i64::from(self.height) - 1) as usize;
        self.values[y * self.width as usize + x]
    }
}

/// The value between four pixels, of which the second row lies below the first: a share `across` of
/// the way to the right, and `down` of the way to the other row.
fn between(corners: [[f32; 2]; 2], across: f32, down: f32) -> Option<f32> {
    let [above, below] = corners.map(|[west, east]| west + (east - west) * across);
    let value = above + (below - above) * down;
    // Voids are NaN, and make NaN of whatever they are mixed with.
    if value.is_nan() {
        beside_voids(corners, across, down)
    } else {
        Some(value)
    }
}

/// The same without the corners that are voids, unless the nearest one is.
fn beside_voids(corners: [[f32; 2]; 2], across: f32, down: f32) -> Option<f32> {
    let nearest = corners[usize::from(down >= 0.5)][usize::from(across >= 0.5)];
    if nearest.is_nan() {
        return None;
    }
    let weights = [1.0 - down, down].map(|y| [(1.0 - across) * y, across * y]);
    let known = corners.as_flattened().iter().zip(weights.as_flattened());
    let known = known.filter(|(value, _)| !value.is_nan());
    let (sum, weight) = known.fold((0.0, 0.0), |(sum, weight), (value, w)| {
        (sum + value * w, weight + w)
    });
    Some(sum / weight)
}

#[cfg(test)]
#[path = "map_tests.rs"]
mod tests;
