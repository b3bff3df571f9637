//! Files: saves, presets, scenarios, pictures and figures.
//!
//! ```text
//! error      why a file could not be read or written
//! files      writing whole or not at all
//! codec      numbers and texts in bytes
//! planes     maps in few bytes
//! sections   the parts of a save
//! save       *.pangaea: all state of a planet, checksummed
//! digest     one hash over all state
//! capture    from a planet in a world to its state
//! text       texts that people write
//! preset     *.planet.ron: recipes
//! scenario   *.scenario.ron: commands to come
//! stats      figures of a planet
//! png        16-bit elevation, RGB maps
//! sidecar    the scale of a picture of heights
//! export     the ground: GeoTIFF, EXR, 16-bit greys, glTF; squares, tiles, boxes of degrees
//! dem        elevation models of real ground
//! maps       maps of the whole planet: climate, terrain
//! terrain    *.terrain.ron: planets of maps
//! ```
//!
//! Input is never trusted: every error is one line that names the file, and no input makes a loader
//! panic, or allocate more than the input's own size allows, 128 MiB apart. Output is there whole or
//! not at all.

mod error;

mod files;

mod codec;

mod planes;

mod sections;

pub mod save;

mod digest;

mod capture;

mod limited;

mod text;

pub mod preset;

pub mod scenario;

pub mod stats;

#[cfg(feature = "export")]
pub mod png;

#[cfg(any(feature = "dem", feature = "export"))]
mod sidecar;

#[cfg(feature = "export")]
pub mod export;

#[cfg(feature = "dem")]
mod dem;

#[cfg(feature = "dem")]
mod maps;

#[cfg(feature = "dem")]
pub mod terrain;

pub use capture::capture;
#[cfg(feature = "dem")]
pub use dem::{Dem, DemError, dem_files, load_dem, raster_files};
pub use digest::{digest, map_digest};
pub use error::{IoError, SaveError};
#[cfg(feature = "export")]
pub use export::{ExportError, export};
pub use files::{
    MarkedJson, Output, abandon_outputs, check_outputs, is_marked, write_all, write_atomically,
};
#[cfg(feature = "dem")]
pub use maps::{
    LoadedClimate, LoadedMap, MapFileError, MapQuantity, load_climate_maps, load_map, load_map_of,
};
pub use preset::{PlanetPreset, PlanetRecipeLoader, PresetPlugin, load_preset};
pub use save::{load, save};
pub use scenario::{load_scenario, save_scenario};
#[cfg(any(feature = "dem", feature = "export"))]
pub use sidecar::Sidecar;
pub use stats::{Stats, Timings};
#[cfg(feature = "dem")]
pub use terrain::{
    LoadedPlanet, PlanetFileKind, load_planet, load_planet_with_notes, planet_files,
};
pub use text::TextError;
