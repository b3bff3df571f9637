//! Terranes as entities: brought up to date at the end of each step (paper 000 §3).
//!
//! Land that rises is added to the census, terranes of crust that changed its frame are counted
//! again; only a resample asks for a new census.

use super::commit::commit;
use crate::crust::{Crust, Frames};
use crate::plate::census::{TerraneCensus, recount_terranes};
use crate::plate::terrane::{Terrane, TerraneOf, Terranes};
use crate::plate::{PlateAccess, Plates};
use crate::schedule::{
    BetweenSteps, BetweenStepsSystems, CurrentPlanet, Stage, TectonicStep, TectonicSystems,
};
use crate::view::{PlanetQuery, PlanetView};
use bevy::prelude::*;

/// Adds [`census`] and [`refresh_terranes`] to the step.
pub struct TerranePlugin;

impl Plugin for TerranePlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            (census, refresh_terranes)
                .chain()
                .in_set(TectonicSystems::Process(Stage::Commit))
                // Whoever hears that the step is over finds its terranes.
                .before(commit),
        )
        .add_systems(
            BetweenSteps,
            (census, refresh_terranes)
                .chain()
                .in_set(BetweenStepsSystems::Caches),
        );
    }
}

/// Counts the land of the current planet that has risen or moved since the last census, or all of it
/// if that census is stale.
pub fn census(
    plates: PlateAccess,
    mut planets: Query<(PlanetQuery, &Crust, &Frames, &mut TerraneCensus)>,
    mut commands: Commands,
) {
    let planet = plates.planet();
    let Ok((body, crust, frames, mut census)) = planets.get_mut(planet) else {
        return;
    };
    if census.stale {
        commands.queue(move |world: &mut World| recount_terranes(world, planet));
        return;
    }
    let PlanetView { mesh, radius, .. } = body.view();
    let known = census.len();
    census.catch_up(mesh, crust);
    if census.len() == known {
        return;
    }
    let plates = plates.table();
    for number in known..census.len() {
        let terrane = census.terrane(number, frames, radius);
        let row = terrane
            .as_ref()
            .and_then(|terrane| plates.get(frames.plate(terrane.frame)));
        if let (Some(terrane), Some(row)) = (terrane, row) {
            commands.spawn((TerraneOf(row.entity), terrane));
        }
    }
}

/// Gives the terranes of the current planet the size that they were counted with, and the place
/// that they have drifted to; those that were joined to others go.
pub fn refresh_terranes(
    current: Res<CurrentPlanet>,
    planets: Query<(PlanetQuery, &Frames, &TerraneCensus, &Plates)>,
    plates: Query<&Terranes>,
    mut terranes: Query<(Entity, &mut Terrane)>,
    mut commands: Commands,
) {
    let Ok((body, frames, census, of_planet)) = planets.get(current.0) else {
        return;
    };
    let radius = body.view().radius;
    let of_plates = plates
        .iter_many(of_planet.iter())
        .flat_map(|terranes| terranes.iter());
    let mut of_planet = terranes.iter_many_mut(of_plates);
    while let Some((entity, mut terrane)) = of_planet.fetch_next() {
        match census.terrane(terrane.number, frames, radius) {
            Some(now) => _ = terrane.set_if_neq(now),
            None => commands.entity(entity).despawn(),
        }
    }
}
