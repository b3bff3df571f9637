//! Continental collision: when it starts, who moves, what it leaves.
//!
//! Two continents meet head-on along the equator; the overlap is measured by brute force, point by
//! point.

use bevy::prelude::*;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::math::{direction, lat_lon};
use bevy_pangaea::plate::PlateId;
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::measure::Coverage;
use pangaea_tests::shape::{Floor, hemispheres, shaped};
use pangaea_tests::world::{self, get, heard, listen, spawn, steps};

const SAMPLES: u32 = 20_000;
/// Kilometres in a degree.
const DEGREE: f64 = 6370.0 * core::f64::consts::PI / 180.0;

/// Plate 0 carries a continent from longitude -`west.1` to -`west.0` east at `speed`; that of plate
/// 1 reaches from `east.0` to `east.1` and is larger. Time steps are short.
fn head_on(speed: f64, west: (f64, f64), east: (f64, f64)) -> PlanetState {
    let mut recipe = hemispheres(SAMPLES, speed, 0.0);
    recipe.params.time_step = 0.5;
    recipe.params.slab_pull = 0.0;
    shaped(&recipe, move |plate, lat, lon| {
        let a = plate == 0 && lat.abs() < 20.0 && -lon >= west.0 && -lon < west.1;
        let b = plate == 1 && lat.abs() < 35.0 && lon >= east.0 && lon < east.1;
        if a || b {
            Floor::Land(0.4)
        } else {
            Floor::Ocean(80.0)
        }
    })
}

/// Longest way along a parallel on which both continents lie, in km.
fn overlap(app: &App, planet: Entity) -> f64 {
    let coverage = Coverage::of(app, planet);
    let mut longest = 0.0_f64;
    for lat in (-15..=15).step_by(3).map(f64::from) {
        let mut run = 0.0;
        for k in 0..900 {
            let p = direction(lat, f64::from(k) * 0.1 - 20.0);
            if coverage.continent(PlateId(0), p) && coverage.continent(PlateId(1), p) {
                run += 0.1 * DEGREE * lat.to_radians().cos();
                longest = longest.max(run);
            } else {
                run = 0.0;
            }
        }
    }
    longest
}

/// Steps until continents collide. Returns the overlap before the step in which they did, or the
/// largest that was seen if they did not in `most` steps.
fn until_collision(app: &mut App, planet: Entity, most: u64) -> Result<f64, f64> {
    listen::<TerraneCollided>(app);
    let mut largest = 0.0_f64;
    for _ in 0..most {
        let before = overlap(app, planet);
        largest = largest.max(before);
        steps(app, planet, 1);
        if !heard::<TerraneCollided>(app).is_empty() {
            return Ok(before);
        }
    }
    Err(largest)
}

/// A terrane breaks off when 300 km overlap: not a step later, and not before, within a sample.
fn assert_trigger(at: Result<f64, f64>, app: &App, planet: Entity, step: f64) {
    let trigger = get::<TectonicParams>(app, planet).collision_trigger;
    let spacing = get::<Lattice>(app, planet).spacing() * 6370.0;
    let before = at.unwrap_or_else(|largest| {
        panic!("no collision, though continents overlapped by {largest:.0} km")
    });
    assert!(
        before + step > trigger - 1.2 * spacing,
        "they collided at an overlap of {before:.0} km"
    );
    assert!(
        before < trigger + 1.2 * spacing,
        "they collided only at an overlap of {before:.0} km"
    );
}

#[test]
fn terranes_break_off_at_300_km_of_overlap() {
    let (mut app, planet) = spawn(head_on(100.0, (10.0, 35.0), (0.0, 45.0)));
    let at = until_collision(&mut app, planet, 60);
    assert_trigger(at, &app, planet, 50.0);
}

#[test]
fn a_smaller_trigger_collides_earlier() {
    let trigger = |km: f64| {
        let mut state = head_on(100.0, (0.0, 30.0), (0.0, 45.0));
        state.params.collision_trigger = km;
        // A resample resolves overlaps; it must not come before the collision here.
        state.params.processes.resample = false;
        let (mut app, planet) = spawn(state);
        until_collision(&mut app, planet, 60).unwrap_or(f64::INFINITY)
    };
    let (early, late) = (trigger(300.0), trigger(800.0));
    assert!(
        late > early + 350.0 && late < early + 650.0,
        "{early} and {late} km"
    );
}

#[test]
fn continents_behind_their_own_oceans_collide_as_well() {
    // Neither coast is a rim of its plate until the ocean before it has been consumed.
    let (mut app, planet) = spawn(head_on(100.0, (5.0, 30.0), (4.0, 45.0)));
    let at = until_collision(&mut app, planet, 60);
    assert_trigger(at, &app, planet, 50.0);
}

#[test]
fn long_steps_and_their_resamples_do_not_swallow_a_collision() {
    // 100 km a step; neither coast is a rim, and a resample is due after 20 steps.
    let mut state = head_on(50.0, (5.0, 30.0), (4.0, 45.0));
    state.params.time_step = 2.0;
    let (mut app, planet) = spawn(state);
    let at = until_collision(&mut app, planet, 40);
    assert_trigger(at, &app, planet, 100.0);
}

#[test]
fn slow_continents_collide_as_well() {
    // 12 km/My: 240 km between two resamples, less than the trigger, but 1,200 km in all.
    let mut state = head_on(12.0, (0.0, 25.0), (0.0, 45.0));
    state.params.time_step = 2.0;
    state.params.resample_max_steps = 10.0;
    let (mut app, planet) = spawn(state);
    until_collision(&mut app, planet, 50).unwrap_or_else(|largest| {
        let lost = get::<Ledger>(&app, planet).of(Cause::ForcedSubduction).area;
        panic!("no collision in 100 My; overlaps reached {largest:.0} km, {lost:.2e} km² were forced down")
    });
}

#[test]
fn slow_continents_do_not_collide_before_they_touch() {
    let (mut app, planet) = spawn(head_on(30.0, (15.0, 35.0), (0.0, 45.0)));
    listen::<TerraneCollided>(&mut app);
    steps(&mut app, planet, 60);
    assert!(
        heard::<TerraneCollided>(&app).is_empty(),
        "1670 km apart, 900 km travelled"
    );
}

#[test]
fn the_smaller_terrane_changes_plate_in_a_new_frame() {
    let mut state = head_on(100.0, (0.0, 20.0), (0.0, 45.0));
    state.params.processes.resample = false;
    let (mut app, planet) = spawn(state);
    let frames = loop {
        let before = world::state(&app, planet);
        let earlier = heard::<TerraneCollided>(&app).len();
        until_collision(&mut app, planet, 1).ok();
        if heard::<TerraneCollided>(&app).len() > earlier {
            break before.frames.len();
        }
        assert!(before.clock.step < 60, "no collision");
    };
    let event = heard::<TerraneCollided>(&app).remove(0);
    assert_eq!(
        (event.from, event.to),
        (PlateId(0), PlateId(1)),
        "the smaller continent moves"
    );
    let after = world::state(&app, planet);
    assert_eq!(after.frames.len(), frames + 1);
    let terrane = after.frames.last().unwrap();
    assert!(terrane.terrane && terrane.plate == PlateId(1));
    let old = after
        .frames
        .iter()
        .find(|frame| frame.plate == PlateId(0))
        .unwrap();
    assert_eq!(
        terrane.rotation, old.rotation,
        "it keeps the rotation that it has"
    );
    let moved = (0..after.crust.len()).filter(|&i| usize::from(after.crust.frame[i]) == frames);
    let area: f64 = moved
        .inspect(|&i| assert!(after.crust.is_continental(i)))
        .map(|i| after.lattice.0.area(i as u32) * 6370.0 * 6370.0)
        .sum();
    assert!((area / event.area - 1.0).abs() < 1e-9);
    // From now on it is carried by the other plate: 10 steps later the old plate has left it
    // behind.
    steps(&mut app, planet, 3);
    let later = world::state(&app, planet);
    assert_eq!(
        later.frames[frames].rotation, terrane.rotation,
        "plate 1 is at rest"
    );
}

#[test]
fn a_himalayan_belt_stands_at_the_suture() {
    let (mut app, planet) = spawn(head_on(100.0, (2.0, 22.0), (0.0, 45.0)));
    let before: f32 = get::<Crust>(&app, planet)
        .elevation
        .iter()
        .fold(0.0, |a, &b| a.max(b));
    until_collision(&mut app, planet, 60).expect("a collision");
    let event = heard::<TerraneCollided>(&app).remove(0);
    let (lat, lon) = lat_lon(event.at);
    assert!(
        lat.abs() < 25.0 && lon.abs() < 8.0,
        "contact at {lat} {lon}"
    );
    assert!((event.speed - 100.0).abs() < 15.0, "{}", event.speed);
    let (crust, frames) = (get::<Crust>(&app, planet), get::<Frames>(&app, planet));
    let mesh = get::<Lattice>(&app, planet);
    let params = get::<TectonicParams>(&app, planet);
    let reach = params.collision_distance * params.collision_reach;
    let (mut belt, mut highest) = (0, (0.0_f32, 0.0));
    for i in 0..crust.len() {
        let p = frames[usize::from(crust.frame[i])].to_world(mesh.points()[i]);
        let (lat, lon) = lat_lon(p);
        if crust.orogeny[i] == Orogeny::Himalayan {
            let km = lon.abs() * DEGREE * lat.to_radians().cos();
            assert!(km < reach + 600.0, "a belt {km:.0} km from the suture");
            assert!(crust.is_continental(i));
            assert!((crust.fold[i].length() - 1.0).abs() < 0.1, "folded");
            assert!(
                crust.fold[i].dot(mesh.points()[i].as_vec3()).abs() < 0.1,
                "the fold is tangent"
            );
            belt += 1;
        }
        if crust.elevation[i] > highest.0 {
            highest = (crust.elevation[i], lon);
        }
    }
    assert!(belt > 30, "{belt} samples");
    assert!(highest.0 > before + 1.0 && highest.0 <= params.summit_elevation as f32);
    assert!(
        highest.1.abs() < 8.0,
        "the highest summit stands at the suture, not at longitude {}",
        highest.1
    );
    assert!(
        get::<Ledger>(&app, planet)
            .of(Cause::CollisionUplift)
            .volume
            > 0.0
    );
}
