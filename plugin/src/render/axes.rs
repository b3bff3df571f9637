//! From a planet's axes to Bevy's and back: the planet's axis (+z) is Bevy's +y.

use bevy::math::DVec3;
use bevy::prelude::*;

/// A planet direction or position in Bevy's axes: (x, y, z) becomes (x, z, -y).
///
/// ```
/// use bevy::math::DVec3;
/// use bevy::prelude::*;
/// use bevy_pangaea::render::{from_bevy, to_bevy};
///
/// assert_eq!(to_bevy(DVec3::Z), Vec3::Y, "the north pole is up");
/// assert_eq!(from_bevy(Vec3::Y), DVec3::Z);
/// ```
#[inline]
pub fn to_bevy(v: DVec3) -> Vec3 {
    Vec3::new(v.x as f32, v.z as f32, -v.y as f32)
}

/// The inverse of [`to_bevy`].
#[inline]
pub fn from_bevy(v: Vec3) -> DVec3 {
    DVec3::new(f64::from(v.x), -f64::from(v.z), f64::from(v.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_right_handed_and_invertible() {
        let v = DVec3::new(0.25, -0.5, 0.75);
        assert_eq!(from_bevy(to_bevy(v)), v);
        assert_eq!(to_bevy(DVec3::Z), Vec3::Y);
        let x_cross_y = to_bevy(DVec3::X).cross(to_bevy(DVec3::Y));
        assert_eq!(x_cross_y, to_bevy(DVec3::Z));
    }
}
