//! From a planet in a world to its state.

use crate::authoring::{Inbox, Recording, Scenario, TimedCommand};
use crate::climate::ClimateMaps;
use crate::crust::{Crust, Frames, Ledger};
use crate::hydrology::TerrainMaps;
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
///
/// ```
/// use bevy::prelude::*;
/// use bevy_pangaea::schedule::run_steps;
/// use bevy_pangaea::{io, prelude::*, spawn::PlanetState};
///
/// let mut app = App::new();
/// app.add_plugins(PangaeaPlugins);
/// let recipe = PlanetRecipe { samples: 1000, plate_count: 8, ..default() };
/// let planet = PlanetState::new(&recipe)?.spawn(app.world_mut());
/// run_steps(app.world_mut(), planet, 3);
///
/// let state = io::capture(app.world(), planet).ok_or("in the middle of a step")?;
/// assert_eq!(state.clock.step, 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn capture(world: &World, planet: Entity) -> Option<PlanetState> {
    let entity = world.get_entity(planet).ok()?;
    // In the middle of a step, columns are of two times.
    if entity
        .get::<StepCursor>()
        .is_some_and(|cursor| !cursor.at_boundary())
    {
        return None;
    }
    let (plates, stats) = plates(world, entity.get::<Plates>())?;
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
        climate: entity.get::<ClimateMaps>().cloned().unwrap_or_default(),
        terrain: entity.get::<TerrainMaps>().cloned(),
    })
}

/// The plates in order of their numbers: number, motion, time of birth in My; and what each is made
/// of.
fn plates(
    world: &World,
    plates: Option<&Plates>,
) -> Option<(Vec<(PlateId, PlateMotion, f64)>, Vec<PlateStats>)> {
    let mut rows = Vec::new();
    for plate in plates.into_iter().flat_map(Plates::iter) {
        let plate = world.get_entity(plate).ok()?;
        let id = *plate.get::<PlateId>()?;
        let motion = *plate.get::<PlateMotion>()?;
        let born = plate.get::<Plate>()?.born;
        rows.push(((id, motion, born), *plate.get::<PlateStats>()?));
    }
    rows.sort_by_key(|&((id, ..), _)| id);
    Some(rows.into_iter().unzip())
}

/// The commands of the scenario that have still to come, and the inbox: its commands are due now,
/// after those of the scenario.
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
