//! Control maps: the last CPU stage, and the only input of the amplifier (paper 002 §3, §4).
//!
//! In: the base mesh with its terrain, climate and drainage. Out: a
//! [`ControlMesh`](pangaea_shaders::amplify::control::ControlMesh), in whole numbers.
//!
//! ```text
//! topology   edges and faces of the base mesh; once per seed
//! pack       C, A, W, P, B, rivers and lakes per vertex, in the packed form
//! bake       all stages from the surface to the control mesh
//! plugin     a bake that follows a running planet in the background
//! ```

pub mod topology;

pub mod pack;

pub mod bake;

pub mod plugin;

pub use bake::{Bake, BakeError, BakeFrame, BakeRules, BakeSource};
pub use pack::{RiverRule, control_mesh};
pub use plugin::{BakeFinished, BakePlugin, BakeSettings, PlanetBake, bake_now};
pub use topology::Topology;
