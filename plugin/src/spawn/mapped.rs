//! A planet of a user's maps (paper 002 §3): no plate moves on it, and no process is on.
//!
//! Its crust is that of the maps at the samples of a lattice, for globes, maps and figures. Its
//! climate, its rivers and its ground follow from the maps themselves.

use super::state::PlanetState;
use crate::control::BakeError;
use crate::crust::Crust;
use crate::hydrology::TerrainMaps;
use crate::params::{ProcessSwitches, TectonicParams};
use crate::planet::{Planet, PlanetRecipe};
use crate::plate::PlateMotion;
use crate::sphere::SphereMesh;
use std::sync::Arc;

/// Samples of the crust: 50 km from each other on a planet like the Earth, as vertices of the base
/// mesh are.
const SAMPLES: u32 = 200_000;

impl PlanetState {
    /// The planet that maps describe, on one plate at rest, with every process off.
    ///
    /// ```
    /// use bevy_pangaea::climate::EquirectMap;
    /// use bevy_pangaea::hydrology::TerrainMaps;
    /// use bevy_pangaea::planet::Planet;
    /// use bevy_pangaea::spawn::PlanetState;
    ///
    /// // Land of 500 m in the north, sea of 500 m in the south.
    /// let crust = EquirectMap::from_fn(32, |lat, _| if lat > 0.0 { 0.5 } else { -0.5 })?;
    /// let maps = TerrainMaps { crust, age: None, plateau: None, hills: None };
    /// let state = PlanetState::from_maps(Planet { radius: 6370.0, seed: 1 }, maps)?;
    /// let land = state.crust.elevation.iter().filter(|&&km| km > 0.0).count();
    /// assert!(land.abs_diff(state.crust.len() / 2) < state.crust.len() / 100);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`BakeError::Radius`], and [`BakeError::Map`] for values that no planet has.
    pub fn from_maps(planet: Planet, maps: TerrainMaps) -> Result<Self, BakeError> {
        BakeError::check_radius(planet.radius)?;
        maps.check()?;
        let recipe = resting(planet);
        let mesh = Arc::new(SphereMesh::fibonacci(SAMPLES)?);
        let mut crust = Crust::ocean(mesh.len(), &recipe.params);
        for i in 0..mesh.len() {
            crust.set_row(i, &maps.crust_row(mesh.point(i as u32), &recipe.params));
        }
        let state = Self::with_crust(&recipe, mesh, vec![PlateMotion::REST], crust);
        Ok(Self {
            terrain: Some(maps),
            ..state
        })
    }
}

/// The recipe of a planet on which nothing happens.
fn resting(planet: Planet) -> PlanetRecipe {
    PlanetRecipe {
        seed: planet.seed,
        radius: planet.radius,
        params: TectonicParams {
            processes: ProcessSwitches::all(false),
            ..TectonicParams::default()
        },
        ..PlanetRecipe::default()
    }
}

#[cfg(test)]
#[path = "mapped_tests.rs"]
mod tests;
