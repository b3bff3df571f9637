//! Caches: what follows from the state and is never saved, found again after a load and whenever
//! frames gain or lose samples.
//!
//! | cache | follows from | recomputed by |
//! |---|---|---|
//! | [`Rim`], [`OverlapIndex`], [`PlateStats`] | which samples a frame has | [`recompute`], [`recompute_moved`] |
//! | [`FrontField`] | contacts and rims; it has a memory | marked stale here, recomputed by subduction |
//! | [`PlateStats`] alone | the kinds of samples | [`recompute_stats`] |
//! | [`Contacts`] | rims, frames, motions | each step; for pictures by [`recompute_contacts`] |
//! | terranes | frames and kinds | noted here, counted by the [census](super::census) |

use super::boundary::Rim;
use super::census::TerraneCensus;
use super::contact::{Contact, ContactInput, Contacts, find_contacts};
use super::front::FrontField;
use super::overlap::OverlapIndex;
use super::polarity::PolarityMemory;
use super::stats::plate_stats;
use super::{PlateRow, PlateStats, plate_table};
use crate::crust::{Crust, Frames};
use crate::events::PlateConsumed;
use crate::ids::{FrameId, PlateId};
use crate::sphere::SphereMesh;
use crate::view::{PlanetQuery, PlanetView};
use bevy::prelude::*;

/// Samples that went to other frames.
#[derive(Clone, Debug, Default)]
pub struct MovedSamples {
    /// The samples, in order.
    pub samples: Vec<u32>,
    /// The frames that lost or gained them.
    pub frames: Vec<FrameId>,
}

/// Recomputes what depends on which samples a frame has: rims, overlap tables, plate statistics;
/// distances to fronts are marked stale. Plates without crust are removed.
pub fn recompute(world: &mut World, planet: Entity) {
    recompute_but_fronts(world, planet);
    if let Some(mut fronts) = world.get_mut::<FrontField>(planet) {
        fronts.stale = true;
    }
}

/// The same as [`recompute`] where only a few samples have moved: what does not touch them stays.
pub fn recompute_moved(world: &mut World, planet: Entity, moved: &MovedSamples) {
    recompute_frames(world, planet, Some(moved));
    let mut query = world.query::<(&Crust, &mut FrontField)>();
    if let Ok((crust, mut fronts)) = query.get_mut(world, planet) {
        fronts.forget(&crust.frame, &moved.frames);
    }
}

/// The same as [`recompute`] for a planet whose distances to fronts were loaded with it.
pub fn recompute_but_fronts(world: &mut World, planet: Entity) {
    recompute_frames(world, planet, None);
}

/// Recomputes the statistics of all plates after crust has changed its kind.
pub fn recompute_stats(world: &mut World, planet: Entity) {
    let mut query = world.query::<(PlanetQuery, &Crust, &Frames)>();
    let Ok((body, crust, frames)) = query.get(world, planet) else {
        return;
    };
    let view = body.view();
    let stats = plate_stats(view.mesh, crust, frames, view.radius, |_| true);
    assign_stats(world, planet, &stats);
    recount_later(world, planet, None);
}

/// Finds contacts for pictures, until the next step finds its own: looking must not change the
/// memory of polarity.
pub fn recompute_contacts(world: &mut World, planet: Entity) {
    let plates = &plate_table(world, planet);
    let mut query = world.query::<(
        (PlanetQuery, &Crust, &Frames, &Rim),
        (&OverlapIndex, &PolarityMemory, &mut Contacts),
    )>();
    let Ok((state, (overlap, polarity, mut contacts))) = query.get_mut(world, planet) else {
        return;
    };
    let (body, crust, frames, rim) = state;
    let view = body.view();
    let input = ContactInput {
        mesh: view.mesh,
        crust,
        frames,
        overlap,
        plates,
        radius: view.radius,
    };
    let mut memory = polarity.clone();
    *contacts = find_contacts(&input, rim, &mut memory, view.params.polarity_hysteresis);
}

/// Leaves terranes to be counted anew: those that the moved samples belonged to, or all.
fn recount_later(world: &mut World, planet: Entity, moved: Option<&MovedSamples>) {
    let Some(mut census) = world.get_mut::<TerraneCensus>(planet) else {
        return;
    };
    match moved {
        Some(moved) => census.moved.extend(&moved.samples),
        None => census.stale = true,
    }
}

/// The plates that lost or gained samples.
enum Affected {
    All,
    Only(Vec<PlateId>),
}

impl Affected {
    fn contains(&self, plate: PlateId) -> bool {
        match self {
            Self::All => true,
            Self::Only(plates) => plates.contains(&plate),
        }
    }
}

/// Recomputes rims, overlap tables and statistics, where `moved` is given only those that it
/// touches, and removes plates that have no crust left.
fn recompute_frames(world: &mut World, planet: Entity, moved: Option<&MovedSamples>) {
    let Some((affected, stats)) = recompute_columns(world, planet, moved) else {
        return;
    };
    let consumed: Vec<PlateRow> = plate_table(world, planet)
        .rows()
        .iter()
        .copied()
        .filter(|row| affected.contains(row.id) && stats_of(&stats, row.id).is_none())
        .collect();
    // Numbers are not given twice: nobody would ask for these segments again.
    if let Some(mut polarity) = world.get_mut::<PolarityMemory>(planet) {
        polarity.retain(|id| consumed.iter().all(|row| row.id != id));
    }
    assign_stats(world, planet, &stats);
    recount_later(world, planet, moved);
    for row in consumed {
        world.despawn(row.entity);
        world.trigger(PlateConsumed {
            planet,
            plate: row.id,
        });
    }
}

/// The part of [`recompute_frames`] that reads and writes the planet's own columns. Returns the
/// statistics of the plates that are affected.
fn recompute_columns(
    world: &mut World,
    planet: Entity,
    moved: Option<&MovedSamples>,
) -> Option<(Affected, Vec<(PlateId, PlateStats)>)> {
    let mut query = world.query::<(
        (PlanetQuery, &Crust, &Frames),
        (&mut Rim, &mut OverlapIndex, &mut Contacts),
    )>();
    let (state, (mut rim, mut overlap, mut contacts)) = query.get_mut(world, planet).ok()?;
    let (body, crust, frames) = state;
    let PlanetView { mesh, radius, .. } = body.view();
    // Contacts are parallel to the rim as it was.
    let old_rim = rim.samples.clone();
    let affected = update_rim(&mut rim, mesh, &crust.frame, frames, moved);
    overlap.update(mesh, &crust.frame, frames);
    contacts.0 = kept_contacts(&old_rim, &contacts.0, &rim.samples);
    let stats = plate_stats(mesh, crust, frames, radius, |plate| {
        affected.contains(plate)
    });
    Some((affected, stats))
}

/// Updates the rims after samples have moved, or finds them anew. Returns the plates that lost or
/// gained samples.
fn update_rim(
    rim: &mut Rim,
    mesh: &SphereMesh,
    frame: &[FrameId],
    frames: &Frames,
    moved: Option<&MovedSamples>,
) -> Affected {
    // A rim that was never found has no index to update.
    match moved.filter(|_| !rim.index.is_empty()) {
        Some(moved) => {
            rim.update(mesh, frame, frames, &moved.samples);
            Affected::Only(moved.frames.iter().map(|&id| frames.plate(id)).collect())
        }
        None => {
            *rim = Rim::new(mesh, frame, frames);
            Affected::All
        }
    }
}

/// The statistics of a plate, if it has samples.
fn stats_of(stats: &[(PlateId, PlateStats)], id: PlateId) -> Option<PlateStats> {
    stats
        .iter()
        .find(|(other, stats)| *other == id && stats.samples > 0)
        .map(|(_, stats)| *stats)
}

/// Gives plates their statistics.
fn assign_stats(world: &mut World, planet: Entity, stats: &[(PlateId, PlateStats)]) {
    for row in plate_table(world, planet).rows() {
        if let Some(stats) = stats_of(stats, row.id) {
            world.entity_mut(row.entity).insert(stats);
        }
    }
}

/// Contacts are parallel to the rim. Those of samples that are still on it stay good enough for
/// pictures until the next step.
fn kept_contacts(old_rim: &[u32], contacts: &[Contact], rim: &[u32]) -> Vec<Contact> {
    let mut known = old_rim.iter().zip(contacts).peekable();
    rim.iter()
        .map(|&i| {
            while known.next_if(|(k, _)| **k < i).is_some() {}
            match known.peek() {
                Some((k, contact)) if **k == i => **contact,
                _ => Contact::default(),
            }
        })
        .collect()
}
