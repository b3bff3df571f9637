//! The cameras of the window: drag turns the globe and lets it swing out, the wheel zooms, arrow
//! keys turn.

use super::flight::Flight;
use super::land::LandBelow;
use super::orbit::{FIELD_OF_VIEW, OrbitCamera};
use super::state::{PlateDrag, Pointer, ShownPlanet};
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
use bevy_pangaea::planet::Planet;
use bevy_pangaea::render::{from_bevy, to_bevy};

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

type Steered<'a> = (
    Entity,
    &'a mut OrbitCamera,
    &'a mut Transform,
    Option<&'a mut Flight>,
);

/// Turns, zooms and flies by mouse and keys.
pub fn steer(
    mut cameras: Query<Steered>,
    time: Res<Time>,
    input: SteeringInput,
    shown: Res<ShownPlanet>,
    planets: Query<&Planet>,
    land: Res<LandBelow>,
    mut commands: Commands,
) {
    let Ok((entity, mut camera, mut transform, flight)) = cameras.single_mut() else {
        return;
    };
    let planet = shown.0.and_then(|planet| planets.get(planet).ok());
    let radius_m = planet.map_or(1.0, |planet| planet.radius * 1000.0);
    // A frame that took long must not throw the globe around.
    let dt = time.delta_secs().clamp(1e-3, 0.1);
    let Some(mut flight) = flight else {
        let descends = input.orbit(&mut camera, dt);
        transform.set_if_neq(camera.transform());
        if descends && planet.is_some() {
            let up = from_bevy(transform.translation).normalize();
            let flight = Flight::from_orbit(up, radius_m);
            commands.entity(entity).insert(flight);
        }
        return;
    };
    input.fly(&mut flight, f64::from(dt), radius_m);
    flight.ground = land.height(flight.up);
    transform.set_if_neq(flight.transform(radius_m));
    if flight.leaves(radius_m) || planet.is_none() {
        *camera = OrbitCamera::rising(to_bevy(flight.up));
        commands.entity(entity).remove::<Flight>();
    }
}

impl SteeringInput<'_> {
    /// Circles the globe; returns whether the user wants to come nearer than that allows.
    fn orbit(&self, camera: &mut OrbitCamera, dt: f32) -> bool {
        self.drag(camera, dt);
        let notches = self.notches(dt);
        let descends = notches > 0.0 && camera.is_nearest();
        if notches != 0.0 {
            camera.zoom(notches);
        }
        let wish = self.arrows();
        if wish != Vec2::ZERO {
            camera.turn_by_keys(wish, dt);
        }
        camera.settle(dt);
        descends
    }

    /// Flies over the ground.
    fn fly(&self, flight: &mut Flight, dt: f64, radius_m: f64) {
        let height = self.view_height();
        if self.pointer.on_globe && self.buttons.pressed(MouseButton::Right) {
            flight.turn(self.motion.delta);
        } else if self.pointer.on_globe && self.buttons.any_pressed(DRAG_BUTTONS) {
            flight.drag(self.motion.delta, height, radius_m);
        }
        let notches = self.notches(dt as f32);
        if notches != 0.0 {
            flight.zoom(f64::from(notches));
        }
        let wish = self.arrows();
        if wish != Vec2::ZERO {
            flight.press_keys(wish, dt, radius_m);
        }
        flight.settle(dt);
    }

    /// Logical pixels from the bottom of the view to its top.
    fn view_height(&self) -> f32 {
        self.area.0.map_or(700.0, |rect| rect.height()).max(1.0)
    }

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
            camera.drag(self.motion.delta, self.view_height(), dt);
        }
    }

    /// Notches towards the ground, of the wheel and of keys.
    fn notches(&self, dt: f32) -> f32 {
        let of_wheel = match self.scroll.unit {
            _ if !self.pointer.on_globe => 0.0,
            MouseScrollUnit::Line => self.scroll.delta.y,
            MouseScrollUnit::Pixel => self.scroll.delta.y * NOTCHES_PER_PIXEL,
        };
        let of_keys = self.axis(KeyCode::PageDown, KeyCode::PageUp) * KEY_NOTCHES * dt;
        of_wheel + of_keys
    }

    /// The arrow keys that are held: 1 to the right and up.
    fn arrows(&self) -> Vec2 {
        Vec2::new(
            self.axis(KeyCode::ArrowLeft, KeyCode::ArrowRight),
            self.axis(KeyCode::ArrowDown, KeyCode::ArrowUp),
        )
    }

    /// 1 while the key of the positive direction is held, -1 for the negative one.
    fn axis(&self, minus: KeyCode, plus: KeyCode) -> f32 {
        if self.egui.wants_keyboard_input() {
            return 0.0;
        }
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
