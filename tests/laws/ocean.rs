//! New ocean crust: gaps between plates that part.
//!
//! Two hemispheres part at the meridian 0 by rotation about the pole: the gap is a lune, and all is
//! known in closed form.

use bevy_pangaea::crust::Cover;
use bevy_pangaea::math::{PI, lat_lon};
use bevy_pangaea::prelude::*;
use bevy_pangaea::sphere::SphereMesh;
use core::ops::Range;
use pangaea_tests::shape::{Floor, hemispheres, shaped};
use pangaea_tests::world::{get, heard, listen, spawn, steps, surface};

const RADIUS: f64 = 6370.0;

/// Two oceans that part at the meridian 0 by 2 x 100 km/My; they meet at the meridian 180.
fn parting(samples: u32) -> (bevy::prelude::App, bevy::prelude::Entity) {
    let recipe = hemispheres(samples, -100.0, 100.0);
    spawn(shaped(&recipe, |_, _, _| Floor::Ocean(100.0)))
}

/// Half the gap's width in degrees of longitude after 9 steps, in which each rim has moved by 1800
/// km along the equator. On other latitudes the rims are great circles through the poles, too.
fn half_width() -> f64 {
    (1800.0 / RADIUS).to_degrees()
}

#[test]
fn a_gap_holds_a_ridge_in_its_middle_before_any_resample() {
    let (mut app, planet) = parting(30_000);
    steps(&mut app, planet, 9);
    let surface = surface(&mut app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let (half, spacing) = (half_width(), mesh.spacing().to_degrees());
    let mut ridge = 0;
    for i in 0..surface.len() {
        let (lat, lon) = lat_lon(mesh.points()[i]);
        if lat.abs() > 30.0 || lon.abs() > 90.0 {
            continue;
        }
        let inside = half - lon.abs();
        if inside > spacing {
            assert_new_floor(&surface, i, (lat, lon), spacing);
            ridge += 1;
        } else if inside < -spacing {
            assert_eq!(surface.cover[i], Cover::One, "{lat} {lon}");
        }
    }
    assert!(ridge > 500);
}

/// Asserts that a sample within the gap has floor of the nearer plate, and of its age.
fn assert_new_floor(surface: &Surface, i: usize, (lat, lon): (f64, f64), spacing: f64) {
    assert_eq!(surface.cover[i], Cover::Ridge, "{lat} {lon}");
    assert_eq!(surface.crust.kind[i], CrustKind::Oceanic);
    let half = half_width();
    let expected = 18.0 * lon.abs() / half;
    let age = f64::from(surface.crust.ocean_age[i]);
    let tolerance = 18.0 * spacing / half + 0.5;
    assert!(
        (age - expected).abs() < tolerance,
        "age {age} for {expected} at {lat} {lon}"
    );
    let is_east = surface.plate[i].0 == 1;
    assert!(
        lon.abs() < spacing || is_east == (lon > 0.0),
        "{lat} {lon} is on the wrong plate"
    );
}

#[test]
fn the_floor_falls_from_the_ridge_to_the_rims() {
    let (mut app, planet) = parting(30_000);
    steps(&mut app, planet, 9);
    let surface = surface(&mut app, planet);
    let params = get::<TectonicParams>(&app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let profile = [(0.0, 2.0), (4.0, 7.0), (9.0, 12.0), (13.5, 16.0)]
        .map(|(low, high)| mean_elevation(&surface, mesh, low..high));
    assert!(profile.is_sorted_by(|a, b| a > b), "{profile:?}");
    assert!(
        (profile[0] - params.ridge_elevation).abs() < 0.5,
        "{profile:?}"
    );
    assert!(profile[3] < params.ridge_elevation - 0.6, "{profile:?}");
}

/// Mean elevation in km around the equator between two longitudes, east and west.
fn mean_elevation(surface: &Surface, mesh: &SphereMesh, degrees: Range<f64>) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for (i, &p) in mesh.points().iter().enumerate() {
        let (lat, lon) = lat_lon(p);
        if lat.abs() < 20.0 && degrees.contains(&lon.abs()) {
            sum += f64::from(surface.elevation(i));
            count += 1.0;
        }
    }
    sum / count
}

#[test]
fn ridge_directions_are_parallel_to_the_ridge() {
    let (mut app, planet) = parting(20_000);
    steps(&mut app, planet, 9);
    let surface = surface(&mut app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let mut seen = 0;
    for i in (0..surface.len()).filter(|&i| surface.cover[i] == Cover::Ridge) {
        let p = mesh.points()[i];
        let (lat, _) = lat_lon(p);
        if lat.abs() < 30.0 {
            let ridge = surface.crust.ridge[i].as_dvec3();
            assert!((ridge.length() - 1.0).abs() < 1e-4 && ridge.dot(p).abs() < 1e-4);
            let north = (bevy::math::DVec3::Z - p * p.z).normalize();
            assert!(ridge.dot(north).abs() > 0.85, "{ridge} at latitude {lat}");
            seen += 1;
        }
    }
    assert!(seen > 300);
}

#[test]
fn the_area_of_new_crust_is_that_of_the_lune() {
    let (mut app, planet) = parting(20_000);
    listen::<CrustResampled>(&mut app);
    steps(&mut app, planet, 10);
    let events = heard::<CrustResampled>(&app);
    assert_eq!(
        events.len(),
        1,
        "at 100 km/My a resample is due every 10 steps"
    );
    // Opening angle of 2 x 100 km/My x 20 My; a lune of angle a covers 2 a R².
    let lune = 2.0 * (2.0 * 100.0 * 20.0 / RADIUS) * RADIUS * RADIUS;
    assert!(
        (events[0].new_ocean / lune - 1.0).abs() < 0.03,
        "{:e} for {lune:e}",
        events[0].new_ocean
    );
    let ages = &get::<Crust>(&app, planet).ocean_age;
    let mean = ages.iter().map(|&age| f64::from(age)).sum::<f64>() / ages.len() as f64;
    // Old floor aged by 20 My; the lune has a mean of 10; what went under is as large as the lune.
    let share = lune / (4.0 * PI * RADIUS * RADIUS);
    let expected = 120.0 * (1.0 - share) + 10.0 * share;
    assert!((mean - expected).abs() < 1.0, "{mean} for {expected}");
}

#[test]
fn a_new_rim_floor_ages_with_the_years() {
    let (mut app, planet) = parting(5000);
    steps(&mut app, planet, 12);
    let before = get::<Crust>(&app, planet).ocean_age.clone();
    steps(&mut app, planet, 3);
    let after = &get::<Crust>(&app, planet).ocean_age;
    assert!(
        before
            .iter()
            .zip(after)
            .all(|(a, b)| (b - a - 6.0).abs() < 1e-3),
        "6 My older, everywhere"
    );
}
