//! Who moves together: plates as entities.
//!
//! In: samples of the crust. Out: plates with motions, and where they meet.

pub mod motion;

mod partition;

mod continents;

mod initial;

pub mod boundary;

pub mod polarity;

#[doc(hidden)]
pub mod overlap;

pub mod contact;

pub mod front;

pub mod terrane;

pub(crate) mod stats;

mod table;

#[doc(hidden)]
pub mod census;

pub mod caches;

pub use crate::ids::PlateId;
pub use continents::{initial_crust, smallest_continent_km, smallest_land};
pub use initial::initial_plates;
pub use motion::PlateMotion;
#[cfg(feature = "render")]
pub(crate) use table::PlateQuery;
pub use table::{PlateAccess, PlateRow, PlateTable, plate_table};
pub use terrane::{Terrane, TerraneOf, Terranes};

use bevy::prelude::*;

/// The planet that a plate belongs to.
#[derive(Component, Clone, Copy, Debug, PartialEq, Eq, Reflect)]
#[relationship(relationship_target = Plates)]
#[reflect(Component)]
pub struct PlateOf(pub Entity);

/// The plates of a planet, in no particular order; sort by [`PlateId`] where order matters.
///
/// ```
/// # use bevy::prelude::*;
/// # use bevy_pangaea::prelude::*;
/// use bevy_pangaea::plate::PlateStats;
///
/// /// The largest plate of every planet.
/// fn largest(planets: Query<&Plates>, plates: Query<(&PlateId, &PlateStats)>) {
///     for of_planet in &planets {
///         let areas = plates.iter_many(of_planet.iter());
///         if let Some((id, stats)) = areas.max_by(|a, b| a.1.area.total_cmp(&b.1.area)) {
///             info!("plate {} has {:.0} km²", id.0, stats.area);
///         }
///     }
/// }
/// # bevy::ecs::system::assert_is_system(largest);
/// ```
#[derive(Component, Clone, Debug, Default, Reflect)]
#[relationship_target(relationship = PlateOf, linked_spawn)]
#[reflect(Component)]
pub struct Plates(Vec<Entity>);

/// A plate: the marker of its entity, with the time of its birth.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq, Reflect)]
#[reflect(Component)]
pub struct Plate {
    /// Geological time in My at which the plate was made.
    pub born: f64,
}

/// Size and composition of a plate, recomputed when its samples or their kinds change.
#[derive(Component, Clone, Copy, Debug, Default, PartialEq, Reflect)]
#[reflect(Component)]
pub struct PlateStats {
    /// Number of samples.
    pub samples: u32,
    /// Area in km².
    pub area: f64,
    /// Share of continental crust, 0..1: x_P in the paper.
    pub continental: f64,
    /// Mean age of its oceanic crust in My; 0 where there is none.
    pub ocean_age: f64,
    /// Unit direction of the centroid in world coordinates.
    pub centroid: bevy::math::DVec3,
}
