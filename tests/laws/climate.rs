//! Climate on whole planets: what every atlas of the Earth shows, and that a planet's radius does
//! not matter.

use bevy_pangaea::climate::{Climate, ClimateMaps};
use bevy_pangaea::hydrology::{BaseMesh, Terrain, TerrainMaps};
use bevy_pangaea::math::{angle_between, direction};
use bevy_pangaea::prelude::*;
use pangaea_tests::earth::earth;
use pangaea_tests::shape::small;
use pangaea_tests::world::{get, planet_app, steps, surface};

/// Mean of a column within `radius` degrees around a place.
fn around(base: &BaseMesh, column: &[f32], (lat, lon): (f64, f64), radius: f64) -> f64 {
    let centre = direction(lat, lon);
    let (mut sum, mut count) = (0.0, 0.0);
    for (p, &value) in base.mesh.points().iter().zip(column) {
        if angle_between(*p, centre).to_degrees() < radius {
            (sum, count) = (sum + f64::from(value), count + 1.0);
        }
    }
    assert!(count > 0.0);
    sum / count
}

#[test]
fn the_earth_has_its_deserts_and_its_rain_forests() {
    let Some(crust) = earth() else { return };
    let base = BaseMesh::new(1, 0.012).expect("a base mesh");
    let terrain = Terrain::from_maps(
        &base,
        &TerrainMaps {
            crust,
            age: None,
            plateau: None,
            hills: None,
        },
    );
    let elevation = terrain.elevation_km();
    let climate = Climate::new(&base.mesh, &base.winds, &elevation, &ClimateMaps::default());
    let rain = |place| around(&base, &climate.rain, place, 3.0);
    // Köppen asks 60 mm of every month of a rain forest.
    for (name, place) in [
        ("Amazon", (-3.0, -60.0)),
        ("Congo", (0.0, 22.0)),
        ("Borneo", (1.0, 114.0)),
    ] {
        assert!(rain(place) > 720.0, "{name}: {} mm", rain(place));
    }
    for (name, place) in [
        ("Sahara", (23.0, 10.0)),
        ("Arabia", (22.0, 50.0)),
        ("Gobi", (42.0, 105.0)),
    ] {
        assert!(rain(place) < 300.0, "{name}: {} mm", rain(place));
    }
    // Both sides of the Himalaya and Tibet.
    assert!(rain((27.5, 88.0)) > 2.0 * rain((39.0, 85.0)));
    let temperature = |place| around(&base, &climate.temperature, place, 3.0);
    assert!(temperature((0.0, 22.0)) > 20.0 && temperature((33.0, 88.0)) < 5.0);
    let land: Vec<usize> = (0..elevation.len())
        .filter(|&i| elevation[i] > 0.0)
        .collect();
    let mean = land
        .iter()
        .map(|&i| f64::from(climate.rain[i]))
        .sum::<f64>()
        / land.len() as f64;
    // 715 mm on Earth.
    assert!((450.0..950.0).contains(&mean), "{mean} mm on land");
}

#[test]
fn a_grown_planet_has_dry_belts_and_wet_ones() {
    let (mut app, planet) = planet_app(&small(3, 10_000));
    steps(&mut app, planet, 30);
    let surface = surface(&mut app, planet);
    let base = BaseMesh::new(3, 0.02).expect("a base mesh");
    let transfer =
        bevy_pangaea::hydrology::Transfer::new(&get::<Lattice>(&app, planet).0, &base.mesh);
    let terrain = Terrain::from_surface(&base, &transfer, &surface);
    let climate = Climate::new(
        &base.mesh,
        &base.winds,
        &terrain.elevation_km(),
        &ClimateMaps::default(),
    );
    let belt = |low: f64, high: f64| {
        let inside = |i: &usize| {
            let lat = base.mesh.points()[*i].z.asin().to_degrees().abs();
            lat >= low && lat < high
        };
        let places: Vec<usize> = (0..base.mesh.len()).filter(inside).collect();
        places
            .iter()
            .map(|&i| f64::from(climate.rain[i]))
            .sum::<f64>()
            / places.len() as f64
    };
    assert!(belt(0.0, 8.0) > 1.8 * belt(18.0, 28.0) && belt(40.0, 55.0) > 1.1 * belt(18.0, 28.0));
    assert!(belt(80.0, 90.0) < belt(40.0, 55.0));
}
