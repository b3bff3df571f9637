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
//! settings   the settings of a planet's bakes
//! plugin     a bake that follows a running planet in the background
//! ```

mod topology;

mod rivers;

mod pack;

mod bake;

mod settings;

mod plugin;

pub use bake::{Bake, BakeError, BakeFrame, BakeRules, BakeSource};
pub use plugin::{BakeFinished, BakePlugin, PlanetBake, bake_now};
pub use rivers::RiverRule;
pub use settings::BakeSettings;
pub use topology::Topology;
