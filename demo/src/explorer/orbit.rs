//! A camera that circles a globe: the geometry of turning and zooming.
//!
//! The planet's centre is the world's origin and its radius is one unit. A drag turns by the angle
//! that keeps the ground under the pointer, so it is fine near the ground and brisk from afar.

use bevy::prelude::*;

/// Vertical field of view in radians.
pub const FIELD_OF_VIEW: f32 = 0.6;
/// Nearest and farthest distance from the planet's centre in radii.
const DISTANCE_LIMITS: (f32, f32) = (1.25, 12.0);
/// Steepest look at the poles in radians.
const MAX_PITCH: f32 = 1.54;
/// How fast a swing dies out, in 1/s.
const FRICTION: f32 = 4.0;
/// How fast the distance follows the wheel, in 1/s.
const ZOOM_RATE: f32 = 10.0;
/// How fast arrow keys turn, in radians per second from one radius above the ground.
const KEY_RATE: f32 = 1.1;
/// How fast the spin follows arrow keys, in 1/s.
const KEY_RESPONSE: f32 = 8.0;
/// Share of a frame's motion that the spin of a drag takes over.
const SPIN_RESPONSE: f32 = 0.35;

/// A camera that circles the origin.
#[derive(Component, Clone, Copy, Debug)]
pub struct OrbitCamera {
    /// Angle about the axis in radians.
    pub yaw: f32,
    /// Angle above the equator in radians.
    pub pitch: f32,
    /// Distance from the centre in radii.
    pub distance: f32,
    /// The distance that it moves to.
    pub target: f32,
    /// Angular velocity (yaw, pitch) in rad/s.
    spin: Vec2,
    /// Whether the pointer holds the globe.
    dragging: bool,
}

impl Default for OrbitCamera {
    fn default() -> Self {
        Self {
            yaw: 0.6,
            pitch: 0.35,
            distance: 5.5,
            target: 4.2,
            spin: Vec2::ZERO,
            dragging: false,
        }
    }
}

impl OrbitCamera {
    /// Where the camera stands.
    pub fn transform(&self) -> Transform {
        let turn = Quat::from_euler(EulerRot::YXZ, self.yaw, -self.pitch, 0.0);
        Transform {
            translation: turn * (Vec3::Z * self.distance),
            rotation: turn,
            ..default()
        }
    }

    /// A camera over a direction of the world, at its nearest; it rises on from there.
    pub fn rising(over: Vec3) -> Self {
        let nearest = DISTANCE_LIMITS.0;
        Self {
            yaw: over.x.atan2(over.z),
            pitch: over.y.clamp(-1.0, 1.0).asin().clamp(-MAX_PITCH, MAX_PITCH),
            distance: nearest,
            target: nearest * 1.05,
            ..default()
        }
    }

    /// Whether it has come as near as it can.
    pub fn is_nearest(&self) -> bool {
        self.target <= DISTANCE_LIMITS.0 && self.distance < DISTANCE_LIMITS.0 * 1.02
    }

    /// The globe stands still, whatever holds it.
    pub fn stop(&mut self) {
        self.dragging = false;
        self.spin = Vec2::ZERO;
    }

    /// The pointer takes hold of the globe, which stands still until it is dragged.
    pub fn grab(&mut self) {
        self.stop();
        self.dragging = true;
    }

    /// The pointer lets go of the globe, which swings out.
    pub fn release(&mut self) {
        self.dragging = false;
    }

    /// Whether the pointer holds the globe.
    pub fn is_dragging(&self) -> bool {
        self.dragging
    }

    /// Turns by a drag of `pixels` in a view of `height` pixels that took `dt` seconds.
    pub fn drag(&mut self, pixels: Vec2, height: f32, dt: f32) {
        let angle = pixels * (FIELD_OF_VIEW * (self.distance - 1.0) / height);
        // Meridians converge: the same angle of yaw moves the ground less near a pole.
        let level = (1.0 - self.sine_of_latitude().powi(2)).sqrt().max(0.25);
        let turn = Vec2::new(-angle.x / level, angle.y);
        self.turn(turn);
        // Smoothed over some frames: one jerk of the hand does not spin the globe.
        self.spin = self.spin.lerp(turn / dt, SPIN_RESPONSE);
    }

    /// Sine of the latitude that the camera stands over.
    fn sine_of_latitude(&self) -> f32 {
        self.transform().translation.y / self.distance
    }

    fn turn(&mut self, by: Vec2) {
        self.yaw = (self.yaw + by.x).rem_euclid(core::f32::consts::TAU);
        self.pitch = (self.pitch + by.y).clamp(-MAX_PITCH, MAX_PITCH);
    }

    /// Turns as keys ask for it during `dt` seconds: 1 to the right and up, -1 to the left and
    /// down.
    pub fn turn_by_keys(&mut self, wish: Vec2, dt: f32) {
        let rate = KEY_RATE * (self.distance - 1.0).clamp(0.3, 2.0);
        let share = (KEY_RESPONSE * dt).min(1.0);
        self.spin = self.spin.lerp(wish * rate, share);
    }

    /// Lets the camera swing out and follow the wheel for `dt` seconds.
    pub fn settle(&mut self, dt: f32) {
        if !self.dragging {
            self.turn(self.spin * dt);
            // Implicit Euler: stable however long a frame takes.
            self.spin *= 1.0 / (1.0 + FRICTION * dt);
        }
        let share = (ZOOM_RATE * dt).min(1.0);
        self.distance += (self.target - self.distance) * share;
    }

    /// Moves the target by notches of the wheel; a notch changes the height above ground by a
    /// sixth.
    pub fn zoom(&mut self, notches: f32) {
        // Inverse factors in the two directions, so that a notch can be undone.
        let farther = 1.0 + notches.abs() / 6.0;
        let factor = if notches > 0.0 {
            farther.recip()
        } else {
            farther
        };
        let height = (self.target - 1.0) * factor;
        self.target = (1.0 + height).clamp(DISTANCE_LIMITS.0, DISTANCE_LIMITS.1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zoom_stays_within_its_limits_and_a_notch_can_be_undone() {
        let mut camera = OrbitCamera::default();
        let before = camera.target;
        camera.zoom(1.0);
        assert!(camera.target < before);
        camera.zoom(-1.0);
        assert!((camera.target - before).abs() < 1e-5);
        camera.zoom(1000.0);
        assert_eq!(camera.target, DISTANCE_LIMITS.0);
        camera.zoom(-1e6);
        assert_eq!(camera.target, DISTANCE_LIMITS.1);
    }

    #[test]
    fn the_camera_looks_at_the_centre_and_swings_out() {
        let mut camera = OrbitCamera::default();
        camera.drag(Vec2::new(30.0, -500.0), 700.0, 0.016);
        assert!(camera.pitch >= -MAX_PITCH);
        for _ in 0..600 {
            camera.settle(0.016);
        }
        assert!(camera.spin.length() < 1e-3);
        assert!((camera.distance - camera.target).abs() < 1e-3);
        let transform = camera.transform();
        let toward = transform.forward().dot(-transform.translation.normalize());
        assert!((toward - 1.0).abs() < 1e-5);
    }

    #[test]
    fn a_camera_that_rises_stands_over_its_place() {
        for over in [
            Vec3::X,
            Vec3::new(-0.3, 0.8, 0.52),
            Vec3::new(0.1, -0.2, -0.9),
        ] {
            let over = over.normalize();
            let camera = OrbitCamera::rising(over);
            assert!((camera.transform().translation / camera.distance - over).length() < 1e-5);
            assert!(!camera.is_nearest());
        }
    }

    #[test]
    fn a_globe_that_is_held_stands_still() {
        let mut camera = OrbitCamera::default();
        camera.drag(Vec2::new(30.0, 20.0), 700.0, 0.016);
        let (yaw, pitch) = (camera.yaw, camera.pitch);
        camera.grab();
        camera.settle(0.016);
        camera.release();
        camera.settle(0.016);
        assert_eq!((camera.yaw, camera.pitch), (yaw, pitch));
    }
}
