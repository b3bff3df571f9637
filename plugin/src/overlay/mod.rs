//! Colours of maps and globes: one for every sample, and the legend that explains them.
//!
//! In: the [`Surface`] of a planet. Out: colours per sample ([`colorize`]) for the globe,
//! [`Raster`]s ([`MapProjection`]) for files. Nothing here needs a renderer.
//!
//! ```
//! use bevy::prelude::*;
//! use bevy_pangaea::overlay::{MapProjection, Overlay, OverlayInput};
//! use bevy_pangaea::plate::plate_table;
//! use bevy_pangaea::prelude::*;
//! use bevy_pangaea::spawn::PlanetState;
//!
//! let mut app = App::new();
//! app.add_plugins(PangaeaPlugins);
//! let recipe = PlanetRecipe { samples: 1000, plate_count: 8, ..default() };
//! let planet = PlanetState::new(&recipe)?.spawn(app.world_mut());
//!
//! let plates = plate_table(app.world(), planet);
//! let input = OverlayInput::from_world(app.world(), planet, &plates).ok_or("no planet")?;
//! let map = MapProjection::new(input.mesh, 64, 32).draw(Overlay::Elevation, &input);
//! assert_eq!(map.rgb.len(), 3 * 64 * 32);
//!
//! let legend = Overlay::Elevation.legend(&input);
//! assert_eq!((legend.title, legend.unit), ("Elevation", "km"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! ```text
//! palette      colour ramps, and the colours of classes
//! raster       a picture in memory
//! derivatives  gradient, slope, Laplacian and shading of the elevation
//! boundary     kinds of plate boundaries
//! discharge    the ramp of a river's discharge
//! rivers       the rivers of a bake as lines
//! baked        climate, discharge, basins and lakes of a bake
//! field        a quantity at every sample, and how it becomes a colour
//! quantity     which quantity an overlay shows
//! colorize     a colour for every sample
//! legend       title, unit and key of an overlay
//! map          equirectangular rasters
//! ```

pub mod palette;

mod raster;

mod derivatives;

mod boundary;

mod discharge;

pub(crate) mod rivers;

pub(crate) mod baked;

mod field;

mod quantity;

mod colorize;

mod legend;

mod map;

pub use boundary::{BoundaryKind, boundaries};
pub use colorize::colorize;
pub use legend::{Legend, LegendEntries};
pub use map::MapProjection;
pub use raster::Raster;

use crate::control::{Bake, PlanetBake};
use crate::crust::{PlanetSurface, Surface};
use crate::params::TectonicParams;
use crate::planet::{Lattice, Planet};
use crate::plate::PlateTable;
use crate::sphere::SphereMesh;
use bevy::prelude::*;

/// A quantity that can be laid over the planet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Reflect)]
#[reflect(Default)]
pub enum Overlay {
    /// Height above the sea, in hypsometric tints.
    #[default]
    Elevation,
    /// Plates, each in a colour of its own, and the kinds of their boundaries.
    Plates,
    /// Oceanic or continental crust.
    CrustType,
    /// Age of the ocean floor.
    OceanAge,
    /// Thickness of the crust.
    Thickness,
    /// Kind of the last mountain building.
    OrogenyType,
    /// Time since the crust was folded.
    OrogenyAge,
    /// Direction of folding.
    FoldDirection,
    /// Direction of the ridge that made the ocean floor.
    RidgeDirection,
    /// Speed of the ground.
    Velocity,
    /// Steepness of the relief.
    Slope,
    /// Curvature of the relief: hollows and crests.
    Laplacian,
    /// The noise that warps the borders of plates.
    VectorNoise,
    /// The samples and their triangles.
    Mesh,
    /// Mean temperature of a year at the ground; this and the following overlays need a [`Bake`].
    Temperature,
    /// Rain of a year.
    Rain,
    /// Wetness W of paper 002.
    Wetness,
    /// Discharge: the water of all land upstream, on a logarithmic ramp, and rivers in its colours.
    Drainage,
    /// Rivers by their Horton–Strahler order, and lakes.
    Rivers,
    /// Drainage basins, a colour per mouth.
    Basins,
    /// Lakes, with and without an outlet.
    Lakes,
}

impl Overlay {
    /// All overlays, in the order in which menus list them.
    pub const ALL: [Self; 21] = [
        Self::Elevation,
        Self::Plates,
        Self::CrustType,
        Self::OceanAge,
        Self::Thickness,
        Self::OrogenyType,
        Self::OrogenyAge,
        Self::FoldDirection,
        Self::RidgeDirection,
        Self::Velocity,
        Self::Slope,
        Self::Laplacian,
        Self::VectorNoise,
        Self::Mesh,
        Self::Temperature,
        Self::Rain,
        Self::Wetness,
        Self::Drainage,
        Self::Rivers,
        Self::Basins,
        Self::Lakes,
    ];

    /// Name in files and commands, in snake case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Elevation => "elevation",
            Self::Plates => "plates",
            Self::CrustType => "crust_type",
            Self::OceanAge => "ocean_age",
            Self::Thickness => "thickness",
            Self::OrogenyType => "orogeny_type",
            Self::OrogenyAge => "orogeny_age",
            Self::FoldDirection => "fold_direction",
            Self::RidgeDirection => "ridge_direction",
            Self::Velocity => "velocity",
            Self::Slope => "slope",
            Self::Laplacian => "laplacian",
            Self::VectorNoise => "vector_noise",
            Self::Mesh => "mesh",
            Self::Temperature => "temperature",
            Self::Rain => "rain",
            Self::Wetness => "wetness",
            Self::Drainage => "drainage",
            Self::Rivers => "rivers",
            Self::Basins => "basins",
            Self::Lakes => "lakes",
        }
    }

    /// The overlay of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|overlay| overlay.name() == name)
    }

    /// Name for people.
    pub fn label(self) -> &'static str {
        match self {
            Self::Elevation => "Elevation",
            Self::Plates => "Plates",
            Self::CrustType => "Crust type",
            Self::OceanAge => "Ocean age",
            Self::Thickness => "Crust thickness",
            Self::OrogenyType => "Orogeny type",
            Self::OrogenyAge => "Orogeny age",
            Self::FoldDirection => "Fold direction",
            Self::RidgeDirection => "Ridge direction",
            Self::Velocity => "Velocity",
            Self::Slope => "Slope",
            Self::Laplacian => "Laplacian",
            Self::VectorNoise => "Border noise",
            Self::Mesh => "Mesh",
            Self::Temperature => "Temperature",
            Self::Rain => "Rain",
            Self::Wetness => "Wetness",
            Self::Drainage => "Drainage",
            Self::Rivers => "Rivers by order",
            Self::Basins => "Drainage basins",
            Self::Lakes => "Lakes",
        }
    }

    /// Whether the overlay shows a bake, and is grey without one.
    pub fn needs_bake(self) -> bool {
        matches!(
            self,
            Self::Temperature
                | Self::Rain
                | Self::Wetness
                | Self::Drainage
                | Self::Rivers
                | Self::Basins
                | Self::Lakes
        )
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_found_again() {
        for overlay in Overlay::ALL {
            assert_eq!(Overlay::from_name(overlay.name()), Some(overlay));
            assert!(!overlay.label().is_empty());
        }
        assert_eq!(Overlay::from_name("Elevation"), None);
    }
}
