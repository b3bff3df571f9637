//! Climate on whole planets: the belts that every atlas of the Earth shows, and that a planet's radius does
//! not matter.

use bevy_pangaea::climate::{Climate, ClimateMaps};
use bevy_pangaea::hydrology::{BaseMesh, Terrain, TerrainMaps, Transfer};
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

/// Places and their rain in mm per year: most of the dry ones, least of the wet ones. Köppen asks
/// 60 mm of every month of a rain forest.
const DESERTS: [(&str, (f64, f64)); 3] = [
    ("Sahara", (23.0, 10.0)),
    ("Arabia", (22.0, 50.0)),
    ("Gobi", (42.0, 105.0)),
];
const DESERT_RAIN: f64 = 300.0;
const RAIN_FORESTS: [(&str, (f64, f64)); 3] = [
    ("Amazon", (-3.0, -60.0)),
    ("Congo", (0.0, 22.0)),
    ("Borneo", (1.0, 114.0)),
];
const FOREST_RAIN: f64 = 720.0;

#[test]
fn the_earth_has_its_deserts_and_its_rain_forests() {
    let Some(crust) = earth() else { return };
    let base = BaseMesh::new(1, 0.012).expect("a base mesh");
    let maps = TerrainMaps {
        crust,
        age: None,
        plateau: None,
        hills: None,
    };
    let elevation = Terrain::from_maps(&base, &maps).elevation_km();
    let climate = Climate::new(&base.mesh, &base.winds, &elevation, &ClimateMaps::default());
    let rain = |place| around(&base, &climate.rain, place, 3.0);
    for (name, place) in RAIN_FORESTS {
        assert!(rain(place) > FOREST_RAIN, "{name}: {} mm", rain(place));
    }
    for (name, place) in DESERTS {
        assert!(rain(place) < DESERT_RAIN, "{name}: {} mm", rain(place));
    }
    // Both sides of the Himalaya and Tibet.
    assert!(rain((27.5, 88.0)) > 2.0 * rain((39.0, 85.0)));
    let temperature = |place| around(&base, &climate.temperature, place, 3.0);
    assert!(temperature((0.0, 22.0)) > 20.0 && temperature((33.0, 88.0)) < 5.0);
    // 715 mm on Earth.
    let mean = mean_on_land(&climate.rain, &elevation);
    assert!((450.0..950.0).contains(&mean), "{mean} mm on land");
}

/// Mean of a column over the vertices above the sea.
fn mean_on_land(column: &[f32], elevation: &[f32]) -> f64 {
    let pairs = column.iter().zip(elevation);
    let land: Vec<f64> = pairs
        .filter(|(_, z)| **z > 0.0)
        .map(|(&x, _)| f64::from(x))
        .collect();
    land.iter().sum::<f64>() / land.len() as f64
}

/// Mean rain in mm between two latitudes in degrees, north and south.
fn belt(base: &BaseMesh, climate: &Climate, latitudes: core::ops::Range<f64>) -> f64 {
    let points = base.mesh.points().iter().zip(&climate.rain);
    let inside = points.filter(|(p, _)| latitudes.contains(&p.z.asin().to_degrees().abs()));
    let rain: Vec<f64> = inside.map(|(_, &rain)| f64::from(rain)).collect();
    rain.iter().sum::<f64>() / rain.len() as f64
}

#[test]
fn a_grown_planet_has_dry_belts_and_wet_ones() {
    let (mut app, planet) = planet_app(&small(3, 10_000));
    steps(&mut app, planet, 30);
    let surface = surface(&mut app, planet);
    let base = BaseMesh::new(3, 0.02).expect("a base mesh");
    let transfer = Transfer::new(&get::<Lattice>(&app, planet).0, &base.mesh);
    let elevation = Terrain::from_surface(&base, &transfer, &surface).elevation_km();
    let climate = Climate::new(&base.mesh, &base.winds, &elevation, &ClimateMaps::default());
    let [tropics, deserts] = [0.0..8.0, 18.0..28.0].map(|belt| self::belt(&base, &climate, belt));
    let [westerlies, poles] =
        [40.0..55.0, 80.0..90.0].map(|belt| self::belt(&base, &climate, belt));
    assert!(tropics > 1.8 * deserts && westerlies > 1.1 * deserts);
    assert!(poles < westerlies);
}
