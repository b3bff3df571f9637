//! Transcendental functions: the simulation calls no others.
//!
//! The platform's `sin`, `exp` or `pow` differ in their last bits between machines and compiler
//! versions; those of `libm` are the same everywhere, and the same seed must give the same planet
//! everywhere. `clippy.toml` bans the methods of `f32` and `f64`. Addition, multiplication,
//! division and square roots are exact by IEEE 754 and are used directly.
//!
//! Directions are unit vectors with +z at the north pole and +x at 0° N 0° E.

use bevy::math::{DQuat, DVec3};

pub use core::f64::consts::{PI, TAU};

/// Sine of `x` radians.
#[inline]
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}

/// Cosine of `x` radians.
#[inline]
pub fn cos(x: f64) -> f64 {
    libm::cos(x)
}

/// Sine and cosine of `x` radians.
#[inline]
pub fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// Angle of the vector (`x`, `y`) in radians, -pi..pi.
#[inline]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// Arc sine in radians; the argument is clamped to -1..1.
#[inline]
pub fn asin(x: f64) -> f64 {
    libm::asin(x.clamp(-1.0, 1.0))
}

/// Arc cosine in radians; the argument is clamped to -1..1.
#[inline]
pub fn acos(x: f64) -> f64 {
    libm::acos(x.clamp(-1.0, 1.0))
}

/// e to the power `x`.
#[inline]
pub fn exp(x: f64) -> f64 {
    libm::exp(x)
}

/// 2 to the power `x`.
#[inline]
pub fn exp2(x: f64) -> f64 {
    libm::exp2(x)
}

/// Natural logarithm.
#[inline]
pub fn ln(x: f64) -> f64 {
    libm::log(x)
}

/// `x` to the power `y`.
#[inline]
pub fn pow(x: f64, y: f64) -> f64 {
    libm::pow(x, y)
}

/// e to the power `x` in single precision, for sweeps over columns.
#[inline]
pub fn exp_f32(x: f32) -> f32 {
    libm::expf(x)
}

/// The whole number nearest to `x`, halves away from zero, for |x| < 2⁶³; 0 for NaN. It is
/// `x.round()`, which is a call on processors without SSE 4.1, as programs are compiled for them.
///
/// ```
/// # use bevy_pangaea::math::nearest;
/// assert_eq!([0.5, -0.5, 0.499_999_999_999_999_94, 2.5].map(nearest), [1, -1, 0, 3]);
/// ```
#[inline]
pub fn nearest(x: f64) -> i64 {
    let whole = x as i64;
    let rest = x - whole as f64;
    whole + i64::from(rest >= 0.5) - i64::from(rest <= -0.5)
}

/// The cubic 3x² - 2x³ that joins 0 and 1 with level ends; `x` is clamped to 0..1.
#[inline]
pub fn smoothstep(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// Rotation by `angle` radians about the unit vector `axis`.
///
/// `DQuat::from_axis_angle` would call the platform's sine.
///
/// ```
/// # use bevy_pangaea::math;
/// # use bevy::math::DVec3;
/// let quarter = math::rotation(DVec3::Z, 0.25 * math::TAU);
/// assert!((quarter * DVec3::X - DVec3::Y).length() < 1e-15);
/// ```
pub fn rotation(axis: DVec3, angle: f64) -> DQuat {
    let (s, c) = sin_cos(0.5 * angle);
    let v = axis * s;
    DQuat::from_xyzw(v.x, v.y, v.z, c)
}

/// Great-circle angle between two unit vectors in radians, exact for near and for opposite points.
pub fn angle_between(a: DVec3, b: DVec3) -> f64 {
    atan2(a.cross(b).length(), a.dot(b))
}

/// Unit vector at `latitude` and `longitude` in degrees; +z is the north pole, +x is 0° E.
///
/// ```
/// # use bevy_pangaea::math;
/// let zurich = math::direction(47.4, 8.5);
/// let (latitude, longitude) = math::lat_lon(zurich);
/// assert!((latitude - 47.4).abs() < 1e-9 && (longitude - 8.5).abs() < 1e-9);
/// ```
pub fn direction(latitude: f64, longitude: f64) -> DVec3 {
    let (sin_lat, cos_lat) = sin_cos(latitude.to_radians());
    let (sin_lon, cos_lon) = sin_cos(longitude.to_radians());
    DVec3::new(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat)
}

/// Latitude and longitude in degrees of a direction of any length, the inverse of [`direction`].
pub fn lat_lon(direction: DVec3) -> (f64, f64) {
    let across = (direction.x * direction.x + direction.y * direction.y).sqrt();
    let latitude = atan2(direction.z, across);
    let longitude = atan2(direction.y, direction.x);
    (latitude.to_degrees(), longitude.to_degrees())
}

/// A unit vector perpendicular to the unit vector `n`.
pub fn any_tangent(n: DVec3) -> DVec3 {
    // The axis is never near `n`, or the cross product would have no direction.
    let axis = if n.x.abs() < 0.6 { DVec3::X } else { DVec3::Y };
    n.cross(axis).normalize()
}

/// East and north at the unit direction `p`. At both poles east is that of the meridian 0.
pub fn east_north(p: DVec3) -> (DVec3, DVec3) {
    let across = DVec3::new(-p.y, p.x, 0.0);
    // Within 1e-12 rad of a pole rounding alone would say where east is.
    let east = if across.length_squared() > 1e-24 {
        across.normalize()
    } else {
        DVec3::Y
    };
    (east, p.cross(east))
}

/// Azimuth of the tangent vector `v` at `p` in degrees clockwise from north, 0..360.
pub fn azimuth(p: DVec3, v: DVec3) -> f64 {
    let (east, north) = east_north(p);
    let degrees = atan2(v.dot(east), v.dot(north)).to_degrees();
    if degrees < 0.0 {
        degrees + 360.0
    } else {
        degrees
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn east_and_north_are_those_of_the_map_and_exist_at_the_poles() {
        let (east, north) = east_north(DVec3::X);
        assert_eq!((east, north), (DVec3::Y, DVec3::Z));
        for up in [DVec3::Z, -DVec3::Z, direction(89.999_999_9, 30.0)] {
            let (east, north) = east_north(up);
            assert!(east.dot(up).abs() < 1e-9 && north.dot(up).abs() < 1e-9);
            assert!((east.cross(north) - up).length() < 1e-8);
        }
    }

    #[test]
    fn azimuth_goes_clockwise_from_north() {
        let p = direction(30.0, 50.0);
        let (east, north) = east_north(p);
        for (v, degrees) in [(north, 0.0), (east, 90.0), (-north, 180.0), (-east, 270.0)] {
            assert!((azimuth(p, v) - degrees).abs() < 1e-9);
        }
        assert!(azimuth(DVec3::Z, DVec3::X).is_finite());
    }

    #[test]
    fn a_full_turn_leads_back() {
        let p = DVec3::new(0.3, -0.5, 0.81).normalize();
        let q = rotation(DVec3::new(1.0, 2.0, 3.0).normalize(), TAU) * p;
        assert!((p - q).length() < 1e-14);
    }

    #[test]
    fn directions_and_coordinates_are_inverse() {
        for (lat, lon) in [(0.0, 0.0), (45.0, 10.0), (-89.0, 179.0), (12.5, -120.25)] {
            let (a, b) = lat_lon(direction(lat, lon));
            assert!(
                (a - lat).abs() < 1e-9 && (b - lon).abs() < 1e-9,
                "{lat} {lon} -> {a} {b}"
            );
        }
    }

    #[test]
    fn angles_are_exact_near_zero_and_pi() {
        let p = DVec3::X;
        assert!((angle_between(p, direction(1e-7, 0.0)) - 1e-7_f64.to_radians()).abs() < 1e-20);
        assert!((angle_between(p, -p) - PI).abs() < 1e-15);
    }
}
