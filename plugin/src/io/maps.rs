//! Maps of the whole planet, as a user gives them: equirectangular, north up, longitude -180 at the
//! left edge.
//!
//! A GeoTIFF of one band holds the values themselves. A grey PNG of 8 or 16 bits holds greys: what
//! black and white stand for is told by a sidecar NAME.json, `{"min": -40, "max": 35}`, or by
//! whoever asks for the map; values between are linear.

use super::IoError;
use super::dem::geotiff::Band;
use super::dem::grey::Greys;
use super::dem::{DemError, read_limited};
use crate::climate::{EquirectMap, MapError};
use std::path::Path;
use thiserror::Error;

/// Why a file is no map.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum MapFileError {
    /// The name's extension is none of those that are read.
    #[error("maps are .tif, .tiff or .png files")]
    Extension,
    /// The file cannot be decoded.
    #[error(transparent)]
    Raster(#[from] DemError),
    /// It shows a part of the planet, or begins at another meridian.
    #[error("the map reaches from {} to {} °E and from {} to {} °N; it must reach from -180 to 180 and from -90 to 90",
        .0[0], .0[1], .0[2], .0[3])]
    Extent([f64; 4]),
    /// A picture of which nobody says what black and white are.
    #[error(
        "a grey picture needs a sidecar {0} with the values of black and white, {{\"min\": .., \"max\": ..}}"
    )]
    NoScale(String),
    /// A sidecar that is no such JSON.
    #[error("the sidecar must be {{\"min\": .., \"max\": ..}}, two different finite numbers")]
    Sidecar,
    /// Its size or its values are none of a map.
    #[error(transparent)]
    Map(#[from] MapError),
}

/// Values of black and white.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Scale {
    min: f32,
    max: f32,
}

impl Scale {
    /// The values of black and white that a sidecar tells.
    fn load(path: &Path) -> Result<[f32; 2], IoError> {
        let scale = serde_json::from_slice(&read_limited(path)?).ok();
        let good = |&Self { min, max }: &Self| min.is_finite() && max.is_finite() && min != max;
        let refused = || IoError::Map {
            path: path.to_path_buf(),
            source: MapFileError::Sidecar,
        };
        scale
            .filter(good)
            .map(|Self { min, max }| [min, max])
            .ok_or_else(refused)
    }
}

/// Reads a map; its extension says of which kind. `grey` are the values of black and white of a
/// picture that has no sidecar.
///
/// # Errors
/// [`IoError::Read`] if the file cannot be read, [`IoError::Map`] if it is no map of a whole
/// planet.
pub fn load_map(path: &Path, grey: Option<[f32; 2]>) -> Result<EquirectMap, IoError> {
    let refused = |source: MapFileError| IoError::Map {
        path: path.to_path_buf(),
        source,
    };
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    match extension.to_str() {
        Some("tif" | "tiff") => geotiff(&read_limited(path)?).map_err(refused),
        Some("png") => {
            let bytes = read_limited(path)?;
            let sidecar = path.with_extension("json");
            let scale = match grey {
                // The sidecar knows best.
                _ if sidecar.exists() => Scale::load(&sidecar)?,
                Some(scale) => scale,
                None => {
                    return Err(refused(MapFileError::NoScale(
                        sidecar.display().to_string(),
                    )));
                }
            };
            picture(&bytes, scale).map_err(refused)
        }
        _ => Err(refused(MapFileError::Extension)),
    }
}

fn check_size(width: u32, height: u32) -> Result<(), MapFileError> {
    Ok(EquirectMap::check_size(width, height)?)
}

fn geotiff(bytes: &[u8]) -> Result<EquirectMap, MapFileError> {
    let mut band = Band::read(bytes, check_size)?;
    // Climate data often begins at Greenwich: half a planet off is worse than no map.
    if let Some(extent) = band.extent_deg() {
        let pixel = 360.0 / f64::from(band.size[0]);
        let whole = extent
            .iter()
            .zip([-180.0, 180.0, -90.0, 90.0])
            .all(|(x, end)| (x - end).abs() <= pixel);
        if !whole {
            return Err(MapFileError::Extent(extent));
        }
    }
    Ok(EquirectMap::new(band.size[0], band.size[1], band.values)?)
}

fn picture(bytes: &[u8], [black, white]: [f32; 2]) -> Result<EquirectMap, MapFileError> {
    let Greys {
        size: [width, height],
        values,
        ..
    } = Greys::read(bytes, check_size)?;
    let value = |&grey: &u16| {
        let share = f64::from(grey) / 65_535.0;
        (f64::from(black) * (1.0 - share) + f64::from(white) * share) as f32
    };
    Ok(EquirectMap::new(
        width,
        height,
        values.iter().map(value).collect(),
    )?)
}

#[cfg(test)]
#[path = "maps_tests.rs"]
mod tests;
