//! The work of a projection, in time slices: chunks of samples, then gaps, conservation and
//! trenches; after a resample the projection becomes the state.

use super::conservation::conserve;
use super::exclaves::merge_exclaves;
use super::gap::{GapRims, fill_gaps};
use super::input::{GapInput, ProjectInput};
use super::project::{ProjectNotes, prepare, project_chunks};
use super::trench::{TrenchInput, bend};
use crate::crust::{Crust, Frame, FrameId, Frames, Ledger, PlanetSurface, Surface};
use crate::events::CrustResampled;
use crate::ids::PlateId;
use crate::math::PI;
use crate::parallel::{self, CHUNK};
use crate::planet::GeologicClock;
use crate::plate::boundary::Rim;
use crate::plate::caches::recompute;
use crate::plate::contact::{Contact, Contacts};
use crate::plate::overlap::OverlapIndex;
use crate::plate::polarity::PolarityMemory;
use crate::plate::{PlateTable, plate_table};
use crate::schedule::StepCursor;
use crate::sphere::nearest_source::SourceScratch;
use crate::view::{PlanetQuery, PlanetView};
use bevy::prelude::*;
use rayon::prelude::*;
use std::sync::Arc;

/// The purpose of a projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Aim {
    /// It becomes the new state.
    Resample,
    /// It is published for readers; the state stays.
    Look,
}

/// Buffers of a projection in progress.
#[derive(Component, Clone, Debug, Default)]
pub struct Resampling {
    next: Surface,
    notes: ProjectNotes,
    rims: GapRims,
    scratch: SourceScratch,
    /// Samples that became new ocean floor.
    new_ocean: usize,
    /// Whether the last step resampled the crust.
    pub done: bool,
}

/// Parts of the work after the chunks have been projected, in order.
#[derive(Clone, Copy, PartialEq, Eq)]
enum WorkPart {
    Gaps,
    Conservation,
    Trenches,
}

/// The parts in their order.
const PARTS: [WorkPart; 3] = [WorkPart::Gaps, WorkPart::Conservation, WorkPart::Trenches];

/// Works on the projection until the time slice is up; then the stage holds. Returns whether the
/// projection is complete.
pub(super) fn advance(world: &mut World, planet: Entity, aim: Aim) -> bool {
    let plates = plate_table(world, planet);
    let Some(mut resampling) = world.get_mut::<Resampling>(planet) else {
        return true;
    };
    // Taken out of the world, which the work borrows as a whole.
    let mut work = core::mem::take(&mut *resampling);
    let complete = advance_work(world, planet, &plates, &mut work, aim);
    if complete {
        publish(world, planet, &plates, &mut work, aim);
        work.done = aim == Aim::Resample;
    }
    if let Some(mut resampling) = world.get_mut::<Resampling>(planet) {
        *resampling = work;
    }
    complete
}

/// Everything that the parts of the work read.
struct WorkInput<'a> {
    aim: Aim,
    project: ProjectInput<'a>,
    gaps: GapInput<'a>,
    trenches: TrenchInput<'a>,
}

/// Does parts of the work until the time slice is up. Returns whether all are done.
fn advance_work(
    world: &mut World,
    planet: Entity,
    plates: &PlateTable,
    work: &mut Resampling,
    aim: Aim,
) -> bool {
    let mut query = world.query::<(
        (PlanetQuery, &GeologicClock, &Crust, &Frames),
        (&Rim, &Contacts, &PolarityMemory),
        (&mut OverlapIndex, &mut Ledger, &mut StepCursor),
    )>();
    let Ok((state, (rim, contacts, polarity), (mut overlap, mut ledger, mut cursor))) =
        query.get_mut(world, planet)
    else {
        return false;
    };
    let (planet, clock, crust, frames) = state;
    let planet = planet.view();
    if cursor.progress == 0 {
        // Collisions and riftings of this step have changed the frames since the contacts were
        // found.
        overlap.turn(frames);
        prepare(&mut work.next, &mut work.notes, planet.mesh.len());
    }
    // A resample belongs to the end of its step, for which the clock has not ticked yet.
    let now = match aim {
        Aim::Resample => clock.time + planet.params.time_step,
        Aim::Look => clock.time,
    };
    let input = WorkInput {
        aim,
        project: ProjectInput {
            mesh: planet.mesh,
            crust,
            frames,
            overlap: &overlap,
            polarity,
        },
        gaps: GapInput {
            planet,
            plates,
            elapsed: now - clock.last_resample,
        },
        trenches: TrenchInput {
            planet,
            crust,
            frames,
            rim,
            contacts,
        },
    };
    work.run(&input, &mut ledger, &mut cursor)
}

impl Resampling {
    /// Does part after part until the time slice is up, one at least. Returns whether all are done.
    fn run(&mut self, input: &WorkInput, ledger: &mut Ledger, cursor: &mut StepCursor) -> bool {
        while self.next_part(input, ledger, &mut cursor.progress) {
            if cursor.out_of_time() {
                cursor.hold();
                return false;
            }
        }
        true
    }

    /// Does the part of the work that `progress` stands at, and moves it on; `false` when all is
    /// done.
    fn next_part(&mut self, input: &WorkInput, ledger: &mut Ledger, progress: &mut usize) -> bool {
        let planet = &input.gaps.planet;
        let chunks = planet.mesh.len().div_ceil(CHUNK);
        let next = &mut self.next;
        if *progress < chunks {
            *progress = project_chunks(&input.project, next, &mut self.notes, *progress);
            return true;
        }
        match PARTS.get(*progress - chunks) {
            Some(WorkPart::Gaps) => {
                self.new_ocean = fill_gaps(&input.gaps, next, &self.notes, &mut self.rims);
            }
            Some(WorkPart::Conservation) => {
                // Who only looks changes no ledger.
                if input.aim == Aim::Resample {
                    conserve(&input.project, planet, next, &self.notes, ledger);
                    merge_exclaves(planet.mesh, next);
                }
            }
            Some(WorkPart::Trenches) => bend(&input.trenches, next, &mut self.scratch),
            None => return false,
        }
        *progress += 1;
        true
    }
}

impl Resampling {
    /// Hands the projection to its readers, and takes the last one back as memory for the next,
    /// unless somebody still looks at it.
    fn swap(&mut self, surface: &mut PlanetSurface) {
        let next = Arc::new(core::mem::take(&mut self.next));
        let last = core::mem::replace(&mut surface.0, next);
        self.next = Arc::try_unwrap(last).unwrap_or_default();
    }

    /// Area of new ocean floor in km².
    fn new_ocean_area(&self, planet: &PlanetView) -> f64 {
        let share = self.new_ocean as f64 / planet.mesh.len() as f64;
        share * 4.0 * PI * planet.radius * planet.radius
    }
}

/// Publishes the projection; after a resample it becomes the state.
fn publish(
    world: &mut World,
    planet: Entity,
    plates: &PlateTable,
    work: &mut Resampling,
    aim: Aim,
) {
    let mut query = world.query::<(
        (PlanetQuery, &mut PlanetSurface),
        (&mut Crust, &mut Frames, &mut GeologicClock),
    )>();
    let Ok(((body, mut surface), (mut crust, mut frames, mut clock))) =
        query.get_mut(world, planet)
    else {
        return;
    };
    let view = body.view();
    work.next.version = surface.version + 1;
    work.next.time = clock.time;
    if aim == Aim::Resample {
        renumber(&mut work.next, plates, &mut frames);
        crust.copy_from(&work.next.crust);
        // The clock ticks later, in the stage Commit.
        clock.last_resample = clock.time + view.params.time_step;
        clock.resample_requested = false;
        work.next.time = clock.last_resample;
    }
    work.swap(&mut surface);
    let new_ocean = work.new_ocean_area(&view);
    if aim == Aim::Resample {
        recompute(world, planet);
        forget_contacts(world, planet);
        world.trigger(CrustResampled { planet, new_ocean });
    }
}

/// Contacts found before belong to samples that are now others.
fn forget_contacts(world: &mut World, planet: Entity) {
    let mut query = world.query::<(&Rim, &mut Contacts)>();
    if let Ok((rim, mut contacts)) = query.get_mut(world, planet) {
        contacts.0 = vec![Contact::default(); rim.len()];
    }
}

/// Whether each plate of the table has samples.
fn used_plates(surface: &Surface, plates: &PlateTable) -> Vec<bool> {
    let parts = parallel::map_chunks(surface.len(), |range| {
        let mut used = vec![false; plates.rows().len()];
        for run in surface.plate[range].chunk_by(|a, b| a == b) {
            used[plates.index(run[0]).unwrap_or(0)] = true;
        }
        used
    });
    let is_used = |k: usize| parts.iter().any(|part| part[k]);
    (0..plates.rows().len()).map(is_used).collect()
}

/// One frame at rest for every plate that has samples, in the order of plate numbers.
fn renumber(surface: &mut Surface, plates: &PlateTable, frames: &mut Frames) {
    let index = |id: PlateId| plates.index(id).unwrap_or(0);
    let used = used_plates(surface, plates);
    let mut number = vec![0 as FrameId; plates.rows().len()];
    frames.0.clear();
    for (k, row) in plates.rows().iter().enumerate() {
        if used[k] {
            number[k] = frames.len() as FrameId;
            frames.0.push(Frame::at_rest(row.id));
        }
    }
    let columns = (
        surface.crust.frame.par_chunks_mut(CHUNK),
        surface.plate.par_chunks(CHUNK),
    );
    // Neighbours in memory mostly lie on one plate: its number is looked up once for a run.
    columns.into_par_iter().for_each(|(mut frame, plate)| {
        for run in plate.chunk_by(|a, b| a == b) {
            let (here, rest) = frame.split_at_mut(run.len());
            here.fill(number[index(run[0])]);
            frame = rest;
        }
    });
}
