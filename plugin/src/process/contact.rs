//! Contact: where plates meet, and which goes under (paper 000 §6); the geometry is in
//! [`crate::plate::contact`].

use crate::crust::{Crust, Frames};
use crate::plate::PlateAccess;
use crate::plate::boundary::Rim;
use crate::plate::contact::{ContactInput, Contacts, find_contacts};
use crate::plate::overlap::OverlapIndex;
use crate::plate::polarity::PolarityMemory;
use crate::schedule::{Stage, TectonicStep, TectonicSystems};
use crate::view::PlanetQuery;
use bevy::prelude::*;

/// Adds [`contact`] to the step.
pub struct ContactPlugin;

impl Plugin for ContactPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            contact.in_set(TectonicSystems::Process(Stage::Contact)),
        );
    }
}

/// Finds the contacts of the current planet.
pub fn contact(
    plates: PlateAccess,
    mut planets: Query<(
        (PlanetQuery, &Crust, &Frames, &Rim),
        (&mut OverlapIndex, &mut Contacts, &mut PolarityMemory),
    )>,
) {
    let Ok((state, (mut overlap, mut contacts, mut polarity))) = planets.get_mut(plates.planet())
    else {
        return;
    };
    let (planet, crust, frames, rim) = state;
    let view = planet.view();
    // Drift has turned the frames since the table of the world was made.
    overlap.turn(frames);
    let table = plates.table();
    let input = ContactInput {
        mesh: view.mesh,
        crust,
        frames,
        overlap: &overlap,
        plates: &table,
        radius: view.radius,
    };
    *contacts = find_contacts(&input, rim, &mut polarity, view.params.polarity_hysteresis);
}
