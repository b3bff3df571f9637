//! Everything that follows from the state: found again after a load, and whenever frames gain or lose samples.

use crate::crust::cover::CoverIndex;
use crate::crust::terrane::census;
use crate::crust::{Crust, Frames};
use crate::events::PlateConsumed;
use crate::params::TectonicParams;
use crate::planet::{Lattice, Planet};
use crate::plate::PlateId;
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contact, ContactInput, Contacts, PolarityMemory, find_contacts};
use crate::plate::stats::plate_stats;
use crate::process::plate_table;
use bevy::prelude::*;

/// Renews what depends on which samples a frame has: rims, candidate tables and plate statistics. Plates
/// without crust are removed.
pub fn rebuild(world: &mut World, planet: Entity) {
    renew(world, planet, None);
}

/// The same where only the samples `changed`, in order, have gone to other frames.
pub fn rebuild_changed(world: &mut World, planet: Entity, changed: &[u32]) {
    renew(world, planet, Some(changed));
}

fn renew(world: &mut World, planet: Entity, changed: Option<&[u32]>) {
    let mut query = world.query::<(
        (&Planet, &Lattice, &Crust, &Frames),
        (&mut Rim, &mut CoverIndex, &mut PolarityMemory, &mut Contacts),
    )>();
    let Ok(((body, lattice, crust, frames), derived)) = query.get_mut(world, planet) else { return };
    let (mut rim, mut cover, mut polarity, mut contacts) = derived;
    let old: Vec<u32> = rim.samples.clone();
    match changed {
        Some(changed) if !rim.index.is_empty() => rim.renew(lattice, &crust.frame, frames, changed),
        _ => *rim = Rim::new(lattice, &crust.frame, frames),
    }
    cover.renew(lattice, &crust.frame, frames);
    contacts.0 = carried(&old, &contacts.0, &rim.samples);
    let stats = plate_stats(lattice, crust, frames, body.radius);
    let alive = |id: PlateId| stats.iter().any(|(other, stats)| *other == id && stats.samples > 0);
    polarity.retain(alive);
    for row in plate_table(world, planet).rows() {
        match stats.iter().find(|(id, stats)| *id == row.id && stats.samples > 0) {
            Some((_, stats)) => {
                world.entity_mut(row.entity).insert(*stats);
            }
            None => {
                world.despawn(row.entity);
                world.trigger(PlateConsumed { planet, plate: row.id });
            }
        }
    }
}

/// Contacts are parallel to the rim. What was known of samples that are still on it stays good enough for
/// pictures until the next step.
fn carried(old: &[u32], contacts: &[Contact], rim: &[u32]) -> Vec<Contact> {
    let mut known = old.iter().zip(contacts).peekable();
    let contact = |&i: &u32| {
        while known.next_if(|(k, _)| **k < i).is_some() {}
        known.peek().filter(|(k, _)| **k == i).map_or_else(Contact::default, |(_, contact)| **contact)
    };
    rim.iter().map(contact).collect()
}

/// Finds everything that a planet derives from its state, after it was made or loaded, and projects its surface.
pub fn refresh(world: &mut World, planet: Entity) {
    rebuild(world, planet);
    look_for_contacts(world, planet);
    take_census(world, planet);
    super::project_now(world, planet);
}

/// Finds contacts for pictures, until the next step finds its own: looking must not change the memory of polarity.
pub(super) fn look_for_contacts(world: &mut World, planet: Entity) {
    let plates = &plate_table(world, planet);
    let mut query = world.query::<(
        (&Planet, &Lattice, &TectonicParams, &Crust, &Frames, &Rim),
        (&CoverIndex, &PolarityMemory, &mut Contacts),
    )>();
    if let Ok((input, (cover, polarity, mut contacts))) = query.get_mut(world, planet) {
        let (body, mesh, params, crust, frames, rim) = input;
        let input = ContactInput { mesh, crust, frames, cover, plates, radius: body.radius };
        *contacts = find_contacts(&input, rim, &mut polarity.clone(), params.polarity_hysteresis);
    }
}

/// Counts the terranes of all plates anew.
pub(super) fn take_census(world: &mut World, planet: Entity) {
    let table = plate_table(world, planet);
    let mut query = world.query::<(&Planet, &Lattice, &Crust, &Frames)>();
    let Ok((body, lattice, crust, frames)) = query.get(world, planet) else { return };
    let found = census(lattice, crust, frames, body.radius);
    for row in table.rows() {
        world.entity_mut(row.entity).despawn_related::<crate::crust::Terranes>();
    }
    for (plate, terrane) in found {
        if let Some(row) = table.get(plate) {
            world.spawn((crate::crust::TerraneOf(row.entity), terrane));
        }
    }
}
