//! Rigid geodetic motion: rotation about an axis through the planet's centre (paper 000 §3).

use bevy::math::DVec3;
use bevy::prelude::*;

/// The motion G of a plate. A point p of it moves with `s(p) = omega w x p`.
///
/// ```
/// # use bevy_pangaea::{math, plate::PlateMotion};
/// # use bevy::math::DVec3;
/// // 60 km/My to the east along the equator of a planet of 6370 km.
/// let motion = PlateMotion { axis: DVec3::Z, speed: 60.0 / 6370.0 };
/// let velocity = motion.velocity(math::direction(0.0, 0.0)) * 6370.0;
/// assert!((velocity - DVec3::Y * 60.0).length() < 1e-9);
/// // Nothing moves at the pole of rotation.
/// assert_eq!(motion.velocity(DVec3::Z), DVec3::ZERO);
/// ```
#[derive(Component, Clone, Copy, Debug, PartialEq, Reflect)]
#[reflect(Component)]
pub struct PlateMotion {
    /// Unit rotation axis w.
    pub axis: DVec3,
    /// Angular speed omega in rad/My, not negative.
    pub speed: f64,
}

/// Angular speed in rad/My below which a plate is at rest: its axis would be rounding.
const LEAST_SPEED: f64 = 1e-12;

impl PlateMotion {
    /// A plate at rest.
    pub const REST: Self = Self {
        axis: DVec3::Z,
        speed: 0.0,
    };

    /// The motion with the angular velocity `omega` in rad/My.
    pub fn from_angular_velocity(omega: DVec3) -> Self {
        let speed = omega.length();
        if speed > LEAST_SPEED {
            Self {
                axis: omega / speed,
                speed,
            }
        } else {
            Self::REST
        }
    }

    /// Angular velocity omega w in rad/My.
    pub fn angular_velocity(&self) -> DVec3 {
        self.axis * self.speed
    }

    /// Surface velocity at the unit direction `p`, in planet radii per My.
    pub fn velocity(&self, p: DVec3) -> DVec3 {
        self.angular_velocity().cross(p)
    }

    /// The same motion slowed so that no point exceeds `limit` rad/My.
    pub fn limited(&self, limit: f64) -> Self {
        Self {
            axis: self.axis,
            speed: self.speed.min(limit),
        }
    }
}
