//! The end of a step: the clock ticks, and the ledger is compared with what is there.

use crate::crust::ledger::measure;
use crate::crust::{Crust, Ledger};
use crate::events::StepCompleted;
use crate::planet::GeologicClock;
use crate::resample::Resampling;
use crate::schedule::{CurrentPlanet, Stage, TectonicStep, TectonicSystems};
use crate::view::PlanetQuery;
use bevy::prelude::*;

/// Adds [`commit`] to the step.
pub struct CommitPlugin;

impl Plugin for CommitPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            commit.in_set(TectonicSystems::Process(Stage::Commit)),
        );
    }
}

/// Ends the step of the current planet.
pub fn commit(
    current: Res<CurrentPlanet>,
    mut planets: Query<(
        (PlanetQuery, &Crust, &Resampling),
        (&mut GeologicClock, &mut Ledger),
    )>,
    mut commands: Commands,
) {
    let Ok((input, (mut clock, mut ledger))) = planets.get_mut(current.0) else {
        return;
    };
    let (planet, crust, resampling) = input;
    let view = planet.view();
    ledger.check(measure(crust, view.mesh, view.radius));
    clock.step += 1;
    clock.time += view.params.time_step;
    clock.since_resample = if resampling.done {
        0
    } else {
        clock.since_resample + 1
    };
    commands.trigger(StepCompleted {
        planet: current.0,
        step: clock.step,
        time: clock.time,
    });
}
