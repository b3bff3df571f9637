//! Small islands are not silently swallowed: crust that is forced down or scraped off is booked.

use bevy_pangaea::crust::Cause;
use bevy_pangaea::math::lat_lon;
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::measure::continents;
use pangaea_tests::shape::{Floor, hemispheres, shaped};
use pangaea_tests::world::{get, heard, listen, spawn, steps};

/// Longitudes of an island on the equator, 10 degrees high.
type Longitudes = core::ops::Range<f64>;

fn is_island(lat: f64, lon: f64, island: &Longitudes) -> bool {
    lat.abs() < 5.0 && island.contains(&lon)
}

/// A planet whose western plate carries an island towards the mainland of the eastern one; terranes
/// below `least_area` km² do not break off.
fn approaching(island: &Longitudes, least_area: f64) -> PlanetState {
    let mut recipe = hemispheres(20_000, 100.0, 0.0);
    recipe.params.terrane_min_area = least_area;
    shaped(&recipe, |plate, lat, lon| {
        let mainland = plate == 1 && lat.abs() < 40.0 && lon < 50.0;
        if mainland || is_island(lat, lon, island) {
            Floor::Land(0.3)
        } else {
            Floor::Ocean(60.0)
        }
    })
}

/// Area of the island's samples in km².
fn area(state: &PlanetState, island: &Longitudes) -> f64 {
    let mut sum = 0.0;
    for (&p, area) in state.lattice.points().iter().zip(state.lattice.areas()) {
        let (lat, lon) = lat_lon(p);
        if is_island(lat, lon, island) {
            sum += area * 6370.0 * 6370.0;
        }
    }
    sum
}

#[test]
fn an_island_below_the_least_area_is_forced_down_and_booked() {
    let island = -15.0..-5.0;
    let state = approaching(&island, 5e6);
    let whole = area(&state, &island);
    let (mut app, planet) = spawn(state);
    listen::<TerraneCollided>(&mut app);
    steps(&mut app, planet, 20);
    let collisions = heard::<TerraneCollided>(&app);
    assert!(collisions.is_empty(), "too small to break off");
    let ledger = get::<Ledger>(&app, planet);
    let lost = -ledger.of(Cause::ForcedSubduction).area - ledger.of(Cause::Stacking).area;
    assert!(
        (lost / whole - 1.0).abs() < 0.1,
        "{lost:e} km² booked of {whole:e}"
    );
    let (area, volume) = continents(get(&app, planet), get::<Lattice>(&app, planet), 6370.0);
    let expected = ledger.expected();
    assert!((area / expected.area - 1.0).abs() < 1e-3);
    let error = (volume / expected.volume - 1.0).abs();
    assert!(error < 1e-6, "its rock thickens the crust above");
}

#[test]
fn an_island_above_the_least_area_is_sutured() {
    let (mut app, planet) = spawn(approaching(&(-13.0..-3.0), 5e5));
    listen::<TerraneCollided>(&mut app);
    steps(&mut app, planet, 9);
    let events = heard::<TerraneCollided>(&app);
    assert_eq!(events.len(), 1);
    // 10 x 10 degrees on the equator.
    let area = events[0].area;
    assert!((area / 1.235e6 - 1.0).abs() < 0.15, "{area:e}");
}
