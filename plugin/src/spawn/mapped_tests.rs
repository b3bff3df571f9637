use super::*;
use crate::PangaeaPlugins;
use crate::climate::{EquirectMap, MapError};
use crate::control::{PlanetBake, bake_now};
use crate::crust::{CrustKind, PlanetSurface};
use crate::hydrology::{NO_VERTEX, ShoreClass};
use crate::io::capture;
use crate::math::direction;
use crate::schedule::run_steps;
use bevy::prelude::*;

const EARTH: Planet = Planet {
    radius: 6370.0,
    seed: 3,
};

/// Land 1 km high between 30° S and 30° N in the west, sea 4 km deep elsewhere.
fn island(lat: f64, lon: f64) -> f32 {
    if lat.abs() < 30.0 && lon < 0.0 {
        1.0
    } else {
        -4.0
    }
}

fn maps(value: impl Fn(f64, f64) -> f32) -> TerrainMaps {
    TerrainMaps {
        crust: EquirectMap::from_fn(90, value).unwrap(),
        age: None,
        plateau: None,
        hills: None,
    }
}

#[test]
fn the_crust_is_that_of_the_map() {
    let state = PlanetState::from_maps(EARTH, maps(island)).unwrap();
    let at = |lat, lon| state.lattice.0.nearest(direction(lat, lon)) as usize;
    let (land, sea) = (at(10.0, -90.0), at(10.0, 90.0));
    assert_eq!(state.crust.elevation[land], 1.0);
    assert_eq!(state.crust.elevation[sea], -4.0);
    assert_eq!(state.crust.kind[land], CrustKind::Continental);
    assert_eq!(state.crust.kind[sea], CrustKind::Oceanic);
    // Half of the belt between 30° S and 30° N, whose share of the sphere is sin 30°.
    let high = state.crust.elevation.iter().filter(|&&km| km > 0.0).count();
    let share = high as f64 / state.crust.len() as f64;
    assert!((share - 0.25).abs() < 0.01, "{share}");
}

#[test]
fn nothing_happens_on_a_planet_of_maps() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let state = PlanetState::from_maps(EARTH, maps(island)).unwrap();
    let before = state.crust.clone();
    let planet = state.spawn(app.world_mut());
    run_steps(app.world_mut(), planet, 3);
    let after = capture(app.world(), planet).unwrap();
    // To a millimetre: a resample interpolates, and sums of weights are rounded.
    for (now, then) in after.crust.elevation.iter().zip(&before.elevation) {
        assert!((now - then).abs() < 1e-6, "{now} {then}");
    }
    assert_eq!(after.crust.kind, before.kind);
    assert_eq!((after.plates.len(), after.terrain.is_some()), (1, true));
}

#[test]
fn rivers_follow_the_maps_and_not_the_surface() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let state = PlanetState::from_maps(EARTH, maps(|_, _| -4.0)).unwrap();
    let planet = state.spawn(app.world_mut());
    // The surface is all sea; other maps are given to the planet.
    app.world_mut().entity_mut(planet).insert(maps(island));
    bake_now(app.world_mut(), planet).unwrap();
    let bake = app.world().get::<PlanetBake>(planet).unwrap();
    let at = bake.mesh().nearest(direction(10.0, -90.0)) as usize;
    assert!(bake.terrain.elevation_km()[at] > 0.5);
    let surface = app.world().get::<PlanetSurface>(planet).unwrap();
    assert_eq!(bake.version, surface.version);
}

/// A dome that falls from 2 km in the middle of the west to the sea, and to its floor.
fn dome(lat: f64, lon: f64) -> f32 {
    let away = (lat * lat + (lon + 90.0) * (lon + 90.0)).sqrt();
    (2.0 - 0.06 * away).max(-4.0) as f32
}

#[test]
fn rivers_run_from_the_mountain_to_the_sea() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let state = PlanetState::from_maps(EARTH, maps(dome)).unwrap();
    let planet = state.spawn(app.world_mut());
    bake_now(app.world_mut(), planet).unwrap();
    let bake = app.world().get::<PlanetBake>(planet).unwrap();
    let drainage = &bake.drainage;
    let mut at = bake.mesh().nearest(direction(0.0, -90.0));
    let mut steps = 0;
    while drainage.routes.receiver[at as usize] != NO_VERTEX {
        at = drainage.routes.receiver[at as usize];
        steps += 1;
        assert!(steps < bake.mesh().len(), "the river has no end");
    }
    assert_ne!(drainage.shore[at as usize], ShoreClass::Land);
    // 30 degrees are 3300 km; edges are about 50.
    assert!(steps > 40, "{steps} edges to the sea");
}

#[test]
fn another_planet_on_the_entity_has_no_maps() {
    let mut app = App::new();
    app.add_plugins(PangaeaPlugins);
    let mapped = PlanetState::from_maps(EARTH, maps(island)).unwrap();
    let planet = mapped.spawn(app.world_mut());
    let recipe = PlanetRecipe {
        samples: 500,
        plate_count: 6,
        ..default()
    };
    let grown = PlanetState::new(&recipe).unwrap();
    grown.insert(app.world_mut(), planet);
    assert!(app.world().get::<TerrainMaps>(planet).is_none());
}

#[test]
fn values_that_no_planet_has_are_refused() {
    let radius = Planet {
        radius: f64::NAN,
        ..EARTH
    };
    let refused = |planet, maps| PlanetState::from_maps(planet, maps).err().unwrap();
    assert!(matches!(
        refused(radius, maps(island)),
        BakeError::Radius(_)
    ));
    let metres = refused(EARTH, maps(|lat, _| 40.0 * lat as f32));
    assert!(matches!(metres, BakeError::Map(MapError::Range { .. })));
    let holes = refused(EARTH, maps(|lat, _| if lat > 0.0 { 1.0 } else { f32::NAN }));
    assert!(matches!(holes, BakeError::Map(MapError::Void { .. })));
}
