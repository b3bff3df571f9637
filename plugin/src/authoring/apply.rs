//! Carrying commands out, between two steps.

use super::Inbox;
use super::check::{direction_of, within};
use super::command::TectonicCommand;
use super::error::CommandError;
use super::events::{CommandApplied, CommandRejected};
use super::paint::{self, paint};
use super::scenario::{Recording, Scenario, TimedCommand};
use crate::crust::{Cause, Crust, Frames, Ledger};
use crate::params::TectonicParams;
use crate::planet::planet_radius;
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::plate_table;
use crate::plate::{PlateId, PlateMotion};
use crate::process::rifting::{rift_along, rift_at_random};
use bevy::prelude::*;

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
    let looked_at = world.get::<crate::resample::SurfaceProjection>(planet)
        == Some(&crate::resample::SurfaceProjection::EveryStep);
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
fn apply(world: &mut World, planet: Entity, command: &TectonicCommand) -> Result<(), CommandError> {
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
    crate::plate::caches::recompute_stats(world, planet);
    Ok(())
}
