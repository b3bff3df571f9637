//! Small islands are not silently swallowed: what is forced down or scraped off is booked.

use bevy_pangaea::crust::Cause;
use bevy_pangaea::prelude::*;
use pangaea_tests::measure::continents;
use pangaea_tests::shape::{Floor, hemispheres, shaped};
use pangaea_tests::world::{get, heard, listen, spawn, steps};

#[test]
fn an_island_below_the_least_area_is_forced_down_and_booked() {
    let mut recipe = hemispheres(20_000, 100.0, 0.0);
    recipe.params.terrane_min_area = 5e6;
    let island = |lat: f64, lon: f64| lat.abs() < 5.0 && (-15.0..-5.0).contains(&lon);
    let state = shaped(&recipe, |plate, lat, lon| {
        let mainland = plate == 1 && lat.abs() < 40.0 && lon < 50.0;
        if mainland || island(lat, lon) {
            Floor::Land(0.3)
        } else {
            Floor::Ocean(60.0)
        }
    });
    let island_area: f64 = (0..state.crust.len())
        .filter(|&i| {
            let (lat, lon) = bevy_pangaea::math::lat_lon(state.lattice.0.points()[i]);
            island(lat, lon)
        })
        .map(|i| state.lattice.0.area(i as u32) * 6370.0 * 6370.0)
        .sum();
    let (mut app, planet) = spawn(state);
    listen::<TerraneCollided>(&mut app);
    steps(&mut app, planet, 20);
    assert!(
        heard::<TerraneCollided>(&app).is_empty(),
        "too small to break off"
    );
    let ledger = get::<Ledger>(&app, planet);
    let lost = -ledger.of(Cause::ForcedSubduction).area - ledger.of(Cause::Stacking).area;
    assert!(
        (lost / island_area - 1.0).abs() < 0.1,
        "{lost:e} km² booked of {island_area:e}"
    );
    let (area, volume) = continents(get(&app, planet), get::<Lattice>(&app, planet), 6370.0);
    let expected = ledger.expected();
    assert!((area / expected.area - 1.0).abs() < 1e-3);
    assert!(
        (volume / expected.volume - 1.0).abs() < 1e-6,
        "its rock thickens what lies above"
    );
}

#[test]
fn an_island_above_the_least_area_is_sutured() {
    let mut recipe = hemispheres(20_000, 100.0, 0.0);
    recipe.params.terrane_min_area = 5e5;
    let state = shaped(&recipe, |plate, lat, lon| {
        let mainland = plate == 1 && lat.abs() < 40.0 && lon < 50.0;
        let island = lat.abs() < 5.0 && (-13.0..-3.0).contains(&lon);
        if mainland || island {
            Floor::Land(0.3)
        } else {
            Floor::Ocean(60.0)
        }
    });
    let (mut app, planet) = spawn(state);
    listen::<TerraneCollided>(&mut app);
    steps(&mut app, planet, 9);
    let events = heard::<TerraneCollided>(&app);
    assert_eq!(events.len(), 1);
    // 10 x 10 degrees on the equator.
    assert!(
        (events[0].area / 1.235e6 - 1.0).abs() < 0.15,
        "{:e}",
        events[0].area
    );
}
