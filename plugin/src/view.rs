//! Samples, parameters and size of a planet: nearly every rule asks for them.

use crate::params::TectonicParams;
use crate::planet::{Lattice, Planet};
use crate::sphere::SphereMesh;
use bevy::ecs::query::QueryData;

/// The parts of a planet that do not change within a step, as a query.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// # use bevy_pangaea::view::PlanetQuery;
/// fn count(planets: Query<(PlanetQuery, &Crust)>) {
///     for (planet, crust) in &planets {
///         let view = planet.view();
///         info!("{} samples on {} km", crust.len(), view.radius);
///         assert_eq!(view.mesh.len(), crust.len());
///     }
/// }
/// # bevy::ecs::system::assert_is_system(count);
/// ```
#[derive(QueryData)]
pub struct PlanetQuery {
    /// Radius and seed.
    pub planet: &'static Planet,
    /// Samples and triangles.
    pub lattice: &'static Lattice,
    /// Parameters.
    pub params: &'static TectonicParams,
}

impl PlanetQueryItem<'_, '_> {
    /// The same for functions that know no ECS.
    pub fn view(&self) -> PlanetView<'_> {
        PlanetView {
            mesh: self.lattice,
            params: self.params,
            radius: self.planet.radius,
            seed: self.planet.seed,
        }
    }
}

/// A planet's samples, parameters and size.
#[derive(Clone, Copy)]
pub struct PlanetView<'a> {
    /// Samples and triangles.
    pub mesh: &'a SphereMesh,
    /// Parameters.
    pub params: &'a TectonicParams,
    /// Radius in km.
    pub radius: f64,
    /// Seed of everything random.
    pub seed: u64,
}

impl PlanetView<'_> {
    /// km² of a steradian.
    pub fn square(&self) -> f64 {
        self.radius * self.radius
    }
}
