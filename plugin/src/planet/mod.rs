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
///
/// ```
/// use bevy_pangaea::prelude::*;
///
/// let recipe = PlanetRecipe { samples: 500, ..Default::default() };
/// let lattice = PlanetState::new(&recipe)?.lattice;
/// let here = lattice.nearest(bevy_pangaea::math::direction(48.0, 11.0));
/// // A sample has its place, its area in steradians and its neighbours in order.
/// assert!(lattice.ring(here).len() >= 3 && lattice.area(here) > 0.0);
/// # Ok::<(), PlanetError>(())
/// ```
#[derive(Component, Clone, Deref)]
pub struct Lattice(pub Arc<SphereMesh>);

/// Radius of a planet in km; that of the Earth for an entity without [`Planet`].
pub(crate) fn planet_radius(world: &World, planet: Entity) -> f64 {
    world
        .get::<Planet>(planet)
        .map_or(6370.0, |planet| planet.radius)
}
