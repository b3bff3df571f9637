//! A planet: the entity, its clock, and the recipe it is grown from.

mod clock;

mod recipe;

pub use clock::{ClockControls, GeologicClock, PlateNumbers};
pub use recipe::{DiscRecipe, PlanetError, PlanetRecipe, PlateRecipe};

use crate::params::TectonicParams;
use crate::sphere::SphereMesh;
use bevy::prelude::*;
use std::sync::Arc;

/// A tectonic planet. Several may live in one world.
///
/// It is not spawned by itself: spawn a [`PlanetRecipe`], or a
/// [`PlanetState`](crate::spawn::PlanetState), and this comes with all that belongs to it.
#[derive(
    Component, Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize,
)]
#[require(GeologicClock, ClockControls, PlateNumbers, TectonicParams)]
#[reflect(Component, Serialize, Deserialize)]
pub struct Planet {
    /// Radius R in km; 6370 in paper 000, Appendix A.
    pub radius: f64,
    /// Seed of everything random on the planet.
    pub seed: u64,
}

/// The samples of the sphere and their triangles, shared by everything that reads the planet.
#[derive(Component, Clone, Deref)]
pub struct Lattice(pub Arc<SphereMesh>);

/// Radius of a planet in km; that of the Earth for an entity without [`Planet`].
pub(crate) fn planet_radius(world: &World, planet: Entity) -> f64 {
    world
        .get::<Planet>(planet)
        .map_or(6370.0, |planet| planet.radius)
}
