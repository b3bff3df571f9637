//! Relief: erosion, subsidence, sediment, noise and isostasy on a planet at rest.

use bevy::prelude::*;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::crust::isostasy::Isostasy;
use bevy_pangaea::params::OceanFloor;
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::shape::{Floor, cube, shaped, small};
use pangaea_tests::world::{get, params, planet_app, spawn, steps};

/// A planet on which only `switch` runs.
fn only(mut recipe: PlanetRecipe, switch: &str) -> PlanetRecipe {
    recipe.params.processes = ProcessSwitches::all(false);
    *recipe.params.processes.get_mut(switch).unwrap() = true;
    recipe
}

/// A planet that erosion alone has worn for 60 My, and its crust before.
fn eroded() -> (App, Entity, Crust) {
    let (mut app, planet) = planet_app(&only(small(1, 6000), "erosion"));
    let before = get::<Crust>(&app, planet).clone();
    steps(&mut app, planet, 30);
    (app, planet, before)
}

#[test]
fn erosion_wears_the_land_and_books_it() {
    let (app, planet, before) = eroded();
    let after = get::<Crust>(&app, planet);
    let mut land = 0;
    for i in (0..before.len()).filter(|&i| before.is_continental(i)) {
        assert!(after.is_continental(i), "worn land stays continental");
        let [was, is] = [&before, after].map(|crust| crust.elevation[i]);
        if was > 0.01 {
            assert!(is < was && is > 0.0, "{was} -> {is}");
            assert!(after.thickness[i] < before.thickness[i]);
            land += 1;
        }
    }
    assert!(land > 500);
    assert!(get::<Ledger>(&app, planet).of(Cause::Erosion).volume < 0.0);
}

#[test]
fn erosion_leaves_the_shelves() {
    let (app, planet, before) = eroded();
    let after = get::<Crust>(&app, planet);
    let is_shelf = |i: &usize| before.is_continental(*i) && before.elevation[*i] < 0.0;
    let shelf: Vec<usize> = (0..before.len()).filter(is_shelf).collect();
    for &i in &shelf {
        let [was, is] = [&before, after].map(|crust| crust.elevation[i]);
        assert!((is - was).abs() < 1e-3, "a shelf moved from {was} to {is}");
        assert_eq!(after.thickness[i], before.thickness[i]);
    }
    assert!(shelf.len() > 100);
}

/// Land of an elevation in km on plate 0, and oceans of 80 My.
fn one_continent(recipe: &PlanetRecipe, elevation: f32) -> PlanetState {
    shaped(recipe, |plate, _, _| {
        if plate == 0 {
            Floor::Land(elevation)
        } else {
            Floor::Ocean(80.0)
        }
    })
}

#[test]
fn eroded_land_falls_off_exponentially_and_rebounds() {
    // Isostasy carries what is left: z follows e, so both decay together. The closed form of a step
    // is the product.
    let mut recipe = only(cube(1000), "erosion");
    recipe.params.isostasy_time = 0.5;
    let (mut app, planet) = spawn(one_continent(&recipe, 4.0));
    let mut elevation = get::<Crust>(&app, planet).elevation.iter();
    let i = elevation.position(|&z| z == 4.0).unwrap();
    steps(&mut app, planet, 100);
    let p = get::<TectonicParams>(&app, planet);
    let expected = 4.0 * (1.0 - p.erosion / p.summit_elevation * p.time_step).powi(100);
    let z = f64::from(get::<Crust>(&app, planet).elevation[i]);
    assert!((z / expected - 1.0).abs() < 0.01, "{z} for {expected}");
}

#[test]
fn ocean_floor_sinks_as_the_plates_cool() {
    let recipe = only(cube(1000), "subsidence");
    let mut state = shaped(&recipe, |_, _, _| Floor::Ocean(0.0));
    state.crust.elevation.fill(-1.0);
    let (mut app, planet) = spawn(state);
    for step in [5, 13, 36, 100] {
        let done = get::<GeologicClock>(&app, planet).step;
        steps(&mut app, planet, step - done);
        let expected_age = 2.0 * step as f64;
        let expected = -6.0 + 5.0 * (-expected_age / 36.0).exp();
        let crust = get::<Crust>(&app, planet);
        for (&z, &age) in crust.elevation.iter().zip(&crust.ocean_age) {
            let [z, age] = [z, age].map(f64::from);
            assert!(
                (z - expected).abs() < 0.01,
                "{z} for {expected} at {age} My"
            );
            assert!((age - expected_age).abs() < 1e-3);
        }
    }
}

#[test]
fn the_papers_form_drowns_old_floor_in_a_trench() {
    let mut recipe = only(cube(1000), "subsidence");
    recipe.params.ocean_floor = OceanFloor::Paper;
    let (mut app, planet) = spawn(shaped(&recipe, |_, _, _| Floor::Ocean(100.0)));
    steps(&mut app, planet, 300);
    let expected = -10.0 + 4.0 * (1.0_f64 - 0.04 * 2.0 / 10.0).powi(300);
    let z = f64::from(get::<Crust>(&app, planet).elevation[0]);
    assert!((z - expected).abs() < 0.02, "{z} for {expected}");
}

#[test]
fn sediment_fills_what_lies_too_deep_and_no_more() {
    let recipe = only(cube(1000), "sediment");
    let mut state = shaped(&recipe, |_, _, _| Floor::Ocean(100.0));
    state.crust.elevation.fill(-8.0);
    let (mut app, planet) = spawn(state);
    steps(&mut app, planet, 2);
    let z = get::<Crust>(&app, planet).elevation[7];
    assert!((z + 8.0 - 2.0 * 0.6).abs() < 1e-4, "0.3 km/My: {z}");
    steps(&mut app, planet, 20);
    assert!(
        get::<Crust>(&app, planet)
            .elevation
            .iter()
            .all(|z| (z + 6.0).abs() < 1e-3)
    );
}

#[test]
fn thickened_crust_rises_to_where_it_floats() {
    let mut recipe = cube(1000);
    recipe.params.processes = ProcessSwitches::all(false);
    let mut state = one_continent(&recipe, 0.5);
    let law = Isostasy::new(&recipe.params);
    let all = 0..state.crust.len();
    let land: Vec<usize> = all.filter(|&i| state.crust.is_continental(i)).collect();
    land.iter().for_each(|&i| state.crust.thickness[i] += 10.0);
    let target = f64::from(law.elevation(law.thickness(0.5) + 10.0));
    let (mut app, planet) = spawn(state);
    steps(&mut app, planet, 4);
    let expected = target + (0.5 - target) * (-8.0_f64 / recipe.params.isostasy_time).exp();
    for &i in &land {
        let z = f64::from(get::<Crust>(&app, planet).elevation[i]);
        assert!((z - expected).abs() < 1e-3, "{z} for {expected}");
    }
}

#[test]
fn noise_is_coherent_and_leaves_the_ocean_alone() {
    let (mut app, planet) = planet_app(&only(small(2, 6000), "noise"));
    params(&mut app, planet).isostasy_time = 200.0;
    let before = get::<Crust>(&app, planet).clone();
    steps(&mut app, planet, 20);
    let after = get::<Crust>(&app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let change = |i: usize| after.elevation[i] - before.elevation[i];
    let [mut own, mut step, mut n] = [0.0; 3];
    for i in 0..before.len() {
        if !before.is_continental(i) {
            assert_eq!(change(i), 0.0);
            continue;
        }
        assert!(change(i).abs() < 1.0);
        let neighbours = mesh.ring(i as u32).iter().map(|&j| j as usize);
        for j in neighbours.filter(|&j| before.is_continental(j)) {
            own += f64::from(change(i).abs());
            step += f64::from((change(i) - change(j)).abs());
            n += 1.0;
        }
    }
    assert!(own / n > 0.02, "{} km", own / n);
    assert!(step < 0.6 * own, "neighbours change alike: {step} of {own}");
}
