//! The end of a step: the clock ticks, and the ledger is compared with what is there.
//!
//! Reads: crust. Writes: clock, ledger.

use crate::crust::ledger::measure;
use crate::crust::{Crust, Ledger};
use crate::events::StepCompleted;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::resample::Resampling;
use crate::schedule::{CurrentPlanet, Stage, TectonicStep, TectonicSystems};
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
        (&Planet, &Lattice, &TectonicParams, &Crust, &Resampling),
        (&mut GeologicClock, &mut Ledger),
    )>,
    mut commands: Commands,
) {
    let Ok((input, (mut clock, mut ledger))) = planets.get_mut(current.0) else {
        return;
    };
    let (planet, lattice, params, crust, resampling) = input;
    ledger.check(measure(crust, lattice, planet.radius));
    clock.step += 1;
    clock.time += params.time_step;
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
