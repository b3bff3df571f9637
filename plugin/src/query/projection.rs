//! Azimuthal equidistant projection of the sphere (Snyder 1987, "Map projections: a working
//! manual", p. 191-202).
//!
//! Distances and bearings from the centre are true. Everything is done with vectors: there is no
//! pole and no antimeridian to except. The plane's x points east, y north, in metres along the sea
//! level.

use super::check::{check_radius, direction_at};
use super::error::GroundError;
use crate::math::{self, PI, east_north};
use bevy::math::{DVec2, DVec3};
use bevy::reflect::Reflect;

/// The projection about one centre.
///
/// ```
/// use bevy::math::DVec2;
/// use bevy_pangaea::query::{AzimuthalEquidistant, direction_at};
///
/// let map = AzimuthalEquidistant::new(45.0, 10.0, 6_370_000.0)?;
/// let pole = map.plane(direction_at(90.0, 0.0)?);
/// assert!((pole - DVec2::new(0.0, map.radius_m() * 45_f64.to_radians())).length() < 1e-3);
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(opaque, Clone, Debug, PartialEq)]
pub struct AzimuthalEquidistant {
    centre: DVec3,
    east: DVec3,
    north: DVec3,
    lat_lon: (f64, f64),
    radius_m: f64,
}

impl AzimuthalEquidistant {
    /// The projection about a latitude and a longitude in degrees on a sphere of `radius_m`. At a
    /// pole north is up along the meridian `longitude`.
    ///
    /// # Errors
    /// [`GroundError::Latitude`], [`GroundError::Longitude`], [`GroundError::Radius`].
    pub fn new(latitude: f64, longitude: f64, radius_m: f64) -> Result<Self, GroundError> {
        check_radius(radius_m)?;
        let centre = direction_at(latitude, longitude)?;
        let (sin, cos) = math::sin_cos(longitude.to_radians());
        let east = DVec3::new(-sin, cos, 0.0);
        Ok(Self {
            centre,
            east,
            north: centre.cross(east),
            lat_lon: (latitude, longitude),
            radius_m,
        })
    }

    /// The projection about a unit vector.
    pub(super) fn about(centre: DVec3, radius_m: f64) -> Self {
        let (east, north) = east_north(centre);
        Self {
            centre,
            east,
            north,
            lat_lon: math::lat_lon(centre),
            radius_m,
        }
    }

    /// Unit vector of the centre.
    pub fn centre(&self) -> DVec3 {
        self.centre
    }

    /// Latitude and longitude of the centre in degrees.
    pub fn lat_lon(&self) -> (f64, f64) {
        self.lat_lon
    }

    /// Unit vectors to the east and to the north at the centre.
    pub fn axes(&self) -> (DVec3, DVec3) {
        (self.east, self.north)
    }

    /// Radius of the sphere in m.
    pub fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// The unit vector at `x` m to the east and `y` m to the north, at most half a great circle
    /// away.
    pub fn direction(&self, plane: DVec2) -> DVec3 {
        let distance = plane.length();
        if distance == 0.0 {
            return self.centre;
        }
        let (sin, cos) = math::sin_cos(distance / self.radius_m);
        let bearing = (self.east * plane.x + self.north * plane.y) / distance;
        (self.centre * cos + bearing * sin).normalize()
    }

    /// Where a unit vector lies in the plane, in m; the inverse of [`direction`](Self::direction).
    /// The point opposite to the centre, whose bearing is not defined, lies in the north.
    pub fn plane(&self, direction: DVec3) -> DVec2 {
        let flat = DVec2::new(direction.dot(self.east), direction.dot(self.north));
        let sin = flat.length();
        let distance = self.radius_m * math::atan2(sin, direction.dot(self.centre));
        if sin == 0.0 {
            DVec2::new(0.0, distance)
        } else {
            flat * (distance / sin)
        }
    }

    /// Side of the largest square in m whose corners are not beyond the point opposite to the
    /// centre.
    pub fn largest_square(radius_m: f64) -> f64 {
        core::f64::consts::SQRT_2 * PI * radius_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const R: f64 = 6_370_000.0;

    fn about(lat: f64, lon: f64) -> AzimuthalEquidistant {
        AzimuthalEquidistant::new(lat, lon, R).unwrap()
    }

    #[test]
    fn north_is_up_and_degrees_are_equally_long_from_the_centre() {
        let degree = R * PI / 180.0;
        let map = about(0.0, 0.0);
        let east = map.plane(math::direction(0.0, 10.0));
        assert!((east - DVec2::new(10.0 * degree, 0.0)).length() < 1e-6);
        let south = map.plane(math::direction(-20.0, 0.0));
        assert!((south - DVec2::new(0.0, -20.0 * degree)).length() < 1e-6);
        let pole = about(45.0, 100.0).plane(DVec3::Z);
        assert!((pole - DVec2::new(0.0, 45.0 * degree)).length() < 1e-6);
    }

    #[test]
    fn the_closed_form_for_the_oblique_case_holds() {
        // Centre 40° N 100° W, point 20° S 100° E: Snyder's numerical example, p. 337.
        let map = AzimuthalEquidistant::new(40.0, -100.0, 1.0).unwrap();
        let found = map.plane(math::direction(-20.0, 100.0));
        // His equations 22-4, 22-5, 25-2 and 5-3.
        let [(sin0, cos0), (sin, cos), (sin_l, cos_l)] =
            [40.0_f64, -20.0, 200.0].map(|degrees| math::sin_cos(degrees.to_radians()));
        let c = math::acos(sin0 * sin + cos0 * cos * cos_l);
        let k = c / math::sin(c);
        let (x, y) = (k * cos * sin_l, k * (cos0 * sin - sin0 * cos * cos_l));
        let expected = DVec2::new(x, y);
        assert!((found - expected).length() < 1e-12, "{found} {expected}");
    }

    #[test]
    fn poles_and_the_antimeridian_are_points_like_any_other() {
        for (lat, lon) in [
            (90.0, 0.0),
            (-90.0, 77.0),
            (0.0, 180.0),
            (10.0, -180.0),
            (-89.999_999, 12.0),
        ] {
            let map = about(lat, lon);
            assert!(map.plane(map.centre()).length() < 1e-9);
            for plane in [DVec2::new(3e5, -2e5), DVec2::new(-1e6, 1e-3), DVec2::Y] {
                let back = map.plane(map.direction(plane));
                assert!((back - plane).length() < 1e-7, "{lat} {lon} {plane}");
            }
        }
        // At the north pole, up is along the meridian opposite to the given one.
        let up = math::lat_lon(about(90.0, 30.0).direction(DVec2::new(0.0, 1e5)));
        assert!((up.1 - -150.0).abs() < 1e-9, "{up:?}");
        let left = math::lat_lon(about(0.0, 180.0).direction(DVec2::new(1e5, 0.0)));
        assert!(left.1 < -179.0, "{left:?}");
    }

    #[test]
    fn the_opposite_point_has_its_distance() {
        let map = about(10.0, 20.0);
        assert!((map.plane(-map.centre()).length() - PI * R).abs() < 1e-3);
    }

    proptest! {
        #[test]
        fn distances_from_the_centre_are_true_and_points_come_back(
            lat in -90.0..90.0_f64, lon in -180.0..180.0_f64,
            x in -1e7..1e7_f64, y in -1e7..1e7_f64,
        ) {
            let map = about(lat, lon);
            let p = map.direction(DVec2::new(x, y));
            let distance = R * math::angle_between(map.centre(), p);
            prop_assert!((distance - DVec2::new(x, y).length()).abs() < 1e-6);
            prop_assert!((p.length() - 1.0).abs() < 1e-15);
            // Near the opposite point the bearing is lost in rounding.
            prop_assert!((map.plane(p) - DVec2::new(x, y)).length() < 1e-4);
        }
    }

    #[test]
    fn bad_centres_are_refused() {
        let new = |lat, lon, radius| AzimuthalEquidistant::new(lat, lon, radius).map(|_| ());
        assert_eq!(new(91.0, 0.0, R), Err(GroundError::Latitude(91.0)));
        assert_eq!(new(0.0, 400.0, R), Err(GroundError::Longitude(400.0)));
        assert_eq!(new(0.0, 0.0, -1.0), Err(GroundError::Radius(-1.0)));
    }
}
