//! The overlays by name.

use crate::named::named_enum;
use serde::{Deserialize, Serialize};

named_enum! {
    /// A quantity that can be laid over the planet. Menus list them in this order.
    #[derive(Default, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Overlay {
        /// Height above the sea, in hypsometric tints.
        #[default]
        Elevation = "elevation",
        /// Plates, each in a colour of its own, and the kinds of their boundaries.
        Plates = "plates",
        /// Oceanic or continental crust.
        CrustType = "crust_type",
        /// Age of the ocean floor.
        OceanAge = "ocean_age",
        /// Thickness of the crust.
        Thickness = "thickness",
        /// Kind of the last mountain building.
        OrogenyType = "orogeny_type",
        /// Time since the crust was folded.
        OrogenyAge = "orogeny_age",
        /// Direction of folding.
        FoldDirection = "fold_direction",
        /// Direction of the ridge that made the ocean floor.
        RidgeDirection = "ridge_direction",
        /// Speed of the ground.
        Velocity = "velocity",
        /// Steepness of the relief.
        Slope = "slope",
        /// Curvature of the relief: hollows and crests.
        Laplacian = "laplacian",
        /// The noise that warps the borders of plates.
        VectorNoise = "vector_noise",
        /// The samples and their triangles.
        Mesh = "mesh",
        /// Mean temperature of a year at the ground; this and the following overlays need a
        /// [`Bake`](crate::control::Bake).
        Temperature = "temperature",
        /// Rain of a year.
        Rain = "rain",
        /// Wetness W of paper 002.
        Wetness = "wetness",
        /// Discharge: the water of all land upstream, on a logarithmic ramp, and rivers in its
        /// colours.
        Drainage = "drainage",
        /// Rivers by their Horton–Strahler order, and lakes.
        Rivers = "rivers",
        /// Drainage basins, a colour per mouth.
        Basins = "basins",
        /// Lakes, with and without an outlet.
        Lakes = "lakes",
    }
}

impl Overlay {
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
