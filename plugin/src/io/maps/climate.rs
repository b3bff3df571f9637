//! Maps that replace fields of the climate, and what to say of them.

use super::error::MapFileError;
use super::load::{LoadedMap, load_map_of};
use super::units::MapQuantity;
use crate::climate::{ClimateField, ClimateMaps, EquirectMap};
use crate::io::IoError;
use std::path::Path;

/// Maps of the climate, and what their user should know of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadedClimate {
    /// The maps.
    pub maps: ClimateMaps,
    /// Voids that the planet's own climate fills, and doubts of units, a line each that names the
    /// file.
    pub notes: Vec<String>,
}

/// Reads the maps of fields of the climate. Wetness from a grey picture without a sidecar reaches
/// from 0 to 1; other pictures need one.
///
/// ```
/// # #[cfg(feature = "export")]
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use bevy_pangaea::climate::ClimateField;
/// use bevy_pangaea::io::{load_climate_maps, png::grey_png};
///
/// # let folder = tempfile::tempdir()?;
/// let path = folder.path().join("wetness.png");
/// std::fs::write(&path, grey_png(4, [0, 65_535].repeat(4).into_iter())?)?;
///
/// let climate = load_climate_maps([(ClimateField::Wetness, path.as_path())])?;
/// assert!(climate.maps.wetness.is_some() && climate.notes.is_empty());
/// # Ok(())
/// # }
/// # #[cfg(not(feature = "export"))]
/// # fn main() {}
/// ```
///
/// # Errors
/// Names the first file that cannot be read, is no map of a planet, or has values that no climate
/// has.
pub fn load_climate_maps<'a>(
    files: impl IntoIterator<Item = (ClimateField, &'a Path)>,
) -> Result<LoadedClimate, IoError> {
    let mut all = LoadedClimate::default();
    for (field, path) in files {
        let quantity = MapQuantity::of(field);
        let LoadedMap { map, warnings } = load_map_of(path, quantity, quantity.greys())?;
        all.notes.extend(voids(path, &map));
        let warnings = warnings.into_iter();
        all.notes
            .extend(warnings.map(|doubt| format!("warning: {}: {doubt}", path.display())));
        all.maps.set(field, map);
        // What was read before is good: it is this file that is refused.
        all.maps
            .check()
            .map_err(|problem| IoError::map(path, MapFileError::Map(problem)))?;
    }
    Ok(all)
}

/// How many voids of a map are filled, if any.
fn voids(path: &Path, map: &EquirectMap) -> Option<String> {
    let [width, height] = map.size().map(u64::from);
    (map.voids() > 0).then(|| {
        format!(
            "{}: {} voids of {} pixels are filled from the planet's own climate",
            path.display(),
            map.voids(),
            width * height
        )
    })
}
