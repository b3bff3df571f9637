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

/// Overlap in km at which continents collide, with another trigger than the usual one. A resample
/// resolves overlaps, so there is none.
fn overlap_at_collision(trigger: f64) -> f64 {
    let mut state = head_on(100.0, (0.0, 30.0), (0.0, 45.0));
    state.params.collision_trigger = trigger;
    state.params.processes.resample = false;
    let (mut app, planet) = spawn(state);
    until_collision(&mut app, planet, 60).unwrap_or(f64::INFINITY)
}

#[test]
fn a_smaller_trigger_collides_earlier() {
    let [early, late] = [300.0, 800.0].map(overlap_at_collision);
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

/// Steps until continents have collided, and returns the number of frames before that step.
fn frames_before_collision(app: &mut App, planet: Entity) -> usize {
    listen::<TerraneCollided>(app);
    for _ in 0..60 {
        let frames = get::<Frames>(app, planet).len();
        steps(app, planet, 1);
        if !heard::<TerraneCollided>(app).is_empty() {
            return frames;
        }
    }
    panic!("no collision");
}

#[test]
fn the_smaller_terrane_changes_plate_in_a_new_frame() {
    let mut state = head_on(100.0, (0.0, 20.0), (0.0, 45.0));
    state.params.processes.resample = false;
    let (mut app, planet) = spawn(state);
    let frames = frames_before_collision(&mut app, planet);
    let event = heard::<TerraneCollided>(&app).remove(0);
    let plates = (event.from, event.to);
    assert_eq!(
        plates,
        (PlateId(0), PlateId(1)),
        "the smaller continent moves"
    );
    let after = world::state(&app, planet);
    assert_eq!(after.frames.len(), frames + 1);
    let terrane = after.frames[frames];
    assert!(terrane.terrane && terrane.plate == PlateId(1));
    let mut old = after
        .frames
        .iter()
        .filter(|frame| frame.plate == PlateId(0));
    let rotation = old.next().unwrap().rotation;
    assert_eq!(
        terrane.rotation, rotation,
        "it keeps the rotation that it has"
    );
    assert_terrane_area(&after, frames, event.area);
    // From now on it is carried by the other plate, which is at rest.
    steps(&mut app, planet, 3);
    let later = get::<Frames>(&app, planet)[frames].rotation;
    assert_eq!(later, terrane.rotation);
}

/// Asserts that the samples of a frame are continental and cover `area` km².
fn assert_terrane_area(state: &PlanetState, frame: usize, area: f64) {
    let crust = &state.crust;
    let moved = (0..crust.len()).filter(|&i| usize::from(crust.frame[i]) == frame);
    let mut sum = 0.0;
    for i in moved {
        assert!(crust.is_continental(i));
        sum += state.lattice.areas()[i] * 6370.0 * 6370.0;
    }
    assert!((sum / area - 1.0).abs() < 1e-9);
}

/// A planet just after two continents have collided near latitude 0, longitude 0, and its highest
/// elevation in km before.
fn sutured() -> (App, Entity, f32) {
    let (mut app, planet) = spawn(head_on(100.0, (2.0, 22.0), (0.0, 45.0)));
    let elevation = &get::<Crust>(&app, planet).elevation;
    let before = elevation.iter().copied().fold(0.0, f32::max);
    until_collision(&mut app, planet, 60).expect("a collision");
    (app, planet, before)
}

/// Latitude and longitude of sample `i` as it is now.
fn place(app: &App, planet: Entity, i: usize) -> (f64, f64) {
    let frame = get::<Crust>(app, planet).frame[i];
    let p = get::<Lattice>(app, planet).points()[i];
    lat_lon(get::<Frames>(app, planet)[usize::from(frame)].to_world(p))
}

#[test]
fn a_collision_tells_where_and_how_fast() {
    let (app, ..) = sutured();
    let event = heard::<TerraneCollided>(&app).remove(0);
    let (lat, lon) = lat_lon(event.at);
    assert!(
        lat.abs() < 25.0 && lon.abs() < 8.0,
        "contact at {lat} {lon}"
    );
    assert!((event.speed - 100.0).abs() < 15.0, "{}", event.speed);
}

#[test]
fn a_himalayan_belt_stands_at_the_suture() {
    let (app, planet, _) = sutured();
    let (crust, mesh) = (get::<Crust>(&app, planet), get::<Lattice>(&app, planet));
    let params = get::<TectonicParams>(&app, planet);
    let reach = params.collision_distance * params.collision_reach;
    let belt = (0..crust.len()).filter(|&i| crust.orogeny[i] == Orogeny::Himalayan);
    let mut count = 0;
    for i in belt {
        let (lat, lon) = place(&app, planet, i);
        let km = lon.abs() * DEGREE * lat.to_radians().cos();
        assert!(km < reach + 600.0, "a belt {km:.0} km from the suture");
        assert!(crust.is_continental(i));
        let (fold, up) = (crust.fold[i], mesh.points()[i].as_vec3());
        assert!((fold.length() - 1.0).abs() < 0.1, "folded");
        assert!(fold.dot(up).abs() < 0.1, "the fold is tangent");
        count += 1;
    }
    assert!(count > 30, "{count} samples");
}

#[test]
fn the_highest_summit_stands_at_the_suture_and_its_uplift_is_booked() {
    let (app, planet, before) = sutured();
    let elevation = &get::<Crust>(&app, planet).elevation;
    let highest = (0..elevation.len()).max_by(|&a, &b| elevation[a].total_cmp(&elevation[b]));
    let highest = highest.expect("a planet has samples");
    let ceiling = get::<TectonicParams>(&app, planet).summit_elevation as f32;
    assert!(elevation[highest] > before + 1.0 && elevation[highest] <= ceiling);
    let (_, lon) = place(&app, planet, highest);
    assert!(lon.abs() < 8.0, "at longitude {lon}");
    let uplift = get::<Ledger>(&app, planet).of(Cause::CollisionUplift);
    assert!(uplift.volume > 0.0);
}
