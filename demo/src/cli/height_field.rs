//! A height field that is laid upon the ground, as options of `export` and `query`.

use crate::dem::tell_means;
use crate::error::CliError;
use crate::values::{PlaceSpec, place};
use bevy_pangaea::io::{load_dem, raster_files};
use bevy_pangaea::query::{AzimuthalEquidistant, HeightField};
use clap::Args;
use std::path::PathBuf;

/// Part of the shorter side of a field over which it blends into the ground at its rim.
const RIM: f64 = 0.125;

/// A height field, and its place.
#[derive(Args, Debug, Default, Clone)]
pub struct HeightFieldArgs {
    /// Heights of your own at a place, instead of the planet's
    ///
    /// An elevation model in metres above sea level, north up, in the true size of its pixels: .hgt,
    /// GeoTIFF, or grey PNG with a sidecar NAME.json {metres_per_pixel, metres_per_unit}. Over an
    /// eighth of its shorter side it blends into the ground around it; levels finer than its pixels
    /// add the planet's roughness. Of more than 16 million pixels blocks count by their means.
    #[arg(long, value_name = "FILE")]
    pub height_field: Option<PathBuf>,
    /// Middle of the height field in degrees [default: the place that the file tells]
    #[arg(
        long,
        value_name = "LAT,LON",
        allow_hyphen_values = true,
        value_parser = place,
        requires = "height_field"
    )]
    pub height_field_at: Option<PlaceSpec>,
}

impl HeightFieldArgs {
    /// The files of the field.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        self.height_field
            .as_deref()
            .into_iter()
            .flat_map(raster_files)
    }

    /// Reads the field, if there is one, for a planet of `radius_m`.
    ///
    /// # Errors
    /// If the file is refused, or neither it nor the user tells its place.
    pub fn load(&self, radius_m: f64) -> Result<Option<HeightField>, CliError> {
        let Some(path) = &self.height_field else {
            return Ok(None);
        };
        let tile = load_dem(path)?;
        tell_means(path, &tile);
        let place = self.height_field_at.map(|at| (at.lat, at.lon));
        let Some((lat, lon)) = place.or(tile.centre) else {
            return Err(CliError::input(format!(
                "--height-field: {} does not tell its place; give --height-field-at LAT,LON",
                path.display()
            )));
        };
        let [across, down] = tile.grid.pixel_m;
        let shorter = (across * tile.grid.width as f64).min(down * tile.grid.height as f64);
        let about = AzimuthalEquidistant::new(lat, lon, radius_m)?;
        Ok(Some(HeightField::new(about, tile.grid, RIM * shorter)?))
    }
}
