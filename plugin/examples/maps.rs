//! A planet without a simulation, from maps alone: its climate, its rivers, and the ground under
//! one's feet.
//!
//! `cargo run --example maps --no-default-features -- [CRUST.tif]`
//!
//! The file is an equirectangular map of the elevation in km, as GeoTIFF, or as grey PNG, black -11
//! km, white 9 km. Without one the map is made up: a continent with a mountain range, and islands.

use bevy_pangaea::climate::{ClimateMaps, EquirectMap};
use bevy_pangaea::control::{Bake, BakeFrame, BakeRules, BakeSource};
use bevy_pangaea::hydrology::TerrainMaps;
use bevy_pangaea::hydrology::base::SPACING;
use bevy_pangaea::hydrology::flow::per_second;
use bevy_pangaea::io::load_map;
use bevy_pangaea::query::{PlanetGround, Rules, direction_at, samples};
use std::path::Path;
use std::sync::Arc;

/// Radius of the planet in km.
const RADIUS: f64 = 6370.0;

/// Elevation in km of a made-up planet.
fn crust(lat: f64, lon: f64) -> f32 {
    let hill = |at: (f64, f64), height: f64, width: (f64, f64)| {
        let (y, x) = ((lat - at.0) / width.0, (lon - at.1) / width.1);
        height / (1.0 + (x * x + y * y) * (x * x + y * y))
    };
    let land = hill((10.0, 0.0), 5.0, (45.0, 50.0)) + hill((-35.0, 130.0), 4.6, (9.0, 22.0));
    (land + hill((15.0, -22.0), 3.5, (30.0, 7.0)) - 4.4) as f32
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let crust = match std::env::args().nth(1) {
        Some(file) => load_map(Path::new(&file), Some([-11.0, 9.0]))?,
        None => EquirectMap::from_fn(512, crust)?,
    };
    // A: young mountains everywhere. P and B, where plateaus and hills are, follow from the
    // elevation.
    let age = EquirectMap::from_fn(1, |_, _| 20.0)?;
    let terrain = TerrainMaps {
        crust,
        age: Some(age),
        plateau: None,
        hills: None,
    };
    // Wetness W is a map, too: rain forests along the equator. Temperature and rain are the model's
    // own.
    let wetness = EquirectMap::from_fn(90, |lat, _| (1.0 - lat.abs() / 60.0).max(0.1) as f32)?;
    let climate = ClimateMaps {
        wetness: Some(wetness),
        ..ClimateMaps::default()
    };

    let frame = Arc::new(BakeFrame::new(7, SPACING, None)?);
    let rules = BakeRules {
        climate,
        ..BakeRules::default()
    };
    let bake = Bake::new(&frame, RADIUS, &BakeSource::Maps(&terrain), &rules)?;
    let greatest = bake.drainage.discharge.iter().copied().max().unwrap_or(0);
    println!(
        "{} vertices, the greatest river {:.0} m³/s",
        bake.mesh().len(),
        per_second(greatest)
    );

    let ground = PlanetGround::of_bake(&bake, Rules::default())?;
    let places = [
        (15.0, -22.0),
        (10.0, 0.0),
        (10.0, 25.0),
        (-35.0, 130.0),
        (0.0, 180.0),
    ];
    let directions: Vec<_> = places
        .into_iter()
        .map(|(lat, lon)| direction_at(lat, lon))
        .collect::<Result<_, _>>()?;
    for ((lat, lon), here) in places.into_iter().zip(samples(&ground, &directions, 17)?) {
        println!(
            "{lat:6.1}° N {lon:6.1}° E {:9.2} m  {}",
            here.height_m,
            here.surface.name()
        );
    }
    Ok(())
}
