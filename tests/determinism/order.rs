//! No order that nobody asked for matters: of plugins, of systems, of planets.
//!
//! The executor runs systems that are free of each other in the order in which plugins have added
//! them, so another order of plugins is another order of systems.

use super::{digests_alone, lively};
use bevy::ecs::schedule::{InternedScheduleLabel, ScheduleLabel};
use bevy::prelude::*;
use bevy_pangaea::authoring::AuthoringPlugin;
use bevy_pangaea::control::{BakePlugin, BakeSettings};
use bevy_pangaea::io::PresetPlugin;
use bevy_pangaea::prelude::*;
use bevy_pangaea::process::collision::CollisionPlugin;
use bevy_pangaea::process::commit::CommitPlugin;
use bevy_pangaea::process::contact::ContactPlugin;
use bevy_pangaea::process::drift::DriftPlugin;
use bevy_pangaea::process::margin::MarginPlugin;
use bevy_pangaea::process::rifting::RiftingPlugin;
use bevy_pangaea::process::slab_pull::SlabPullPlugin;
use bevy_pangaea::process::subduction::SubductionPlugin;
use bevy_pangaea::process::surface_processes::SurfaceProcessesPlugin;
use bevy_pangaea::process::terranes::TerranePlugin;
use bevy_pangaea::resample::{ResamplePlugin, SurfaceProjection};
use bevy_pangaea::schedule::TectonicSchedulePlugin;
use bevy_pangaea::spawn::{PlanetState, SpawnPlugin};
use fastrand::Rng;
use pangaea_tests::world::{app, digest, planet_app, steps};
use std::time::Duration;

/// Functions that add one plugin each.
macro_rules! adders {
    ($($plugin:ident),+ $(,)?) => {
        [$((|app: &mut App| { app.add_plugins($plugin); }) as fn(&mut App)),+]
    };
}

/// An app with the plugins of the group in an order of chance, but for the schedule, which the
/// others need.
fn shuffled_app(rng: &mut Rng) -> App {
    let mut adders = adders!(
        DriftPlugin,
        ContactPlugin,
        SubductionPlugin,
        SlabPullPlugin,
        CollisionPlugin,
        RiftingPlugin,
        SurfaceProcessesPlugin,
        MarginPlugin,
        ResamplePlugin,
        TerranePlugin,
        CommitPlugin,
        AuthoringPlugin,
        SpawnPlugin,
        BakePlugin,
        PresetPlugin,
    );
    rng.shuffle(&mut adders);
    let mut app = App::new();
    app.add_plugins(TectonicSchedulePlugin::default());
    adders.iter().for_each(|add| add(&mut app));
    app
}

/// Number of systems of a schedule.
fn systems(app: &App, label: impl ScheduleLabel) -> usize {
    let label: InternedScheduleLabel = label.intern();
    let schedule = app.get_schedule(label).expect("a schedule of the group");
    schedule.graph().systems.len()
}

#[test]
fn the_shuffled_plugins_are_those_of_the_group() {
    let (group, shuffled) = (app(), shuffled_app(&mut Rng::with_seed(0)));
    assert_eq!(
        systems(&group, TectonicStep),
        systems(&shuffled, TectonicStep)
    );
    assert_eq!(systems(&group, Update), systems(&shuffled, Update));
}

#[test]
fn any_order_of_plugins_gives_the_same_bits() {
    let recipe = lively(21, 4000);
    let (mut ordered, planet) = planet_app(&recipe);
    steps(&mut ordered, planet, 30);
    let expected = digest(&ordered, planet);
    for seed in 0..6 {
        let mut app = shuffled_app(&mut Rng::with_seed(seed));
        let planet = PlanetState::new(&recipe).unwrap().spawn(app.world_mut());
        app.world_mut()
            .entity_mut(planet)
            .insert(SurfaceProjection::EveryStep);
        steps(&mut app, planet, 30);
        assert_eq!(digest(&app, planet), expected, "order {seed}");
    }
}

/// Single steps that every planet of a game takes.
const STEPS: u32 = 10;

/// Lets a planet take its steps in the frames of a game, with pictures and bakes.
fn set_going(world: &mut World, planet: Entity) {
    let bake = BakeSettings {
        spacing: 0.05,
        ..default()
    };
    world
        .entity_mut(planet)
        .insert((SurfaceProjection::EveryStep, bake));
    let mut controls = world.get_mut::<ClockControls>(planet).unwrap();
    controls.paused = true;
    controls.single_steps = STEPS;
    controls.frame_budget = Duration::from_millis(2);
}

/// Whether a planet has taken all its steps.
fn is_done(app: &App, planet: Entity) -> bool {
    let controls = app.world().get::<ClockControls>(planet);
    controls.is_some_and(|controls| controls.single_steps == 0)
}

/// Digests of planets that lived in one game, in the order of `recipes`, spawned in the order of
/// chance.
fn digests_of_a_game(recipes: &[PlanetRecipe], rng: &mut Rng) -> Vec<String> {
    let mut app = shuffled_app(rng);
    let mut order: Vec<usize> = (0..recipes.len()).collect();
    rng.shuffle(&mut order);
    let mut planets = vec![Entity::PLACEHOLDER; recipes.len()];
    for k in order {
        planets[k] = PlanetState::new(&recipes[k])
            .unwrap()
            .spawn(app.world_mut());
        set_going(app.world_mut(), planets[k]);
    }
    while !planets.iter().all(|&planet| is_done(&app, planet)) {
        app.update();
    }
    planets.iter().map(|&planet| digest(&app, planet)).collect()
}

#[test]
fn planets_of_a_game_have_the_same_bits_in_any_order() {
    let recipes = [lively(1, 1500), lively(2, 2500), lively(3, 1000)];
    let alone = digests_alone(&recipes, u64::from(STEPS));
    for seed in 0..4 {
        let together = digests_of_a_game(&recipes, &mut Rng::with_seed(seed));
        assert_eq!(together, alone, "order {seed}");
    }
}
