//! Builds of globes on other threads: queued when a planet or its [`Globe`] has changed, received
//! when they are ready.

use super::build::{BuildInput, BuildKey, BuiltGlobe};
use super::globe::Globe;
use crate::control::PlanetBake;
use crate::crust::PlanetSurface;
use crate::params::TectonicParams;
use crate::planet::{Lattice, Planet};
use crate::plate::{Plate, PlateId, PlateMotion, PlateRow, PlateStats, PlateTable, Plates};
use crate::sphere::SphereMesh;
use bevy::ecs::query::QueryData;
use bevy::prelude::*;
use bevy::tasks::{AsyncComputeTaskPool, Task, TaskPool, futures::check_ready};
use std::sync::{Arc, OnceLock};

/// The build of a globe that is in progress or was made last. On the planet's entity: dropped with
/// it, a build in progress is cancelled.
#[derive(Component, Default)]
pub(super) struct GlobeTask {
    running: Option<Task<BuiltGlobe>>,
    /// A finished build that is not uploaded yet.
    pub(super) built: Option<BuiltGlobe>,
    /// The key of the last build.
    key: Option<BuildKey>,
    /// The lattice of the last build.
    lattice: Option<Arc<SphereMesh>>,
    radii: (f64, f64),
}

impl GlobeTask {
    /// Least and largest distance of the drawn ground from the centre, in planet radii.
    pub(super) fn radii(&self) -> (f64, f64) {
        self.radii
    }

    fn is_busy(&self) -> bool {
        self.running.is_some() || self.built.is_some()
    }

    fn is_new(&self, lattice: &Lattice) -> bool {
        let known = self.lattice.as_ref();
        known.is_none_or(|known| !Arc::ptr_eq(known, &lattice.0))
    }

    fn start(&mut self, input: BuildInput) {
        self.key = Some(input.key.clone());
        self.lattice = Some(input.mesh.clone());
        let pool = AsyncComputeTaskPool::get_or_init(TaskPool::new);
        self.running = Some(pool.spawn(async move { on_own_thread(|| input.build()) }));
    }
}

/// A planet with a globe.
#[derive(QueryData)]
#[query_data(mutable)]
pub(super) struct GlobeQuery {
    planet: &'static Planet,
    lattice: &'static Lattice,
    surface: &'static PlanetSurface,
    params: &'static TectonicParams,
    globe: &'static Globe,
    plates: Option<&'static Plates>,
    bake: Option<&'static PlanetBake>,
    task: &'static mut GlobeTask,
}

/// The parts of a plate's row.
type PlateParts = (
    Entity,
    &'static PlateId,
    &'static PlateMotion,
    &'static PlateStats,
    &'static Plate,
);

/// Starts a build of every globe that has changed and is not being built.
pub(super) fn queue_builds(mut globes: Query<GlobeQuery>, plates: Query<PlateParts>) {
    for mut globe in &mut globes {
        let radius = globe.planet.radius;
        let key = BuildKey::new(globe.surface, globe.globe, radius, globe.bake);
        let is_known = globe.task.key.as_ref() == Some(&key);
        let is_projected = globe.surface.len() == globe.lattice.len();
        // One build at a time: a busy globe is looked at again when its build is done.
        if globe.task.is_busy() || is_known || !is_projected {
            continue;
        }
        let input = BuildInput {
            planet: *globe.planet,
            mesh: globe.lattice.0.clone(),
            surface: globe.surface.0.clone(),
            plates: plate_table(globe.plates, &plates),
            params: globe.params.clone(),
            globe: globe.globe.clone(),
            bake: globe.bake.map(|bake| bake.0.clone()),
            key,
            new_lattice: globe.task.is_new(globe.lattice),
        };
        globe.task.start(input);
    }
}

fn plate_table(members: Option<&Plates>, plates: &Query<PlateParts>) -> PlateTable {
    let members = members.into_iter().flat_map(Plates::iter);
    let rows = members.filter_map(|plate| plates.get(plate).ok());
    PlateTable::new(rows.map(|(entity, id, motion, stats, plate)| PlateRow {
        id: *id,
        entity,
        motion: *motion,
        stats: *stats,
        born: plate.born,
    }))
}

/// Runs `work` with a thread of its own for its parallel loops, so that a build never holds the
/// threads that a step of the simulation waits for.
fn on_own_thread<T: Send>(work: impl FnOnce() -> T + Send) -> T {
    static POOL: OnceLock<Option<rayon::ThreadPool>> = OnceLock::new();
    match POOL.get_or_init(one_thread) {
        Some(pool) => pool.install(work),
        None => work(),
    }
}

fn one_thread() -> Option<rayon::ThreadPool> {
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .thread_name(|_| "globe build".to_string())
        .build()
        .ok()
}

/// Receives finished builds.
pub(super) fn receive_builds(mut tasks: Query<&mut GlobeTask>) {
    for mut task in &mut tasks {
        let Some(built) = task.running.as_mut().and_then(check_ready) else {
            continue;
        };
        // A finished task must not be asked again.
        task.running = None;
        task.radii = built.radii;
        task.built = Some(built);
    }
}
