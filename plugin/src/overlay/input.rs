//! The parts of a planet that overlays read.

use crate::control::{Bake, PlanetBake};
use crate::crust::{PlanetSurface, Surface};
use crate::params::TectonicParams;
use crate::planet::{Lattice, Planet};
use crate::plate::PlateTable;
use crate::sphere::SphereMesh;
use bevy::prelude::*;

/// The parts of a planet that overlays read.
#[derive(Clone, Copy)]
pub struct OverlayInput<'a> {
    /// Radius and seed.
    pub planet: &'a Planet,
    /// Samples and triangles.
    pub mesh: &'a SphereMesh,
    /// The planet as it is now.
    pub surface: &'a Surface,
    /// Plates and their motions.
    pub plates: &'a PlateTable,
    /// Parameters of the model.
    pub params: &'a TectonicParams,
    /// The last bake of the ground, where there is one: for climate and rivers.
    pub bake: Option<&'a Bake>,
}

impl<'a> OverlayInput<'a> {
    /// The parts of a planet in a world; `None` if the entity is no planet. `plates` are those of
    /// [`plate_table`](crate::plate::plate_table).
    pub fn from_world(world: &'a World, planet: Entity, plates: &'a PlateTable) -> Option<Self> {
        Some(Self {
            planet: world.get::<Planet>(planet)?,
            mesh: &world.get::<Lattice>(planet)?.0,
            surface: world.get::<PlanetSurface>(planet)?,
            plates,
            params: world.get::<TectonicParams>(planet)?,
            bake: world.get::<PlanetBake>(planet).map(|bake| &*bake.0),
        })
    }
}
