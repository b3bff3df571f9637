//! A planet without a simulation, from maps alone: its climate, its rivers, and the ground under
//! one's feet.
//!
//! `cargo run --example maps --no-default-features -- [CRUST.tif]`
//!
//! The file is an equirectangular map of the elevation in km, as GeoTIFF, or as grey PNG, black -11
//! km, white 9 km. Without one the map is made up: a continent with a mountain range, and islands.

use bevy_pangaea::climate::{ClimateMaps, EquirectMap, MapError};
use bevy_pangaea::control::{Bake, BakeFrame, BakeRules, BakeSource};
use bevy_pangaea::hydrology::{BASE_SPACING, TerrainMaps};
use bevy_pangaea::io::load_map;
use bevy_pangaea::query::{Ground, PlanetGround, Rules, direction_at};
use std::path::Path;
use std::sync::Arc;

/// Radius of the planet in km.
const RADIUS_KM: f64 = 6370.0;

/// Latitudes and longitudes in degrees of the places that are looked at.
const PLACES: [(f64, f64); 5] = [
    (15.0, -22.0),
    (10.0, 0.0),
    (10.0, 25.0),
    (-35.0, 130.0),
    (0.0, 180.0),
];

/// A hill of the made-up planet.
struct Hill {
    /// Latitude and longitude of its top in degrees.
    top: (f64, f64),
    /// Height above the floor in km.
    height: f64,
    /// Half width to the north and to the east in degrees.
    width: (f64, f64),
}

impl Hill {
    fn at(&self, lat: f64, lon: f64) -> f64 {
        let y = (lat - self.top.0) / self.width.0;
        let x = (lon - self.top.1) / self.width.1;
        self.height / (1.0 + (x * x + y * y) * (x * x + y * y))
    }
}

const CONTINENT: Hill = Hill {
    top: (10.0, 0.0),
    height: 5.0,
    width: (45.0, 50.0),
};

const ISLAND: Hill = Hill {
    top: (-35.0, 130.0),
    height: 4.6,
    width: (9.0, 22.0),
};

const MOUNTAINS: Hill = Hill {
    top: (15.0, -22.0),
    height: 3.5,
    width: (30.0, 7.0),
};

/// Depth of the floor in km.
const FLOOR_KM: f64 = 4.4;

/// Elevation in km of the made-up planet.
fn crust(lat: f64, lon: f64) -> f32 {
    let land = CONTINENT.at(lat, lon) + ISLAND.at(lat, lon);
    (land + MOUNTAINS.at(lat, lon) - FLOOR_KM) as f32
}

/// Young mountains everywhere (A). Where plateaus and hills are (P, B) follows from the elevation.
fn terrain(crust: EquirectMap) -> Result<TerrainMaps, MapError> {
    Ok(TerrainMaps {
        crust,
        age: Some(EquirectMap::from_fn(1, |_, _| 20.0)?),
        plateau: None,
        hills: None,
    })
}

/// Rain forests along the equator (W). Temperature and rain are the model's own.
fn climate() -> Result<ClimateMaps, MapError> {
    let wetness = EquirectMap::from_fn(90, |lat, _| (1.0 - lat.abs() / 60.0).max(0.1) as f32)?;
    Ok(ClimateMaps {
        wetness: Some(wetness),
        ..ClimateMaps::default()
    })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let crust = match std::env::args().nth(1) {
        Some(file) => load_map(Path::new(&file), Some([-11.0, 9.0]))?,
        None => EquirectMap::from_fn(512, crust)?,
    };
    let terrain = terrain(crust)?;
    let (climate, rules) = (climate()?, BakeRules::default());
    let frame = Arc::new(BakeFrame::new(7, BASE_SPACING, None)?);
    let source = BakeSource::Maps(&terrain);
    let bake = Bake::new(&frame, RADIUS_KM, &source, &climate, &rules)?;
    let vertices = bake.mesh().len();
    let greatest = (0..vertices)
        .map(|i| bake.drainage.discharge_m3s(i))
        .fold(0.0, f64::max);
    println!("{vertices} vertices, the greatest river {greatest:.0} m³/s");

    let ground = PlanetGround::of_bake(&bake, Rules::default())?;
    for (lat, lon) in PLACES {
        let here = ground.sample(direction_at(lat, lon)?, 17)?;
        let surface = here.surface.name();
        println!(
            "{lat:6.1}° N {lon:6.1}° E {:9.2} m  {surface}",
            here.height_m
        );
    }
    Ok(())
}
