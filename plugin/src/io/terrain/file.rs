//! The fields of a terrain file, and the planet that they describe.

use super::elevation::HeightUnit;
use super::loaded::LoadedPlanet;
use crate::climate::{ClimateField, EARTH_RADIUS, EquirectMap};
use crate::hydrology::TerrainMaps;
use crate::io::IoError;
use crate::io::maps::{
    LoadedClimate, MapFileError, MapQuantity, load_climate_maps, load_map_of, reduced,
};
use crate::io::text::TextError;
use crate::planet::Planet;
use crate::spawn::PlanetState;
use std::path::{Path, PathBuf};

/// The place of a map among others.
type TerrainField = fn(&mut TerrainMaps) -> &mut Option<EquirectMap>;

/// The fields of a terrain file.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TerrainFile {
    elevation: PathBuf,
    #[serde(default)]
    unit: HeightUnit,
    #[serde(default = "earth_radius")]
    radius: f64,
    #[serde(default)]
    seed: u64,
    age: Option<PathBuf>,
    plateaus: Option<PathBuf>,
    hills: Option<PathBuf>,
    temperature: Option<PathBuf>,
    rain: Option<PathBuf>,
    wetness: Option<PathBuf>,
}

fn earth_radius() -> f64 {
    EARTH_RADIUS
}

impl TerrainFile {
    /// The file that would name this map and nothing else, in the same folder.
    pub(super) fn of_elevation(map: &Path) -> Self {
        Self {
            elevation: map.file_name().unwrap_or_default().into(),
            unit: HeightUnit::Metres,
            radius: earth_radius(),
            seed: 0,
            age: None,
            plateaus: None,
            hills: None,
            temperature: None,
            rain: None,
            wetness: None,
        }
    }

    /// The maps that a file at `path` names.
    pub(super) fn maps(&self, path: &Path) -> Vec<PathBuf> {
        let folder = path.parent().unwrap_or(Path::new(""));
        let others = [
            &self.age,
            &self.plateaus,
            &self.hills,
            &self.temperature,
            &self.rain,
            &self.wetness,
        ];
        core::iter::once(&self.elevation)
            .chain(others.into_iter().flatten())
            .map(|map| folder.join(map))
            .collect()
    }

    /// The planet of a file at `path`.
    pub(super) fn planet(&self, path: &Path) -> Result<LoadedPlanet, IoError> {
        let folder = path.parent().unwrap_or(Path::new(""));
        let planet = Planet {
            radius: self.radius,
            seed: self.seed,
        };
        let terrain = self.terrain(folder)?;
        let climate = self.climate(folder)?;
        let state = PlanetState::from_maps(planet, terrain).map_err(|error| {
            let problem = error.to_string();
            TextError { line: 0, problem }.in_file(path)
        })?;
        let planet = PlanetState {
            climate: climate.maps,
            ..state
        };
        let notes = climate.notes;
        Ok(LoadedPlanet { planet, notes })
    }

    fn terrain(&self, folder: &Path) -> Result<TerrainMaps, IoError> {
        let mut maps = TerrainMaps {
            crust: self.unit.load(&folder.join(&self.elevation))?,
            age: None,
            plateau: None,
            hills: None,
        };
        let fields: [(_, _, TerrainField); 3] = [
            (&self.age, MapQuantity::Age, |maps| &mut maps.age),
            (&self.plateaus, MapQuantity::Share, |maps| &mut maps.plateau),
            (&self.hills, MapQuantity::Share, |maps| &mut maps.hills),
        ];
        for (file, quantity, field) in fields {
            let Some(file) = file else { continue };
            let path = folder.join(file);
            let refused = |error| IoError::map(&path, MapFileError::Map(error));
            let map = load_map_of(&path, quantity, quantity.greys())?.map;
            *field(&mut maps) = Some(map.clone());
            // What was read before is good: it is this file that is refused.
            maps.check().map_err(refused)?;
            *field(&mut maps) = Some(reduced(&map).map_err(refused)?);
        }
        Ok(maps)
    }

    fn climate(&self, folder: &Path) -> Result<LoadedClimate, IoError> {
        let fields = [
            (&self.temperature, ClimateField::Temperature),
            (&self.rain, ClimateField::Rain),
            (&self.wetness, ClimateField::Wetness),
        ];
        let given = fields
            .into_iter()
            .filter_map(|(file, field)| Some((field, folder.join(file.as_ref()?))));
        let files: Vec<(ClimateField, PathBuf)> = given.collect();
        load_climate_maps(files.iter().map(|(field, path)| (*field, path.as_path())))
    }
}
