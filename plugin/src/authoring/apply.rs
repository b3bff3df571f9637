//! Carrying commands out, between two steps.

use super::Inbox;
use super::check::{direction_of, within};
use super::command::TectonicCommand;
use super::paint::{self, paint};
use super::scenario::{Recording, Scenario, TimedCommand};
use crate::crust::{Cause, Crust, Frames, Ledger};
use crate::events::{CommandApplied, CommandRejected};
use crate::params::{ParamError, TectonicParams};
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::{PlateId, PlateMotion};
use crate::process::rifting::{RiftError, rift_along, rift_at_random};
use crate::process::{planet_radius, plate_table};
use crate::schedule::CurrentPlanet;
use bevy::prelude::*;
use thiserror::Error;

/// Why a command was refused.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum CommandError {
    /// The plate does not exist, or no longer.
    #[error("there is no plate {}", .0.0)]
    NoPlate(PlateId),
    /// A number is outside of its limits, or no number.
    #[error("{field} = {} is outside of {min}..={max}", crate::params::shown(*value))]
    OutOfRange {
        /// The field.
        field: &'static str,
        /// The refused value.
        value: f64,
        /// Smallest allowed value.
        min: f64,
        /// Largest allowed value.
        max: f64,
    },
    /// The parameter or its value is refused.
    #[error(transparent)]
    Param(#[from] ParamError),
    /// The plate does not rift.
    #[error(transparent)]
    Rift(#[from] RiftError),
}

/// The stage of a step in which commands take effect.
pub fn commands(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    if let Some(mut resampling) = world.get_mut::<crate::resample::Resampling>(planet) {
        resampling.done = false;
    }
    apply_pending(world, planet);
}

/// Carries out all commands that are due: those of a scenario first, then those in the inbox.
///
/// What succeeds is recorded, what fails is reported by [`CommandRejected`] and changes nothing.
pub fn apply_pending(world: &mut World, planet: Entity) {
    let Some(step) = world.get::<GeologicClock>(planet).map(|clock| clock.step) else {
        return;
    };
    let mut due = Vec::new();
    if let Some(mut scenario) = world.get_mut::<Scenario>(planet) {
        due = scenario.take_due(step);
    }
    if let Some(mut inbox) = world.get_mut::<Inbox>(planet) {
        due.append(&mut inbox.0);
    }
    let changed = !due.is_empty();
    for command in due {
        match apply(world, planet, &command) {
            Ok(()) => {
                if let Some(mut recording) = world.get_mut::<Recording>(planet) {
                    recording.0.push(TimedCommand {
                        step,
                        command: command.clone(),
                    });
                }
                world.trigger(CommandApplied { planet, command });
            }
            Err(error) => world.trigger(CommandRejected {
                planet,
                command,
                error,
            }),
        }
    }
    let looked_at = world.get::<crate::resample::SurfaceDemand>(planet)
        == Some(&crate::resample::SurfaceDemand::EveryStep);
    let at_boundary = world
        .get::<crate::schedule::StepCursor>(planet)
        .is_some_and(|c| c.at_boundary());
    if changed && looked_at && at_boundary {
        crate::resample::project_now(world, planet);
    }
}

/// Carries out one command.
///
/// # Errors
/// [`CommandError`]; nothing has changed then.
pub fn apply(
    world: &mut World,
    planet: Entity,
    command: &TectonicCommand,
) -> Result<(), CommandError> {
    command.check()?;
    match command {
        TectonicCommand::SetPlateMotion { plate, pole, speed } => {
            set_motion(world, planet, *plate, *pole, *speed)
        }
        TectonicCommand::RiftPlate {
            plate,
            line,
            fragments,
        } => {
            if line.is_empty() {
                rift_at_random(world, planet, *plate, Some(*fragments))?;
            } else {
                let points = line
                    .iter()
                    .map(|&p| direction_of(p))
                    .collect::<Result<_, _>>()?;
                rift_along(world, planet, *plate, points)?;
            }
            Ok(())
        }
        TectonicCommand::SetPlateCrust { plate, kind } => {
            if plate_table(world, planet).get(*plate).is_none() {
                return Err(CommandError::NoPlate(*plate));
            }
            edit_crust(world, planet, |scene| {
                paint::kind_of_plate(scene, *plate, *kind)
            })
        }
        TectonicCommand::PaintCrust { target, brush } => {
            edit_crust(world, planet, |scene| paint(scene, target, brush))
        }
        TectonicCommand::SetParam { name, value } => {
            let Some(mut params) = world.get_mut::<TectonicParams>(planet) else {
                return Ok(());
            };
            let mut wanted = params.clone();
            wanted.set(name, *value)?;
            wanted.validate()?;
            *params = wanted;
            slow_down(world, planet);
            Ok(())
        }
        TectonicCommand::SetProcess { name, on } => {
            let Some(mut params) = world.get_mut::<TectonicParams>(planet) else {
                return Ok(());
            };
            *params.processes.get_mut(name)? = *on;
            Ok(())
        }
        TectonicCommand::SetOceanFloor { law } => {
            let Some(mut params) = world.get_mut::<TectonicParams>(planet) else {
                return Ok(());
            };
            params.ocean_floor = *law;
            Ok(())
        }
        TectonicCommand::Resample => {
            if let Some(mut clock) = world.get_mut::<GeologicClock>(planet) {
                clock.resample_requested = true;
            }
            Ok(())
        }
    }
}

fn set_motion(
    world: &mut World,
    planet: Entity,
    id: PlateId,
    pole: (f64, f64),
    speed: f64,
) -> Result<(), CommandError> {
    let axis = direction_of(pole)?;
    let limit = world
        .get::<TectonicParams>(planet)
        .map_or(100.0, |params| params.max_speed);
    within("speed", speed, -limit, limit)?;
    let row = *plate_table(world, planet)
        .get(id)
        .ok_or(CommandError::NoPlate(id))?;
    let radius = planet_radius(world, planet);
    let axis = if speed < 0.0 { -axis } else { axis };
    world.entity_mut(row.entity).insert(PlateMotion {
        axis,
        speed: speed.abs() / radius,
    });
    Ok(())
}

/// Holds all plates to the highest speed, which may be lower than it was.
fn slow_down(world: &mut World, planet: Entity) {
    let limit = world
        .get::<TectonicParams>(planet)
        .map_or(f64::INFINITY, |params| params.max_speed);
    let radius = planet_radius(world, planet);
    for row in plate_table(world, planet)
        .rows()
        .iter()
        .filter(|row| row.motion.speed > limit / radius)
    {
        world
            .entity_mut(row.entity)
            .insert(row.motion.limited(limit / radius));
    }
}

/// Lets `edit` change the crust and books what it does to the continents.
fn edit_crust(
    world: &mut World,
    planet: Entity,
    edit: impl FnOnce(&mut paint::Scene),
) -> Result<(), CommandError> {
    let mut query = world.query::<(
        &Planet,
        &Lattice,
        &TectonicParams,
        &Frames,
        &mut Crust,
        &mut Ledger,
    )>();
    let Ok((body, mesh, params, frames, mut crust, mut ledger)) = query.get_mut(world, planet)
    else {
        return Ok(());
    };
    let before = crate::crust::ledger::measure(&crust, mesh, body.radius);
    edit(&mut paint::Scene {
        mesh,
        params,
        frames,
        radius: body.radius,
        crust: &mut crust,
    });
    let after = crate::crust::ledger::measure(&crust, mesh, body.radius);
    ledger.book(
        Cause::Command,
        after.area - before.area,
        after.volume - before.volume,
    );
    crate::resample::recount(world, planet);
    Ok(())
}
