//! Carrying commands out, between two steps.

use super::check::direction_of;
use super::command::TectonicCommand;
use super::error::CommandError;
use super::events::{CommandApplied, CommandRejected};
use super::inbox::Inbox;
use super::paint::{CrustEdit, paint, set_plate_kind};
use super::scenario::{Recording, Scenario, TimedCommand};
use crate::crust::{Cause, Crust, Frames, Ledger, ledger};
use crate::params::{TectonicParams, within};
use crate::planet::{GeologicClock, planet_radius};
use crate::plate::{PlateId, PlateMotion, PlateRow, caches, plate_table};
use crate::process::rifting::{rift_along, rift_at_random};
use crate::resample::{SurfaceProjection, project_now};
use crate::schedule::StepCursor;
use crate::view::PlanetQuery;
use bevy::prelude::*;

/// Carries out all commands that are due: those of a scenario first, then those in the inbox.
///
/// A command that succeeds is recorded; one that fails is reported by [`CommandRejected`] and
/// changes nothing.
pub fn apply_pending(world: &mut World, planet: Entity) {
    let Some(step) = world.get::<GeologicClock>(planet).map(|clock| clock.step) else {
        return;
    };
    let due = take_due(world, planet, step);
    if due.is_empty() {
        return;
    }
    for command in due {
        match apply_now(world, planet, &command) {
            Ok(()) => world.trigger(CommandApplied { planet, command }),
            Err(error) => world.trigger(CommandRejected {
                planet,
                command,
                error,
            }),
        }
    }
    project_at_boundary(world, planet);
}

/// Carries out one command at once and records it: for tools, which look at the result instead of
/// hearing of it. The planet must stand between two steps.
///
/// # Errors
/// [`CommandError`]; nothing has changed then.
pub fn apply_now(
    world: &mut World,
    planet: Entity,
    command: &TectonicCommand,
) -> Result<(), CommandError> {
    let step = world
        .get::<GeologicClock>(planet)
        .ok_or(CommandError::NoPlanet)?
        .step;
    apply(world, planet, command)?;
    if let Some(mut recording) = world.get_mut::<Recording>(planet) {
        let command = command.clone();
        recording.0.push(TimedCommand { step, command });
    }
    Ok(())
}

fn take_due(world: &mut World, planet: Entity, step: u64) -> Vec<TectonicCommand> {
    let mut due = world
        .get_mut::<Scenario>(planet)
        .map_or_else(Vec::new, |mut scenario| scenario.take_due(step));
    if let Some(mut inbox) = world.get_mut::<Inbox>(planet) {
        due.append(&mut inbox.0);
    }
    due
}

/// Shows what commands have changed, where someone looks and no step is about to do so.
fn project_at_boundary(world: &mut World, planet: Entity) {
    let looked_at = world.get::<SurfaceProjection>(planet) == Some(&SurfaceProjection::EveryStep);
    let at_boundary = world
        .get::<StepCursor>(planet)
        .is_some_and(StepCursor::at_boundary);
    if looked_at && at_boundary {
        project_now(world, planet);
    }
}

fn apply(world: &mut World, planet: Entity, command: &TectonicCommand) -> Result<(), CommandError> {
    command.check()?;
    match command {
        TectonicCommand::SetPlateMotion { plate, pole, speed } => {
            set_motion(world, planet, *plate, *pole, *speed)?;
        }
        TectonicCommand::RiftPlate {
            plate,
            line,
            fragments,
        } => rift(world, planet, *plate, line, *fragments)?,
        TectonicCommand::SetPlateCrust { plate, kind } => {
            // An unknown plate is an error, not an edit of no samples.
            plate_row(world, planet, *plate)?;
            edit_crust(world, planet, |edit| set_plate_kind(edit, *plate, *kind))?;
        }
        TectonicCommand::PaintCrust { target, brush } => {
            edit_crust(world, planet, |edit| paint(edit, target, brush))?;
        }
        TectonicCommand::SetParam { name, value } => set_param(world, planet, name, *value)?,
        TectonicCommand::SetProcess { name, on } => {
            *params(world, planet)?.processes.get_mut(name)? = *on;
        }
        TectonicCommand::SetOceanFloor { law } => params(world, planet)?.ocean_floor = *law,
        TectonicCommand::Resample => {
            world
                .get_mut::<GeologicClock>(planet)
                .ok_or(CommandError::NoPlanet)?
                .resample_requested = true;
        }
    }
    Ok(())
}

fn params(world: &mut World, planet: Entity) -> Result<Mut<'_, TectonicParams>, CommandError> {
    world.get_mut(planet).ok_or(CommandError::NoPlanet)
}

fn plate_row(world: &World, planet: Entity, plate: PlateId) -> Result<PlateRow, CommandError> {
    plate_table(world, planet)
        .get(plate)
        .copied()
        .ok_or(CommandError::NoPlate(plate))
}

fn set_motion(
    world: &mut World,
    planet: Entity,
    id: PlateId,
    pole: (f64, f64),
    speed: f64,
) -> Result<(), CommandError> {
    let axis = direction_of(pole)?;
    let limit = params(world, planet)?.max_speed;
    within("speed", speed, -limit, limit)?;
    let row = plate_row(world, planet, id)?;
    let radius = planet_radius(world, planet);
    // Plates turn counter-clockwise about their axis: a negative speed turns the axis round.
    let axis = if speed < 0.0 { -axis } else { axis };
    world.entity_mut(row.entity).insert(PlateMotion {
        axis,
        speed: speed.abs() / radius,
    });
    Ok(())
}

/// Breaks a plate along a line, or at random where there is none.
fn rift(
    world: &mut World,
    planet: Entity,
    plate: PlateId,
    line: &[(f64, f64)],
    fragments: u32,
) -> Result<(), CommandError> {
    if line.is_empty() {
        rift_at_random(world, planet, plate, Some(fragments))?;
    } else {
        let points = line
            .iter()
            .map(|&point| direction_of(point))
            .collect::<Result<_, _>>()?;
        rift_along(world, planet, plate, points)?;
    }
    Ok(())
}

fn set_param(
    world: &mut World,
    planet: Entity,
    name: &str,
    value: f64,
) -> Result<(), CommandError> {
    let mut present = params(world, planet)?;
    // A copy is checked first: a refused value changes nothing.
    let mut wanted = present.clone();
    wanted.set(name, value)?;
    wanted.validate()?;
    let limit = wanted.max_speed;
    *present = wanted;
    slow_down(world, planet, limit);
    Ok(())
}

/// Holds all plates to the highest speed `limit` in km/My, which may be lower than it was.
fn slow_down(world: &mut World, planet: Entity, limit: f64) {
    let limit = limit / planet_radius(world, planet);
    for row in plate_table(world, planet).rows() {
        if row.motion.speed > limit {
            world
                .entity_mut(row.entity)
                .insert(row.motion.limited(limit));
        }
    }
}

/// Lets `edit` change the crust and books what it does to the continents.
fn edit_crust(
    world: &mut World,
    planet: Entity,
    edit: impl FnOnce(&mut CrustEdit),
) -> Result<(), CommandError> {
    let mut query = world.query::<(PlanetQuery, &Frames, &mut Crust, &mut Ledger)>();
    let (body, frames, mut crust, mut ledger) = query
        .get_mut(world, planet)
        .map_err(|_| CommandError::NoPlanet)?;
    let view = body.view();
    // Edits do not say what they add: the difference does.
    let before = ledger::measure(&crust, view.mesh, view.radius);
    edit(&mut CrustEdit {
        planet: view,
        frames,
        crust: &mut crust,
    });
    let after = ledger::measure(&crust, view.mesh, view.radius);
    let (area, volume) = (after.area - before.area, after.volume - before.volume);
    ledger.book(Cause::Command, area, volume);
    caches::recompute_stats(world, planet);
    Ok(())
}
