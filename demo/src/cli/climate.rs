//! Maps of a user that replace fields of the climate, as options of all commands that ask for
//! rivers or for the ground.

use crate::error::CliError;
use crate::output::say;
use bevy_pangaea::climate::{ClimateField, ClimateMaps, EquirectMap};
use bevy_pangaea::io::load_map;
use clap::Args;
use std::path::{Path, PathBuf};

/// Maps that replace fields of the climate.
#[derive(Args, Debug, Default, Clone)]
pub struct ClimateArgs {
    /// Map of the mean temperature of a year at the ground in °C, to use instead of the planet's
    /// own
    ///
    /// Maps show the whole planet, equirectangular, north up, 180° W at the left edge. A .tif holds
    /// values. A grey .png needs a sidecar NAME.json {"min", "max"}: the values of black and white.
    /// Voids, pixels without a value, are filled from the planet's own climate.
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
    /// Reads the maps, and says how many voids the planet's own climate will fill.
    ///
    /// # Errors
    /// Names the first file that cannot be read, is no map of a planet, or has values that no
    /// climate has.
    pub fn load(&self) -> Result<ClimateMaps, CliError> {
        let mut maps = ClimateMaps::default();
        for field in ClimateField::ALL {
            let (file, grey) = match field {
                ClimateField::Temperature => (&self.temperature, None),
                ClimateField::Rain => (&self.rain, None),
                ClimateField::Wetness => (&self.wetness, Some([0.0, 1.0])),
            };
            let Some(path) = file else { continue };
            let map = load_map(path, grey)?;
            maps.set(field, map.clone());
            // What was read before is good: it is this file that is refused.
            maps.check()
                .map_err(|problem| CliError::input(format!("{}: {problem}", path.display())))?;
            tell_voids(path, &map);
        }
        Ok(maps)
    }
}

/// Says how many voids of a map are filled.
fn tell_voids(path: &Path, map: &EquirectMap) {
    let [width, height] = map.size().map(u64::from);
    if map.voids() > 0 {
        say(&format!(
            "{}: {} voids of {} pixels are filled from the planet's own climate",
            path.display(),
            map.voids(),
            width * height
        ));
    }
}
