//! When the crust is resampled and when its surface is projected.
//!
//! A resample is due after 10 to 60 steps, sooner where plates are fast: `10 v_0 / v_max` steps,
//! the time in which the fastest plate moves as far as a plate at v_0 in ten.

use super::work::{Aim, Resampling, advance};
use crate::crust::Frames;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Planet};
use crate::plate::caches::recompute_contacts;
use crate::plate::{PlateTable, plate_table};
use crate::schedule::{
    CurrentPlanet, Stage, StageTimings, StepCursor, TectonicStep, TectonicSystems,
};
use bevy::prelude::*;
use std::time::Instant;

/// Frame numbers are 16 bits wide; a planet that collects so many frames of terranes is resampled.
const MOST_FRAMES: usize = 50_000;

/// Adds the stages [`Stage::Resample`] and [`Stage::Projection`].
pub struct ResamplePlugin;

impl Plugin for ResamplePlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            (
                resample.in_set(TectonicSystems::Process(Stage::Resample)),
                project.in_set(TectonicSystems::Process(Stage::Projection)),
            ),
        );
    }
}

/// How often the surface is projected.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq, Eq, Reflect)]
#[reflect(Component, Default)]
pub enum SurfaceProjection {
    /// At resamples only, and when [`project_now`] is called.
    #[default]
    OnRequest,
    /// After every step.
    EveryStep,
}

/// Steps between two resamples when the fastest plate moves at `speed` km/My.
pub fn interval(params: &TectonicParams, speed: f64) -> u32 {
    let wanted = params.resample_min_steps * params.max_speed / speed.max(1e-9);
    let most = params.resample_max_steps.max(params.resample_min_steps);
    wanted.clamp(params.resample_min_steps, most) as u32
}

/// Whether this step ends with a resample.
pub fn due(
    params: &TectonicParams,
    clock: &GeologicClock,
    plates: &PlateTable,
    radius: f64,
    frames: usize,
) -> bool {
    let fastest = plates
        .rows()
        .iter()
        .map(|row| row.motion.speed * radius)
        .fold(0.0, f64::max);
    // The clock ticks later: the present step counts too.
    let due = clock.since_resample + 1 >= interval(params, fastest);
    clock.resample_requested || frames > MOST_FRAMES || (params.processes.resample && due)
}

fn resample(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    let Some(cursor) = world.get::<StepCursor>(planet) else {
        return;
    };
    if cursor.progress == 0 {
        if let Some(mut resampling) = world.get_mut::<Resampling>(planet) {
            // The first time slice of the stage: of this step nothing is done yet.
            resampling.done = false;
        }
        if !is_due(world, planet) {
            return;
        }
    }
    let start = Instant::now();
    let complete = advance(world, planet, Aim::Resample);
    if let Some(mut timings) = world.get_mut::<StageTimings>(planet) {
        timings.resample.0 += u32::from(complete);
        timings.resample.1 += start.elapsed().as_secs_f64() * 1e3;
    }
}

fn is_due(world: &mut World, planet: Entity) -> bool {
    let table = plate_table(world, planet);
    let entity = world.entity(planet);
    let parts = entity.get_components::<(&Planet, &TectonicParams, &GeologicClock, &Frames)>();
    parts.is_ok_and(|(body, params, clock, frames)| {
        due(params, clock, &table, body.radius, frames.len())
    })
}

fn project(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    let wanted = world.get::<SurfaceProjection>(planet) == Some(&SurfaceProjection::EveryStep);
    if wanted && !has_resampled(world, planet) {
        advance(world, planet, Aim::Look);
    }
}

/// Whether the last step resampled the crust, and so projected its surface.
fn has_resampled(world: &World, planet: Entity) -> bool {
    world
        .get::<Resampling>(planet)
        .is_none_or(|resampling| resampling.done)
}

/// Projects the whole surface at once.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// use bevy_pangaea::resample::project_now;
///
/// # fn main() -> Result<(), PlanetError> {
/// let mut app = App::new();
/// app.add_plugins(PangaeaPlugins);
/// let recipe = PlanetRecipe { samples: 500, ..default() };
/// let planet = PlanetState::new(&recipe)?.spawn(app.world_mut());
/// run_steps(app.world_mut(), planet, 2);
/// project_now(app.world_mut(), planet);
/// let surface = app.world().get::<PlanetSurface>(planet).unwrap();
/// assert_eq!((surface.time, surface.len()), (4.0, 500));
/// # Ok(())
/// # }
/// ```
pub fn project_now(world: &mut World, planet: Entity) {
    if has_resampled(world, planet) {
        // Nothing has looked for contacts since.
        recompute_contacts(world, planet);
    }
    if let Some(mut cursor) = world.get_mut::<StepCursor>(planet) {
        cursor.progress = 0;
        // From the first chunk to the last in one go.
        cursor.deadline = None;
    }
    advance(world, planet, Aim::Look);
    if let Some(mut cursor) = world.get_mut::<StepCursor>(planet) {
        cursor.progress = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fast_plates_are_resampled_sooner() {
        let params = TectonicParams::default();
        assert_eq!(interval(&params, 100.0), 10);
        assert_eq!(interval(&params, 50.0), 20);
        assert_eq!(interval(&params, 1.0), 60);
        assert_eq!(interval(&params, 0.0), 60);
        assert_eq!(interval(&params, 300.0), 10);
    }
}
