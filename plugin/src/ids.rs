//! Numbers by which plates and frames are told apart. Everything names them, so they come first.

use bevy::prelude::*;

/// The stable number of a plate. Everything that must not depend on the order of entities goes by
/// it. Numbers are never used twice on one planet.
#[derive(
    Component,
    Clone,
    Copy,
    Debug,
    Default,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Reflect,
    serde::Serialize,
    serde::Deserialize,
)]
#[serde(transparent)]
#[reflect(Component)]
pub struct PlateId(pub u32);

/// Index of a frame in [`Frames`](crate::crust::Frames); the number that the crust's `frame` column
/// holds.
pub type FrameId = u16;
