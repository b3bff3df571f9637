//! Drift: rigid rotation, no sample moves, nothing is lost.

use bevy_pangaea::math::{PI, angle_between, direction, rotation};
use bevy_pangaea::prelude::*;
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

#[test]
fn a_full_turn_returns_every_sample() {
    let recipe = turntable(3000, 4.5);
    let state = shaped(&recipe, |_, lat, lon| {
        if lat.abs() < 40.0 && lon.abs() < 50.0 {
            Floor::Land(0.5 + (lon / 100.0) as f32)
        } else {
            Floor::Ocean(80.0)
        }
    });
    let (mut app, planet) = spawn(state);
    let before = surface(&mut app, planet);
    let crust = get::<Crust>(&app, planet).clone();
    steps(&mut app, planet, 80);
    let after = surface(&mut app, planet);
    for frame in get::<Frames>(&app, planet).iter() {
        assert!((frame.to_world(bevy::math::DVec3::X) - bevy::math::DVec3::X).length() < 1e-10);
    }
    for i in 0..before.len() {
        assert!(
            (before.elevation(i) - after.elevation(i)).abs() < 1e-4,
            "sample {i}"
        );
        assert_eq!(before.crust.kind[i], after.crust.kind[i]);
        assert_eq!(before.plate[i], after.plate[i]);
    }
    let now = get::<Crust>(&app, planet);
    assert_eq!(
        (&crust.kind, &crust.frame, &crust.fold),
        (&now.kind, &now.frame, &now.fold),
        "samples never move"
    );
}

#[test]
fn a_continent_moves_at_the_speed_of_its_plate() {
    let recipe = turntable(8000, 1.0);
    let state = shaped(&recipe, |_, lat, lon| {
        if lat.abs() < 30.0 && lon.abs() < 30.0 {
            Floor::Land(0.5)
        } else {
            Floor::Ocean(80.0)
        }
    });
    let (mut app, planet) = spawn(state);
    let before = surface(&mut app, planet);
    steps(&mut app, planet, 37);
    let after = surface(&mut app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let turn = rotation(bevy::math::DVec3::Z, 37.0_f64.to_radians());
    let spacing = mesh.spacing();
    for (i, p) in mesh.points().iter().enumerate() {
        let from = mesh.nearest(turn.conjugate() * *p);
        let (lat, lon) = bevy_pangaea::math::lat_lon(turn.conjugate() * *p);
        let margin = 1.5 * spacing.to_degrees();
        let near_coast = (lat.abs() - 30.0).abs() < margin
            || (lon.abs() - 30.0).abs() < margin / lat.to_radians().cos();
        if !near_coast {
            assert_eq!(
                after.crust.kind[i], before.crust.kind[from as usize],
                "at {lat} {lon}"
            );
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
        let odd = surface
            .cover
            .iter()
            .filter(|&&c| c != bevy_pangaea::crust::Cover::One)
            .count();
        assert_eq!(odd, 0, "the seam of two plates at rest against each other");
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
