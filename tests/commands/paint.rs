//! Brushes.

use super::{accept, assert_ledger_closed, planet};
use bevy::prelude::*;
use bevy_pangaea::math::{angle_between, direction};
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::measure::continents;
use pangaea_tests::order::{paint, paint_all};
use pangaea_tests::world::{get, obey, state, steps};

const CENTER: (f64, f64) = (10.0, 20.0);
/// Radius of the disc in km.
const RADIUS: f64 = 1200.0;

fn disc() -> PaintTarget {
    PaintTarget::Disc {
        center: CENTER,
        radius: RADIUS,
    }
}

/// Distance in km of every sample from the centre of the disc.
fn distances(state: &PlanetState) -> Vec<f64> {
    let center = direction(CENTER.0, CENTER.1);
    let places = state.crust.frame.iter().zip(state.lattice.points());
    places
        .map(|(&frame, &p)| state.frames[usize::from(frame)].to_world(p))
        .map(|p| angle_between(p, center) * 6370.0)
        .collect()
}

#[test]
fn a_disc_becomes_a_continent() {
    let (mut app, planet) = planet();
    let land = Brush::Kind(CrustKind::Continental);
    accept(&mut app, planet, paint(disc(), land));
}

/// Samples of a planet that was raised by 2 km in a disc: distance from its middle, rise and
/// thickening in km.
fn raised() -> (App, Entity, Vec<[f64; 3]>) {
    let (mut app, planet) = planet();
    let old = state(&app, planet);
    assert!(obey(&mut app, planet, paint(disc(), Brush::Raise(2.0))));
    let new = get::<Crust>(&app, planet);
    let samples = distances(&old).into_iter().enumerate().map(|(i, km)| {
        let rise = new.elevation[i] - old.crust.elevation[i];
        let thickening = new.thickness[i] - old.crust.thickness[i];
        [km, f64::from(rise), f64::from(thickening)]
    });
    let samples = samples.collect();
    (app, planet, samples)
}

#[test]
fn a_disc_is_raised_in_full_within_half_its_radius_and_not_beyond_it() {
    let (app, planet, samples) = raised();
    let (mut full, mut outside) = (0, 0);
    for [km, rise, thickening] in samples {
        if km > RADIUS {
            assert_eq!([rise, thickening], [0.0; 2]);
            outside += 1;
        } else if km < 0.5 * RADIUS {
            assert!((rise - 2.0).abs() < 1e-3, "{rise} at {km} km");
            assert!(thickening > 0.0, "thickness follows");
            full += 1;
        } else {
            assert!((0.0..=2.0).contains(&rise));
        }
    }
    assert!(full > 5 && outside > 1000);
    assert_ledger_closed(&app, planet);
}

#[test]
fn a_disc_is_levelled() {
    let (mut app, planet) = planet();
    assert!(obey(&mut app, planet, paint(disc(), Brush::Elevation(3.0))));
    let elevation = &get::<Crust>(&app, planet).elevation;
    let level = elevation.iter().filter(|&&z| z == 3.0).count();
    assert!(level > 10, "{level} samples at 3 km");
    assert_ledger_closed(&app, planet);
}

#[test]
fn the_whole_planet_is_painted() {
    let (mut app, planet) = planet();
    let old = get::<Crust>(&app, planet).elevation.clone();
    assert!(obey(&mut app, planet, paint_all(Brush::Raise(0.5))));
    let new = &get::<Crust>(&app, planet).elevation;
    assert!(old.iter().zip(new).all(|(a, b)| (b - a - 0.5).abs() < 1e-4));
    let ocean = Brush::Kind(CrustKind::Oceanic);
    accept(&mut app, planet, paint_all(ocean));
}

fn assert_finite(app: &App, planet: Entity) {
    let elevation = &get::<Crust>(app, planet).elevation;
    assert!(elevation.iter().all(|z| z.is_finite()));
}

#[test]
fn a_drowned_planet_lives_on() {
    let (mut app, planet) = planet();
    assert!(obey(
        &mut app,
        planet,
        paint_all(Brush::Kind(CrustKind::Oceanic))
    ));
    let left = continents(get(&app, planet), get::<Lattice>(&app, planet), 6370.0);
    assert_eq!(left, (0.0, 0.0));
    steps(&mut app, planet, 25);
    assert_finite(&app, planet);
    assert!(obey(
        &mut app,
        planet,
        paint_all(Brush::Kind(CrustKind::Continental))
    ));
    steps(&mut app, planet, 25);
    assert_finite(&app, planet);
}
