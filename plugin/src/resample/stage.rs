//! The stages that resample the crust and project the surface, in slices.

use super::conservation::conserve;
use super::exclaves::merge_exclaves;
use super::gap::{GapInput, Rims, fill_gaps};
use super::project::{Notes, ProjectInput, prepare, project_slice};
use super::trench::bend;
use crate::crust::{Crust, Frame, FrameId, Frames, Ledger, PlanetSurface, Surface};
use crate::events::CrustResampled;
use crate::parallel::{self, CHUNK};
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::boundary::Rim;
use crate::plate::caches::{recompute, recompute_contacts};
use crate::plate::contact::{Contact, Contacts};
use crate::plate::overlap::OverlapIndex;
use crate::plate::plate_table;
use crate::plate::polarity::PolarityMemory;
use crate::plate::{PlateId, PlateTable};
use crate::schedule::{
    CurrentPlanet, Stage, StageTimings, StepCursor, TectonicStep, TectonicSystems,
};
use crate::sphere::nearest_source::SourceScratch;
use bevy::prelude::*;
use rayon::prelude::*;
use std::sync::Arc;
use std::time::Instant;

/// Adds the stages [`Stage::Resample`] and [`Stage::Projection`].
pub struct ResamplePlugin;

impl Plugin for ResamplePlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            (
                resample.in_set(TectonicSystems::Process(Stage::Resample)),
                surface.in_set(TectonicSystems::Process(Stage::Projection)),
            ),
        );
    }
}

/// Buffers of a projection in progress.
#[derive(Component, Clone, Debug, Default)]
pub struct Resampling {
    next: Surface,
    notes: Notes,
    rims: Rims,
    scratch: SourceScratch,
    new_ocean: usize,
    /// Whether this step has resampled the crust.
    pub done: bool,
}

/// How often the surface is projected.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq, Eq, Reflect)]
#[reflect(Component)]
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

/// Parts of the work after the chunks have been projected.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Finish {
    Gaps,
    Quota,
    Trenches,
    Commit,
}

fn resample(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    let Some(progress) = world
        .get::<StepCursor>(planet)
        .map(|cursor| cursor.progress)
    else {
        return;
    };
    if progress == 0 {
        if let Some(mut resampling) = world.get_mut::<Resampling>(planet) {
            resampling.done = false;
        }
        if !is_due(world, planet) {
            return;
        }
    }
    let start = Instant::now();
    let ended = advance(world, planet, true);
    if let Some(mut timings) = world.get_mut::<StageTimings>(planet) {
        timings.resample.0 += u32::from(ended);
        timings.resample.1 += start.elapsed().as_secs_f64() * 1e3;
    }
}

fn surface(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    let wanted = world.get::<SurfaceProjection>(planet) == Some(&SurfaceProjection::EveryStep);
    let fresh = world
        .get::<Resampling>(planet)
        .is_none_or(|resampling| resampling.done);
    if wanted && !fresh {
        advance(world, planet, false);
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

/// Whether this step ends with a resample.
pub fn due(
    params: &TectonicParams,
    clock: &GeologicClock,
    plates: &PlateTable,
    radius: f64,
    frames: usize,
) -> bool {
    let speed = plates
        .rows()
        .iter()
        .map(|row| row.motion.speed * radius)
        .fold(0.0, f64::max);
    let due = clock.since_resample + 1 >= interval(params, speed);
    // Frame numbers are 16 bits wide; a planet that collects so many terranes must be tidied.
    clock.resample_requested || frames > 50_000 || (params.processes.resample && due)
}

/// Projects the whole surface at once.
pub fn project_now(world: &mut World, planet: Entity) {
    if world
        .get::<Resampling>(planet)
        .is_some_and(|resampling| resampling.done)
    {
        // Nothing has looked for contacts since.
        recompute_contacts(world, planet);
    }
    if let Some(mut cursor) = world.get_mut::<StepCursor>(planet) {
        cursor.progress = 0;
        cursor.deadline = None;
    }
    advance(world, planet, false);
    if let Some(mut cursor) = world.get_mut::<StepCursor>(planet) {
        cursor.progress = 0;
    }
}

/// Works on the projection until the slice's time is up; then the stage holds. Returns whether it
/// is complete.
fn advance(world: &mut World, planet: Entity, commit: bool) -> bool {
    let table = plate_table(world, planet);
    let Some(mut work) = world
        .get_mut::<Resampling>(planet)
        .map(|mut r| core::mem::take(&mut *r))
    else {
        return true;
    };
    let ended = advance_work(world, planet, &table, &mut work, commit);
    if ended == Some(true) {
        finish(world, planet, &table, &mut work, commit);
        work.done = commit;
    }
    if let Some(mut slot) = world.get_mut::<Resampling>(planet) {
        *slot = work;
    }
    ended.unwrap_or(true)
}

fn advance_work(
    world: &mut World,
    planet: Entity,
    plates: &PlateTable,
    work: &mut Resampling,
    commit: bool,
) -> Option<bool> {
    let mut query = world.query::<(
        (
            &Planet,
            &Lattice,
            &TectonicParams,
            &GeologicClock,
            &Crust,
            &Frames,
        ),
        (&Rim, &Contacts, &PolarityMemory),
        (&mut OverlapIndex, &mut Ledger, &mut StepCursor),
    )>();
    let (state, (rim, contacts, polarity), (mut overlap, mut ledger, mut cursor)) =
        query.get_mut(world, planet).ok()?;
    let (body, mesh, params, clock, crust, frames) = state;
    let chunks = mesh.len().div_ceil(CHUNK);
    if cursor.progress == 0 {
        // Collisions and riftings of this step have changed the frames since the contacts were
        // found.
        overlap.turn(frames);
        prepare(&mut work.next, &mut work.notes, mesh.len());
    }
    let input = ProjectInput {
        mesh,
        crust,
        frames,
        overlap: &overlap,
        polarity,
    };
    loop {
        if cursor.progress < chunks {
            cursor.progress =
                project_slice(&input, &mut work.next, &mut work.notes, cursor.progress);
        } else {
            match [
                Finish::Gaps,
                Finish::Quota,
                Finish::Trenches,
                Finish::Commit,
            ][cursor.progress - chunks]
            {
                Finish::Gaps => {
                    let now = clock.time + if commit { params.time_step } else { 0.0 };
                    let elapsed = now - clock.last_resample;
                    let gaps = GapInput {
                        mesh,
                        plates,
                        params,
                        radius: body.radius,
                        elapsed,
                    };
                    let Resampling {
                        next, notes, rims, ..
                    } = work;
                    work.new_ocean = fill_gaps(&gaps, next, notes, rims);
                }
                Finish::Quota if commit => {
                    let Resampling { next, notes, .. } = work;
                    conserve(&input, params, body.radius, next, notes, &mut ledger);
                    merge_exclaves(mesh, next);
                }
                Finish::Quota => {}
                Finish::Trenches => {
                    let Resampling { next, scratch, .. } = work;
                    bend(
                        mesh,
                        crust,
                        frames,
                        rim,
                        contacts,
                        params,
                        body.radius,
                        next,
                        scratch,
                    );
                }
                Finish::Commit => return Some(true),
            }
            cursor.progress += 1;
        }
        if cursor.out_of_time() {
            cursor.hold();
            return Some(false);
        }
    }
}

/// Publishes the projection; after a resample it becomes the state.
fn finish(
    world: &mut World,
    planet: Entity,
    plates: &PlateTable,
    work: &mut Resampling,
    commit: bool,
) {
    let mut query = world.query::<(
        &Planet,
        &Lattice,
        &TectonicParams,
        &mut Crust,
        &mut Frames,
        &mut GeologicClock,
        &mut PlanetSurface,
    )>();
    let Ok((body, mesh, params, mut crust, mut frames, mut clock, mut surface)) =
        query.get_mut(world, planet)
    else {
        return;
    };
    work.next.version = surface.version + 1;
    work.next.time = clock.time;
    if commit {
        renumber(&mut work.next, plates, &mut frames);
        copy(&work.next.crust, &mut crust);
        clock.last_resample = clock.time + params.time_step;
        clock.resample_requested = false;
        work.next.time = clock.last_resample;
    }
    let next = Arc::new(core::mem::take(&mut work.next));
    let last = core::mem::replace(&mut surface.0, next);
    // Its memory serves the next projection, unless somebody still looks at it.
    work.next = Arc::try_unwrap(last).unwrap_or_default();
    let share = work.new_ocean as f64 / mesh.len() as f64;
    let new_ocean = share * 4.0 * crate::math::PI * body.radius * body.radius;
    if commit {
        recompute(world, planet);
        // What was known of contacts belongs to samples that are now others.
        let mut query = world.query::<(&Rim, &mut Contacts)>();
        if let Ok((rim, mut contacts)) = query.get_mut(world, planet) {
            contacts.0 = vec![Contact::default(); rim.len()];
        }
        world.trigger(CrustResampled { planet, new_ocean });
    }
}

/// Copies all columns; they have equal lengths.
fn copy(from: &Crust, to: &mut Crust) {
    let small = || {
        to.frame.clone_from(&from.frame);
        to.kind.clone_from(&from.kind);
        to.orogeny.clone_from(&from.orogeny);
        to.thickness.clone_from(&from.thickness);
        to.elevation.clone_from(&from.elevation);
        to.ocean_age.clone_from(&from.ocean_age);
        to.orogeny_age.clone_from(&from.orogeny_age);
    };
    let large = || {
        to.ridge.clone_from(&from.ridge);
        to.fold.clone_from(&from.fold);
    };
    rayon::join(small, large);
}

/// One frame at rest for every plate that has samples, in the order of plate numbers.
fn renumber(surface: &mut Surface, plates: &PlateTable, frames: &mut Frames) {
    let index = |id: PlateId| plates.index(id).unwrap_or(0);
    let used = parallel::map_chunks(surface.len(), |range| {
        let mut used = vec![false; plates.rows().len()];
        surface.plate[range]
            .chunk_by(|a, b| a == b)
            .for_each(|run| used[index(run[0])] = true);
        used
    });
    let mut number = vec![0 as FrameId; plates.rows().len()];
    frames.0.clear();
    for (k, row) in plates
        .rows()
        .iter()
        .enumerate()
        .filter(|&(k, _)| used.iter().any(|part| part[k]))
    {
        number[k] = frames.len() as FrameId;
        frames.0.push(Frame::at_rest(row.id));
    }
    let columns = (
        surface.crust.frame.par_chunks_mut(CHUNK),
        surface.plate.par_chunks(CHUNK),
    );
    columns.into_par_iter().for_each(|(mut frame, plate)| {
        for run in plate.chunk_by(|a, b| a == b) {
            let (here, rest) = frame.split_at_mut(run.len());
            here.fill(number[index(run[0])]);
            frame = rest;
        }
    });
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
