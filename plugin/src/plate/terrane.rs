//! Terranes: connected regions of continental crust on one plate (paper 000 §3).

use crate::ids::FrameId;
use bevy::math::DVec3;
use bevy::prelude::*;

/// A connected region of continental crust, from a small island to a whole continent.
///
/// After every step, and after commands between two steps, the terranes are those of the crust as
/// it is. An entity stays while its terrane drifts, grows, or takes in others. Crust that changes
/// its frame, as in a collision or a rifting, replaces the entities of the terranes that it was part
/// of; a resampling replaces all.
#[derive(Component, Clone, Debug, PartialEq, Reflect)]
#[reflect(Component)]
pub struct Terrane {
    /// Its number in the [`TerraneCensus`](super::census::TerraneCensus).
    pub number: u32,
    /// The frame that carries it.
    pub frame: FrameId,
    /// Number of samples.
    pub samples: u32,
    /// Area in km².
    pub area: f64,
    /// Unit direction of the centroid in world coordinates.
    pub centroid: DVec3,
}

/// The plate that carries a terrane.
#[derive(Component, Clone, Copy, Debug, PartialEq, Eq, Reflect)]
#[relationship(relationship_target = Terranes)]
#[reflect(Component)]
pub struct TerraneOf(pub Entity);

/// The terranes of a plate.
#[derive(Component, Clone, Debug, Default, Reflect)]
#[relationship_target(relationship = TerraneOf, linked_spawn)]
#[reflect(Component)]
pub struct Terranes(Vec<Entity>);
