//! Planets of maps: terrain files `*.terrain.ron`, and maps of the elevation alone.
//!
//! ```ron
//! (
//!     elevation: "earth.tif",
//!     unit: metres,
//!     radius: 6370,
//!     seed: 1,
//!     rain: "rain.tif",
//! )
//! ```
//!
//! | field | meaning | default |
//! |---|---|---|
//! | `elevation` | map of the whole planet, without voids, 0 at the sea | must be given |
//! | `unit` | `metres` or `kilometres`: the unit of that map's values | `metres` |
//! | `radius` | radius of the planet in km | 6370 |
//! | `seed` | seed of rivers and ground | 0 |
//! | `age` | age of the last orogeny in My | high ground 100 My |
//! | `plateaus`, `hills` | their presence, 0 to 1 | by the relief |
//! | `temperature`, `rain`, `wetness` | fields of the climate: °C, mm a year, 0 to 1 | the model's |
//!
//! Names of files count from the folder of the terrain file. Maps are those of
//! [`load_map`](super::load_map). Grey pictures without a sidecar: of an elevation, black is -12 km
//! and white 12 km, as in `elevation.png` of `pangaea maps`; of plateaus, hills and wetness, black
//! is 0 and white 1. Maps of the terrain finer than the base mesh count by the means of their
//! pixels.
//!
//! ```text
//! elevation  the map of the elevation, in km
//! loaded     a planet, and what to say of it
//! file       the fields of a terrain file, and the planet that they describe
//! ```

mod elevation;

mod loaded;

mod file;

pub use loaded::LoadedPlanet;

use self::file::TerrainFile;
use super::dem::{extension, raster_files};
use super::text::{parse, read_text};
use super::{IoError, save};
use crate::spawn::PlanetState;
use std::path::{Path, PathBuf};

/// A kind of file that holds a planet; its name says which.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanetFileKind {
    /// A save. Any name that is not one of the others.
    Save,
    /// The description of a planet of maps, `*.terrain.ron`.
    Terrain,
    /// A map of the elevation in metres, `*.tif`, `*.tiff` or `*.png`: a planet of this map alone.
    Elevation,
}

impl PlanetFileKind {
    /// The kind of a file of this name.
    pub fn of(path: &Path) -> Self {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.to_lowercase().ends_with(".terrain.ron") {
            return Self::Terrain;
        }
        match extension(path).as_deref() {
            Some("tif" | "tiff" | "png") => Self::Elevation,
            _ => Self::Save,
        }
    }
}

/// The files that are read with a planet: its own, and of one of maps those of the maps, as far as
/// they can be found out without an error.
pub fn planet_files(path: &Path) -> Vec<PathBuf> {
    match PlanetFileKind::of(path) {
        PlanetFileKind::Save => vec![path.to_path_buf()],
        PlanetFileKind::Elevation => raster_files(path),
        PlanetFileKind::Terrain => {
            let file = read_text(path).ok().and_then(|text| parse(&text).ok());
            let maps = file.map(|file: TerrainFile| file.maps(path));
            let maps = maps.into_iter().flatten();
            core::iter::once(path.to_path_buf())
                .chain(maps.flat_map(|map| raster_files(&map)))
                .collect()
        }
    }
}

/// Loads a planet of any kind of file.
///
/// ```
/// # #[cfg(feature = "export")]
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use bevy_pangaea::io::{load_planet, png::grey_png};
///
/// # let folder = tempfile::tempdir()?;
/// let path = folder.path().join("island.terrain.ron");
/// std::fs::write(&path, r#"(elevation: "island.png", radius: 3000)"#)?;
/// // Black is -12 km, white 12 km: a northern hemisphere of 6 km, and sea.
/// let greys = [49_151, 49_151, 49_151, 49_151, 16_384, 16_384, 16_384, 16_384];
/// std::fs::write(folder.path().join("island.png"), grey_png(4, greys.into_iter())?)?;
///
/// let planet = load_planet(&path)?;
/// assert_eq!(planet.planet.radius, 3000.0);
/// let highest = planet.crust.elevation.iter().copied().fold(f32::MIN, f32::max);
/// assert!((highest - 6.0).abs() < 0.01);
/// # Ok(())
/// # }
/// # #[cfg(not(feature = "export"))]
/// # fn main() {}
/// ```
///
/// # Errors
/// [`IoError`] names the file that cannot be read, or is refused: that of a map where it is a map.
pub fn load_planet(path: &Path) -> Result<PlanetState, IoError> {
    Ok(load_planet_with_notes(path)?.planet)
}

/// The same, with what its user should know of its maps.
///
/// # Errors
/// As [`load_planet`].
pub fn load_planet_with_notes(path: &Path) -> Result<LoadedPlanet, IoError> {
    match PlanetFileKind::of(path) {
        PlanetFileKind::Save => Ok(save::load(path)?.into()),
        PlanetFileKind::Terrain => {
            let file: TerrainFile =
                parse(&read_text(path)?).map_err(|problem| problem.in_file(path))?;
            file.planet(path)
        }
        PlanetFileKind::Elevation => TerrainFile::of_elevation(path).planet(path),
    }
}

#[cfg(all(test, feature = "export"))]
mod tests;
