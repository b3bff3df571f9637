//! The choice of a river network.

use bevy::reflect::Reflect;

/// How the network of rivers is found.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, Reflect, serde::Serialize, serde::Deserialize,
)]
pub enum RiverNetwork {
    /// Water runs down the relief.
    #[default]
    Drainage,
    /// Rivers grow from the coasts, as in paper 002.
    Grown,
}
