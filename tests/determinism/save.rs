//! A save, loaded again, goes on as if nothing had been.

use super::lively;
use bevy::prelude::*;
use bevy_pangaea::climate::EquirectMap;
use bevy_pangaea::control::{BakeSettings, PlanetBake, bake_now};
use bevy_pangaea::io;
use bevy_pangaea::io::save::{load, read_from, save, write_to};
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::order::{rift, set_param};
use pangaea_tests::world::{command, digest, get, heard, listen, planet_app, spawn, state, steps};

const STEPS: u64 = 34;

fn saved(state: &PlanetState) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_to(state, &mut bytes).unwrap();
    bytes
}

#[test]
fn every_step_of_a_lively_planet_can_be_saved_and_continued() {
    let (mut app, planet) = planet_app(&lively(4, 5000));
    listen::<TerraneCollided>(&mut app);
    listen::<PlateRifted>(&mut app);
    listen::<CrustResampled>(&mut app);
    let mut saves = Vec::new();
    for _ in 0..STEPS {
        saves.push((saved(&state(&app, planet)), events(&app)));
        steps(&mut app, planet, 1);
    }
    assert_lively(events(&app));
    let end = digest(&app, planet);
    for (step, (bytes, events)) in (0..).zip(saves) {
        let place = format!("saved at step {step}, after {events:?} collisions, rifts, resamples");
        assert_eq!(continued(&bytes, STEPS - step), end, "{place}");
    }
}

/// Numbers of collisions, rifts and resamples so far.
fn events(app: &App) -> [usize; 3] {
    [
        heard::<TerraneCollided>(app).len(),
        heard::<PlateRifted>(app).len(),
        heard::<CrustResampled>(app).len(),
    ]
}

/// Asserts that there was a collision, a rift and more than one resample.
fn assert_lively(events: [usize; 3]) {
    let [collisions, rifts, resamples] = events;
    assert!(collisions > 0 && rifts > 0 && resamples > 1, "{events:?}");
}

/// Loads a save and takes some steps. Returns the digest at the end.
fn continued(bytes: &[u8], count: u64) -> String {
    let loaded = read_from(bytes).unwrap();
    assert!(saved(&loaded) == bytes, "a load changes bits");
    let before = io::digest(&loaded);
    let (mut app, planet) = spawn(loaded);
    assert_eq!(digest(&app, planet), before, "spawning changes bits");
    steps(&mut app, planet, count);
    digest(&app, planet)
}

#[test]
fn a_file_holds_all_state_and_replaces_an_older_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("planet.pangaea");
    let (mut app, planet) = planet_app(&lively(5, 2000));
    save(&state(&app, planet), &path).unwrap();
    let old = std::fs::read(&path).unwrap();
    command(&mut app, planet, set_param("erosion", 0.1));
    steps(&mut app, planet, 7);
    save(&state(&app, planet), &path).unwrap();
    assert!(old != std::fs::read(&path).unwrap());
    let files = std::fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(files, 1, "no part file stays behind");
    let loaded = load(&path).unwrap();
    assert_eq!(loaded.recording.0.len(), 1);
    assert_eq!(loaded.params.erosion, 0.1);
    assert_eq!(io::digest(&loaded), digest(&app, planet));
}

/// Small changes of the state, one of each kind.
const CHANGES: [fn(&mut PlanetState); 13] = [
    |s| s.crust.thickness[3] += 1e-5,
    |s| s.crust.elevation[499] += 1e-6,
    |s| s.crust.ocean_age[7] += 1e-4,
    |s| s.crust.orogeny_age[7] += 1.0,
    |s| s.crust.fold[7].x += 1e-6,
    |s| s.crust.ridge[7].z += 1e-6,
    |s| s.crust.frame[7] = (s.crust.frame[7] + 1) % 40,
    |s| s.plates[2].1.speed *= 1.0 + 1e-15,
    |s| s.ledger.carried_area += 1e-9,
    |s| s.clock.step += 1,
    |s| s.params.erosion += 1e-9,
    |s| s.planet.seed += 1,
    |s| s.climate.rain = EquirectMap::from_fn(4, |_, _| 800.0).ok(),
];

#[test]
fn digests_see_every_column() {
    let (app, planet) = planet_app(&lively(6, 500));
    let original = state(&app, planet);
    let digest = io::digest(&original);
    assert_eq!(digest, io::digest(&original.clone()));
    for (k, change) in CHANGES.into_iter().enumerate() {
        let mut other = original.clone();
        change(&mut other);
        assert_ne!(digest, io::digest(&other), "change {k} is not seen");
    }
}

#[test]
fn how_time_passes_is_no_state() {
    let (mut app, planet) = planet_app(&lively(6, 500));
    let before = digest(&app, planet);
    let mut controls = app.world_mut().get_mut::<ClockControls>(planet).unwrap();
    controls.paused = true;
    controls.speed = 99.0;
    assert_eq!(before, digest(&app, planet));
}

/// A rift at random that is to come.
fn to_come(step: u64, plate: u32) -> TimedCommand {
    TimedCommand {
        step,
        command: rift(PlateId(plate), &[], 2),
    }
}

#[test]
fn commands_that_are_still_to_come_are_saved() {
    let (mut app, planet) = planet_app(&lively(8, 3000));
    let scenario = Scenario(vec![to_come(9, 3), to_come(2, 1), to_come(6, 5)]);
    app.world_mut().entity_mut(planet).insert(scenario);
    steps(&mut app, planet, 5);
    command(&mut app, planet, set_param("erosion", 0.2));
    let bytes = saved(&state(&app, planet));
    steps(&mut app, planet, 10);
    let (mut again, loaded) = spawn(read_from(&bytes).unwrap());
    steps(&mut again, loaded, 10);
    assert_eq!(digest(&again, loaded), digest(&app, planet));
    let [old, new] = [state(&app, planet), state(&again, loaded)];
    assert_eq!(new.recording.0.len(), old.recording.0.len());
    assert!(new.pending.0.is_empty());
}

/// The control maps of a planet, from which all of its ground follows.
fn control_maps(state: PlanetState) -> String {
    let (mut app, planet) = spawn(state);
    let coarse = BakeSettings {
        spacing: 0.05,
        ..default()
    };
    app.world_mut().entity_mut(planet).insert(coarse);
    bake_now(app.world_mut(), planet).unwrap();
    format!("{:?}", get::<PlanetBake>(&app, planet).control)
}

#[test]
fn a_loaded_planet_has_the_climate_that_it_was_given() {
    let (mut app, planet) = planet_app(&lively(9, 2000));
    let own = control_maps(state(&app, planet));
    let drought = ClimateMaps {
        rain: EquirectMap::from_fn(18, |lat, _| if lat > 0.0 { 40.0 } else { 2000.0 }).ok(),
        ..default()
    };
    app.world_mut().entity_mut(planet).insert(drought.clone());
    let given = state(&app, planet);
    let bytes = saved(&given);
    let given = control_maps(given);
    assert!(given != own, "a map of rain changes the rivers");
    let loaded = read_from(&bytes).unwrap();
    assert_eq!(loaded.climate, drought);
    assert!(control_maps(loaded) == given);
}

#[test]
fn maps_stay_with_a_planet_that_grows() {
    let mut given = PlanetState::new(&lively(10, 500)).unwrap();
    given.climate.wetness = EquirectMap::from_fn(4, |_, _| 0.5).ok();
    let climate = given.climate.clone();
    let (mut app, planet) = spawn(given);
    steps(&mut app, planet, 3);
    assert_eq!(state(&app, planet).climate, climate);
}
