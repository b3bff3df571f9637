//! The pointer on the globe: what lies under it, and what a click there does.

use super::camera::OrbitCamera;
use super::panels::paint::PaintForm;
use super::session::Session;
use super::state::{Action, Pointer, Tool};
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_pangaea::prelude::*;
use bevy_pangaea::render::{GlobePicker, GlobeRay};

/// How far the pointer may move in logical pixels between press and release of a click.
const CLICK_SLOP: f32 = 4.0;

/// Finds the ground under the pointer.
pub fn find_ground(
    session: Res<Session>,
    window: Query<&Window, With<PrimaryWindow>>,
    cameras: Query<(&Camera, &GlobalTransform), With<OrbitCamera>>,
    globes: Query<(&GlobePicker, &GlobalTransform)>,
    mut pointer: ResMut<Pointer>,
) {
    let ground = || {
        let (camera, eye) = cameras.single().ok()?;
        let (picker, place) = globes.get(session.planet?).ok()?;
        let at = window.single().ok()?.cursor_position()?;
        let ray = camera.viewport_to_world(eye, at).ok()?;
        Some(picker.pick(GlobeRay::from_world(ray, place))?.direction)
    };
    pointer.ground = if pointer.on_globe { ground() } else { None };
}

/// Does what a click asks for.
pub fn click(
    (buttons, pointer): (Res<ButtonInput<MouseButton>>, Res<Pointer>),
    window: Query<&Window, With<PrimaryWindow>>,
    mut pressed_at: Local<Option<Vec2>>,
    session: Res<Session>,
    planets: Query<(&Lattice, &PlanetSurface)>,
    (mut tool, brush): (ResMut<Tool>, Res<PaintForm>),
    mut actions: MessageWriter<Action>,
) {
    let at = window.single().ok().and_then(Window::cursor_position);
    if buttons.just_pressed(MouseButton::Left) {
        *pressed_at = at.filter(|_| pointer.on_globe);
    }
    if !buttons.just_released(MouseButton::Left) {
        return;
    }
    let (Some(from), Some(to)) = (pressed_at.take(), at) else {
        return;
    };
    if from.distance(to) > CLICK_SLOP || !pointer.on_globe {
        return;
    }
    match (&mut *tool, pointer.ground) {
        (Tool::Select, None) => {
            actions.write(Action::Select(None));
        }
        (Tool::Select, Some(ground)) => {
            let Some(planet) = session.planet else { return };
            let Ok((lattice, surface)) = planets.get(planet) else {
                return;
            };
            let plate = surface
                .plate
                .get(lattice.0.nearest(ground) as usize)
                .copied();
            actions.write(Action::Select(plate));
        }
        (Tool::RiftLine { points, .. }, Some(ground)) => points.push(ground),
        (Tool::Paint, Some(ground)) => {
            actions.write(Action::Tectonic(brush.stroke(ground)));
        }
        (_, None) => {}
    }
}
