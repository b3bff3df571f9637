//! Spherical caps around patches of ground, and whether a camera sees over the horizon to them.
//!
//! A point at distance r from the centre, under the angle a from the camera's direction, is hidden
//! by a ball of radius b if a > acos(b / d) + acos(b / r), d the camera's distance: the ray to it
//! must pass the ball first.

use crate::math;
use bevy::math::DVec3;
use bevy::prelude::*;

/// Angle in radians beyond the horizon that stays visible: a camera may move that much in a frame.
const HORIZON_MARGIN: f64 = 0.05;

/// A circle on the sphere around a patch of ground.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub(super) struct SphericalCap {
    /// Unit direction of the middle in planet coordinates.
    pub(super) axis: DVec3,
    /// Angle from the middle to the farthest point in radians.
    pub(super) angle: f64,
}

impl SphericalCap {
    /// A circle around some unit vectors.
    pub(super) fn around(points: impl Iterator<Item = DVec3> + Clone) -> Self {
        let axis = points
            .clone()
            .sum::<DVec3>()
            .try_normalize()
            .unwrap_or(DVec3::Z);
        let angle = points
            .map(|p| math::angle_between(axis, p))
            .fold(0.0, f64::max);
        Self { axis, angle }
    }

    /// Whether a camera at `camera` (planet coordinates, planet radii) may see ground between the
    /// radii `lowest` and `highest` on this patch.
    pub(super) fn seen_from(&self, camera: DVec3, lowest: f64, highest: f64) -> bool {
        let distance = camera.length();
        // From below the ground there is no horizon.
        if distance.is_nan() || distance <= lowest {
            return true;
        }
        let horizon = math::acos(lowest / distance) + math::acos(lowest / highest.max(lowest));
        math::angle_between(self.axis, camera) - self.angle <= horizon + HORIZON_MARGIN
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Stream};

    #[test]
    fn nothing_that_a_camera_sees_is_hidden() {
        let random = Stream::new(5, Purpose::Relief, 0);
        let mut hidden = 0;
        for i in 0..3000 {
            let (lowest, highest) = (0.95, 1.05);
            let camera = random.direction(3 * i) * random.range(3 * i, 0.5, 6.0);
            let axis = random.direction(3 * i + 1);
            let cap = SphericalCap { axis, angle: 0.2 };
            // A point of the patch, as high as ground may be.
            let off = 0.19 * math::any_tangent(axis);
            let point = highest * (axis + off).normalize();
            let ray = point - camera;
            let along = (-camera.dot(ray) / ray.length_squared()).clamp(0.0, 1.0);
            let free = (camera + along * ray).length() > lowest;
            let seen = cap.seen_from(camera, lowest, highest);
            assert!(seen || !free, "{camera} {axis}");
            hidden += u32::from(!seen);
        }
        assert!(hidden > 700, "{hidden}");
    }

    #[test]
    fn a_cap_holds_its_points() {
        let random = Stream::new(6, Purpose::Relief, 0);
        let points: Vec<_> = (0..50)
            .map(|i| (DVec3::X + 0.3 * random.direction(i)).normalize())
            .collect();
        let cap = SphericalCap::around(points.iter().copied());
        let held = |&p: &DVec3| math::angle_between(cap.axis, p) <= cap.angle;
        assert!(cap.angle < 0.7 && points.iter().all(held));
        let opposite = SphericalCap::around([DVec3::X, -DVec3::X].into_iter());
        assert_eq!(opposite.axis, DVec3::Z);
    }
}
