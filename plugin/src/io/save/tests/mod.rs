//! Tests of the save file on a small planet with every kind of state.

mod climate;
mod damage;
mod format;
mod round_trip;
mod terrain;

use super::*;
use crate::authoring::{Brush, PaintTarget, Recording, Scenario, TectonicCommand, TimedCommand};
use crate::climate::EquirectMap;
use crate::crust::{Cause, Crust, CrustKind, Frame, Frames, Ledger, Orogeny};
use crate::hydrology::TerrainMaps;
use crate::math;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet, PlateNumbers};
use crate::plate::front::FrontField;
use crate::plate::polarity::{FrontSegment, PolarityMemory};
use crate::plate::{PlateId, PlateMotion, PlateStats};
use crate::sphere::SphereMesh;
use bevy::math::{DVec3, Vec3};
use std::sync::Arc;

/// A planet of 150 samples in which no part of the state is empty.
fn state() -> PlanetState {
    let mesh = Arc::new(SphereMesh::fibonacci(150).unwrap());
    let params = params();
    PlanetState {
        planet: Planet {
            radius: 6370.0,
            seed: 42,
        },
        crust: crust(&mesh, &params),
        frames: frames(),
        plates: plates(),
        stats: vec![stats(0.25), stats(0.5)],
        clock: GeologicClock {
            time: 20.0,
            step: 10,
            resample_requested: true,
            ..GeologicClock::default()
        },
        numbers: PlateNumbers { next: 2 },
        params,
        ledger: ledger(),
        recording: Recording(vec![painting_at(4)]),
        pending: Scenario(vec![painting_at(40)]),
        polarity: polarity(),
        fronts: fronts(&mesh),
        climate: maps(),
        terrain: Some(terrain()),
        lattice: Lattice(mesh),
    }
}

fn params() -> TectonicParams {
    let mut params = TectonicParams {
        erosion: 0.07,
        ..TectonicParams::default()
    };
    params.processes.noise = false;
    params
}

/// Columns of which no two are equal.
fn crust(mesh: &SphereMesh, params: &TectonicParams) -> Crust {
    let mut crust = Crust::ocean(mesh.len(), params);
    for i in 0..mesh.len() {
        let x = i as f32;
        crust.frame[i] = (i % 3) as u16;
        crust.kind[i] = [CrustKind::Continental, CrustKind::Oceanic][(i % 4).min(1)];
        crust.orogeny[i] = [Orogeny::None, Orogeny::Andean, Orogeny::Himalayan][i % 3];
        crust.thickness[i] = 7.0 + 0.1 * x;
        crust.elevation[i] = -6.0 + 0.013 * x;
        crust.ocean_age[i] = x;
        crust.orogeny_age[i] = 2.0 * x;
        crust.ridge[i] = mesh.point(i as u32).as_vec3();
        crust.fold[i] = -crust.ridge[i];
    }
    crust
}

/// Two plates, and a terrane on the second.
fn frames() -> Frames {
    let moved = Frame {
        rotation: math::rotation(DVec3::Y, 0.3),
        ..Frame::at_rest(PlateId(1))
    };
    let terrane = Frame {
        terrane: true,
        ..moved
    };
    Frames(vec![Frame::at_rest(PlateId(0)), moved, terrane])
}

fn plates() -> Vec<(PlateId, PlateMotion, f64)> {
    let motion = PlateMotion {
        axis: DVec3::X,
        speed: 0.01,
    };
    vec![
        (PlateId(0), PlateMotion::REST, 0.0),
        (PlateId(1), motion, 12.0),
    ]
}

fn stats(continental: f64) -> PlateStats {
    PlateStats {
        samples: 75,
        area: 2.5e8,
        continental,
        ocean_age: 60.0,
        centroid: DVec3::Y,
    }
}

fn ledger() -> Ledger {
    let mut ledger = Ledger::default();
    ledger.book(Cause::ArcGrowth, 1.25e5, 3.5e6);
    ledger
}

fn painting_at(step: u64) -> TimedCommand {
    let command = TectonicCommand::PaintCrust {
        target: PaintTarget::Disc {
            center: (10.5, -20.25),
            radius: 900.0,
        },
        brush: Brush::Raise(0.1),
    };
    TimedCommand { step, command }
}

fn polarity() -> PolarityMemory {
    PolarityMemory(vec![FrontSegment {
        pair: (PlateId(0), PlateId(1)),
        bin: 17,
        first_under: true,
        held: 7,
    }])
}

/// Two samples of front, and one sample that is near the first.
fn fronts(mesh: &SphereMesh) -> FrontField {
    let fronts = FrontField {
        reach: 0.25,
        front: vec![(3, 0), (7, 2)],
        ..FrontField::new(150)
    };
    let chord2 = mesh.point(70).distance_squared(mesh.point(3));
    fronts.nearest.set(70, 3, chord2 as f32);
    fronts
}

/// Maps of two fields.
fn maps() -> ClimateMaps {
    ClimateMaps {
        temperature: EquirectMap::from_fn(4, |lat, _| 30.0 - lat.abs() as f32).ok(),
        rain: EquirectMap::from_fn(3, |lat, lon| (500.1 + lat + 0.1 * lon) as f32).ok(),
        wetness: None,
    }
}

/// Maps of a planet that was not grown: an age, and no plateaus.
fn terrain() -> TerrainMaps {
    TerrainMaps {
        crust: EquirectMap::from_fn(5, |lat, lon| (0.01 * lat + 0.001 * lon) as f32).unwrap(),
        age: uniform(30.5),
        plateau: None,
        hills: EquirectMap::from_fn(3, |lat, _| if lat > 0.0 { 0.5 } else { f32::NAN }).ok(),
    }
}

/// A map of one value.
fn uniform(value: f32) -> Option<EquirectMap> {
    EquirectMap::from_fn(2, |_, _| value).ok()
}

fn bytes(state: &PlanetState) -> Vec<u8> {
    let mut out = Vec::new();
    write_to(state, &mut out).unwrap();
    out
}

/// Why these bytes are refused.
fn refusal(bytes: &[u8]) -> SaveError {
    read_from(bytes).err().unwrap()
}
