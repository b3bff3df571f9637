//! A recording of commands, replayed on the same recipe, gives the same bits.

use super::lively;
use bevy::prelude::*;
use bevy_pangaea::authoring::apply_pending;
use bevy_pangaea::io::scenario::{parse_scenario, scenario_of};
use bevy_pangaea::plate::PlateId;
use bevy_pangaea::prelude::*;
use pangaea_tests::order::{paint, paint_all, rift, set_crust, set_motion, set_param, set_process};
use pangaea_tests::world::{command, digest, get, heard, listen, obey, planet_app, state, steps};

/// Commands of a user, each with the step before which it comes; two are refused.
fn session() -> Vec<(u64, TectonicCommand)> {
    let disc = PaintTarget::Disc {
        center: (20.0, 40.0),
        radius: 1500.0,
    };
    vec![
        (0, set_motion(PlateId(1), (40.0, -70.0), -85.5)),
        (2, paint(disc, Brush::Kind(CrustKind::Continental))),
        (2, paint(disc, Brush::Raise(1.25))),
        (5, rift(PlateId(0), &[], 2)),
        (5, set_motion(PlateId(999), (0.0, 0.0), 1.0)),
        (6, set_param("uplift", 1.1)),
        (8, TectonicCommand::Resample),
        (9, set_crust(PlateId(5), CrustKind::Oceanic)),
        (9, set_process("erosion", false)),
        (14, set_param("erosion", f64::NAN)),
        (15, paint_all(Brush::Raise(-0.1))),
        (17, set_process("erosion", true)),
    ]
}

const STEPS: u64 = 24;

/// A planet whose user does what [`session`] says.
fn played(recipe: &PlanetRecipe) -> (App, Entity) {
    let (mut app, planet) = planet_app(recipe);
    listen::<CommandRejected>(&mut app);
    listen::<CommandApplied>(&mut app);
    for step in 0..STEPS {
        for (_, wanted) in session().into_iter().filter(|(when, _)| *when == step) {
            command(&mut app, planet, wanted);
        }
        steps(&mut app, planet, 1);
    }
    (app, planet)
}

#[test]
fn a_recording_replays_to_the_same_digest() {
    let recipe = lively(7, 6000);
    let (app, planet) = played(&recipe);
    let recording = get::<Recording>(&app, planet).clone();
    let accepted = session().len() - 2;
    assert_eq!(heard::<CommandRejected>(&app).len(), 2);
    assert_eq!(heard::<CommandApplied>(&app).len(), accepted);
    assert_eq!(recording.0.len(), accepted);
    let (mut again, replayed) = planet_app(&recipe);
    let world = again.world_mut();
    world.entity_mut(replayed).insert(Scenario::from(recording));
    steps(&mut again, replayed, STEPS);
    assert_eq!(digest(&app, planet), digest(&again, replayed));
}

#[test]
fn the_scenario_of_a_planet_gives_the_same_planet() {
    let recipe = lively(11, 3000);
    let (mut app, planet) = played(&recipe);
    // The planet rests, and its user goes on.
    assert!(obey(&mut app, planet, paint_all(Brush::Raise(0.3))));
    let text = scenario_of(&state(&app, planet));
    assert_eq!(
        text.lines()
            .filter(|line| line.contains("command:"))
            .count(),
        session().len() - 1
    );
    let (mut again, replayed) = planet_app(&recipe);
    let scenario = parse_scenario(&text).unwrap();
    again.world_mut().entity_mut(replayed).insert(scenario);
    steps(&mut again, replayed, STEPS);
    apply_pending(again.world_mut(), replayed);
    assert_eq!(digest(&app, planet), digest(&again, replayed));
}

#[test]
fn commands_to_come_are_part_of_the_scenario_of_a_planet() {
    let recipe = lively(12, 1000);
    let (mut app, planet) = planet_app(&recipe);
    let to_come = vec![TimedCommand {
        step: 9,
        command: set_param("erosion", 0.1 + 0.2),
    }];
    let scenario = Scenario(to_come.clone());
    app.world_mut().entity_mut(planet).insert(scenario);
    command(&mut app, planet, TectonicCommand::Resample);
    steps(&mut app, planet, 2);
    let written = parse_scenario(&scenario_of(&state(&app, planet))).unwrap();
    assert_eq!((written.0.len(), &written.0[1..]), (2, &to_come[..]));
    let (mut again, replayed) = planet_app(&recipe);
    again.world_mut().entity_mut(replayed).insert(written);
    steps(&mut again, replayed, 2);
    assert_eq!(digest(&app, planet), digest(&again, replayed));
}

#[test]
fn a_scenario_file_plays_like_a_user() {
    let recipe = lively(8, 3000);
    let (mut app, planet) = planet_app(&recipe);
    steps(&mut app, planet, 3);
    command(
        &mut app,
        planet,
        set_motion(PlateId(2), (60.0, -30.0), 80.0),
    );
    steps(&mut app, planet, 4);
    command(&mut app, planet, set_param("erosion", 0.1));
    steps(&mut app, planet, 5);
    let text = "[
        (step: 7, command: SetParam(name: \"erosion\", value: 0.1)),
        (step: 3, command: SetPlateMotion(plate: 2, pole: (60, -30), speed: 80)),
    ]";
    let (mut other, played) = planet_app(&recipe);
    other
        .world_mut()
        .entity_mut(played)
        .insert(parse_scenario(text).unwrap());
    steps(&mut other, played, 12);
    assert_eq!(digest(&app, planet), digest(&other, played));
}

#[test]
fn late_commands_of_a_scenario_are_not_lost() {
    let (mut app, planet) = planet_app(&lively(8, 1000));
    steps(&mut app, planet, 5);
    let timed = TimedCommand {
        step: 2,
        command: TectonicCommand::Resample,
    };
    app.world_mut()
        .entity_mut(planet)
        .insert(Scenario(vec![timed]));
    listen::<CrustResampled>(&mut app);
    steps(&mut app, planet, 1);
    assert_eq!(heard::<CrustResampled>(&app).len(), 1);
    let recorded = &get::<Recording>(&app, planet).0;
    assert_eq!(recorded[0].step, 5, "it is recorded when it took effect");
}
