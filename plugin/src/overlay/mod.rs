//! What maps and globes show: a colour for every sample, and the legend that explains it.
//!
//! In: the [`Surface`] of a planet. Out: colours per sample ([`colorize`](fn@colorize)) for the
//! globe, rasters ([`map`]) for files. Nothing here needs a renderer.
//!
//! ```text
//! palette     colour ramps
//! relief      gradient, slope, Laplacian and shading of the elevation
//! boundary    kinds of plate boundaries
//! field       the quantity that an overlay shows, and how it becomes a colour
//! ground      climate, discharge, basins and lakes of a bake
//! rivers      its rivers as lines
//! legend      title, unit and key of an overlay
//! map         equirectangular rasters
//! ```

pub mod palette;

pub mod derivatives;

pub mod boundary;

mod field;

pub(crate) mod ground;

pub(crate) mod rivers;

pub mod legend;

pub mod colorize;

pub mod map;

pub use boundary::{BoundaryKind, boundaries};
pub use colorize::colorize;
pub use legend::{Legend, LegendEntries};
pub use map::{MapProjection, Raster};

use crate::control::Bake;
use crate::crust::Surface;
use crate::params::TectonicParams;
use crate::planet::Planet;
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
    /// What folded the crust last.
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
    /// Mean temperature of a year at the ground; this and what follows needs a [`Bake`].
    Temperature,
    /// Rain of a year.
    Rain,
    /// Wetness W of paper 002.
    Wetness,
    /// Discharge: the water of all that lies upstream, on a logarithmic ramp, and rivers in its
    /// colours.
    Drainage,
    /// Rivers by their Horton–Strahler order, and lakes.
    Rivers,
    /// What drains to the same mouth.
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
        ground::is_baked(self)
    }

    /// Title, unit and key of the overlay on the planet as it is now.
    pub fn legend(self, input: &OverlayInput) -> Legend {
        legend::legend(self, input)
    }
}

/// Everything that an overlay may look at.
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
