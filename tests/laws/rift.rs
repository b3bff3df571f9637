//! Rifting on demand: fragments part and stay apart.
//!
//! Plates are the faces of a cube and at rest, so that all motion is that of the rift. Coverage is
//! found by brute force.

use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::math::{angle_between, direction};
use bevy_pangaea::plate::{PlateId, PlateStats};
use bevy_pangaea::prelude::*;
use pangaea_tests::measure::Coverage;
use pangaea_tests::shape::{Floor, cube, shaped};
use pangaea_tests::world::{get, heard, listen, obey, plates, spawn, steps};

const RADIUS: f64 = 6370.0;

/// A continent in the middle of plate 0.
fn planet(warp: f64) -> (App, Entity) {
    let mut recipe = cube(20_000);
    recipe.params.processes.resample = false;
    let state = shaped(&recipe, |plate, lat, lon| {
        if plate == 0 && lat.abs() < 30.0 && lon.abs() < 30.0 {
            Floor::Land(0.5)
        } else {
            Floor::Ocean(80.0)
        }
    });
    let (mut app, planet) = spawn(state);
    app.world_mut()
        .get_mut::<TectonicParams>(planet)
        .unwrap()
        .border_warp = warp;
    (app, planet)
}

fn rift(app: &mut App, planet: Entity, line: &[(f64, f64)], fragments: u32) -> Vec<PlateId> {
    listen::<PlateRifted>(app);
    let command = TectonicCommand::RiftPlate {
        plate: PlateId(0),
        line: line.to_vec(),
        fragments,
    };
    assert!(obey(app, planet, command));
    heard::<PlateRifted>(app).remove(0).fragments
}

/// The fragments that cover each point of plate 0's face, on a grid of half a degree.
fn covers(app: &App, planet: Entity, fragments: &[PlateId]) -> Vec<(f64, f64, Vec<PlateId>)> {
    let coverage = Coverage::of(app, planet);
    let mut out = Vec::new();
    for y in -70..=70 {
        for x in -70..=70 {
            let (lat, lon) = (f64::from(y) * 0.5, f64::from(x) * 0.5);
            let found = coverage.at(direction(lat, lon));
            let own = found
                .into_iter()
                .map(|hit| hit.0)
                .filter(|id| fragments.contains(id))
                .collect();
            out.push((lat, lon, own));
        }
    }
    out
}

fn assert_apart(app: &mut App, planet: Entity, fragments: &[PlateId]) {
    for step in 1..=10 {
        steps(app, planet, 1);
        let overlaps = covers(app, planet, fragments)
            .iter()
            .filter(|(_, _, own)| own.len() > 1)
            .count();
        assert_eq!(
            overlaps,
            0,
            "points under two fragments {} My after the rift",
            2 * step
        );
    }
}

/// Asserts that a rift along a line leaves fragments that part, with a gap at `middle`.
fn assert_opens(warp: f64, line: &[(f64, f64)], middle: DVec3) {
    let (mut app, planet) = planet(warp);
    let fragments = rift(&mut app, planet, line, 2);
    assert_eq!(
        fragments[0],
        PlateId(0),
        "the first fragment keeps the number"
    );
    assert_apart(&mut app, planet, &fragments);
    let coverage = Coverage::of(&app, planet);
    assert!(coverage.at(middle).is_empty(), "no gap on the line");
}

#[test]
fn fragments_of_a_users_line_do_not_overlap_for_20_my() {
    let bent = [(-25.0, 3.0), (0.0, -4.0), (25.0, 5.0)];
    assert_opens(0.3, &bent, direction(0.0, -4.0));
    let meridian = [(-25.0, 0.0), (25.0, 0.0)];
    assert_opens(0.0, &meridian, direction(0.0, 0.0));
    let slanting = [(-10.0, -20.0), (12.0, 20.0)];
    let [a, b] = slanting.map(|(lat, lon)| direction(lat, lon));
    assert_opens(0.3, &slanting, (a + b).normalize());
}

/// Width in km of the gap on a parallel near the meridian 0.
fn gap_width(coverage: &Coverage, lat: f64) -> f64 {
    let is_open = |k: &i32| coverage.at(direction(lat, f64::from(*k) * 0.05)).is_empty();
    let open = (-300..=300).filter(is_open).count();
    open as f64 * 0.05_f64.to_radians() * lat.to_radians().cos() * RADIUS
}

#[test]
fn the_pole_of_a_rift_lies_on_the_extension_of_its_line() {
    let (mut app, planet) = planet(0.0);
    let pole = opened(&mut app, planet).normalize();
    assert!(pole.dot(DVec3::Y).abs() < 1e-9);
    let middle = direction(0.0, 0.0);
    let from_middle = angle_between(pole, middle).min(angle_between(-pole, middle));
    assert!(
        from_middle > 45f64.to_radians(),
        "it lies outside of the plate"
    );
}

/// Rifts plate 0 along the meridian 0. Returns the relative motion of the fragments in rad/My.
fn opened(app: &mut App, planet: Entity) -> DVec3 {
    let fragments = rift(app, planet, &[(-25.0, 0.0), (25.0, 0.0)], 2);
    let table = plates(app, planet);
    table.angular_velocity(fragments[0]) - table.angular_velocity(fragments[1])
}

#[test]
fn the_gap_grows_with_the_distance_from_its_pole() {
    let (mut app, planet) = planet(0.0);
    let motion = opened(&mut app, planet);
    let from_pole = |lat: f64| angle_between(motion, direction(lat, 0.0)).sin();
    let spacing = get::<Lattice>(&app, planet).spacing() * RADIUS;
    steps(&mut app, planet, 10);
    let coverage = Coverage::of(&app, planet);
    for lat in (-30..=30).step_by(10).map(f64::from) {
        let expected = motion.length() * 20.0 * from_pole(lat) * RADIUS;
        let found = gap_width(&coverage, lat);
        let error = (found - expected).abs();
        assert!(
            error < 1.1 * spacing,
            "{found:.0} km at latitude {lat}, not {expected:.0}"
        );
    }
    // A quarter of a turn from the pole the gap is widest.
    let [south, north] = [-30.0, 30.0].map(|lat| gap_width(&coverage, lat));
    let wider = (north - south) * (from_pole(30.0) - from_pole(-30.0)).signum();
    assert!(wider > spacing, "{south} and {north} km");
}

#[test]
fn fragments_of_a_rift_are_the_plate() {
    for count in [2, 3, 4] {
        let (mut app, planet) = planet(0.3);
        let whole = plates(&app, planet).rows()[0].stats.area;
        let fragments = rift(&mut app, planet, &[], count);
        assert_eq!(fragments.len(), count as usize);
        let table = plates(&app, planet);
        assert_eq!(table.rows().len(), 5 + count as usize);
        let area = |&id: &PlateId| table.get(id).unwrap().stats.area;
        let areas: Vec<f64> = fragments.iter().map(area).collect();
        assert!((areas.iter().sum::<f64>() / whole - 1.0).abs() < 1e-9);
        assert!(areas.iter().all(|area| *area > 0.14 * whole), "{areas:?}");
    }
}

#[test]
fn fragments_move_away_from_their_junction() {
    for count in [2, 3, 4] {
        let (mut app, planet) = planet(0.3);
        let fragments = rift(&mut app, planet, &[], count);
        assert_apart(&mut app, planet, &fragments);
        let coverage = Coverage::of(&app, planet);
        let face = covers(&app, planet, &fragments);
        let open = face.iter().filter(|(lat, lon, own)| {
            own.is_empty() && coverage.at(direction(*lat, *lon)).is_empty()
        });
        assert!(open.count() > 200, "nothing has opened");
    }
}

#[test]
fn a_rift_thins_the_continent_beside_it_and_books_it() {
    let (mut app, planet) = planet(0.0);
    let before = get::<Crust>(&app, planet).clone();
    rift(&mut app, planet, &[(-25.0, 0.0), (25.0, 0.0)], 2);
    let after = get::<Crust>(&app, planet);
    let params = get::<TectonicParams>(&app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let mut volume = 0.0;
    for (i, p) in mesh.points().iter().enumerate() {
        let km = p.dot(DVec3::Y).abs().asin() * RADIUS;
        let [was, is] = [&before, after].map(|crust| f64::from(crust.thickness[i]));
        if before.is_continental(i) && p.x > 0.0 && km < params.rift_width {
            let least = 1.0 - params.rift_thinning - 1e-6;
            assert!((least..1.0).contains(&(is / was)));
            volume += (is - was) * mesh.areas()[i] * RADIUS * RADIUS;
        } else {
            assert_eq!(is, was, "{km:.0} km from the rift");
        }
    }
    let booked = get::<Ledger>(&app, planet).of(Cause::Rifting).volume;
    assert!(volume < 0.0 && (booked / volume - 1.0).abs() < 1e-9);
}

/// The chance that a plate rifts within a step, written out from the paper (000 §4.4, with
/// 1 - exp(-λ) for λ exp(-λ)): λ grows with the plate's area and with its share of continent.
fn chance(params: &TectonicParams, stats: &PlateStats) -> f64 {
    let sphere = 4.0 * core::f64::consts::PI * RADIUS * RADIUS;
    let oceanic = params.rift_oceanic_share;
    let weight = oceanic + (1.0 - oceanic) * stats.continental.powi(2);
    let lambda = params.rift_rate * weight * stats.area / (params.plate_share * sphere);
    1.0 - (-lambda).exp()
}

/// Plates of fewer samples are left alone.
const FEWEST_SAMPLES: u32 = 200;

#[test]
fn planets_rift_by_themselves_about_as_often_as_they_should() {
    // Over many steps the number of rifts is the sum of the chances.
    let mut recipe = pangaea_tests::shape::small(11, 4000);
    recipe.params.rift_rate = 0.02;
    let (mut app, planet) = pangaea_tests::world::planet_app(&recipe);
    listen::<PlateRifted>(&mut app);
    let mut expected = 0.0;
    for _ in 0..150 {
        let params = get::<TectonicParams>(&app, planet);
        let table = plates(&app, planet);
        let large = table
            .rows()
            .iter()
            .filter(|row| row.stats.samples >= FEWEST_SAMPLES);
        expected += large.map(|row| chance(params, &row.stats)).sum::<f64>();
        steps(&mut app, planet, 1);
    }
    let rifts = heard::<PlateRifted>(&app).len() as f64;
    let most = expected + 3.0 * expected.sqrt();
    assert!(
        rifts > 0.0 && rifts <= most,
        "{rifts} rifts, expected {expected}"
    );
    // Some plates find no shape to break into.
    assert!(
        rifts >= 0.3 * expected - 2.0,
        "{rifts} rifts, expected {expected}"
    );
}
