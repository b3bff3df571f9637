//! Terranes as entities: what they are is brought up to date once a step (paper 000 §3).
//!
//! Whatever moves samples between frames, or changes their kind, marks the census stale. At the end
//! of the step, and of commands given between two steps, the terranes are found anew. Drift only
//! takes their centroids along.
//!
//! Reads: frames, kinds, motions. Writes: terranes.

use super::commit::commit;
use crate::math::rotation;
use crate::params::TectonicParams;
use crate::plate::caches::recompute_terranes;
use crate::plate::terrane::{Terrane, TerraneCensus, Terranes};
use crate::plate::{PlateMotion, Plates};
use crate::schedule::{
    BetweenSteps, BetweenStepsSystems, CurrentPlanet, Stage, TectonicStep, TectonicSystems,
};
use bevy::prelude::*;

/// Adds [`carry_terranes`] and [`census`] to the step.
pub struct TerranePlugin;

impl Plugin for TerranePlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            (
                carry_terranes.in_set(TectonicSystems::Process(Stage::Drift)),
                census
                    .in_set(TectonicSystems::Process(Stage::Commit))
                    .after(commit),
            ),
        )
        .add_systems(BetweenSteps, census.in_set(BetweenStepsSystems::Caches));
    }
}

/// Takes the centroids of the current planet's terranes along with their plates.
pub fn carry_terranes(
    current: Res<CurrentPlanet>,
    planets: Query<(&TectonicParams, &Plates)>,
    plates: Query<(&PlateMotion, &Terranes)>,
    mut terranes: Query<&mut Terrane>,
) {
    let Ok((params, of_planet)) = planets.get(current.0) else {
        return;
    };
    if !params.processes.drift {
        return;
    }
    for (motion, of_plate) in plates.iter_many(of_planet.iter()) {
        let turn = rotation(motion.axis, motion.speed * params.time_step);
        let mut terranes = terranes.iter_many_mut(of_plate.iter());
        while let Some(mut terrane) = terranes.fetch_next() {
            terrane.centroid = (turn * terrane.centroid).normalize();
        }
    }
}

/// Finds the terranes of the current planet anew if they are out of date.
pub fn census(world: &mut World) {
    let planet = world.resource::<CurrentPlanet>().0;
    let census = world.get::<TerraneCensus>(planet);
    if census.is_some_and(|census| census.stale) {
        recompute_terranes(world, planet);
    }
}
