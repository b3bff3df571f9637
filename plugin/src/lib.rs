//! Tectonic planets for Bevy: plates that drift, collide, subduct, rift and make new ocean floor.

// In the order of the data's way; blank lines keep rustfmt from sorting.

pub mod math;

pub mod parallel;

mod named;

pub mod params;

pub mod ids;

pub mod random;

pub mod noise;

pub mod sphere;

pub mod planet;

pub mod view;

pub mod events;

pub mod schedule;

pub mod crust;

pub mod plate;

pub mod resample;

pub mod process;

pub mod authoring;

pub mod climate;

pub mod hydrology;

pub mod control;

pub mod overlay;

pub mod query;

pub mod relief_stats;

pub mod spawn;

pub mod io;

#[cfg(feature = "render")]
pub mod render;

mod plugin;

pub use plugin::PangaeaPlugins;

#[cfg(test)]
mod registry_tests;

/// All that the examples of the README use.
pub mod prelude {
    pub use crate::PangaeaPlugins;
    pub use crate::authoring::{
        Brush, CommandApplied, CommandError, CommandRejected, PaintTarget, Recording, Scenario,
        TectonicCommand, TectonicCommandsExt, TimedCommand,
    };
    pub use crate::control::{BakeFinished, BakeSettings, PlanetBake};
    pub use crate::crust::{Crust, CrustKind, Frames, Ledger, Orogeny, PlanetSurface, Surface};
    pub use crate::events::{
        CrustResampled, PlateConsumed, PlateRifted, StepCompleted, TerraneCollided,
    };
    pub use crate::io::PlanetPreset;
    pub use crate::params::{OceanFloor, ProcessSwitches, TectonicParams};
    pub use crate::planet::{
        ClockControls, DiscRecipe, GeologicClock, Lattice, Planet, PlanetError, PlanetRecipe,
        PlateNumbers, PlateRecipe,
    };
    pub use crate::plate::{PlateId, PlateMotion, PlateOf, Plates};
    pub use crate::query::{Ground, PlanetGround, Rules};
    #[cfg(feature = "render")]
    pub use crate::render::{Globe, PangaeaRenderPlugin};
    pub use crate::schedule::{
        CurrentPlanet, Stage, TectonicSchedulePlugin, TectonicStep, TectonicSystems, run_steps,
    };
    pub use crate::spawn::{PlanetFailed, PlanetReady, PlanetState, SpawnPlanet};
}

/// The README's examples, compiled as doc-tests.
#[cfg(all(doctest, feature = "render"))]
#[doc = include_str!("../../README.md")]
pub struct Readme;
