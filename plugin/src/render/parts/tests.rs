//! Globes come and go with their planets. Needs no GPU: nothing is drawn.

use super::*;
use crate::PangaeaPlugins;
use crate::planet::{ClockControls, Planet, PlanetRecipe};
use crate::render::GlobePlugin;
use crate::render::material::{AirMaterial, GroundMaterial, LineMaterial};
use crate::spawn::PlanetState;
use std::time::{Duration, Instant};

/// An app with the systems of globes and their assets, but no renderer.
fn app() -> App {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, AssetPlugin::default(), PangaeaPlugins))
        .init_asset::<Mesh>()
        .init_asset::<ShaderBuffer>()
        .init_asset::<GroundMaterial>()
        .init_asset::<AirMaterial>()
        .init_asset::<LineMaterial>()
        .add_plugins(GlobePlugin);
    app
}

/// A small planet at rest.
fn planet(app: &mut App) -> Entity {
    let recipe = PlanetRecipe {
        samples: 1000,
        plate_count: 8,
        ..default()
    };
    let planet = PlanetState::new(&recipe).unwrap().spawn(app.world_mut());
    let paused = ClockControls {
        paused: true,
        ..default()
    };
    app.world_mut().entity_mut(planet).insert(paused);
    planet
}

/// Runs frames until the planet is drawn.
fn draw(app: &mut App, planet: Entity) {
    let deadline = Instant::now() + Duration::from_secs(60);
    while app.world().get::<GlobeDrawn>(planet).is_none() {
        assert!(Instant::now() < deadline, "the globe is not drawn");
        app.update();
    }
}

/// Numbers of meshes, buffers and materials, and of entities with a mesh.
fn counts(app: &mut App) -> [usize; 6] {
    for _ in 0..3 {
        app.update();
    }
    let world = app.world_mut();
    [
        world.resource::<Assets<Mesh>>().len(),
        world.resource::<Assets<ShaderBuffer>>().len(),
        world.resource::<Assets<GroundMaterial>>().len(),
        world.resource::<Assets<AirMaterial>>().len(),
        world.resource::<Assets<LineMaterial>>().len(),
        world.query::<&Mesh3d>().iter(world).count(),
    ]
}

/// The mesh of the air is shared by all globes and stays.
const NOTHING_DRAWN: [usize; 6] = [1, 0, 0, 0, 0, 0];

#[test]
fn a_planet_gets_a_globe_of_a_patch_lines_and_air() {
    let mut app = app();
    let planet = planet(&mut app);
    assert!(app.world().get::<Globe>(planet).is_some());
    draw(&mut app, planet);
    // Ground and lines have meshes of their own; ground has a second material for its edges.
    assert_eq!(counts(&mut app), [3, 1, 2, 1, 1, 3]);
    assert!(app.world().get::<GlobePicker>(planet).is_some());
}

#[test]
fn edges_of_triangles_are_spawned_once_they_are_asked_for() {
    let mut app = app();
    let planet = planet(&mut app);
    draw(&mut app, planet);
    app.world_mut().get_mut::<Globe>(planet).unwrap().wireframe = true;
    assert_eq!(counts(&mut app), [4, 1, 2, 1, 1, 4]);
}

#[test]
fn a_despawned_planet_takes_its_globe_with_it() {
    let mut app = app();
    let planet = planet(&mut app);
    draw(&mut app, planet);
    app.world_mut().despawn(planet);
    assert_eq!(counts(&mut app), NOTHING_DRAWN);
}

#[test]
fn a_planet_that_is_despawned_while_its_globe_is_built_leaves_nothing() {
    let mut app = app();
    let planet = planet(&mut app);
    app.update();
    let task = app.world().get::<GlobeTask>(planet);
    assert!(task.is_some());
    app.world_mut().despawn(planet);
    assert_eq!(counts(&mut app), NOTHING_DRAWN);
}

#[test]
fn a_planet_without_its_globe_is_not_drawn() {
    let mut app = app();
    let planet = planet(&mut app);
    draw(&mut app, planet);
    app.world_mut().entity_mut(planet).remove::<Globe>();
    assert_eq!(counts(&mut app), NOTHING_DRAWN);
    assert!(app.world().get::<GlobeDrawn>(planet).is_none());
    app.world_mut().entity_mut(planet).insert(Globe::default());
    draw(&mut app, planet);
}

/// A globe without air.
fn plain() -> Globe {
    Globe {
        air: 0.0,
        ..default()
    }
}

#[test]
fn an_app_may_choose_the_globe_of_its_planets() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    app.register_required_components_with::<Planet, Globe>(plain);
    crate::render::require_globe(&mut app);
    let planet = planet(&mut app);
    assert_eq!(app.world().get::<Globe>(planet), Some(&plain()));
}
