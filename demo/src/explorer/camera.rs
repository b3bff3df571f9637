//! The cameras of the window: drag turns the globe and lets it swing out, the wheel zooms, arrow
//! keys turn.

use super::orbit::{FIELD_OF_VIEW, OrbitCamera};
use super::state::{PlateDrag, Pointer};
use bevy::camera::{CameraOutputMode, Viewport, visibility::RenderLayers};
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::ecs::system::SystemParam;
use bevy::input::mouse::{AccumulatedMouseMotion, AccumulatedMouseScroll, MouseScrollUnit};
use bevy::prelude::*;
use bevy::render::render_resource::BlendState;
use bevy::render::renderer::RenderAdapterInfo;
use bevy::window::PrimaryWindow;
use bevy_egui::input::EguiWantsInput;
use bevy_egui::{EguiGlobalSettings, PrimaryEguiContext, egui};

/// Buttons that turn the globe.
const DRAG_BUTTONS: [MouseButton; 3] = [MouseButton::Left, MouseButton::Right, MouseButton::Middle];
/// Notches of the wheel that a pixel of a touchpad counts for.
const NOTCHES_PER_PIXEL: f32 = 0.02;
/// Notches of the wheel that a held key counts for, in 1/s.
const KEY_NOTCHES: f32 = 6.0;

/// The area between the panels in logical pixels, `None` before the first frame.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq)]
pub struct FreeArea(pub Option<egui::Rect>);

/// Puts the globe's camera and the one of the panels into the world.
pub fn spawn_cameras(
    mut commands: Commands,
    mut egui: ResMut<EguiGlobalSettings>,
    adapter: Option<Res<RenderAdapterInfo>>,
) {
    // Software renderers pay four times for smooth edges.
    let software = adapter.is_some_and(|info| format!("{:?}", info.device_type) == "Cpu");
    let msaa = if software { Msaa::Off } else { Msaa::Sample4 };
    commands.spawn((globe_camera(), msaa));
    // A camera with a viewport must not carry egui: the panels would be squeezed into it.
    egui.auto_create_primary_context = false;
    commands.spawn(panel_camera());
}

fn globe_camera() -> impl Bundle {
    let orbit = OrbitCamera::default();
    (
        Name::new("globe camera"),
        Camera3d::default(),
        Tonemapping::None,
        Projection::from(PerspectiveProjection {
            fov: FIELD_OF_VIEW,
            near: 0.01,
            far: 100.0,
            ..default()
        }),
        orbit.transform(),
        orbit,
    )
}

/// A camera that draws egui over the whole window, and nothing else.
fn panel_camera() -> impl Bundle {
    (
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
    )
}

/// The mouse and the keys that steer the camera.
#[derive(SystemParam)]
pub struct SteeringInput<'w> {
    pointer: Res<'w, Pointer>,
    plate_drag: Res<'w, PlateDrag>,
    area: Res<'w, FreeArea>,
    buttons: Res<'w, ButtonInput<MouseButton>>,
    keys: Res<'w, ButtonInput<KeyCode>>,
    motion: Res<'w, AccumulatedMouseMotion>,
    scroll: Res<'w, AccumulatedMouseScroll>,
    egui: Res<'w, EguiWantsInput>,
}

/// Turns and zooms by mouse and keys.
pub fn steer(
    mut cameras: Query<(&mut OrbitCamera, &mut Transform)>,
    time: Res<Time>,
    input: SteeringInput,
) {
    let Ok((mut camera, mut transform)) = cameras.single_mut() else {
        return;
    };
    // A frame that took long must not throw the globe around.
    let dt = time.delta_secs().clamp(1e-3, 0.1);
    input.drag(&mut camera, dt);
    input.scroll(&mut camera);
    if !input.egui.wants_keyboard_input() {
        input.press_keys(&mut camera, dt);
    }
    camera.settle(dt);
    transform.set_if_neq(camera.transform());
}

impl SteeringInput<'_> {
    fn drag(&self, camera: &mut OrbitCamera, dt: f32) {
        // The globe stands still while a plate is dragged over it.
        if self.plate_drag.0.is_some() {
            camera.stop();
            return;
        }
        if self.pointer.on_globe && self.buttons.any_just_pressed(DRAG_BUTTONS) {
            camera.grab();
        }
        if !self.buttons.any_pressed(DRAG_BUTTONS) {
            camera.release();
        }
        if camera.is_dragging() {
            let height = self.area.0.map_or(700.0, |rect| rect.height()).max(1.0);
            camera.drag(self.motion.delta, height, dt);
        }
    }

    fn scroll(&self, camera: &mut OrbitCamera) {
        if !self.pointer.on_globe || self.scroll.delta.y == 0.0 {
            return;
        }
        let notches = match self.scroll.unit {
            MouseScrollUnit::Line => 1.0,
            MouseScrollUnit::Pixel => NOTCHES_PER_PIXEL,
        };
        camera.zoom(self.scroll.delta.y * notches);
    }

    fn press_keys(&self, camera: &mut OrbitCamera, dt: f32) {
        let wish = Vec2::new(
            self.axis(KeyCode::ArrowLeft, KeyCode::ArrowRight),
            self.axis(KeyCode::ArrowDown, KeyCode::ArrowUp),
        );
        if wish != Vec2::ZERO {
            camera.turn_by_keys(wish, dt);
        }
        camera.zoom(self.axis(KeyCode::PageDown, KeyCode::PageUp) * KEY_NOTCHES * dt);
    }

    /// 1 while the key of the positive direction is held, -1 for the negative one.
    fn axis(&self, minus: KeyCode, plus: KeyCode) -> f32 {
        f32::from(self.keys.pressed(plus)) - f32::from(self.keys.pressed(minus))
    }
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
    let viewport = area.0.and_then(|rect| viewport_of(rect, window));
    // Written only where it differs: Bevy computes a camera that was touched anew.
    if camera.viewport.as_ref().map(place_of) != viewport.as_ref().map(place_of) {
        camera.viewport = viewport;
    }
}

/// The part of the window under an area in logical pixels; `None` where it is too small to draw.
fn viewport_of(area: egui::Rect, window: &Window) -> Option<Viewport> {
    let scale = window.scale_factor();
    let min = (Vec2::new(area.min.x, area.min.y) * scale).as_uvec2();
    let max = (Vec2::new(area.max.x, area.max.y) * scale).as_uvec2();
    let size = max.min(window.physical_size()).saturating_sub(min);
    (size.min_element() >= 16).then(|| Viewport {
        physical_position: min,
        physical_size: size,
        ..default()
    })
}

fn place_of(viewport: &Viewport) -> (UVec2, UVec2) {
    (viewport.physical_position, viewport.physical_size)
}
