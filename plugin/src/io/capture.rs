//! From a planet in a world to its state.

use crate::authoring::{Inbox, Recording, Scenario, TimedCommand};
use crate::crust::{Crust, Frames, Ledger};
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet, PlateNumbers};
use crate::plate::front::FrontField;
use crate::plate::polarity::PolarityMemory;
use crate::plate::{Plate, PlateId, PlateMotion, PlateStats, Plates};
use crate::schedule::StepCursor;
use crate::spawn::PlanetState;
use bevy::prelude::*;

/// Copies the state of a planet out of its world, plates in the order of their numbers.
///
/// `None` if the entity is no planet, or while it is in the middle of a step. Commands that wait in
/// its inbox are part of the state, as those of a scenario are that have still to come.
pub fn capture(world: &World, planet: Entity) -> Option<PlanetState> {
    let entity = world.get_entity(planet).ok()?;
    if entity
        .get::<StepCursor>()
        .is_some_and(|cursor| !cursor.at_boundary())
    {
        return None;
    }
    let mut rows: Vec<((PlateId, PlateMotion, f64), PlateStats)> = Vec::new();
    for plate in entity
        .get::<Plates>()
        .into_iter()
        .flat_map(|plates| plates.iter())
    {
        let plate = world.get_entity(plate).ok()?;
        let row = (
            *plate.get::<PlateId>()?,
            *plate.get::<PlateMotion>()?,
            plate.get::<Plate>()?.born,
        );
        rows.push((row, *plate.get::<PlateStats>()?));
    }
    rows.sort_by_key(|&((id, ..), _)| id);
    let (plates, stats) = rows.into_iter().unzip();
    Some(PlanetState {
        planet: *entity.get::<Planet>()?,
        lattice: entity.get::<Lattice>()?.clone(),
        crust: entity.get::<Crust>()?.clone(),
        frames: entity.get::<Frames>()?.clone(),
        plates,
        stats,
        clock: entity.get::<GeologicClock>()?.clone(),
        numbers: *entity.get::<PlateNumbers>()?,
        params: entity.get::<TectonicParams>()?.clone(),
        ledger: entity.get::<Ledger>()?.clone(),
        recording: entity.get::<Recording>()?.clone(),
        pending: pending(entity)?,
        polarity: entity.get::<PolarityMemory>()?.clone(),
        fronts: entity.get::<FrontField>()?.clone(),
    })
}

/// What is left of the scenario, and the inbox: its commands are due now, after those of the
/// scenario.
fn pending(planet: EntityRef) -> Option<Scenario> {
    let step = planet.get::<GeologicClock>()?.step;
    let mut pending = planet.get::<Scenario>().cloned().unwrap_or_default();
    let waiting = planet.get::<Inbox>().into_iter().flat_map(|inbox| &inbox.0);
    pending.0.extend(waiting.map(|command| TimedCommand {
        step,
        command: command.clone(),
    }));
    Some(pending)
}
