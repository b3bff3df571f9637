//! The control mesh as the GPU wants it, made in the background.

use super::view::{GroundStatus, GroundView, Reports};
use crate::background::{BackgroundJob, BackgroundPool};
use crate::control::{Bake, PlanetBake};
use bevy::prelude::*;
use pangaea_shaders::amplify::base::{BadMesh, Base};
use pangaea_shaders::gpu::BaseRows;
use std::sync::Arc;

static POOL: BackgroundPool = BackgroundPool::new("ground rows", |cores| cores.div_ceil(4));

/// The rows of a planet's last bake.
#[derive(Component, Clone)]
pub(super) struct GroundRows {
    bake: Arc<Bake>,
    pub(super) rows: Arc<BaseRows>,
}

/// Rows that are being made.
#[derive(Component)]
pub(super) struct RowsJob {
    bake: Arc<Bake>,
    job: BackgroundJob<Result<BaseRows, BadMesh>>,
}

/// Starts to make the rows of planets that a camera looks at and whose bake is new.
pub(super) fn start(
    views: Query<&GroundView>,
    planets: Query<(&PlanetBake, Option<&GroundRows>), Without<RowsJob>>,
    mut commands: Commands,
) {
    for view in &views {
        let Ok((PlanetBake(bake), rows)) = planets.get(view.planet) else {
            continue;
        };
        if rows.is_some_and(|rows| Arc::ptr_eq(&rows.bake, bake)) {
            continue;
        }
        let control = bake.clone();
        let job = POOL.start(move || rows_of(&control));
        let bake = bake.clone();
        commands.entity(view.planet).insert(RowsJob { bake, job });
    }
}

fn rows_of(bake: &Bake) -> Result<BaseRows, BadMesh> {
    Base::new(&bake.control).map(|base| BaseRows::new(&base))
}

/// Takes rows that are ready.
pub(super) fn collect(
    jobs: Query<(Entity, &RowsJob)>,
    views: Query<(Entity, &GroundView)>,
    reports: Res<Reports>,
    mut commands: Commands,
) {
    for (planet, RowsJob { bake, job }) in &jobs {
        let Some(result) = job.take() else { continue };
        let mut planet_commands = commands.entity(planet);
        planet_commands.remove::<RowsJob>();
        match result {
            Ok(rows) => {
                let (bake, rows) = (bake.clone(), Arc::new(rows));
                planet_commands.insert(GroundRows { bake, rows });
            }
            Err(error) => {
                let looking = views.iter().filter(|(_, view)| view.planet == planet);
                for (camera, _) in looking {
                    reports.say(camera, GroundStatus::Failed(error.to_string()));
                }
            }
        }
    }
}
