//! Directions, radii, lengths and counts that make sense.

use super::error::GroundError;
use super::level::LEVELS;
use crate::math;
use bevy::math::DVec3;

/// The unit vector along `direction`, which may have any length, if it and the level are good.
///
/// ```
/// use bevy::math::DVec3;
/// use bevy_pangaea::query::{GroundError, checked};
///
/// assert_eq!(checked(DVec3::new(0.0, 5.0, 0.0), 3), Ok(DVec3::Y));
/// assert_eq!(checked(DVec3::ZERO, 3), Err(GroundError::NotADirection));
/// assert_eq!(checked(DVec3::Y, 18), Err(GroundError::Level(18)));
/// ```
///
/// # Errors
/// [`GroundError::NotADirection`], [`GroundError::Level`].
pub fn checked(direction: DVec3, level: u8) -> Result<DVec3, GroundError> {
    check_level(level)?;
    let largest = direction.abs().max_element();
    if !direction.is_finite() || largest == 0.0 {
        return Err(GroundError::NotADirection);
    }
    // Dividing by the largest component first keeps the length clear of overflow and underflow.
    Ok((direction / largest).normalize())
}

/// Refuses levels beyond the finest.
pub(super) fn check_level(level: u8) -> Result<(), GroundError> {
    if level > LEVELS {
        Err(GroundError::Level(level))
    } else {
        Ok(())
    }
}

/// The direction of a latitude and a longitude in degrees; longitudes count from -360 to 360.
///
/// ```
/// use bevy_pangaea::query::direction_at;
///
/// assert!((direction_at(90.0, 0.0)?.z - 1.0).abs() < 1e-15);
/// assert!(direction_at(91.0, 0.0).is_err());
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
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

/// Refuses positions that are not finite.
pub(super) fn check_position(position: DVec3) -> Result<(), GroundError> {
    if position.is_finite() {
        Ok(())
    } else {
        Err(GroundError::NotADirection)
    }
}

/// Refuses radii that no planet has.
pub(super) fn check_radius(radius_m: f64) -> Result<(), GroundError> {
    if radius_m > 0.0 && radius_m.is_finite() {
        Ok(())
    } else {
        Err(GroundError::Radius(radius_m))
    }
}

/// Refuses a length of `what` in m outside of `min..=max`.
pub(super) fn check_length(
    what: &'static str,
    value: f64,
    [min, max]: [f64; 2],
) -> Result<(), GroundError> {
    if (min..=max).contains(&value) {
        return Ok(());
    }
    Err(GroundError::Length {
        what,
        value,
        min,
        max,
    })
}

/// Refuses a number of `what` outside of `min..=max`.
pub(super) fn check_count(
    what: &'static str,
    value: usize,
    [min, max]: [usize; 2],
) -> Result<(), GroundError> {
    if (min..=max).contains(&value) {
        return Ok(());
    }
    Err(GroundError::Count {
        what,
        value,
        min,
        max,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bad_directions_and_levels_are_refused() {
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
            let unit = checked(DVec3::new(far, far, 0.0), 17).unwrap();
            assert!((unit.length() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn bad_coordinates_are_refused() {
        for bad in [90.1, -91.0, f64::NAN, f64::INFINITY] {
            let refused = direction_at(bad, 0.0);
            assert!(matches!(refused, Err(GroundError::Latitude(_))));
        }
        for bad in [360.5, f64::NAN, f64::NEG_INFINITY] {
            let refused = direction_at(0.0, bad);
            assert!(matches!(refused, Err(GroundError::Longitude(_))));
        }
        assert!((direction_at(0.0, 270.0).unwrap() + DVec3::Y).length() < 1e-15);
    }
}
