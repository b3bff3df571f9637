//! The pointer on the globe: the ground under it, and clicks there.

use super::orbit::OrbitCamera;
use super::panels::paint::PaintForm;
use super::state::{Action, Pointer, ShownPlanet, Tool};
use super::view::PlanetReader;
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy::window::PrimaryWindow;
use bevy_pangaea::render::{GlobePicker, GlobeRay};

/// How far the pointer may move in logical pixels between press and release of a click.
const CLICK_SLOP: f32 = 4.0;

type Cameras<'w, 's> =
    Query<'w, 's, (&'static Camera, &'static GlobalTransform), With<OrbitCamera>>;

/// Finds the ground under the pointer.
pub fn find_ground(
    shown: Res<ShownPlanet>,
    window: Query<&Window, With<PrimaryWindow>>,
    cameras: Cameras,
    globes: Query<(&GlobePicker, &GlobalTransform)>,
    mut pointer: ResMut<Pointer>,
) {
    let at = window.single().ok().and_then(Window::cursor_position);
    let globe = shown.0.and_then(|planet| globes.get(planet).ok());
    pointer.ground = match (at, globe) {
        (Some(at), Some(globe)) if pointer.on_globe => ground_at(at, &cameras, globe),
        _ => None,
    };
}

/// The unit direction of the ground that is seen at a place of the window.
fn ground_at(
    at: Vec2,
    cameras: &Cameras,
    (picker, globe): (&GlobePicker, &GlobalTransform),
) -> Option<DVec3> {
    let (camera, eye) = cameras.single().ok()?;
    let ray = camera.viewport_to_world(eye, at).ok()?;
    let hit = picker.pick(GlobeRay::from_world(ray, globe))?;
    Some(hit.direction)
}

/// Does what a click asks for.
pub fn click(
    buttons: Res<ButtonInput<MouseButton>>,
    pointer: Res<Pointer>,
    window: Query<&Window, With<PrimaryWindow>>,
    mut pressed_at: Local<Option<Vec2>>,
    reader: PlanetReader,
    (mut tool, brush): (ResMut<Tool>, Res<PaintForm>),
    mut actions: MessageWriter<Action>,
) {
    let at = window.single().ok().and_then(Window::cursor_position);
    if buttons.just_pressed(MouseButton::Left) {
        *pressed_at = at.filter(|_| pointer.on_globe);
    }
    if buttons.just_released(MouseButton::Left)
        && is_click(pressed_at.take(), at)
        && pointer.on_globe
    {
        actions.write_batch(use_tool(&mut tool, &brush, pointer.ground, &reader));
    }
}

/// Whether the pointer stayed where it was pressed.
fn is_click(pressed: Option<Vec2>, released: Option<Vec2>) -> bool {
    let ends = pressed.zip(released);
    ends.is_some_and(|(pressed, released)| pressed.distance(released) <= CLICK_SLOP)
}

/// Uses the tool on the ground at a direction, or beside the globe. Returns what it asks for.
fn use_tool(
    tool: &mut Tool,
    brush: &PaintForm,
    ground: Option<DVec3>,
    reader: &PlanetReader,
) -> Option<Action> {
    match (tool, ground) {
        (Tool::Select, None) => Some(Action::Select(None)),
        (Tool::Select, Some(ground)) => Some(Action::Select(reader.view()?.plate_at(ground))),
        (Tool::RiftLine { points, .. }, Some(ground)) => {
            points.push(ground);
            None
        }
        (Tool::Paint, Some(ground)) => Some(Action::Tectonic(brush.stroke(ground))),
        (Tool::RiftLine { .. } | Tool::Paint, None) => None,
    }
}
