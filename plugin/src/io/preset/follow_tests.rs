//! Planets that follow their presets. The asset is changed here as a file watcher would do it.

use super::*;
use crate::PangaeaPlugins;
use crate::authoring::Recording;
use crate::crust::Crust;
use crate::io::{capture, digest};
use crate::params::TectonicParams;
use crate::planet::{ClockControls, GeologicClock};
use crate::schedule::run_steps;
use crate::spawn::{PlanetReady, PlanetState};
use core::time::Duration;

#[derive(Resource, Default)]
struct Ready(u32);

fn app() -> App {
    let mut app = App::new();
    app.add_plugins((AssetPlugin::default(), PangaeaPlugins))
        .init_resource::<Ready>()
        .add_observer(|_: On<PlanetReady>, mut ready: ResMut<Ready>| ready.0 += 1);
    app.finish();
    app
}

fn recipe() -> PlanetRecipe {
    PlanetRecipe {
        seed: 5,
        samples: 500,
        plate_count: 8,
        ..default()
    }
}

/// A planet of the preset, paused, and the preset's handle.
fn planet(app: &mut App) -> (Entity, Handle<PlanetRecipe>) {
    let handle = app
        .world_mut()
        .resource_mut::<Assets<PlanetRecipe>>()
        .add(recipe());
    let controls = ClockControls {
        paused: true,
        ..default()
    };
    let planet = app
        .world_mut()
        .spawn((PlanetPreset(handle.clone()), controls))
        .id();
    (planet, handle)
}

/// Runs frames until so many planets were ready.
fn wait(app: &mut App, ready: u32) {
    for _ in 0..3000 {
        app.update();
        if app.world().resource::<Ready>().0 >= ready {
            return;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    panic!("no planet within the time of the test");
}

/// Changes the preset, as the loader does when its file has changed.
fn edit(app: &mut App, handle: &Handle<PlanetRecipe>, change: impl Fn(&mut PlanetRecipe)) {
    let mut presets = app.world_mut().resource_mut::<Assets<PlanetRecipe>>();
    let mut preset = presets.get(handle).unwrap().clone();
    change(&mut preset);
    presets.insert(handle, preset).unwrap();
    for _ in 0..3 {
        app.update();
    }
}

fn erosion(app: &App, planet: Entity) -> f64 {
    app.world().get::<TectonicParams>(planet).unwrap().erosion
}

#[test]
fn a_planet_waits_for_its_preset() {
    let mut app = app();
    let handle = app
        .world()
        .resource::<Assets<PlanetRecipe>>()
        .reserve_handle();
    let planet = app.world_mut().spawn(PlanetPreset(handle.clone())).id();
    app.update();
    assert!(app.world().get::<PlanetRecipe>(planet).is_none());
    let mut presets = app.world_mut().resource_mut::<Assets<PlanetRecipe>>();
    presets.insert(&handle, recipe()).unwrap();
    wait(&mut app, 1);
    assert_eq!(app.world().get::<Planet>(planet).unwrap().seed, 5);
}

#[test]
fn changed_parameters_reach_the_planet_as_commands() {
    let mut app = app();
    let (planet, handle) = planet(&mut app);
    wait(&mut app, 1);
    run_steps(app.world_mut(), planet, 3);
    edit(&mut app, &handle, |preset| {
        preset.params.erosion = 0.5;
        preset.params.processes.noise = false;
    });
    assert_eq!(erosion(&app, planet), 0.5);
    let recording = app.world().get::<Recording>(planet).unwrap().clone();
    let steps: Vec<u64> = recording.0.iter().map(|timed| timed.step).collect();
    assert_eq!(steps, [3, 3]);
    assert_eq!(
        app.world().resource::<Ready>().0,
        1,
        "it was not grown anew"
    );

    // The recipe is what the planet was grown from: with the recording it gives the same bits.
    run_steps(app.world_mut(), planet, 10);
    let grown_from = app.world().get::<PlanetRecipe>(planet).unwrap().clone();
    assert_eq!(grown_from, recipe());
    let mut replay = PlanetState::new(&grown_from).unwrap();
    replay.pending = recording.into();
    let replay = replay.spawn(app.world_mut());
    run_steps(app.world_mut(), replay, 13);
    let digests = [planet, replay].map(|it| digest(&capture(app.world(), it).unwrap()));
    assert_eq!(digests[0], digests[1]);
}

#[test]
fn what_a_user_has_set_stays_unless_the_preset_changes_it() {
    let mut app = app();
    let (planet, handle) = planet(&mut app);
    wait(&mut app, 1);
    let set = TectonicCommand::SetParam {
        name: "uplift".into(),
        value: 1.5,
    };
    app.world_mut()
        .get_mut::<Inbox>(planet)
        .unwrap()
        .0
        .push(set);
    edit(&mut app, &handle, |preset| preset.params.erosion = 0.5);
    let params = app.world().get::<TectonicParams>(planet).unwrap();
    assert_eq!((params.uplift, params.erosion), (1.5, 0.5));
}

#[test]
fn any_other_change_grows_the_planet_anew() {
    let mut app = app();
    let (planet, handle) = planet(&mut app);
    wait(&mut app, 1);
    run_steps(app.world_mut(), planet, 3);
    edit(&mut app, &handle, |preset| {
        preset.samples = 600;
        preset.params.erosion = 0.5;
    });
    wait(&mut app, 2);
    assert_eq!(app.world().get::<Crust>(planet).unwrap().len(), 600);
    assert_eq!(app.world().get::<GeologicClock>(planet).unwrap().step, 0);
    assert_eq!(erosion(&app, planet), 0.5);
    assert!(app.world().get::<Recording>(planet).unwrap().0.is_empty());
}

#[test]
fn a_preset_that_is_touched_without_a_change_does_nothing() {
    let mut app = app();
    let (planet, handle) = planet(&mut app);
    wait(&mut app, 1);
    edit(&mut app, &handle, |_| ());
    assert!(app.world().get::<Recording>(planet).unwrap().0.is_empty());
    assert_eq!(app.world().resource::<Ready>().0, 1);
}

#[test]
fn a_preset_is_loaded_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    // As Windows' Notepad saves it.
    let text = "\u{feff}(seed: 9,\r\n samples: 500,\r\n plate_count: 8)\r\n";
    std::fs::write(folder.path().join("small.planet.ron"), text).unwrap();
    let mut app = App::new();
    let assets = AssetPlugin {
        file_path: folder.path().to_string_lossy().into(),
        ..default()
    };
    app.add_plugins((TaskPoolPlugin::default(), assets, PangaeaPlugins))
        .init_resource::<Ready>()
        .add_observer(|_: On<PlanetReady>, mut ready: ResMut<Ready>| ready.0 += 1);
    app.finish();
    let handle = app
        .world()
        .resource::<AssetServer>()
        .load("small.planet.ron");
    let planet = app.world_mut().spawn(PlanetPreset(handle)).id();
    wait(&mut app, 1);
    assert_eq!(app.world().get::<Planet>(planet).unwrap().seed, 9);
}
