//! The orbit camera: drag turns the globe and lets it swing out, the wheel zooms, arrow keys turn.
//!
//! The planet's centre is the world's origin and its radius is one unit. A drag turns by the angle
//! that keeps the ground under the cursor, so it is fine near the ground and brisk from afar.

use super::state::Pointer;
use bevy::camera::{CameraOutputMode, Viewport, visibility::RenderLayers};
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::input::mouse::{AccumulatedMouseMotion, AccumulatedMouseScroll, MouseScrollUnit};
use bevy::prelude::*;
use bevy::render::render_resource::BlendState;
use bevy::render::renderer::RenderAdapterInfo;
use bevy::window::PrimaryWindow;
use bevy_egui::input::EguiWantsInput;
use bevy_egui::{EguiGlobalSettings, PrimaryEguiContext, egui};

/// Nearest and farthest distance from the planet's centre in radii.
const DISTANCE_LIMITS: (f32, f32) = (1.25, 12.0);
/// Steepest look at the poles in radians.
const MAX_PITCH: f32 = 1.54;
/// Vertical field of view in radians.
const FIELD_OF_VIEW: f32 = 0.6;
/// How fast a swing dies out, in 1/s.
const FRICTION: f32 = 4.0;
/// How fast the distance follows the wheel, in 1/s.
const ZOOM_RATE: f32 = 10.0;
/// How fast arrow keys turn, in radians per second from one radius above the ground.
const KEY_RATE: f32 = 1.1;

/// The area between the panels in logical pixels; none before the first frame.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct FreeArea(pub Option<egui::Rect>);

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

    /// Turns by a drag of `pixels` in a view of `height` pixels that took `dt` seconds.
    fn drag(&mut self, pixels: Vec2, height: f32, dt: f32) {
        let angle = pixels * (FIELD_OF_VIEW * (self.distance - 1.0) / height);
        // Meridians converge: the same angle of yaw moves the ground less near a pole.
        let level = (1.0 - self.direction_z().powi(2)).sqrt().max(0.25);
        let turn = Vec2::new(-angle.x / level, angle.y);
        self.turn(turn);
        self.spin = self.spin.lerp(turn / dt, 0.35);
    }

    /// Sine of the latitude that the camera stands over.
    fn direction_z(&self) -> f32 {
        self.transform().translation.y / self.distance
    }

    fn turn(&mut self, by: Vec2) {
        self.yaw = (self.yaw + by.x).rem_euclid(core::f32::consts::TAU);
        self.pitch = (self.pitch + by.y).clamp(-MAX_PITCH, MAX_PITCH);
    }

    /// Lets the camera swing out and follow the wheel for `dt` seconds.
    fn settle(&mut self, dt: f32) {
        if !self.dragging {
            self.turn(self.spin * dt);
            self.spin *= 1.0 / (1.0 + FRICTION * dt);
        }
        let share = (ZOOM_RATE * dt).min(1.0);
        self.distance += (self.target - self.distance) * share;
    }

    /// Moves the target by notches of the wheel; a notch changes the height above ground by a
    /// sixth.
    fn zoom(&mut self, notches: f32) {
        let factor = 1.0 + notches.abs() / 6.0;
        let height = (self.target - 1.0)
            * if notches > 0.0 {
                factor.recip()
            } else {
                factor
            };
        self.target = (1.0 + height).clamp(DISTANCE_LIMITS.0, DISTANCE_LIMITS.1);
    }
}

/// Puts the globe's camera and the one of the panels into the world.
pub fn spawn_cameras(
    mut commands: Commands,
    mut egui: ResMut<EguiGlobalSettings>,
    adapter: Option<Res<RenderAdapterInfo>>,
) {
    let orbit = OrbitCamera::default();
    // Software renderers pay four times for smooth edges.
    let software = adapter.is_some_and(|info| format!("{:?}", info.device_type) == "Cpu");
    commands.spawn((
        Name::new("globe camera"),
        Camera3d::default(),
        Tonemapping::None,
        if software { Msaa::Off } else { Msaa::Sample4 },
        Projection::from(PerspectiveProjection {
            fov: FIELD_OF_VIEW,
            near: 0.01,
            far: 100.0,
            ..default()
        }),
        orbit.transform(),
        orbit,
    ));
    // A camera with a viewport must not carry egui: the panels would be squeezed into it.
    egui.auto_create_primary_context = false;
    commands.spawn((
        Name::new("panel camera"),
        PrimaryEguiContext,
        Camera2d,
        Msaa::Off,
        Tonemapping::None,
        RenderLayers::none(),
        Camera {
            order: 1,
            output_mode: CameraOutputMode::Write {
                blend_state: Some(BlendState::ALPHA_BLENDING),
                clear_color: ClearColorConfig::None,
            },
            clear_color: ClearColorConfig::Custom(Color::NONE),
            ..default()
        },
    ));
}

/// Turns and zooms by mouse and keys.
pub fn steer(
    mut cameras: Query<(&mut OrbitCamera, &mut Transform)>,
    (time, pointer, area): (Res<Time>, Res<Pointer>, Res<FreeArea>),
    (buttons, keys): (Res<ButtonInput<MouseButton>>, Res<ButtonInput<KeyCode>>),
    (motion, scroll): (Res<AccumulatedMouseMotion>, Res<AccumulatedMouseScroll>),
    egui: Res<EguiWantsInput>,
) {
    const DRAG: [MouseButton; 3] = [MouseButton::Left, MouseButton::Right, MouseButton::Middle];
    let Ok((mut camera, mut transform)) = cameras.single_mut() else {
        return;
    };
    let dt = time.delta_secs().clamp(1e-3, 0.1);
    if pointer.on_globe && buttons.any_just_pressed(DRAG) {
        camera.dragging = true;
        camera.spin = Vec2::ZERO;
    }
    if !buttons.any_pressed(DRAG) {
        camera.dragging = false;
    }
    if camera.dragging {
        let height = area.0.map_or(700.0, |rect| rect.height()).max(1.0);
        camera.drag(motion.delta, height, dt);
    }
    if pointer.on_globe && scroll.delta.y != 0.0 {
        let unit = if scroll.unit == MouseScrollUnit::Line {
            1.0
        } else {
            0.02
        };
        camera.zoom(scroll.delta.y * unit);
    }
    if !egui.wants_keyboard_input() {
        let axis = |minus, plus| f32::from(keys.pressed(plus)) - f32::from(keys.pressed(minus));
        let wish = Vec2::new(
            axis(KeyCode::ArrowLeft, KeyCode::ArrowRight),
            axis(KeyCode::ArrowDown, KeyCode::ArrowUp),
        );
        if wish != Vec2::ZERO {
            let rate = KEY_RATE * (camera.distance - 1.0).clamp(0.3, 2.0);
            camera.spin = camera.spin.lerp(wish * rate, (8.0 * dt).min(1.0));
        }
        camera.zoom(axis(KeyCode::PageDown, KeyCode::PageUp) * 6.0 * dt);
    }
    camera.settle(dt);
    transform.set_if_neq(camera.transform());
}

/// Keeps the globe in the middle of the free area.
pub fn fit_viewport(
    area: Res<FreeArea>,
    window: Query<&Window, With<PrimaryWindow>>,
    mut cameras: Query<&mut Camera, With<OrbitCamera>>,
) {
    let (Ok(mut camera), Ok(window)) = (cameras.single_mut(), window.single()) else {
        return;
    };
    let scale = window.scale_factor();
    let viewport = area.0.and_then(|rect| {
        let min = (Vec2::new(rect.min.x, rect.min.y) * scale).as_uvec2();
        let max = (Vec2::new(rect.max.x, rect.max.y) * scale)
            .as_uvec2()
            .min(window.physical_size());
        let size = max.saturating_sub(min);
        (size.min_element() >= 16).then(|| Viewport {
            physical_position: min,
            physical_size: size,
            ..default()
        })
    });
    let place = |v: &Viewport| (v.physical_position, v.physical_size);
    if camera.viewport.as_ref().map(place) != viewport.as_ref().map(place) {
        camera.viewport = viewport;
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
}
