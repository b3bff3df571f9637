//! The plugin that carries commands out.

use super::apply_pending;
use crate::schedule::{
    BetweenSteps, BetweenStepsSystems, CurrentPlanet, Stage, TectonicStep, TectonicSystems,
};
use bevy::prelude::*;

/// Carries commands out: in [`Stage::Commands`] of a step, and at once while a planet rests.
pub struct AuthoringPlugin;

impl Plugin for AuthoringPlugin {
    fn build(&self, app: &mut App) {
        let commands = TectonicSystems::Process(Stage::Commands);
        app.add_systems(TectonicStep, apply_to_current.in_set(commands))
            .add_systems(
                BetweenSteps,
                apply_to_current.in_set(BetweenStepsSystems::Commands),
            );
    }
}

fn apply_to_current(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    apply_pending(world, planet);
}
