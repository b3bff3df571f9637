//! Settings of the planet on show, brought up to date each frame: the look of its globe, whether it
//! is baked, and its share of the frame.

use super::flight::Flight;
use super::orbit::OrbitCamera;
use super::panels::timings::FrameTimes;
use super::state::{Look, Selection, ShownPlanet};
use bevy::prelude::*;
use bevy_pangaea::control::BakeSettings;
use bevy_pangaea::prelude::*;
use bevy_pangaea::render::{Globe, from_bevy};
use std::time::Duration;

/// Share of a frame for the simulation where drawing takes long anyway.
const FRAME_SHARE: f64 = 0.25;
/// Least and most time of a frame for the simulation in ms.
const BUDGET_LIMITS_MS: (f64, f64) = (8.0, 60.0);

/// Gives the simulation its share of a frame: a few ms, or a quarter where drawing takes long
/// anyway.
pub fn set_frame_budget(
    frames: Res<FrameTimes>,
    shown: Res<ShownPlanet>,
    mut controls: Query<&mut ClockControls>,
) {
    let Some(mut controls) = shown.0.and_then(|planet| controls.get_mut(planet).ok()) else {
        return;
    };
    let ms = (FRAME_SHARE * frames.mean()).clamp(BUDGET_LIMITS_MS.0, BUDGET_LIMITS_MS.1);
    controls.frame_budget = Duration::from_secs_f64(ms * 1e-3);
}

/// The colour behind the planet: of space, or of the sky at an altitude in metres.
pub fn sky(altitude_m: Option<f64>) -> Color {
    let space = Color::srgb(0.016, 0.02, 0.031);
    match altitude_m {
        Some(altitude) => space.mix(&crate::landscape::sky(altitude), 0.95),
        None => space,
    }
}

/// Lets climate and rivers follow the planet only while the globe shows them, or somebody flies over
/// the ground: they cost a core a quarter of a second.
pub fn request_bakes(
    look: Res<Look>,
    shown: Res<ShownPlanet>,
    flights: Query<(), With<Flight>>,
    planets: Query<Has<BakeSettings>>,
    mut commands: Commands,
) {
    let Some(planet) = shown.0 else { return };
    let Ok(requested) = planets.get(planet) else {
        return;
    };
    let is_needed = look.overlay.needs_bake() || !flights.is_empty();
    match (is_needed, requested) {
        (true, false) => drop(commands.entity(planet).insert(BakeSettings::default())),
        (false, true) => drop(commands.entity(planet).remove::<BakeSettings>()),
        _ => {}
    }
}

/// Gives the globe the chosen look.
pub fn set_look(
    look: Res<Look>,
    selection: Res<Selection>,
    shown: Res<ShownPlanet>,
    camera: Query<&GlobalTransform, With<OrbitCamera>>,
    mut globes: Query<&mut Globe>,
) {
    let Some(mut globe) = shown.0.and_then(|planet| globes.get_mut(planet).ok()) else {
        return;
    };
    let mut wanted = globe.clone();
    wanted.overlay = look.overlay;
    wanted.exaggeration = look.exaggeration;
    wanted.sea = look.sea;
    wanted.boundaries = look.boundaries;
    wanted.wireframe = look.wireframe;
    wanted.selected = selection.0;
    wanted.air = if look.air { 1.0 } else { 0.0 };
    if let (true, Ok(camera)) = (look.sun_follows, camera.single()) {
        // Behind the viewer's left shoulder.
        let sun = camera.back() * 0.75 + camera.up() * 0.45 - camera.right() * 0.55;
        wanted.sun = from_bevy(sun).normalize();
    }
    // A change makes the globe be drawn anew.
    globe.set_if_neq(wanted);
}
