//! Drift: rigid rotation, no sample moves, nothing is lost.

use bevy::math::DVec3;
use bevy_pangaea::crust::Cover;
use bevy_pangaea::math::{PI, angle_between, direction, lat_lon, rotation};
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::shape::{Floor, hemispheres, shaped};
use pangaea_tests::world::{get, planet_app, plates, spawn, steps, surface};

/// Both hemispheres turn together at `degrees` per step about the north pole; nothing else happens.
fn turntable(samples: u32, degrees: f64) -> PlanetRecipe {
    let speed = degrees.to_radians() * 6370.0 / 2.0;
    let mut recipe = hemispheres(samples, speed, speed);
    recipe.params.processes = ProcessSwitches {
        drift: true,
        ..ProcessSwitches::all(false)
    };
    recipe.params.isostasy_time = 200.0;
    recipe.params.max_speed = 300.0;
    recipe
}

/// A turntable with a square continent of `side` degrees around latitude 0, longitude 0.
fn with_continent(recipe: &PlanetRecipe, side: f64) -> PlanetState {
    shaped(recipe, |_, lat, lon| {
        if lat.abs().max(lon.abs()) < 0.5 * side {
            Floor::Land(0.5 + (lon / 100.0) as f32)
        } else {
            Floor::Ocean(80.0)
        }
    })
}

#[test]
fn a_full_turn_returns_every_sample() {
    let (mut app, planet) = spawn(with_continent(&turntable(3000, 4.5), 90.0));
    let before = surface(&mut app, planet);
    let crust = get::<Crust>(&app, planet).clone();
    steps(&mut app, planet, 80);
    let after = surface(&mut app, planet);
    for frame in get::<Frames>(&app, planet).iter() {
        assert!(frame.to_world(DVec3::X).distance(DVec3::X) < 1e-10);
    }
    for i in 0..before.len() {
        let change = after.elevation(i) - before.elevation(i);
        assert!(change.abs() < 1e-4, "sample {i}");
    }
    assert_eq!(before.crust.kind, after.crust.kind);
    assert_eq!(before.plate, after.plate);
    let now = get::<Crust>(&app, planet);
    let state = (&crust.kind, &crust.frame, &crust.fold);
    assert_eq!(
        state,
        (&now.kind, &now.frame, &now.fold),
        "samples never move"
    );
}

/// Half the side of the continent that moves, in degrees.
const HALF: f64 = 30.0;

/// Whether a point lies within `margin` degrees of the continent's coast.
fn is_near_coast((lat, lon): (f64, f64), margin: f64) -> bool {
    let shrunk = margin / lat.to_radians().cos();
    (lat.abs() - HALF).abs() < margin || (lon.abs() - HALF).abs() < shrunk
}

#[test]
fn a_continent_moves_at_the_speed_of_its_plate() {
    let (mut app, planet) = spawn(with_continent(&turntable(8000, 1.0), 2.0 * HALF));
    let before = surface(&mut app, planet);
    steps(&mut app, planet, 37);
    let after = surface(&mut app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let back = rotation(DVec3::Z, 37.0_f64.to_radians()).conjugate();
    let margin = 1.5 * mesh.spacing().to_degrees();
    for (i, &p) in mesh.points().iter().enumerate() {
        let from = back * p;
        if !is_near_coast(lat_lon(from), margin) {
            let kind = before.crust.kind[mesh.nearest(from) as usize];
            assert_eq!(after.crust.kind[i], kind, "at {:?}", lat_lon(from));
        }
    }
    let row = plates(&app, planet).rows()[0];
    let moved = angle_between(row.stats.centroid, direction(0.0, -90.0 + 37.0));
    assert!(moved < 0.05, "the centroid moves along: {moved}");
}

#[test]
fn plates_that_turn_together_never_open_or_overlap() {
    let (mut app, planet) = planet_app(&turntable(5000, 3.0));
    for _ in 0..5 {
        steps(&mut app, planet, 3);
        let surface = surface(&mut app, planet);
        let is_whole = surface.cover.iter().all(|&cover| cover == Cover::One);
        assert!(
            is_whole,
            "the seam of two plates at rest against each other"
        );
    }
}

#[test]
fn no_point_exceeds_the_speed_of_its_recipe() {
    let (app, planet) = planet_app(&hemispheres(500, 60.0, -30.0));
    for (row, speed) in plates(&app, planet).rows().iter().zip([60.0, 30.0]) {
        assert!((row.motion.speed * 6370.0 - speed).abs() < 1e-9);
        assert!((row.motion.axis.length() - 1.0).abs() < 1e-12);
        assert!(row.motion.speed < PI);
    }
}
