//! Everything that follows from the state: found again after a load, and whenever frames gain or
//! lose samples.

use crate::crust::cover::CoverIndex;
use crate::crust::terrane::census;
use crate::crust::{Crust, FrameId, Frames};
use crate::events::PlateConsumed;
use crate::params::TectonicParams;
use crate::planet::{Lattice, Planet};
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contact, ContactInput, Contacts, find_contacts};
use crate::plate::polarity::PolarityMemory;
use crate::plate::stats::plate_stats;
use crate::plate::{PlateId, PlateStats};
use crate::process::front::FrontField;
use crate::process::plate_table;
use bevy::prelude::*;

/// Renews what depends on which samples a frame has: rims, candidate tables, distances to fronts
/// and plate statistics. Plates without crust are removed.
pub fn rebuild(world: &mut World, planet: Entity) {
    renew(world, planet, None);
    if let Some(mut fronts) = world.get_mut::<FrontField>(planet) {
        fronts.stale = true;
    }
}

/// Samples that went to other frames.
#[derive(Clone, Debug, Default)]
pub struct Moved {
    /// The samples, in order.
    pub samples: Vec<u32>,
    /// The frames that lost or gained them.
    pub frames: Vec<FrameId>,
}

/// The same as [`rebuild`] where only a few samples have moved. What does not touch them stays as
/// it was.
pub fn rebuild_moved(world: &mut World, planet: Entity, moved: &Moved) {
    renew(world, planet, Some(moved));
    let mut query = world.query::<(&Crust, &mut FrontField)>();
    if let Ok((crust, mut fronts)) = query.get_mut(world, planet) {
        fronts.forget(&crust.frame, &moved.frames);
    }
}

/// Renews the statistics of all plates after crust has changed its kind.
pub fn recount(world: &mut World, planet: Entity) {
    let mut query = world.query::<(&Planet, &Lattice, &Crust, &Frames)>();
    let Ok((body, lattice, crust, frames)) = query.get(world, planet) else {
        return;
    };
    let stats = plate_stats(lattice, crust, frames, body.radius, |_| true);
    take_over(world, planet, &stats);
}

fn renew(world: &mut World, planet: Entity, moved: Option<&Moved>) {
    let mut query = world.query::<(
        (&Planet, &Lattice, &Crust, &Frames),
        (&mut Rim, &mut CoverIndex, &mut Contacts),
    )>();
    let Ok(((body, lattice, crust, frames), derived)) = query.get_mut(world, planet) else {
        return;
    };
    let (mut rim, mut cover, mut contacts) = derived;
    let old = rim.samples.clone();
    let known = moved.filter(|_| !rim.index.is_empty());
    match known {
        Some(moved) => rim.renew(lattice, &crust.frame, frames, &moved.samples),
        None => *rim = Rim::new(lattice, &crust.frame, frames),
    }
    cover.renew(lattice, &crust.frame, frames);
    contacts.0 = carried(&old, &contacts.0, &rim.samples);
    let touched: Option<Vec<PlateId>> =
        known.map(|m| m.frames.iter().map(|&id| frames.plate(id)).collect());
    let counted = |plate: PlateId| {
        touched
            .as_ref()
            .is_none_or(|touched| touched.contains(&plate))
    };
    let stats = plate_stats(lattice, crust, frames, body.radius, counted);
    let gone = |id: PlateId| counted(id) && of_plate(&stats, id).is_none();
    let gone: Vec<_> = plate_table(world, planet)
        .rows()
        .iter()
        .copied()
        .filter(|row| gone(row.id))
        .collect();
    if let Some(mut polarity) = world.get_mut::<PolarityMemory>(planet) {
        polarity.retain(|id| gone.iter().all(|row| row.id != id));
    }
    take_over(world, planet, &stats);
    for row in gone {
        world.despawn(row.entity);
        world.trigger(PlateConsumed {
            planet,
            plate: row.id,
        });
    }
}

/// The statistics of a plate, if it has samples.
fn of_plate(stats: &[(PlateId, PlateStats)], id: PlateId) -> Option<PlateStats> {
    stats
        .iter()
        .find(|(other, stats)| *other == id && stats.samples > 0)
        .map(|(_, stats)| *stats)
}

/// Gives plates their statistics.
fn take_over(world: &mut World, planet: Entity, stats: &[(PlateId, PlateStats)]) {
    for row in plate_table(world, planet).rows() {
        if let Some(stats) = of_plate(stats, row.id) {
            world.entity_mut(row.entity).insert(stats);
        }
    }
}

/// Contacts are parallel to the rim. What was known of samples that are still on it stays good
/// enough for pictures until the next step.
fn carried(old: &[u32], contacts: &[Contact], rim: &[u32]) -> Vec<Contact> {
    let mut known = old.iter().zip(contacts).peekable();
    let contact = |&i: &u32| {
        while known.next_if(|(k, _)| **k < i).is_some() {}
        known
            .peek()
            .filter(|(k, _)| **k == i)
            .map_or_else(Contact::default, |(_, contact)| **contact)
    };
    rim.iter().map(contact).collect()
}

/// Finds everything that a planet derives from its state, after it was made or loaded, and projects
/// its surface.
pub fn refresh(world: &mut World, planet: Entity) {
    renew(world, planet, None);
    look_for_contacts(world, planet);
    take_census(world, planet);
    super::project_now(world, planet);
}

/// Finds contacts for pictures, until the next step finds its own: looking must not change the
/// memory of polarity.
pub(super) fn look_for_contacts(world: &mut World, planet: Entity) {
    let plates = &plate_table(world, planet);
    let mut query = world.query::<(
        (&Planet, &Lattice, &TectonicParams, &Crust, &Frames, &Rim),
        (&CoverIndex, &PolarityMemory, &mut Contacts),
    )>();
    if let Ok((input, (cover, polarity, mut contacts))) = query.get_mut(world, planet) {
        let (body, mesh, params, crust, frames, rim) = input;
        let input = ContactInput {
            mesh,
            crust,
            frames,
            cover,
            plates,
            radius: body.radius,
        };
        *contacts = find_contacts(
            &input,
            rim,
            &mut polarity.clone(),
            params.polarity_hysteresis,
        );
    }
}

/// Counts the terranes of all plates anew.
pub(super) fn take_census(world: &mut World, planet: Entity) {
    let table = plate_table(world, planet);
    let mut query = world.query::<(&Planet, &Lattice, &Crust, &Frames)>();
    let Ok((body, lattice, crust, frames)) = query.get(world, planet) else {
        return;
    };
    let found = census(lattice, crust, frames, body.radius);
    for row in table.rows() {
        world
            .entity_mut(row.entity)
            .despawn_related::<crate::crust::Terranes>();
    }
    for (plate, terrane) in found {
        if let Some(row) = table.get(plate) {
            world.spawn((crate::crust::TerraneOf(row.entity), terrane));
        }
    }
}
