//! What a ground answers, and the levels of its detail.
//!
//! Level 0 is the control mesh with edges of about 52 km on an Earth-sized planet (paper 002 §4);
//! every level halves them. Rules go by level, not by length: a planet of any radius has the same
//! levels.

use super::{Climate, GroundError};
use crate::math;
use bevy::math::DVec3;

/// The finest level: edges of 0.4 m on an Earth-sized planet.
pub const LEVELS: u8 = 17;

/// Edge of the control mesh in planet radii: 52 km on a planet of 6370 km (paper 002 §4).
const BASE_EDGE: f64 = 52.0 / 6370.0;

/// The ground of a planet. Every method may be called from many threads at once.
pub trait Ground: Sync {
    /// Radius of the sea level in m.
    fn radius_m(&self) -> f64;

    /// Height of the ground above sea level in m, at a direction of any length and a level up to
    /// [`LEVELS`].
    ///
    /// # Errors
    /// [`GroundError::NotADirection`], [`GroundError::Level`].
    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError>;

    /// Heights at many directions, faster where the ground can share work between neighbours.
    ///
    /// # Errors
    /// As [`height`](Self::height), for the first refused direction; [`GroundError::Count`] if
    /// `heights` is not as long as `directions`.
    fn heights(
        &self,
        directions: &[DVec3],
        level: u8,
        heights: &mut [f32],
    ) -> Result<(), GroundError> {
        same_length(directions, heights)?;
        for (direction, height) in directions.iter().zip(heights) {
            *height = self.height(*direction, level)?;
        }
        Ok(())
    }

    /// Level of the water surface in m; the height of the ground where it is dry. Without a better
    /// answer there is a sea at level 0 and no other water.
    ///
    /// # Errors
    /// As [`height`](Self::height).
    fn water(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        Ok(self.height(direction, level)?.max(0.0))
    }

    /// Warmth and wetness at a direction, for a ground that is `height_m` above the sea. Without a
    /// better answer it is that of the latitude.
    ///
    /// # Errors
    /// As [`height`](Self::height).
    fn climate(&self, direction: DVec3, height_m: f32) -> Result<Climate, GroundError> {
        let unit = checked(direction, 0)?;
        Ok(Climate::of_latitude(unit.z, height_m))
    }

    /// Lowest and highest ground in m that there can be; rays are followed between them.
    fn bounds_m(&self) -> [f64; 2] {
        [-15_000.0, 15_000.0]
    }
}

/// Refuses two slices of different lengths.
pub(super) fn same_length(directions: &[DVec3], heights: &[f32]) -> Result<(), GroundError> {
    if directions.len() == heights.len() {
        return Ok(());
    }
    let n = directions.len();
    Err(GroundError::Count {
        what: "the number of heights",
        value: heights.len(),
        min: n,
        max: n,
    })
}

/// The unit vector along `direction`, which may have any length, if it and the level are good.
///
/// # Errors
/// [`GroundError::NotADirection`], [`GroundError::Level`].
pub fn checked(direction: DVec3, level: u8) -> Result<DVec3, GroundError> {
    if level > LEVELS {
        return Err(GroundError::Level(level));
    }
    let largest = direction.abs().max_element();
    if !direction.is_finite() || largest == 0.0 {
        return Err(GroundError::NotADirection);
    }
    // Dividing by the largest component first keeps the length clear of overflow and underflow.
    Ok((direction / largest).normalize())
}

/// The direction of a latitude and a longitude in degrees; longitudes count from -360 to 360.
///
/// # Errors
/// [`GroundError::Latitude`], [`GroundError::Longitude`].
pub fn direction_at(latitude: f64, longitude: f64) -> Result<DVec3, GroundError> {
    if !(-90.0..=90.0).contains(&latitude) {
        return Err(GroundError::Latitude(latitude));
    }
    if !(-360.0..=360.0).contains(&longitude) {
        return Err(GroundError::Longitude(longitude));
    }
    Ok(math::direction(latitude, longitude))
}

/// Mean length of an edge at a level in m.
pub fn spacing(radius_m: f64, level: u8) -> f64 {
    radius_m * BASE_EDGE / (1_u64 << level.min(63)) as f64
}

/// The coarsest level whose edges are not longer than `spacing_m`; the finest where none is short
/// enough.
pub fn level_for(radius_m: f64, spacing_m: f64) -> u8 {
    (0..LEVELS)
        .find(|&level| spacing(radius_m, level) <= spacing_m)
        .unwrap_or(LEVELS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_reach_from_the_control_mesh_to_the_ground() {
        let earth = 6_370_000.0;
        assert!((spacing(earth, 0) - 52_000.0).abs() < 1e-6);
        assert!((spacing(earth, LEVELS) - 0.397).abs() < 1e-3);
        assert_eq!(level_for(earth, 92.6), 10);
        assert_eq!(level_for(earth, 1e9), 0);
        assert_eq!(
            (
                level_for(earth, 0.5),
                level_for(earth, 1e-9),
                level_for(earth, f64::NAN)
            ),
            (17, 17, 17)
        );
        // A planet of a hundredth of the size has the same levels.
        assert_eq!(level_for(63_700.0, 0.926), level_for(earth, 92.6));
    }

    #[test]
    fn bad_directions_levels_and_coordinates_are_refused() {
        for bad in [
            DVec3::ZERO,
            DVec3::NAN,
            DVec3::new(f64::INFINITY, 0.0, 1.0),
            DVec3::new(0.0, f64::NAN, 1.0),
        ] {
            assert_eq!(checked(bad, 0), Err(GroundError::NotADirection));
        }
        assert_eq!(checked(DVec3::X, 18), Err(GroundError::Level(18)));
        for far in [1e-300, 1e300] {
            assert!((checked(DVec3::new(far, far, 0.0), 17).unwrap().length() - 1.0).abs() < 1e-15);
        }
        for bad in [90.1, -91.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(
                direction_at(bad, 0.0),
                Err(GroundError::Latitude(_))
            ));
        }
        for bad in [360.5, f64::NAN, f64::NEG_INFINITY] {
            assert!(matches!(
                direction_at(0.0, bad),
                Err(GroundError::Longitude(_))
            ));
        }
        assert!((direction_at(0.0, 270.0).unwrap() + DVec3::Y).length() < 1e-15);
    }
}
