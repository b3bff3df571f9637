//! Builds of globes on other threads: queued when a planet or its [`Globe`] has changed, received
//! when they are ready.

use super::build::{BuildInput, BuildKey, BuiltGlobe};
use super::globe::Globe;
use crate::background::{BackgroundJob, BackgroundPool};
use crate::control::PlanetBake;
use crate::crust::PlanetSurface;
use crate::planet::Lattice;
use crate::plate::{PlateQuery, PlateTable, Plates};
use crate::sphere::SphereMesh;
use crate::view::{PlanetQuery, PlanetQueryItem};
use bevy::ecs::query::QueryData;
use bevy::prelude::*;
use std::sync::Arc;

/// The build of a globe that is in progress or was made last. On the planet's entity: dropped with
/// it, a build in progress is cancelled.
#[derive(Component, Default)]
pub(super) struct GlobeTask {
    running: Option<BackgroundJob<BuiltGlobe>>,
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
        static POOL: BackgroundPool = BackgroundPool::new("globe", |_| 1);
        self.running = Some(POOL.start(move || input.build()));
    }
}

/// A planet with a globe.
#[derive(QueryData)]
#[query_data(mutable)]
pub(super) struct GlobeQuery {
    planet: PlanetQuery,
    surface: &'static PlanetSurface,
    globe: &'static Globe,
    plates: Option<&'static Plates>,
    bake: Option<&'static PlanetBake>,
    task: &'static mut GlobeTask,
}

/// Starts a build of every globe that has changed and is not being built.
pub(super) fn queue_builds(mut globes: Query<GlobeQuery>, plates: Query<PlateQuery>) {
    for mut globe in &mut globes {
        let PlanetQueryItem {
            planet,
            lattice,
            params,
        } = globe.planet;
        let key = BuildKey::new(globe.surface, globe.globe, planet.radius, globe.bake);
        let is_known = globe.task.key.as_ref() == Some(&key);
        let is_projected = globe.surface.len() == lattice.len();
        // One build at a time: a busy globe is looked at again when its build is done.
        if globe.task.is_busy() || is_known || !is_projected {
            continue;
        }
        let input = BuildInput {
            planet: *planet,
            mesh: lattice.0.clone(),
            surface: globe.surface.0.clone(),
            plates: plate_table(globe.plates, &plates),
            params: params.clone(),
            globe: globe.globe.clone(),
            bake: globe.bake.map(|bake| bake.0.clone()),
            key,
            new_lattice: globe.task.is_new(lattice),
        };
        globe.task.start(input);
    }
}

fn plate_table(members: Option<&Plates>, plates: &Query<PlateQuery>) -> PlateTable {
    let members = members.into_iter().flat_map(Plates::iter);
    PlateTable::new(plates.iter_many(members).map(|plate| plate.row()))
}

/// Receives finished builds.
pub(super) fn receive_builds(mut tasks: Query<&mut GlobeTask>) {
    for mut task in &mut tasks {
        let Some(built) = task.running.as_ref().and_then(BackgroundJob::take) else {
            continue;
        };
        task.running = None;
        task.radii = built.radii;
        task.built = Some(built);
    }
}
