//! The ground part of `pangaea bench`: how long climate, rivers and the amplified ground take.

use crate::error::CliError;
use crate::headless::Headless;
use bevy::math::DVec3;
use bevy_pangaea::climate::{Climate, ClimateMaps};
use bevy_pangaea::control::{Bake, BakeFrame, BakeRules, BakeSource};
use bevy_pangaea::crust::{PlanetSurface, Surface};
use bevy_pangaea::hydrology::{BASE_SPACING, BaseMesh, Drainage, RiverNetwork, Terrain};
use bevy_pangaea::planet::{Lattice, Planet};
use bevy_pangaea::query::{Ground, GroundError, LEVELS, PlanetGround, Rules};
use bevy_pangaea::random::{Purpose, Stream};
use std::sync::Arc;
use std::time::Instant;

/// Points asked for that are far from each other.
const FRESH_POINTS: u64 = 1000;
/// Places around which points are asked for.
const PLACES: u64 = 20;
/// Points asked for around each place.
const POINTS_PER_PLACE: u64 = 200;
/// How far from a place its points are, in m.
const NEAR_M: f64 = 100.0;
/// Side of a collider in m.
const COLLIDER_M: f64 = 64.0;

/// The measurements on one planet.
#[derive(serde::Serialize)]
pub(super) struct GroundTimings {
    /// Vertices of the base mesh.
    pub(super) vertices: usize,
    /// Points, triangles and winds of the base mesh, once per seed, ms.
    pub(super) base_mesh_ms: f64,
    /// Its edges and faces, and where its vertices lie between samples; once per seed and lattice,
    /// ms.
    pub(super) frame_ms: f64,
    /// Crust at the vertices and its landforms, ms.
    pub(super) terrain_ms: f64,
    /// Climate, ms.
    pub(super) climate_ms: f64,
    /// Coasts, drainage, rivers and lakes, ms.
    pub(super) drainage_ms: f64,
    /// The rest of the bake: the control mesh, packed, ms.
    pub(super) control_ms: f64,
    /// All that follows a running simulation, ms.
    pub(super) bake_ms: f64,
    /// The control mesh made ready for queries, once per bake and not part of `bake_ms`, ms.
    pub(super) ground_ms: f64,
    /// Time between a surface and its first height, ms: the bake and the ground; on a planet
    /// that was just loaded the base mesh and the frame come before.
    pub(super) wait_ms: f64,
    /// A whole wait after loading, ms.
    pub(super) first_wait_ms: f64,
    /// A height of the finest level at a fresh random point, one thread, µs.
    pub(super) fresh_us: f64,
    /// The same within 100 m of the last, median over places, µs.
    pub(super) near_us: f64,
    /// A collider of 64 m at the finest level by an engine that knows nothing, median, ms.
    pub(super) collider_ms: f64,
}

/// Measures the ground of a planet; `None` if there is no ground for a planet of its radius.
///
/// # Errors
/// If the planet cannot be baked.
pub(super) fn ground_timings(headless: &Headless) -> Result<Option<GroundTimings>, CliError> {
    let planet = headless.get::<Planet>()?;
    let surface = headless.get::<PlanetSurface>()?;
    let (base, base_mesh_ms) = timed(|| BaseMesh::new(planet.seed, BASE_SPACING));
    let base = base.map_err(CliError::input)?;
    let lattice = headless.get::<Lattice>()?;
    let (frame, frame_ms) = timed(|| BakeFrame::with_base(base, BASE_SPACING, Some(lattice)));
    let frame = Arc::new(frame);
    let (maps, rules) = (ClimateMaps::default(), BakeRules::default());
    let source = BakeSource::Surface(surface);
    let (bake, bake_ms) = timed(|| Bake::new(&frame, planet.radius, &source, &maps, &rules));
    let bake = bake.map_err(CliError::input)?;
    let [terrain_ms, climate_ms, drainage_ms] = parts_of_bake(planet, surface, &bake, &maps);
    let (ground, ground_ms) = timed(|| PlanetGround::of_bake(&bake, Rules::default()));
    let Ok(ground) = ground else {
        return Ok(None);
    };
    Ok(Some(GroundTimings {
        vertices: bake.control.vertices.len(),
        base_mesh_ms,
        frame_ms,
        terrain_ms,
        climate_ms,
        drainage_ms,
        control_ms: (bake_ms - terrain_ms - climate_ms - drainage_ms).max(0.0),
        bake_ms,
        ground_ms,
        wait_ms: bake_ms + ground_ms,
        first_wait_ms: base_mesh_ms + frame_ms + bake_ms + ground_ms,
        fresh_us: fresh(&ground)?,
        near_us: near(&ground)?,
        collider_ms: collider(&ground)?,
    }))
}

/// Milliseconds of the terrain, of the climate and of the drainage of a bake, each made again.
fn parts_of_bake(planet: &Planet, surface: &Surface, bake: &Bake, maps: &ClimateMaps) -> [f64; 3] {
    let base = &bake.frame.base;
    let transfer = bake.frame.transfer.as_ref();
    let (again, terrain_ms) = timed(|| transfer.map(|t| Terrain::from_surface(base, t, surface)));
    let terrain = again.as_ref().unwrap_or(&bake.terrain);
    let (climate, climate_ms) = timed(|| {
        let elevation_km = terrain.elevation_km();
        Climate::new(&base.mesh, &base.winds, &elevation_km, maps)
    });
    let network = RiverNetwork::default();
    let (_, drainage_ms) = timed(|| Drainage::new(base, planet.radius, terrain, &climate, network));
    [terrain_ms, climate_ms, drainage_ms]
}

/// A result, and how many milliseconds it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, milliseconds(start))
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

/// The random direction of a number.
fn place(number: u64) -> DVec3 {
    Stream::new(1, Purpose::ReliefSites, 0).direction(2 * number)
}

fn fresh(ground: &PlanetGround) -> Result<f64, GroundError> {
    let start = Instant::now();
    for k in 0..FRESH_POINTS {
        ground.height(place(k), LEVELS)?;
    }
    Ok(milliseconds(start) * 1e3 / FRESH_POINTS as f64)
}

fn near(ground: &PlanetGround) -> Result<f64, GroundError> {
    let mut times = Vec::new();
    for k in 0..PLACES {
        let centre = place(FRESH_POINTS + k);
        // The first question pays for the way down to the place.
        ground.height(centre, LEVELS)?;
        let start = Instant::now();
        for j in 0..POINTS_PER_PLACE {
            // A prime apart, so that no two places have the same points around them.
            let number = FRESH_POINTS + 7919 * (k + 1) + j;
            let step = place(number) * (NEAR_M / ground.radius_m());
            ground.height(centre + step, LEVELS)?;
        }
        times.push(milliseconds(start) * 1e3 / POINTS_PER_PLACE as f64);
    }
    Ok(median(times))
}

fn collider(ground: &PlanetGround) -> Result<f64, GroundError> {
    let mut times = Vec::new();
    for k in 0..PLACES {
        // A clone shares the planet, but none of the ground that is already known.
        let fresh = ground.clone();
        let start = Instant::now();
        fresh.collider(place(2 * FRESH_POINTS + k), COLLIDER_M, LEVELS)?;
        times.push(milliseconds(start));
    }
    Ok(median(times))
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(0.0)
}
