//! Tectonic planets for [Bevy](https://bevy.org): plates that drift, collide, subduct and rift, and
//! the ground that they leave behind, down to 40 cm.
//!
//! The models are those of *Procedural Tectonic Planets* (Cortial, Peytavie, Galin, Guérin,
//! Computer Graphics Forum 38(2), 2019; "paper 000" in these pages) and *Real-Time
//! Hyper-Amplification of Planets* (the same, The Visual Computer, 2020; "paper 002").
//!
//! # Quick start
//!
//! A planet is spawned like anything else, by a component that says what it is grown from.
//!
//! ```no_run
//! # #[cfg(feature = "render")]
//! # mod game {
//! use bevy::core_pipeline::tonemapping::Tonemapping;
//! use bevy::prelude::*;
//! use bevy_pangaea::prelude::*;
//!
//! fn main() {
//!     App::new()
//!         .add_plugins((DefaultPlugins, PangaeaPlugins, PangaeaRenderPlugin))
//!         .add_systems(Startup, setup)
//!         .run();
//! }
//!
//! fn setup(mut commands: Commands) {
//!     commands.spawn(PlanetRecipe { seed: 7, ..default() });
//!     let place = Transform::from_xyz(0.0, 1.0, 3.0).looking_at(Vec3::ZERO, Vec3::Y);
//!     commands.spawn((Camera3d::default(), Tonemapping::None, place));
//! }
//! # }
//! ```
//!
//! It is built in the background, on the same entity; [`PlanetReady`] tells when it is there, and
//! [`PlanetFailed`] when the recipe is refused. Then time passes on it at 10 My a second, until
//! [`ClockControls`] say otherwise. The globe is a unit sphere with its north pole on +Y; a
//! component [`Globe`](render::Globe) says how it is drawn.
//!
//! Tools and tests that would rather wait build the state themselves and take whole steps:
//!
//! ```
//! use bevy::prelude::*;
//! use bevy_pangaea::prelude::*;
//!
//! # fn main() -> Result<(), PlanetError> {
//! let mut app = App::new();
//! app.add_plugins(PangaeaPlugins);
//! let recipe = PlanetRecipe { seed: 7, samples: 1000, ..default() };
//! let planet = PlanetState::new(&recipe)?.spawn(app.world_mut());
//! run_steps(app.world_mut(), planet, 5); // 10 My
//! let crust = app.world().get::<Crust>(planet).unwrap();
//! assert_eq!(crust.len(), 1000);
//! # Ok(())
//! # }
//! ```
//!
//! # Concepts
//!
//! | word | item | meaning |
//! |---|---|---|
//! | planet | [`Planet`] | an entity; all that follows are its components. Several may live in one world |
//! | recipe | [`PlanetRecipe`] | what a planet is grown from: seed, samples, plates, land, parameters |
//! | preset | [`PlanetPreset`] | a recipe as a file that may be edited while the game runs |
//! | sample | [`Lattice`] | a point of the sphere with its neighbours; samples never move |
//! | crust | [`Crust`] | the state of the ground, a column per quantity, an entry per sample |
//! | frame | [`Frames`] | a rotation shared by samples: where their crust is now |
//! | plate | [`Plates`] | entities that carry frames, with a [`PlateMotion`] and a stable [`PlateId`] |
//! | terrane | [`Terrane`](plate::Terrane) | connected continental crust on one plate, as an entity |
//! | surface | [`PlanetSurface`] | the crust as it lies now, projected on the samples: what maps and globes read |
//! | step | [`TectonicStep`] | 2 My, a schedule of [`Stage`]s, spread over frames |
//! | command | [`TectonicCommand`] | what a user does to a planet, at any moment, recorded |
//! | ledger | [`Ledger`] | the account of continental crust: every change has a cause |
//! | bake | [`PlanetBake`] | climate, rivers and control maps of a surface, made in the background |
//! | ground | [`Ground`] | heights, water, normals, materials, rays and colliders, in metres |
//!
//! [`guide::symbols`] leads from the symbols of the papers to the items here.
//!
//! Directions are unit vectors of `f64` with +z to the north pole and +x to 0° E; latitudes and
//! longitudes are degrees. Lengths are km, times My, speeds km/My (which is mm/y); the ground,
//! which games stand on, is in metres.
//!
//! # Commands
//!
//! ```
//! # use bevy::prelude::*;
//! # use bevy_pangaea::prelude::*;
//! fn tear(mut commands: Commands, planet: Single<Entity, With<Planet>>) {
//!     let line = vec![(0.0, 10.0), (20.0, 14.0)];
//!     commands.entity(*planet).tectonic(TectonicCommand::RiftPlate {
//!         plate: PlateId(5),
//!         line,
//!         fragments: 2,
//!     });
//! }
//! # bevy::ecs::system::assert_is_system(tear);
//! ```
//!
//! A command waits for the end of the step, then it is carried out as a whole and recorded, or
//! refused as a whole. A [`Recording`], played as a [`Scenario`] on the same recipe, gives the same
//! bits. See [`authoring`].
//!
//! # Events
//!
//! All are triggered on the planet's entity; observe them on one planet or on all.
//!
//! | event | when |
//! |---|---|
//! | [`PlanetReady`], [`PlanetFailed`] | a planet is there, or its recipe is refused |
//! | [`StepCompleted`] | after every step |
//! | [`TerraneCollided`] | a terrane has been sutured to another plate |
//! | [`PlateRifted`], [`PlateConsumed`] | a plate has broken, or is gone |
//! | [`CrustResampled`] | new ocean floor has been made, samples are even again |
//! | [`CommandApplied`], [`CommandRejected`] | how a command went |
//! | [`BakeFinished`] | climate and rivers follow the planet again |
//!
//! # The ground
//!
//! A planet with [`BakeSettings`] is baked whenever its surface has changed. Its [`ClimateMaps`],
//! if you give it some, replace fields of the climate, and are saved with it. Its [`PlanetBake`]
//! makes a [`PlanetGround`], which answers without a GPU, and with the same bits on every machine.
//! A planet with [`TerrainMaps`](hydrology::TerrainMaps) has its ground from them instead of a
//! simulation: [`PlanetState::from_maps`](spawn::PlanetState::from_maps).
//!
//! ```
//! # use bevy::prelude::*;
//! # use bevy_pangaea::prelude::*;
//! use bevy_pangaea::query;
//!
//! fn land(event: On<BakeFinished>, bakes: Query<&PlanetBake>) -> Result {
//!     let ground = PlanetGround::of_bake(bakes.get(event.planet)?, Rules::default())?;
//!     let here = query::direction_at(-33.0, -70.5)?;
//!     let sample = ground.sample(here, 17)?;
//!     info!("{} m above the sea", sample.height_m);
//!     Ok(())
//! }
//! # App::new().add_observer(land);
//! ```
//!
//! # Your own processes, presets, files
//!
//! - Every process is a plugin of [`PangaeaPlugins`]: disable it, replace it, or add one of your
//!   own [after any stage][`TectonicSystems`]. `examples/custom_process.rs` is a model for one.
//! - A [`PlanetPreset`] lets a planet follow a `*.planet.ron` file: parameters that change there
//!   reach the living planet as commands, anything else grows it anew.
//! - [`io`] has saves, scenarios, maps and figures; [`overlay`] has 21 quantities as colours with
//!   their legends.
//! - Components, settings and events of plain values are reflected and registered, for editors and
//!   scripts. Not so [`Rules`](query::Rules), which stand in `pangaea_shaders`, a crate without
//!   dependencies; what shares a mesh or a surface; some caches; [`CommandRejected`] and
//!   [`PlanetFailed`], which carry an error.
//! - A scene holds a planet's recipe or its preset, a save file its state: a [`PlanetRecipe`] is a
//!   planet as soon as it is inserted, by its reflection, as scene files do, or by its template, as
//!   `bsn!` does.
//!
//! # Features
//!
//! | feature | default | what it adds |
//! |---|---|---|
//! | `render` | yes | [`render`]: the globe; without it no renderer is built |
//! | `export` | yes | [`io::export`](mod@io::export), [`io::png`]: the ground as GeoTIFF, EXR, greys, glTF; maps as PNG |
//! | `dem` | yes | [`io::load_dem`], [`io::load_map`], [`io::load_planet`]: GeoTIFF, PNG and HGT are read, and planets of maps |
//! | `relief_stats` | yes | [`relief_stats`]: slopes, relief in windows, spectra, fabric, geomorphons |
//! | `file_watcher` | no | Bevy's watcher of asset folders: a preset that changes on disk reaches its planet |
//! | `window` | no | a window through winit and X11, for the example `minimal` |
//!
//! # What it costs
//!
//! About 6 ms a step at the 60,000 samples of the default recipe, about 8 ms of a frame at
//! most; planets and bakes are made in the background: see [`guide::costs`].
//!
//! # Further reading
//!
//! [ARCHITECTURE.md](https://github.com/pangaea-rs/pangaea/blob/main/ARCHITECTURE.md) is the map of
//! the code and lists the departures from the papers;
//! [CHANGELOG.md](https://github.com/pangaea-rs/pangaea/blob/main/CHANGELOG.md) says which changes
//! give other planets. The binary `pangaea` of the same repository is an explorer, and grows,
//! draws and exports planets without a window.
//!
//! [`BakeFinished`]: control::BakeFinished
//! [`BakeSettings`]: control::BakeSettings
//! [`ClimateMaps`]: climate::ClimateMaps
//! [`ClockControls`]: planet::ClockControls
//! [`CommandApplied`]: authoring::CommandApplied
//! [`CommandRejected`]: authoring::CommandRejected
//! [`Crust`]: crust::Crust
//! [`CrustResampled`]: events::CrustResampled
//! [`Frames`]: crust::Frames
//! [`Ground`]: query::Ground
//! [`Lattice`]: planet::Lattice
//! [`Ledger`]: crust::Ledger
//! [`PlanetBake`]: control::PlanetBake
//! [`PlanetFailed`]: spawn::PlanetFailed
//! [`PlanetGround`]: query::PlanetGround
//! [`PlanetPreset`]: io::PlanetPreset
//! [`PlanetReady`]: spawn::PlanetReady
//! [`PlanetRecipe`]: planet::PlanetRecipe
//! [`PlanetSurface`]: crust::PlanetSurface
//! [`Planet`]: planet::Planet
//! [`PlateConsumed`]: events::PlateConsumed
//! [`PlateId`]: plate::PlateId
//! [`PlateMotion`]: plate::PlateMotion
//! [`PlateRifted`]: events::PlateRifted
//! [`Plates`]: plate::Plates
//! [`Recording`]: authoring::Recording
//! [`Scenario`]: authoring::Scenario
//! [`Stage`]: schedule::Stage
//! [`StepCompleted`]: events::StepCompleted
//! [`TectonicCommand`]: authoring::TectonicCommand
//! [`TectonicStep`]: schedule::TectonicStep
//! [`TectonicSystems`]: schedule::TectonicSystems
//! [`TerraneCollided`]: events::TerraneCollided

#![cfg_attr(docsrs, feature(doc_cfg))]

// In the order of the data's way; blank lines keep rustfmt from sorting.

pub mod math;

#[doc(hidden)]
pub mod parallel;

mod background;

#[doc(hidden)]
pub mod room;

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

#[cfg(feature = "relief_stats")]
pub mod relief_stats;

pub mod spawn;

pub mod io;

#[cfg(feature = "render")]
pub mod render;

#[cfg(feature = "render")]
pub mod amplification;

mod plugin;

pub mod guide;

pub use plugin::PangaeaPlugins;

#[cfg(test)]
mod registry_tests;

pub mod prelude {
    //! Names that stand in most files of games and tools: `use bevy_pangaea::prelude::*;`.
    //!
    //! | for | items |
    //! |---|---|
    //! | an app | [`PangaeaPlugins`], `PangaeaRenderPlugin` and `Globe` with the feature `render` |
    //! | a planet | [`PlanetRecipe`], [`PlanetPreset`], [`PlanetState`], [`SpawnPlanet`], [`PlanetReady`], [`PlanetFailed`] |
    //! | its time | [`ClockControls`], [`GeologicClock`], [`run_steps`], [`StepCompleted`] |
    //! | its state | [`Crust`], [`Frames`], [`Plates`], [`PlanetSurface`], [`Ledger`], [`TectonicParams`] |
    //! | acting on it | [`TectonicCommand`], [`TectonicCommandsExt`], [`Recording`], [`Scenario`], [`CommandRejected`] |
    //! | what happens | [`TerraneCollided`], [`PlateRifted`], [`PlateConsumed`], [`CrustResampled`] |
    //! | its ground | [`BakeSettings`], [`BakeFinished`], [`PlanetBake`], [`PlanetGround`], [`Ground`], [`Rules`] |
    //! | processes of your own | [`TectonicStep`], [`TectonicSystems`], [`Stage`], [`CurrentPlanet`] |
    //!
    //! Files are in [`io`](crate::io), pictures of quantities in [`overlay`](crate::overlay).

    pub use crate::PangaeaPlugins;
    pub use crate::authoring::{
        Brush, CommandApplied, CommandError, CommandRejected, PaintTarget, Recording, Scenario,
        TectonicCommand, TectonicCommandsExt, TimedCommand,
    };
    pub use crate::climate::ClimateMaps;
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

/// The examples of the repository's README, compiled as doc-tests.
#[cfg(all(doctest, feature = "render"))]
#[doc = include_str!("../../README.md")]
pub struct Readme;

/// The example of the crate's README, compiled, too.
#[cfg(all(doctest, feature = "render"))]
#[doc = include_str!("../README.md")]
pub struct CrateReadme;
