//! Plates dragged by the pointer: with the select tool and Shift held, a plate is pressed, pulled
//! along a great circle and released, and moves that way from then on.
//!
//! The press point stays where it is on the globe while the plate goes on under it. Nothing is sent
//! before the release, so that a drag is one command in the recording.

use super::state::{Action, DraggedPlate, PlateDrag, Pointer, Tool};
use super::view::{PlanetReader, ShownView};
use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::math::{angle_between, lat_lon};
use bevy_pangaea::prelude::*;

/// Geological time in My in which a plate covers the distance over which it was dragged.
const DRAG_TIME_MY: f64 = 20.0;
/// Sine of the smallest angle between two points that lie on one great circle only.
const MIN_SINE: f64 = 1e-6;

/// The motion that a drag gives a plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DraggedMotion {
    /// Unit direction of the pole, about which the plate turns anticlockwise.
    pub pole: DVec3,
    /// Speed at 90 degrees from the pole in km/My.
    pub speed: f64,
}

/// The motion that carries the ground at `from` to `to` along their great circle in 20 My, on a
/// planet of `radius` km, slowed to `max_speed` in km/My.
///
/// Both are unit directions. `None` if they are one point or antipodes: no great circle, or every
/// one, leads from one to the other.
pub fn motion_of_drag(
    from: DVec3,
    to: DVec3,
    radius: f64,
    max_speed: f64,
) -> Option<DraggedMotion> {
    let across = from.cross(to);
    let sine = across.length();
    // The pole is 90 degrees from `from`, so the speed there is the largest of the plate.
    (sine > MIN_SINE).then(|| DraggedMotion {
        pole: across / sine,
        speed: (radius * angle_between(from, to) / DRAG_TIME_MY).min(max_speed),
    })
}

/// The motion that a plate gets if it is released at `to`.
pub fn motion_at(dragged: DraggedPlate, to: DVec3, view: &ShownView) -> Option<DraggedMotion> {
    motion_of_drag(dragged.from, to, view.planet.radius, view.params.max_speed)
}

/// Takes hold of plates and lets them go.
pub fn drag_plates(
    buttons: Res<ButtonInput<MouseButton>>,
    keys: Res<ButtonInput<KeyCode>>,
    (tool, pointer): (Res<Tool>, Res<Pointer>),
    reader: PlanetReader,
    mut drag: ResMut<PlateDrag>,
    mut actions: MessageWriter<Action>,
) {
    let shift = keys.any_pressed([KeyCode::ShiftLeft, KeyCode::ShiftRight]);
    if shift && *tool == Tool::Select && buttons.just_pressed(MouseButton::Left) {
        drag.0 = take_hold(&pointer, &reader);
        if let Some(dragged) = drag.0 {
            actions.write(Action::Select(Some(dragged.plate)));
        }
    } else if buttons.just_released(MouseButton::Left) {
        let dragged = drag.0.take();
        actions.write_batch(dragged.and_then(|plate| release(plate, &pointer, &reader)));
    } else if !buttons.pressed(MouseButton::Left) {
        // The release was lost, as where the window loses the focus.
        drag.0 = None;
    }
}

/// The plate under the pointer.
fn take_hold(pointer: &Pointer, reader: &PlanetReader) -> Option<DraggedPlate> {
    let from = pointer.ground?;
    let plate = reader.view()?.plate_at(from)?;
    Some(DraggedPlate { plate, from })
}

/// The command of a drag that ends under the pointer; `None` beside the globe.
fn release(dragged: DraggedPlate, pointer: &Pointer, reader: &PlanetReader) -> Option<Action> {
    let DraggedMotion { pole, speed } = motion_at(dragged, pointer.ground?, &reader.view()?)?;
    Some(Action::Tectonic(TectonicCommand::SetPlateMotion {
        plate: dragged.plate,
        pole: lat_lon(pole),
        speed,
    }))
}

#[cfg(test)]
#[path = "drag_tests.rs"]
mod tests;
