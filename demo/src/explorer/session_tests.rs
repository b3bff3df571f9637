//! Growing, saving and loading without a window: what fails is said, and the planet lives on.

use super::*;
use crate::explorer::messages::Tone;
use std::time::{Duration, Instant};

fn app() -> App {
    let mut app = App::new();
    app.add_message::<Action>()
        .init_resource::<Session>()
        .init_resource::<Messages>()
        .init_resource::<Selection>()
        .init_resource::<PlanetForm>()
        .add_systems(
            Update,
            (start_jobs, finish_jobs, save_at_boundary, finish_save).chain(),
        );
    app
}

/// Does it and waits. Returns the newest message.
fn ask(app: &mut App, action: Action) -> (Tone, String) {
    app.world_mut().resource_mut::<Messages>().clear();
    app.world_mut().write_message(action);
    let patience = Instant::now() + Duration::from_secs(60);
    loop {
        app.update();
        if let Some(entry) = app.world().resource::<Messages>().entries().next() {
            return (entry.tone, entry.text.clone());
        }
        assert!(Instant::now() < patience, "nothing was said");
        std::thread::sleep(Duration::from_millis(1));
    }
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
    assert_eq!(ask(&mut app, Action::Grow(recipe())).0, Tone::Note);
    let planet = app.world().resource::<Session>().planet.unwrap();
    (app, planet)
}

#[test]
fn a_new_planet_replaces_the_old_one_only_when_it_is_there() {
    let (mut app, first) = grown();
    let bad = Box::new(PlanetRecipe {
        land: f64::NAN,
        ..*recipe()
    });
    assert_eq!(ask(&mut app, Action::Grow(bad)).0, Tone::Error);
    assert_eq!(app.world().resource::<Session>().planet, Some(first));
    assert!(app.world().get::<Crust>(first).is_some());
    app.world_mut()
        .get_mut::<ClockControls>(first)
        .unwrap()
        .paused = true;
    assert_eq!(ask(&mut app, Action::Grow(recipe())).0, Tone::Note);
    let second = app.world().resource::<Session>().planet.unwrap();
    assert_ne!(first, second);
    assert!(
        app.world().get_entity(first).is_err(),
        "the old planet is gone"
    );
    assert!(
        app.world().get::<ClockControls>(second).unwrap().paused,
        "a pause stays"
    );
    let plates = app
        .world_mut()
        .query::<&PlateId>()
        .iter(app.world())
        .count();
    assert_eq!(plates, 6, "the plates of the old planet are gone");
}

#[test]
fn a_saved_planet_comes_back_and_bad_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("planet.pangaea");
    let (mut app, first) = grown();
    let crust = app.world().get::<Crust>(first).unwrap().clone();
    assert_eq!(ask(&mut app, Action::Save(path.clone())).0, Tone::Note);
    assert_eq!(ask(&mut app, Action::Load(path.clone())).0, Tone::Note);
    let second = app.world().resource::<Session>().planet.unwrap();
    assert!(*app.world().get::<Crust>(second).unwrap() == crust);

    let bytes = std::fs::read(&path).unwrap();
    std::fs::write(&path, &bytes[..bytes.len() / 2]).unwrap();
    assert_eq!(ask(&mut app, Action::Load(path)).0, Tone::Error);
    let nowhere = folder.path().join("no/such/folder/planet.pangaea");
    for action in [
        Action::Load(nowhere.clone()),
        Action::Save(nowhere.clone()),
        Action::Save(PathBuf::new()),
        Action::ReadPreset(nowhere),
    ] {
        let (tone, text) = ask(&mut app, action);
        assert_eq!((tone, text.lines().count()), (Tone::Error, 1), "{text}");
    }
    assert_eq!(app.world().resource::<Session>().planet, Some(second));
}

#[test]
fn a_planet_that_is_not_saved_goes_when_that_is_asked_for_twice() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("planet.pangaea");
    let (mut app, first) = grown();
    let step = |app: &mut App| {
        let planet = app.world().resource::<Session>().planet.unwrap();
        app.world_mut()
            .get_mut::<GeologicClock>(planet)
            .unwrap()
            .step += 1;
    };
    // What is saved may go.
    step(&mut app);
    assert!(
        ask(&mut app, Action::Save(path.clone()))
            .1
            .starts_with("saved")
    );
    assert!(
        ask(&mut app, Action::Grow(recipe()))
            .1
            .starts_with("a new planet")
    );
    let second = app.world().resource::<Session>().planet.unwrap();
    assert_ne!(first, second);
    // What is not is asked about, for each wish anew.
    step(&mut app);
    assert_eq!(ask(&mut app, Action::Grow(recipe())).1, QUESTION);
    assert_eq!(ask(&mut app, Action::Load(path.clone())).1, QUESTION);
    assert_eq!(app.world().resource::<Session>().planet, Some(second));
    step(&mut app);
    assert!(
        ask(&mut app, Action::Load(path.clone()))
            .1
            .starts_with("loaded")
    );
    // A command is a change, too.
    let third = app.world().resource::<Session>().planet.unwrap();
    let command = TimedCommand {
        step: 1,
        command: TectonicCommand::Resample,
    };
    app.world_mut()
        .get_mut::<Recording>(third)
        .unwrap()
        .0
        .push(command);
    assert_eq!(ask(&mut app, Action::Load(path)).1, QUESTION);
}

#[test]
fn a_planet_that_was_loaded_before_is_the_first_on_show() {
    let mut app = app();
    let state = PlanetState::new(&recipe()).unwrap();
    begin_with(&mut app, Box::new(state), "a.pangaea".into());
    app.update();
    let planet = app.world().resource::<Session>().planet.unwrap();
    assert!(app.world().get::<Crust>(planet).is_some());
    assert_eq!(
        app.world()
            .resource::<Messages>()
            .entries()
            .next()
            .unwrap()
            .text,
        "loaded a.pangaea"
    );
    app.update();
    assert_eq!(app.world().resource::<Session>().planet, Some(planet));
}

#[test]
fn a_second_planet_is_not_begun_while_one_is_on_its_way() {
    let mut app = app();
    app.world_mut().write_message(Action::Grow(recipe()));
    let (tone, text) = ask(&mut app, Action::Grow(recipe()));
    assert_eq!(tone, Tone::Error, "{text}");
}
