//! Planets that grow on entities: when they are there, what they are, what is left of them.

use super::*;
use crate::PangaeaPlugins;
use crate::authoring::{Recording, TectonicCommand, TectonicCommandsExt};
use crate::climate::{ClimateMaps, EquirectMap};
use crate::crust::{Crust, PlanetSurface};
use crate::io;
use crate::planet::{ClockControls, GeologicClock, Planet, PlanetRecipe};
use crate::plate::{Plate, Plates, Terrane};
use crate::schedule::run_steps;
use bevy::ecs::template::FromTemplate;
use bevy::prelude::*;
use core::time::Duration;

/// The events of planets so far.
#[derive(Resource, Default)]
struct Heard {
    ready: Vec<Entity>,
    failed: Vec<PlanetFailed>,
}

fn app() -> App {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins)
        .init_resource::<Heard>()
        .add_observer(|event: On<PlanetReady>, mut heard: ResMut<Heard>| {
            heard.ready.push(event.planet);
        })
        .add_observer(|event: On<PlanetFailed>, mut heard: ResMut<Heard>| {
            heard.failed.push(event.event().clone());
        });
    app
}

fn recipe(seed: u64) -> PlanetRecipe {
    PlanetRecipe {
        seed,
        samples: 500,
        plate_count: 8,
        ..default()
    }
}

/// Runs frames until so many planets were ready, or failed.
fn wait(app: &mut App, ready: usize, failed: usize) {
    for _ in 0..3000 {
        app.update();
        let heard = app.world().resource::<Heard>();
        if heard.ready.len() >= ready && heard.failed.len() >= failed {
            return;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
    panic!("neither planet nor error within the time of the test");
}

fn digest(app: &App, planet: Entity) -> String {
    io::digest(&io::capture(app.world(), planet).unwrap())
}

/// The digest of the planet of a recipe, which is spawned for it and despawned again.
fn digest_of(app: &mut App, recipe: &PlanetRecipe) -> String {
    let planet = PlanetState::new(recipe).unwrap().spawn(app.world_mut());
    let digest = digest(app, planet);
    app.world_mut().despawn(planet);
    digest
}

/// A planet that stands still, so that a test may look at it.
fn still() -> ClockControls {
    ClockControls {
        paused: true,
        ..default()
    }
}

fn count<C: Component>(app: &mut App) -> usize {
    app.world_mut().query::<&C>().iter(app.world()).count()
}

fn surface(app: &App, planet: Entity) -> &PlanetSurface {
    app.world().get::<PlanetSurface>(planet).unwrap()
}

#[test]
fn a_spawned_recipe_becomes_the_planet_of_its_state() {
    let mut app = app();
    let planet = app.world_mut().spawn((recipe(3), still())).id();
    assert!(app.world().get::<PlanetTask>(planet).is_some());
    wait(&mut app, 1, 0);
    assert_eq!(app.world().resource::<Heard>().ready, [planet]);
    assert!(app.world().get::<PlanetTask>(planet).is_none());
    assert!(app.world().get::<PlanetRecipe>(planet).is_some());
    assert!(app.world().get::<ClockControls>(planet).unwrap().paused);

    let state = PlanetState::new(&recipe(3)).unwrap();
    let other = state.spawn(app.world_mut());
    assert_eq!(digest(&app, planet), digest(&app, other));
    assert!(*surface(&app, planet).0 == *surface(&app, other).0);
    run_steps(app.world_mut(), planet, 12);
    run_steps(app.world_mut(), other, 12);
    assert_eq!(digest(&app, planet), digest(&app, other));
}

#[test]
fn commands_wait_for_the_planet() {
    let mut app = app();
    let mut commands = app.world_mut().commands();
    let planet = commands
        .spawn_planet(recipe(4))
        .insert(still())
        .tectonic(TectonicCommand::Resample)
        .id();
    app.world_mut().flush();
    wait(&mut app, 1, 0);
    app.update();
    let recording = app.world().get::<Recording>(planet).unwrap();
    assert_eq!(recording.0[0].command, TectonicCommand::Resample);
}

#[test]
fn maps_that_a_game_gives_stay_with_a_recipe_and_go_with_a_state() {
    let mut app = app();
    let given = ClimateMaps {
        rain: EquirectMap::from_fn(4, |_, _| 900.0).ok(),
        ..default()
    };
    let planet = app
        .world_mut()
        .spawn((recipe(6), still(), given.clone()))
        .id();
    wait(&mut app, 1, 0);
    assert_eq!(app.world().get::<ClimateMaps>(planet), Some(&given));
    assert_eq!(io::capture(app.world(), planet).unwrap().climate, given);

    let state = PlanetState::new(&recipe(7)).unwrap();
    state.insert(app.world_mut(), planet);
    let own = ClimateMaps::default();
    assert_eq!(app.world().get::<ClimateMaps>(planet), Some(&own));
}

#[test]
fn a_refused_recipe_is_reported_once_and_stays() {
    let mut app = app();
    let bad = PlanetRecipe {
        land: f64::NAN,
        ..recipe(1)
    };
    let planet = app.world_mut().spawn(bad).id();
    wait(&mut app, 0, 1);
    app.update();
    let heard = app.world().resource::<Heard>();
    assert_eq!((heard.ready.len(), heard.failed.len()), (0, 1));
    assert_eq!(heard.failed[0].planet, planet);
    assert!(heard.failed[0].error.to_string().contains("land"));
    let entity = app.world().entity(planet);
    assert!(entity.contains::<PlanetRecipe>() && !entity.contains::<Planet>());

    app.world_mut().entity_mut(planet).insert(recipe(1));
    wait(&mut app, 1, 1);
    assert!(app.world().get::<Planet>(planet).is_some());
}

#[test]
fn another_recipe_replaces_the_planet_when_it_is_there() {
    let mut app = app();
    let planet = app.world_mut().spawn((recipe(5), still())).id();
    wait(&mut app, 1, 0);
    run_steps(app.world_mut(), planet, 4);
    let version = surface(&app, planet).version;

    let bad = PlanetRecipe {
        samples: 1,
        ..recipe(6)
    };
    app.world_mut().entity_mut(planet).insert(bad);
    wait(&mut app, 1, 1);
    assert_eq!(app.world().get::<GeologicClock>(planet).unwrap().step, 4);

    app.world_mut().entity_mut(planet).insert(recipe(6));
    assert_eq!(app.world().get::<Planet>(planet).unwrap().seed, 5);
    wait(&mut app, 2, 1);
    assert_eq!(digest(&app, planet), digest_of(&mut app, &recipe(6)));
    assert!(surface(&app, planet).version > version);
    let plates = app.world().get::<Plates>(planet).unwrap().iter().count();
    assert_eq!((plates, count::<Plate>(&mut app)), (8, 8));
}

#[test]
fn the_last_recipe_counts() {
    let mut app = app();
    let planet = app.world_mut().spawn((recipe(7), still())).id();
    app.world_mut().entity_mut(planet).insert(recipe(8));
    wait(&mut app, 1, 0);
    for _ in 0..5 {
        app.update();
    }
    assert_eq!(app.world().get::<Planet>(planet).unwrap().seed, 8);
    assert_eq!(app.world().resource::<Heard>().ready.len(), 1);
}

/// Grows a planet and despawns it, and another one before it is there. Returns how many entities
/// the world has then.
fn grow_and_despawn(app: &mut App, ready: usize) -> usize {
    let planet = app.world_mut().spawn(recipe(9)).id();
    wait(app, ready, 0);
    run_steps(app.world_mut(), planet, 3);
    assert!(count::<Plate>(app) > 0 && count::<Terrane>(app) > 0);
    app.world_mut().despawn(planet);
    let early = app.world_mut().spawn(recipe(10)).id();
    app.world_mut().despawn(early);
    for _ in 0..20 {
        app.update();
        std::thread::sleep(Duration::from_millis(2));
    }
    assert_eq!(app.world().resource::<Heard>().ready.len(), ready);
    app.world_mut().query::<Entity>().iter(app.world()).count()
}

#[test]
fn nothing_is_left_of_a_planet_that_is_despawned() {
    let mut app = app();
    // The first one leaves the resources that the simulation makes when it begins.
    let first = grow_and_despawn(&mut app, 1);
    assert_eq!(grow_and_despawn(&mut app, 2), first);
}

#[test]
fn a_state_goes_onto_an_entity_in_place_of_what_is_being_built() {
    let mut app = app();
    let planet = app.world_mut().spawn((recipe(11), still())).id();
    let state = PlanetState::new(&recipe(12)).unwrap();
    state.insert(app.world_mut(), planet);
    for _ in 0..20 {
        app.update();
        std::thread::sleep(Duration::from_millis(2));
    }
    assert_eq!(app.world().get::<Planet>(planet).unwrap().seed, 12);
    assert_eq!(app.world().resource::<Heard>().ready, [planet]);
    let gone = app.world_mut().spawn_empty().id();
    app.world_mut().despawn(gone);
    PlanetState::new(&recipe(12))
        .unwrap()
        .insert(app.world_mut(), gone);
    assert_eq!(count::<Crust>(&mut app), 1);
}

#[test]
fn a_world_without_plugins_takes_a_planet() {
    let mut world = World::new();
    let planet = PlanetState::new(&recipe(1)).unwrap().spawn(&mut world);
    assert!(!world.get::<PlanetSurface>(planet).unwrap().is_empty());
}

#[test]
fn a_recipe_is_spawned_by_its_reflection() {
    let mut app = app();
    let registry = app.world().resource::<AppTypeRegistry>().clone();
    let registry = registry.read();
    let data = registry
        .get_type_data::<ReflectComponent>(core::any::TypeId::of::<PlanetRecipe>())
        .unwrap();
    // A scene holds values like this one, whose type is known by name alone.
    let dynamic = recipe(13).to_dynamic();
    let mut entity = app.world_mut().spawn_empty();
    data.insert(&mut entity, &*dynamic, &registry);
    let planet = entity.id();
    wait(&mut app, 1, 0);
    assert_eq!(app.world().get::<Planet>(planet).unwrap().seed, 13);
}

#[test]
fn a_recipe_is_spawned_by_a_scene_in_code() {
    let mut app = app();
    // `bsn!` patches a component's template, and builds the component of it.
    let template: <PlanetRecipe as FromTemplate>::Template = recipe(14);
    let mut entity = app.world_mut().spawn_empty();
    let built = entity.build_template(&template).unwrap();
    let planet = entity.insert(built).id();
    wait(&mut app, 1, 0);
    assert_eq!(app.world().get::<Planet>(planet).unwrap().seed, 14);
}
