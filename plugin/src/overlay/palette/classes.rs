//! The colours of classes: what has no value, kinds of crust, folding, lakes, land and sea.

use super::Rgba;

/// Oceanic crust without a value.
pub const NO_VALUE_OCEAN: Rgba = [52, 60, 72, 255];
/// Continental crust without a value.
pub const NO_VALUE_LAND: Rgba = [176, 174, 166, 255];

/// Oceanic crust.
pub const OCEANIC_CRUST: Rgba = [30, 66, 116, 255];
/// Continental crust above the sea.
pub const CONTINENT: Rgba = [190, 164, 112, 255];
/// Continental crust under water.
pub const SHELF: Rgba = [122, 158, 164, 255];

/// Crust folded above a subduction zone.
pub const ANDEAN: Rgba = [226, 110, 60, 255];
/// Crust folded by a collision of continents.
pub const HIMALAYAN: Rgba = [132, 74, 168, 255];

/// Lakes, by the number of their [`LakeKind`](crate::hydrology::LakeKind): blue is what drains to
/// the sea.
pub const LAKES: [Rgba; 3] = [[44, 112, 196, 255], [92, 98, 184, 255], [140, 84, 172, 255]];
/// The sea behind rivers, basins and lakes.
pub const SEA: Rgba = [38, 48, 66, 255];
/// The land behind rivers and lakes.
pub const LAND: Rgba = [206, 202, 190, 255];
/// Basins whose water never reaches the sea darken towards this.
pub const ENDORHEIC: Rgba = [96, 40, 40, 255];
/// Stands for a colour that is not known, and for many at once in a legend.
pub const GREY: Rgba = [150, 150, 150, 255];
