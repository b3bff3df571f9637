//! Commands to the model: parameters, processes, resamples, and when commands take effect.

use super::{accept, planet};
use bevy_pangaea::prelude::*;
use pangaea_tests::order::{set_param, set_process};
use pangaea_tests::world::{command, get, heard, listen, steps};

#[test]
fn a_parameter_has_the_value_it_is_given() {
    let (mut app, planet) = planet();
    accept(&mut app, planet, set_param("erosion", 0.5));
    assert_eq!(get::<TectonicParams>(&app, planet).erosion, 0.5);
}

#[test]
fn a_process_is_switched_off() {
    let (mut app, planet) = planet();
    accept(&mut app, planet, set_process("drift", false));
    assert!(!get::<TectonicParams>(&app, planet).processes.drift);
}

#[test]
fn a_resample_comes_when_it_is_asked_for() {
    let (mut app, planet) = planet();
    listen::<CrustResampled>(&mut app);
    accept(&mut app, planet, TectonicCommand::Resample);
    assert_eq!(heard::<CrustResampled>(&app).len(), 1);
}

#[test]
fn oceans_may_change_their_law() {
    let (mut app, planet) = planet();
    let law = OceanFloor::Paper;
    accept(&mut app, planet, TectonicCommand::SetOceanFloor { law });
    assert_eq!(get::<TectonicParams>(&app, planet).ocean_floor, law);
}

#[test]
fn commands_wait_for_the_end_of_a_step() {
    let (mut app, planet) = planet();
    let before = get::<TectonicParams>(&app, planet).erosion;
    command(&mut app, planet, set_param("erosion", 0.7));
    assert_eq!(get::<TectonicParams>(&app, planet).erosion, before);
    steps(&mut app, planet, 1);
    assert_eq!(get::<TectonicParams>(&app, planet).erosion, 0.7);
    let mut commands = app.world_mut().commands();
    commands.entity(planet).tectonic(TectonicCommand::Resample);
    app.world_mut().flush();
    steps(&mut app, planet, 1);
    assert_eq!(get::<Recording>(&app, planet).0.len(), 2);
}
