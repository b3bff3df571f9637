//! Growing, saving and loading without a window: what fails is said, and the planet lives on.

use super::*;
use crate::explorer::messages::Tone;
use bevy_pangaea::climate::EquirectMap;
use std::time::{Duration, Instant};
use tempfile::TempDir;

fn app() -> App {
    let mut app = App::new();
    app.add_message::<Action>()
        .add_message::<PresetRead>()
        .init_resource::<Session>()
        .init_resource::<ShownPlanet>()
        .init_resource::<MessageLog>()
        .init_resource::<Selection>()
        .add_systems(
            Update,
            (start_jobs, finish_jobs, save_at_boundary, finish_save).chain(),
        );
    app
}

/// Does it and waits. Returns the newest message.
fn ask(app: &mut App, action: Action) -> (Tone, String) {
    app.world_mut().resource_mut::<MessageLog>().clear();
    app.world_mut().write_message(action);
    let deadline = Instant::now() + Duration::from_secs(60);
    loop {
        app.update();
        if let Some(entry) = app.world().resource::<MessageLog>().entries().next() {
            return (entry.tone, entry.text.clone());
        }
        assert!(Instant::now() < deadline, "nothing was said");
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Asks for something that is done, and asserts what the message begins with.
fn assert_done(app: &mut App, action: Action, beginning: &str) {
    let (tone, text) = ask(app, action);
    assert_eq!(tone, Tone::Note, "{text}");
    assert!(text.starts_with(beginning), "{text}");
}

/// Asks for something that fails with one line.
fn assert_refused(app: &mut App, action: Action) {
    let (tone, text) = ask(app, action);
    assert_eq!((tone, text.lines().count()), (Tone::Error, 1), "{text}");
}

fn recipe() -> Box<PlanetRecipe> {
    Box::new(PlanetRecipe {
        samples: 500,
        plate_count: 6,
        ..default()
    })
}

fn grown() -> (App, Entity) {
    let mut app = app();
    assert_done(&mut app, Action::Grow(recipe()), "a new planet");
    let planet = shown(&app);
    (app, planet)
}

fn shown(app: &App) -> Entity {
    app.world().resource::<ShownPlanet>().0.unwrap()
}

fn clock(app: &mut App) -> Mut<'_, GeologicClock> {
    let planet = shown(app);
    app.world_mut().get_mut(planet).unwrap()
}

fn controls(app: &mut App) -> Mut<'_, ClockControls> {
    let planet = shown(app);
    app.world_mut().get_mut(planet).unwrap()
}

#[test]
fn a_planet_that_cannot_grow_leaves_the_old_one() {
    let (mut app, first) = grown();
    let land = f64::NAN;
    let bad = PlanetRecipe { land, ..*recipe() };
    assert_refused(&mut app, Action::Grow(Box::new(bad)));
    assert_eq!(shown(&app), first);
    assert!(app.world().get::<Crust>(first).is_some());
}

#[test]
fn whatever_a_planet_will_lack_is_said_at_the_start() {
    let mut app = app();
    let radius = 12_000.0;
    let huge = PlanetRecipe {
        radius,
        ..*recipe()
    };
    assert_done(&mut app, Action::Grow(Box::new(huge)), "there is no ground");
}

#[test]
fn a_new_planet_replaces_the_old_one() {
    let (mut app, first) = grown();
    controls(&mut app).paused = true;
    assert_done(&mut app, Action::Grow(recipe()), "a new planet");
    assert_ne!(first, shown(&app));
    assert!(app.world().get_entity(first).is_err(), "it is gone");
    assert!(controls(&mut app).paused, "a pause stays");
    let mut plates = app.world_mut().query::<&PlateId>();
    let plates = plates.iter(app.world()).count();
    assert_eq!(plates, 6, "the plates of the old planet are gone");
}

#[test]
fn a_saved_planet_comes_back() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("planet.pangaea");
    let (mut app, first) = grown();
    let crust = app.world().get::<Crust>(first).unwrap().clone();
    assert_done(&mut app, Action::Save(path.clone()), "saved");
    assert_done(&mut app, Action::Load(path), "loaded");
    let second = shown(&app);
    assert!(*app.world().get::<Crust>(second).unwrap() == crust);
}

#[test]
fn the_commands_so_far_are_saved_as_a_scenario_and_the_planet_is_not() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("planet.scenario.ron");
    let (mut app, planet) = grown();
    let timed = TimedCommand {
        step: 0,
        command: TectonicCommand::Resample,
    };
    let mut recording = app.world_mut().get_mut::<Recording>(planet).unwrap();
    recording.0.push(timed.clone());
    assert_done(&mut app, Action::SaveScenario(path.clone()), "saved");
    assert_eq!(io::load_scenario(&path).unwrap().0, [timed]);
    assert_done(&mut app, Action::Grow(recipe()), DISCARD_QUESTION);
    assert_refused(&mut app, Action::SaveScenario(PathBuf::new()));
}

#[test]
fn wishes_to_save_wait_for_each_other() {
    let folder = TempDir::new().unwrap();
    let [planet, scenario] = ["a.pangaea", "a.scenario.ron"].map(|name| folder.path().join(name));
    let (mut app, _) = grown();
    app.world_mut().write_message(Action::Save(planet.clone()));
    assert_done(&mut app, Action::SaveScenario(scenario.clone()), "saved");
    let deadline = Instant::now() + Duration::from_secs(60);
    while !(planet.exists() && scenario.exists()) {
        app.update();
        assert!(Instant::now() < deadline, "a file is missing");
    }
}

#[test]
fn bad_files_are_refused() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("planet.pangaea");
    let (mut app, first) = grown();
    assert_done(&mut app, Action::Save(path.clone()), "saved");
    let bytes = std::fs::read(&path).unwrap();
    std::fs::write(&path, &bytes[..bytes.len() / 2]).unwrap();
    assert_refused(&mut app, Action::Load(path));
    let nowhere = folder.path().join("no/such/folder/planet.pangaea");
    assert_refused(&mut app, Action::Load(nowhere.clone()));
    assert_refused(&mut app, Action::Save(nowhere.clone()));
    assert_refused(&mut app, Action::Save(PathBuf::new()));
    assert_refused(&mut app, Action::ReadPreset(nowhere));
    assert_eq!(shown(&app), first);
}

/// A planet of maps of which all is land 1 km high.
fn mapped() -> PlanetState {
    let maps = TerrainMaps {
        crust: EquirectMap::from_fn(4, |_, _| 1.0).unwrap(),
        age: None,
        plateau: None,
        hills: None,
    };
    let planet = Planet {
        radius: 6370.0,
        seed: 1,
    };
    PlanetState::from_maps(planet, maps).unwrap()
}

#[test]
fn time_stands_still_on_a_planet_of_maps_and_passes_on_the_next_one() {
    let mut app = app();
    begin_with(&mut app, Box::new(mapped()), "a.terrain.ron".into());
    app.update();
    assert!(controls(&mut app).paused);
    assert_done(&mut app, Action::Grow(recipe()), "a new planet");
    assert!(!controls(&mut app).paused);
}

#[test]
fn a_save_does_not_replace_maps() {
    let folder = TempDir::new().unwrap();
    let (mut app, _) = grown();
    for name in ["a.terrain.ron", "a.tif", "a.png"] {
        let path = folder.path().join(name);
        assert_refused(&mut app, Action::Save(path.clone()));
        assert!(!path.exists());
    }
}

#[test]
fn a_planet_that_is_saved_goes_without_a_question() {
    let folder = TempDir::new().unwrap();
    let (mut app, first) = grown();
    clock(&mut app).step += 1;
    let path = folder.path().join("planet.pangaea");
    assert_done(&mut app, Action::Save(path), "saved");
    assert_done(&mut app, Action::Grow(recipe()), "a new planet");
    assert_ne!(first, shown(&app));
}

#[test]
fn a_planet_that_is_not_saved_goes_when_that_is_asked_for_twice() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("planet.pangaea");
    let (mut app, first) = grown();
    assert_done(&mut app, Action::Save(path.clone()), "saved");
    clock(&mut app).step += 1;
    // Each wish has a question of its own.
    assert_done(&mut app, Action::Grow(recipe()), DISCARD_QUESTION);
    assert_done(&mut app, Action::Load(path.clone()), DISCARD_QUESTION);
    assert_eq!(shown(&app), first);
    clock(&mut app).step += 1;
    assert_done(&mut app, Action::Load(path), "loaded");
}

#[test]
fn a_command_is_a_change_too() {
    let (mut app, planet) = grown();
    let command = TimedCommand {
        step: 1,
        command: TectonicCommand::Resample,
    };
    let mut recording = app.world_mut().get_mut::<Recording>(planet).unwrap();
    recording.0.push(command);
    assert_done(&mut app, Action::Grow(recipe()), DISCARD_QUESTION);
}

#[test]
fn a_planet_that_was_loaded_before_is_the_first_on_show() {
    let mut app = app();
    let state = PlanetState::new(&recipe()).unwrap();
    begin_with(&mut app, Box::new(state), "a.pangaea".into());
    app.update();
    let planet = shown(&app);
    assert!(app.world().get::<Crust>(planet).is_some());
    let newest = app.world().resource::<MessageLog>().entries().next();
    assert_eq!(newest.unwrap().text, "loaded a.pangaea");
    app.update();
    assert_eq!(shown(&app), planet);
}

#[test]
fn a_second_planet_is_not_begun_while_one_is_on_its_way() {
    let mut app = app();
    app.world_mut().write_message(Action::Grow(recipe()));
    assert_refused(&mut app, Action::Grow(recipe()));
}

#[test]
fn a_preset_arrives_as_a_message() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.planet.ron");
    std::fs::write(&path, "(samples: 700, plate_count: 9)").unwrap();
    let mut app = app();
    assert_done(&mut app, Action::ReadPreset(path.clone()), "read");
    let mut presets = app.world_mut().resource_mut::<Messages<PresetRead>>();
    let presets: Vec<PresetRead> = presets.drain().collect();
    assert_eq!(presets.len(), 1);
    assert_eq!((presets[0].recipe.samples, &presets[0].path), (700, &path));
}
