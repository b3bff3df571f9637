//! Maps of the whole planet, as a user gives them: equirectangular, north up, longitude -180 at the
//! left edge.
//!
//! A GeoTIFF of one band holds the values themselves; one that says where it is may begin at any
//! meridian, and its rows in the south. A PNG holds greys, in whatever form: what
//! black and white stand for is told by a sidecar NAME.json, `{"min": -40, "max": 35}`, or by the
//! caller; values between are linear.
//!
//! Pixels without a value, such as the sea in an archive of land, are voids: nodata of a GeoTIFF,
//! transparent pixels of a PNG.

mod error;

mod turn;

mod reduce;

pub use error::MapFileError;
pub(super) use reduce::reduced;

use super::IoError;
use super::dem::geotiff::RasterFile;
use super::dem::picture::Greys;
use super::dem::{extension, open, read_limited};
use super::{sidecar, text};
use crate::climate::EquirectMap;
use std::io::{Read, Seek};
use std::path::Path;

/// Reads a map; its extension says of which kind. `grey` are the values of black and white of a
/// picture that has no sidecar.
///
/// ```
/// # #[cfg(feature = "export")]
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use bevy_pangaea::io::{load_map, png::grey_png};
///
/// # let folder = tempfile::tempdir()?;
/// let path = folder.path().join("rain.png");
/// let greys = [0, 65_535, 0, 65_535, 0, 0, 0, 0];
/// std::fs::write(&path, grey_png(4, greys.into_iter())?)?;
///
/// let rain = load_map(&path, Some([0.0, 2000.0]))?;
/// assert_eq!(rain.size(), [4, 2]);
/// # Ok(())
/// # }
/// # #[cfg(not(feature = "export"))]
/// # fn main() {}
/// ```
///
/// # Errors
/// [`IoError::Read`] if the file cannot be read, [`IoError::Map`] if it is no map of a whole
/// planet.
pub fn load_map(path: &Path, grey: Option<[f32; 2]>) -> Result<EquirectMap, IoError> {
    let refused = |source| IoError::map(path, source);
    match extension(path).as_deref() {
        Some("tif" | "tiff") => geotiff(open(path)?).map_err(refused),
        Some("png") => {
            let bytes = read_limited(path)?;
            picture(&bytes, black_and_white(path, grey)?).map_err(refused)
        }
        _ => Err(refused(MapFileError::Extension)),
    }
}

/// The values of black and white of a picture: those of its sidecar, which knows best, or the
/// caller's.
fn black_and_white(picture: &Path, grey: Option<[f32; 2]>) -> Result<[f32; 2], IoError> {
    let sidecar = sidecar::beside(picture);
    if sidecar.exists() {
        return MapSidecar::load(&sidecar);
    }
    let missing = || MapFileError::NoScale(sidecar.display().to_string());
    grey.ok_or_else(|| IoError::map(picture, missing()))
}

/// Values of black and white.
#[derive(serde::Deserialize)]
struct MapSidecar {
    min: f32,
    max: f32,
}

impl MapSidecar {
    /// The values of black and white in a sidecar.
    fn load(path: &Path) -> Result<[f32; 2], IoError> {
        let scale: Option<Self> = text::parse_json(&read_limited(path)?).ok();
        scale
            .filter(|s| s.min.is_finite() && s.max.is_finite() && s.min != s.max)
            .map(|s| [s.min, s.max])
            .ok_or_else(|| IoError::map(path, MapFileError::Sidecar))
    }
}

fn check_size(width: u32, height: u32) -> Result<(), MapFileError> {
    Ok(EquirectMap::check_size(width, height)?)
}

/// Reads a raster of values.
fn geotiff(source: impl Read + Seek) -> Result<EquirectMap, MapFileError> {
    let mut raster = RasterFile::open(source, check_size)?;
    let size = raster.size();
    let column = turn::first_column(raster.extent_deg()?, size)?;
    let mut values = raster.values(1.0)?;
    turn::turn(&mut values, size[0], column);
    Ok(EquirectMap::new(size[0], size[1], values)?)
}

/// Reads a picture with these values of black and white.
fn picture(bytes: &[u8], ends: [f32; 2]) -> Result<EquirectMap, MapFileError> {
    let [black, white] = ends.map(f64::from);
    let Greys { size, values } = Greys::read(bytes, check_size, |grey| grey.between(black, white))?;
    Ok(EquirectMap::new(size[0], size[1], values)?)
}

#[cfg(all(test, feature = "export"))]
mod tests;
