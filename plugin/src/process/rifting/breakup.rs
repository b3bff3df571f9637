//! Carries out the plan of a rift: thinner crust, new frames, new plates.

use super::plan::{PlateSample, RiftPlan};
use crate::crust::{Cause, Crust, Frame, FrameId, Frames, Ledger};
use crate::events::PlateRifted;
use crate::math::smoothstep;
use crate::planet::{GeologicClock, PlateNumbers};
use crate::plate::caches::{MovedSamples, recompute_moved};
use crate::plate::{Plate, PlateId, PlateOf, PlateRow, PlateStats};
use crate::view::{PlanetQuery, PlanetView};
use bevy::prelude::*;

/// Breaks the plate `row`. Returns its fragments, of which the first keeps its number; `None` for
/// an entity that is no planet.
pub(super) fn break_plate(
    world: &mut World,
    planet: Entity,
    row: PlateRow,
    plan: RiftPlan,
) -> Option<Vec<PlateId>> {
    let broken = break_crust(world, planet, row.id, &plan)?;
    // The first fragment is the parent's entity, with a new motion.
    let first = (plan.motions[0], broken.born);
    world.entity_mut(row.entity).insert(first);
    for (&fragment, &motion) in broken.fragments.iter().zip(&plan.motions).skip(1) {
        world.spawn((
            Name::new(format!("plate {}", fragment.0)),
            PlateOf(planet),
            broken.born,
            fragment,
            motion,
            // Found below, with the caches.
            PlateStats::default(),
        ));
    }
    recompute_moved(world, planet, &broken.moved);
    // Observers see fragments that have their statistics.
    world.trigger(PlateRifted {
        planet,
        parent: row.id,
        fragments: broken.fragments.clone(),
    });
    Some(broken.fragments)
}

/// The crust of a plate that has been broken, before its fragments are entities.
struct BrokenCrust {
    fragments: Vec<PlateId>,
    moved: MovedSamples,
    born: Plate,
}

/// Thins the crust along the fracture and gives the fragments their numbers and frames.
fn break_crust(
    world: &mut World,
    planet: Entity,
    parent: PlateId,
    plan: &RiftPlan,
) -> Option<BrokenCrust> {
    let mut query = world.query::<(
        (PlanetQuery, &GeologicClock, &mut PlateNumbers),
        (&mut Crust, &mut Frames, &mut Ledger),
    )>();
    let ((body, clock, mut numbers), (mut crust, mut frames, mut ledger)) =
        query.get_mut(world, planet).ok()?;
    let view = body.view();
    let volume = thin(&mut crust, &view, &plan.samples);
    ledger.book(Cause::Rifting, 0.0, volume * view.radius * view.radius);
    let fragments = number_fragments(parent, plan.motions.len(), &mut numbers);
    reframe(&mut crust, &mut frames, &plan.samples, &fragments);
    Some(BrokenCrust {
        moved: moved_samples(&plan.samples, &frames, &fragments),
        fragments,
        born: Plate { born: clock.time },
    })
}

/// The numbers of the fragments: the parent's, then free ones.
fn number_fragments(parent: PlateId, count: usize, numbers: &mut PlateNumbers) -> Vec<PlateId> {
    core::iter::once(parent)
        .chain((1..count).map(|_| numbers.issue()))
        .collect()
}

/// Thins continental crust beside the fracture. Returns the change of volume per square of the
/// radius.
fn thin(crust: &mut Crust, planet: &PlanetView, samples: &[PlateSample]) -> f64 {
    let width = planet.params.rift_width / planet.radius;
    let mut volume = 0.0;
    for part in samples {
        let i = part.sample as usize;
        let fade = 1.0 - smoothstep(f64::from(part.distance) / width.max(1e-9));
        if fade > 0.0 && crust.is_continental(i) {
            let before = crust.thickness[i];
            // The elevation follows step by step, as surface processes let thinner crust sink.
            crust.thickness[i] = before * (1.0 - planet.params.rift_thinning * fade) as f32;
            volume += f64::from(crust.thickness[i] - before) * planet.mesh.areas()[i];
        }
    }
    volume
}

/// Gives the samples of all fragments but the first new frames, one for each frame that the plate
/// had.
fn reframe(crust: &mut Crust, frames: &mut Frames, samples: &[PlateSample], ids: &[PlateId]) {
    // New frames by old frame and fragment: terranes within a fragment stay frames of their own.
    let mut made: Vec<((FrameId, u8), FrameId)> = Vec::new();
    for part in samples.iter().filter(|part| part.fragment > 0) {
        let i = part.sample as usize;
        let key = (crust.frame[i], part.fragment);
        // A handful of frames: looking at all is quick enough.
        let known = made.iter().find(|(other, _)| *other == key);
        crust.frame[i] = match known {
            Some(&(_, id)) => id,
            None => {
                let id = frames.len() as FrameId;
                let plate = ids[usize::from(part.fragment)];
                let old = frames[usize::from(key.0)];
                frames.push(Frame { plate, ..old });
                made.push((key, id));
                id
            }
        };
    }
}

/// The samples that left the parent's frames, and all frames of the fragments.
fn moved_samples(samples: &[PlateSample], frames: &Frames, ids: &[PlateId]) -> MovedSamples {
    let left = samples.iter().filter(|part| part.fragment > 0);
    let touched = (0..)
        .zip(frames.iter())
        .filter(|(_, frame)| ids.contains(&frame.plate));
    MovedSamples {
        samples: left.map(|part| part.sample).collect(),
        frames: touched.map(|(id, _)| id).collect(),
    }
}
