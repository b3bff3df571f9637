//! A camera near the ground: the geometry of descending, turning and moving along.
//!
//! It stands at a height over a place and looks straight down from on high, along the land from near
//! by. Numbers have 64 bits: those of 32 hold half a metre on an Earth-sized planet.

use super::orbit::FIELD_OF_VIEW;
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::math;
use bevy_pangaea::render::to_bevy;

/// Least height over the ground or the water in metres.
const LEAST_HEIGHT_M: f64 = 2.0;
/// Height in radii from which on the orbit takes over: that of its nearest distance.
pub const ORBIT_HEIGHT: f64 = 0.25;
/// Heights in metres between which the gaze sinks from the land ahead to straight down.
const GAZE_HEIGHTS_M: (f64, f64) = (300.0, 600_000.0);
/// Angle below the horizon at which the camera looks near the ground, in radians.
const LEAST_DIP: f64 = 0.12;
/// How fast the height follows the wheel, in 1/s.
const ZOOM_RATE: f64 = 6.0;
/// How far the arrow keys move a second, in heights.
const KEY_MOVE: f64 = 0.8;
/// How far they turn a second, in radians.
const KEY_TURN: f64 = 0.9;
/// How far a pixel of a drag with the right button turns, in radians.
const PIXEL_TURN: f64 = 0.004;

/// A camera that flies over a planet.
#[derive(Component, Clone, Copy, Debug, PartialEq)]
pub struct Flight {
    /// Unit direction from the planet's centre.
    pub up: DVec3,
    /// Height over the ground in metres.
    pub height: f64,
    /// The height that it moves to.
    target: f64,
    /// Direction ahead in radians, clockwise from north.
    heading: f64,
    /// How far the user has raised the gaze, in radians.
    raised: f64,
    /// Height of the ground or the water under it over the sea, in metres.
    pub ground: f64,
}

impl Flight {
    /// Over a place, at the height at which the orbit ends on a planet of a radius in metres.
    pub fn from_orbit(up: DVec3, radius_m: f64) -> Self {
        let height = ORBIT_HEIGHT * radius_m;
        Self {
            up,
            height,
            target: height * 0.9,
            heading: 0.0,
            raised: 0.0,
            ground: 0.0,
        }
    }

    /// Whether the user wants to be higher than flights go.
    pub fn leaves(&self, radius_m: f64) -> bool {
        self.target > ORBIT_HEIGHT * radius_m
    }

    /// Moves the height to come by notches of the wheel, a sixth each.
    pub fn zoom(&mut self, notches: f64) {
        let farther = 1.0 + notches.abs() / 6.0;
        let factor = if notches > 0.0 {
            farther.recip()
        } else {
            farther
        };
        self.target = (self.target * factor).max(LEAST_HEIGHT_M);
    }

    /// Follows the wheel for `dt` seconds.
    pub fn settle(&mut self, dt: f64) {
        let share = (ZOOM_RATE * dt).min(1.0);
        self.height += (self.target - self.height) * share;
    }

    /// Moves the ground along by a drag of `pixels` in a view of `height` pixels.
    pub fn drag(&mut self, pixels: Vec2, height: f32, radius_m: f64) {
        let pixel = f64::from(FIELD_OF_VIEW / height) * self.height / radius_m;
        self.advance(f64::from(pixels.y) * pixel, f64::from(-pixels.x) * pixel);
    }

    /// Turns the gaze by a drag of `pixels`.
    pub fn turn(&mut self, pixels: Vec2) {
        self.heading += f64::from(pixels.x) * PIXEL_TURN;
        let raised = self.raised - f64::from(pixels.y) * PIXEL_TURN;
        self.raised = raised.clamp(-1.5, 1.5);
    }

    /// Turns and moves as keys ask for it during `dt` seconds: 1 to the right and ahead.
    pub fn press_keys(&mut self, wish: Vec2, dt: f64, radius_m: f64) {
        self.heading += f64::from(wish.x) * KEY_TURN * dt;
        let way = f64::from(wish.y) * KEY_MOVE * self.height / radius_m;
        self.advance(way * dt, 0.0);
    }

    /// Moves by angles ahead and to the right.
    fn advance(&mut self, ahead: f64, right: f64) {
        let [along, across] = self.along_ground();
        let moved = self.up + along * ahead + across * right;
        // The way ahead goes on straight, whatever the meridians do.
        let before = along;
        self.up = moved.normalize();
        let (east, north) = math::east_north(self.up);
        self.heading = math::atan2(before.dot(east), before.dot(north));
    }

    /// Unit tangents ahead and to the right.
    fn along_ground(&self) -> [DVec3; 2] {
        let (east, north) = math::east_north(self.up);
        let (sin, cos) = math::sin_cos(self.heading);
        [north * cos + east * sin, east * cos - north * sin]
    }

    /// Its height over the sea in metres.
    pub fn altitude(&self) -> f64 {
        self.ground + self.height
    }

    /// Its place from the planet's centre in metres.
    pub fn place(&self, radius_m: f64) -> DVec3 {
        self.up * (radius_m + self.altitude())
    }

    /// Where it stands in the world, in which the planet's radius is one unit.
    pub fn transform(&self, radius_m: f64) -> Transform {
        let [ahead, _] = self.along_ground();
        let (sin, cos) = math::sin_cos(self.dip());
        let gaze = ahead * cos - self.up * sin;
        let top = ahead * sin + self.up * cos;
        Transform::from_translation(to_bevy(self.place(radius_m) / radius_m))
            .looking_to(to_bevy(gaze), to_bevy(top))
    }

    /// Angle of the gaze below the horizon in radians.
    fn dip(&self) -> f64 {
        let (low, high) = GAZE_HEIGHTS_M;
        let part = (math::ln(self.height / low) / math::ln(high / low)).clamp(0.0, 1.0);
        let straight_down = core::f64::consts::FRAC_PI_2;
        let own = LEAST_DIP + (straight_down - LEAST_DIP) * part * part;
        (own - self.raised).clamp(-1.5, straight_down)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RADIUS_M: f64 = 6_370_000.0;

    fn flight() -> Flight {
        Flight::from_orbit(DVec3::X, RADIUS_M)
    }

    #[test]
    fn a_descent_ends_two_metres_over_the_ground() {
        let mut flight = flight();
        assert!(!flight.leaves(RADIUS_M));
        flight.ground = 1_500.0;
        (0..200).for_each(|_| flight.zoom(1.0));
        (0..300).for_each(|_| flight.settle(0.05));
        assert!((flight.altitude() - 1_502.0).abs() < 0.1, "{flight:?}");
        (0..200).for_each(|_| flight.zoom(-1.0));
        assert!(flight.leaves(RADIUS_M));
    }

    #[test]
    fn it_looks_down_from_on_high_and_along_the_land_near_by() {
        let mut flight = flight();
        let gaze = |flight: &Flight| *flight.transform(RADIUS_M).forward();
        assert!((gaze(&flight) - Vec3::NEG_X).length() < 1e-3);
        flight.height = 10.0;
        // North is the world's +y.
        assert!(gaze(&flight).y > 0.99 && gaze(&flight).x < 0.0);
    }

    #[test]
    fn a_way_ahead_is_a_great_circle() {
        let mut flight = flight();
        flight.heading = 1.0;
        let axis = flight.up.cross(flight.along_ground()[0]);
        for _ in 0..1_000 {
            flight.press_keys(Vec2::Y, 0.01, RADIUS_M);
        }
        assert!(flight.up.dot(axis).abs() < 1e-6 && flight.up.x < 0.99);
        assert!((flight.up.length() - 1.0).abs() < 1e-12);
    }
}
