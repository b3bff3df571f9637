//! Determinism: the same seed and the same commands give the same bits, on any number of threads,
//! in any slices, across a save, in a replay, and as committed.

mod golden;
mod order;
mod replay;
mod save;

use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use bevy_pangaea::schedule::run_time_slice;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::shape::small;
use pangaea_tests::world::{app, digest, get, planet_app, steps};
use std::time::{Duration, Instant};

/// A planet on which much happens in 60 My.
fn lively(seed: u64, samples: u32) -> PlanetRecipe {
    let mut recipe = small(seed, samples);
    recipe.params.rift_rate = 0.02;
    recipe
}

/// Digest of a planet that has grown on a number of threads.
fn digest_on_threads(threads: usize) -> String {
    let builder = rayon::ThreadPoolBuilder::new().num_threads(threads);
    builder.build().unwrap().install(|| {
        let (mut app, planet) = planet_app(&lively(9, 12_000));
        steps(&mut app, planet, 30);
        digest(&app, planet)
    })
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let one = digest_on_threads(1);
    assert_eq!(one, digest_on_threads(2));
    assert_eq!(one, digest_on_threads(5));
}

#[test]
fn slices_of_a_step_give_the_same_bits_as_whole_steps() {
    let (mut whole, planet) = planet_app(&lively(10, 40_000));
    steps(&mut whole, planet, 22);
    let (mut sliced, other) = planet_app(&lively(10, 40_000));
    sliced
        .world_mut()
        .entity_mut(other)
        .insert(bevy_pangaea::resample::SurfaceProjection::EveryStep);
    let (mut done, mut slices) = (0, 0);
    while done < 22 {
        // No time at all: every stage that can hold does.
        done += u32::from(run_time_slice(
            sliced.world_mut(),
            other,
            Some(Instant::now()),
        ));
        slices += 1;
    }
    assert!(slices > 22 + 20, "the stages did not hold: {slices} slices");
    assert_eq!(digest(&whole, planet), digest(&sliced, other));
}

#[test]
fn frames_of_a_game_give_the_same_bits_as_whole_steps() {
    let (mut whole, planet) = planet_app(&lively(12, 3000));
    steps(&mut whole, planet, 12);
    let (mut game, other) = planet_app(&lively(12, 3000));
    {
        let mut controls = game.world_mut().get_mut::<ClockControls>(other).unwrap();
        controls.paused = true;
        controls.single_steps = 12;
        controls.frame_budget = Duration::from_micros(300);
    }
    for _ in 0..2000 {
        game.update();
    }
    let step = get::<GeologicClock>(&game, other).step;
    let left = get::<ClockControls>(&game, other).single_steps;
    assert_eq!(
        (step, left),
        (12, 0),
        "single steps run while time is paused, and no more"
    );
    assert_eq!(digest(&whole, planet), digest(&game, other));
}

#[test]
fn a_clock_stops_at_the_time_that_it_was_told() {
    let (mut app, planet) = planet_app(&small(13, 1000));
    let mut second = Time::<()>::default();
    second.advance_by(Duration::from_secs(1));
    app.insert_resource(second);
    {
        let mut controls = app.world_mut().get_mut::<ClockControls>(planet).unwrap();
        controls.speed = 2.0;
        controls.until = Some(9.0);
        controls.frame_budget = Duration::from_secs(9);
    }
    for _ in 0..12 {
        app.update();
    }
    let time = get::<GeologicClock>(&app, planet).time;
    let controls = get::<ClockControls>(&app, planet);
    assert_eq!(
        (time, controls.paused, controls.until),
        (10.0, true, None),
        "the step that reaches it is the last"
    );
}

/// Digests of planets that grow in apps of their own.
fn digests_alone(recipes: &[PlanetRecipe], count: u64) -> Vec<String> {
    let alone = recipes.iter().map(|recipe| {
        let (mut app, planet) = planet_app(recipe);
        steps(&mut app, planet, count);
        digest(&app, planet)
    });
    alone.collect()
}

#[test]
fn planets_of_one_world_do_not_disturb_each_other() {
    let recipes = [lively(1, 3000), lively(2, 4000), lively(3, 2500)];
    let mut app = app();
    let world = app.world_mut();
    let planets = recipes
        .each_ref()
        .map(|recipe| PlanetState::new(recipe).unwrap().spawn(world));
    for round in 0..12 {
        for k in 0..3 {
            // Interleaved, in changing order, one of them in slices.
            let planet = planets[(k + round) % 3];
            steps(&mut app, planet, 1);
            while !run_time_slice(app.world_mut(), planet, Some(Instant::now())) {}
        }
    }
    let together = planets.map(|planet| digest(&app, planet));
    assert_eq!(digests_alone(&recipes, 24), together);
}

#[test]
fn another_seed_is_another_planet() {
    let [first, again, other] = [1, 1, 2].map(|seed| {
        let (app, planet) = planet_app(&small(seed, 1000));
        digest(&app, planet)
    });
    assert_eq!(first, again);
    assert_ne!(first, other);
}
