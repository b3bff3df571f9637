//! The ground part of `pangaea bench`: how long climate, rivers and the amplified ground take.

use crate::error::CliError;
use crate::headless::Headless;
use bevy::math::DVec3;
use bevy_pangaea::climate::Climate;
use bevy_pangaea::control::{Bake, BakeFrame, BakeRules, BakeSource};
use bevy_pangaea::crust::PlanetSurface;
use bevy_pangaea::hydrology::BASE_SPACING;
use bevy_pangaea::hydrology::{BaseMesh, Drainage, RiverNetwork};
use bevy_pangaea::planet::{Lattice, Planet};
use bevy_pangaea::query::{Ground, GroundError, PlanetGround, Rules};
use bevy_pangaea::random::{Purpose, Stream};
use std::fmt::Write;
use std::sync::Arc;
use std::time::Instant;

/// The finest level.
const FINEST: u8 = bevy_pangaea::query::LEVELS;
/// Fresh points asked for.
const POINTS: u64 = 1000;
/// Places, and questions around each.
const WALKS: (u64, u64) = (20, 200);
/// How far from a place its questions are, in m.
const NEAR_M: f64 = 100.0;
/// Side of a collider in m.
const COLLIDER_M: f64 = 64.0;

/// What was measured.
#[derive(serde::Serialize)]
pub(super) struct GroundRow {
    /// Vertices of the base mesh.
    vertices: usize,
    /// Points, triangles and winds of the base mesh, once per seed, ms.
    base_mesh_ms: f64,
    /// Climate, ms.
    climate_ms: f64,
    /// Coasts, drainage, rivers and lakes, ms.
    drainage_ms: f64,
    /// All that follows a running simulation, ms.
    bake_ms: f64,
    /// A height of the finest level at a fresh random point, one thread, µs.
    fresh_us: f64,
    /// The same within 100 m of the last, median over places, µs.
    near_us: f64,
    /// A collider of 64 m at the finest level by an engine that knows nothing, median, ms.
    collider_ms: f64,
}

/// Measures the ground of a planet; nothing if there is none for a planet of its radius.
pub(super) fn measure(headless: &Headless) -> Result<Option<GroundRow>, CliError> {
    let (lattice, surface) = (headless.get::<Lattice>()?, headless.get::<PlanetSurface>()?);
    let planet = headless.get::<Planet>()?;
    let start = Instant::now();
    let base = BaseMesh::new(planet.seed, BASE_SPACING).map_err(CliError::input)?;
    let base_mesh_ms = milliseconds(start);
    let frame = Arc::new(BakeFrame::with_base(base, BASE_SPACING, Some(lattice)));
    let base = &frame.base;
    let rules = BakeRules::default();
    let start = Instant::now();
    let bake = Bake::new(&frame, planet.radius, &BakeSource::Surface(surface), &rules)
        .map_err(CliError::input)?;
    let bake_ms = milliseconds(start);
    let start = Instant::now();
    let climate = Climate::new(
        &base.mesh,
        &base.winds,
        &bake.terrain.elevation_km(),
        &rules.climate,
    );
    let climate_ms = milliseconds(start);
    let start = Instant::now();
    Drainage::new(
        base,
        planet.radius,
        &bake.terrain,
        &climate,
        RiverNetwork::default(),
    );
    let drainage_ms = milliseconds(start);
    let Ok(ground) = PlanetGround::of_bake(&bake, Rules::default()) else {
        return Ok(None);
    };
    let vertices = bake.control.vertices.len();
    let fresh_us = fresh(&ground)?;
    let near_us = near(&ground)?;
    let collider_ms = collider(&ground)?;
    Ok(Some(GroundRow {
        vertices,
        base_mesh_ms,
        climate_ms,
        drainage_ms,
        bake_ms,
        fresh_us,
        near_us,
        collider_ms,
    }))
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

fn place(k: u64) -> DVec3 {
    Stream::new(1, Purpose::ReliefSites, 0).direction(2 * k)
}

fn fresh(ground: &PlanetGround) -> Result<f64, GroundError> {
    let start = Instant::now();
    for k in 0..POINTS {
        ground.height(place(k), FINEST)?;
    }
    Ok(milliseconds(start) * 1e3 / POINTS as f64)
}

fn near(ground: &PlanetGround) -> Result<f64, GroundError> {
    let (places, questions) = WALKS;
    let mut times = Vec::new();
    for k in 0..places {
        let centre = place(POINTS + k);
        ground.height(centre, FINEST)?;
        let start = Instant::now();
        for j in 0..questions {
            let step = place(POINTS + 7919 * (k + 1) + j) * (NEAR_M / ground.radius_m());
            ground.height(centre + step, FINEST)?;
        }
        times.push(milliseconds(start) * 1e3 / questions as f64);
    }
    Ok(median(times))
}

fn collider(ground: &PlanetGround) -> Result<f64, GroundError> {
    let mut times = Vec::new();
    for k in 0..WALKS.0 {
        let fresh = ground.clone();
        let start = Instant::now();
        fresh.collider(place(2 * POINTS + k), COLLIDER_M, FINEST)?;
        times.push(milliseconds(start));
    }
    Ok(median(times))
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(0.0)
}

/// The table of all rows that have a ground.
pub(super) fn table<'a>(rows: impl Iterator<Item = (u32, &'a GroundRow)>) -> String {
    let mut text = format!(
        "\n{:>9} {:>9} {:>10} {:>10} {:>11} {:>8} {:>9} {:>9} {:>12}\n",
        "samples",
        "vertices",
        "base ms",
        "climate ms",
        "drainage ms",
        "bake ms",
        "fresh us",
        "near us",
        "collider ms"
    );
    for (samples, r) in rows {
        let _ = writeln!(
            text,
            "{samples:>9} {:>9} {:>10.0} {:>10.1} {:>11.1} {:>8.0} {:>9.1} {:>9.1} {:>12.1}",
            r.vertices,
            r.base_mesh_ms,
            r.climate_ms,
            r.drainage_ms,
            r.bake_ms,
            r.fresh_us,
            r.near_us,
            r.collider_ms,
        );
    }
    text
}
