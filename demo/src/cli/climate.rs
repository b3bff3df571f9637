//! Maps of a user that replace fields of the climate, as options of all commands that ask for
//! rivers or for the ground.

use crate::error::CliError;
use crate::output::say;
use bevy_pangaea::climate::{ClimateField, ClimateMaps};
use bevy_pangaea::io::{load_climate_maps, raster_files};
use clap::Args;
use std::path::{Path, PathBuf};

/// Maps that replace fields of the climate.
#[derive(Args, Debug, Default, Clone)]
pub struct ClimateArgs {
    /// Map of the mean temperature of a year at the ground in °C, to use instead of the planet's
    /// own
    ///
    /// Maps show the planet all around, equirectangular. Without a place they are whole, north up,
    /// 180° W at the left edge, twice as wide as high. A .tif that tells its place, by its tags, a
    /// .tif.aux.xml or a .tfw, may begin at any meridian, go south up, hold values at nodes and
    /// leave out latitudes, which are voids; a .png may tell one by a .pgw. A .tif holds values; if
    /// it tells their unit, such as K, degF, m or kg m-2 s-1, they are converted, and others are
    /// refused. A grey .png needs a sidecar NAME.json {"min", "max"}: the values of black and white.
    /// Voids, pixels without a value, are filled from the planet's own climate. Rasters wider than
    /// 8192 pixels count by the means of their pixels.
    #[arg(long, value_name = "MAP")]
    pub temperature: Option<PathBuf>,
    /// Map of the rain of a year in mm
    #[arg(long, value_name = "MAP")]
    pub rain: Option<PathBuf>,
    /// Map of the wetness W, 0 (deserts) to 1 (rain forests); without a sidecar white is 1
    #[arg(long, value_name = "MAP")]
    pub wetness: Option<PathBuf>,
}

impl ClimateArgs {
    /// Reads the maps, and says what is to say of them.
    ///
    /// # Errors
    /// Names the first file that cannot be read, is no map of a planet, or has values that no
    /// climate has.
    pub fn load(&self) -> Result<ClimateMaps, CliError> {
        let given = ClimateField::ALL.into_iter();
        let files = given.filter_map(|field| Some((field, self.file(field)?)));
        let loaded = load_climate_maps(files)?;
        loaded.notes.iter().for_each(|note| say(note));
        Ok(loaded.maps)
    }

    /// The files of the maps, and those that belong to them.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        ClimateField::ALL
            .into_iter()
            .filter_map(|field| self.file(field))
            .flat_map(raster_files)
    }

    /// The file of the map of a field.
    fn file(&self, field: ClimateField) -> Option<&Path> {
        let file = match field {
            ClimateField::Temperature => &self.temperature,
            ClimateField::Rain => &self.rain,
            ClimateField::Wetness => &self.wetness,
        };
        file.as_deref()
    }
}
