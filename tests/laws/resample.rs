//! Resampling: invisible, and nothing to do where nothing has moved.

use bevy::prelude::*;
use bevy_pangaea::crust::Cover;
use bevy_pangaea::prelude::*;
use bevy_pangaea::resample::project_now;
use pangaea_tests::probe::{Change, probe};
use pangaea_tests::shape::small;
use pangaea_tests::world::{command, get, heard, listen, params, planet_app, steps};

/// Takes one step with a resample and asserts that it changed no bit of the crust.
fn resample_without_a_trace(app: &mut App, planet: Entity) {
    listen::<CrustResampled>(app);
    let earlier = heard::<CrustResampled>(app).len();
    command(app, planet, TectonicCommand::Resample);
    probe(app, |change| {
        if change.stage == Stage::Resample {
            assert_no_trace(change);
        }
    });
    steps(app, planet, 1);
    assert_eq!(heard::<CrustResampled>(app).len(), earlier + 1);
}

/// Asserts that a stage has changed nothing but clock and ledger.
fn assert_no_trace(change: &Change) {
    let [before, after] = [&change.before, &change.after].map(|state| &state.crust.thickness);
    let changes = before.iter().zip(after).map(|(a, b)| (a - b).abs());
    let most = changes.fold(0.0, f32::max);
    let mut changed = change.changed();
    changed.retain(|name| !["clock", "ledger"].contains(name));
    assert!(
        changed.is_empty(),
        "{changed:?} changed, thickness by {most:e} km at most"
    );
}

#[test]
fn a_resample_of_a_new_planet_changes_no_bit() {
    let mut recipe = small(5, 6000);
    recipe.params.processes = ProcessSwitches::all(false);
    let (mut app, planet) = planet_app(&recipe);
    resample_without_a_trace(&mut app, planet);
}

#[test]
fn a_second_resample_changes_no_bit() {
    let (mut app, planet) = planet_app(&small(6, 6000));
    steps(&mut app, planet, 25);
    params(&mut app, planet).processes = ProcessSwitches::all(false);
    command(&mut app, planet, TectonicCommand::Resample);
    steps(&mut app, planet, 1);
    resample_without_a_trace(&mut app, planet);
}

/// The surface just before a resample, while frames still overlap and gape.
#[derive(Resource, Default)]
struct Before(Option<PlanetSurface>);

/// Keeps the surface as it is now.
fn look(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    project_now(world, planet);
    let surface = world.get::<PlanetSurface>(planet).cloned();
    world.resource_mut::<Before>().0 = surface;
}

#[test]
fn pictures_just_before_and_after_a_resample_agree() {
    let (mut app, planet) = planet_app(&small(3, 20_000));
    app.init_resource::<Before>();
    listen::<CrustResampled>(&mut app);
    app.add_systems(
        TectonicStep,
        look.in_set(TectonicSystems::After(Stage::SurfaceProcesses)),
    );
    let mut compared = 0;
    for _ in 0..45 {
        let earlier = heard::<CrustResampled>(&app).len();
        steps(&mut app, planet, 1);
        if heard::<CrustResampled>(&app).len() == earlier {
            continue;
        }
        let before = app.world_mut().resource_mut::<Before>().0.take().unwrap();
        compare(&before, get::<PlanetSurface>(&app, planet));
        compared += 1;
    }
    assert!(compared >= 2, "{compared} resamples");
}

/// Share of `n` samples that differ, in percent.
fn percent(n: usize, differs: impl Fn(usize) -> bool) -> f64 {
    100.0 * (0..n).filter(|&i| differs(i)).count() as f64 / n as f64
}

/// Asserts that few samples of two surfaces differ, and by little.
fn compare(before: &Surface, after: &Surface) {
    let n = before.len();
    let rise = |i: usize| after.elevation(i) - before.elevation(i);
    let moved = percent(n, |i| rise(i).abs() > 0.05);
    assert!(moved < 3.0, "{moved:.2} % move by more than 50 m");
    let kind = percent(n, |i| before.crust.kind[i] != after.crust.kind[i]);
    assert!(kind < 0.5, "{kind:.2} % change their kind");
    let plate = percent(n, |i| before.plate[i] != after.plate[i]);
    assert!(plate < 2.0, "{plate:.2} % change their plate");
    let ages = [before, after].map(|surface| &surface.crust.ocean_age);
    let aged = percent(n, |i| (ages[0][i] - ages[1][i]).abs() > 2.1);
    assert!(aged < 1.0, "{aged:.2} % age by more than a step");
}

#[test]
fn after_a_resample_one_frame_at_rest_covers_every_sample() {
    let (mut app, planet) = planet_app(&small(4, 6000));
    steps(&mut app, planet, 7);
    command(&mut app, planet, TectonicCommand::Resample);
    steps(&mut app, planet, 1);
    let frames = get::<Frames>(&app, planet);
    assert!(
        frames
            .iter()
            .all(|frame| frame.is_at_rest() && !frame.terrane)
    );
    let mut owners: Vec<_> = frames.iter().map(|frame| frame.plate).collect();
    owners.dedup();
    assert_eq!(owners.len(), frames.len(), "one frame for a plate");
    project_now(app.world_mut(), planet);
    let surface = get::<PlanetSurface>(&app, planet);
    assert!(surface.cover.iter().all(|&cover| cover == Cover::One));
    assert_eq!(
        &surface.crust,
        get::<Crust>(&app, planet),
        "the state is the surface, bit for bit"
    );
}

#[test]
fn looking_at_a_planet_does_not_change_it() {
    let (mut app, planet) = planet_app(&small(8, 5000));
    let (mut other, unseen) = planet_app(&small(8, 5000));
    app.world_mut()
        .entity_mut(planet)
        .insert(bevy_pangaea::resample::SurfaceProjection::EveryStep);
    for _ in 0..15 {
        steps(&mut app, planet, 1);
        project_now(app.world_mut(), planet);
    }
    steps(&mut other, unseen, 15);
    assert_eq!(
        pangaea_tests::world::digest(&app, planet),
        pangaea_tests::world::digest(&other, unseen)
    );
}
