//! Control maps: the last CPU stage, and the only input of the amplifier (paper 002 §3, §4).
//!
//! In: the base mesh with its terrain, climate and drainage. Out: a
//! [`ControlMesh`](pangaea_shaders::amplify::control::ControlMesh), in whole numbers.
//!
//! ```text
//! topology   edges and faces of the base mesh; once per seed
//! rivers     which vertices are rivers, and where their edges lead
//! pack       C, A, W, P, B, rivers and lakes per vertex, in the packed form
//! bake       all stages from the surface to the control mesh
//! plugin     a bake that follows a running planet in the background
//! ```

mod topology;

mod rivers;

mod pack;

mod bake;

mod plugin;

pub use bake::{Bake, BakeError, BakeFrame, BakeRules, BakeSource};
pub use plugin::{BakeFinished, BakePlugin, BakeSettings, PlanetBake, bake_now};
pub use rivers::RiverRule;
pub use topology::Topology;
