//! Squares of the ground as files.
//!
//! ```text
//! geotiff   *.tif: one band of f32 in m, georeferenced on the planet
//! grey      *.png: 16-bit grey, with a sidecar *.json to decode it
//! mesh      *.glb: triangles in m
//! ```
//!
//! All show the same: an azimuthal equidistant square, north up, values at the centres of pixels.

mod error;

mod format;

mod geotiff;

mod grey;

mod mesh;

pub use error::ExportError;
pub use format::ExportFormat;

use super::{Output, write_all};
use crate::query::{Ground, HeightGrid, MapSquare};
use error::cannot_encode;
use std::path::{Path, PathBuf};

/// The files that show `grid`, the heights of `square`: the one at `path`, and a sidecar beside a
/// picture.
///
/// # Errors
/// [`ExportError::Extension`], [`ExportError::Pixels`], [`ExportError::Encode`].
pub fn encode(
    square: &MapSquare,
    grid: &HeightGrid,
    path: &Path,
) -> Result<Vec<(PathBuf, Vec<u8>)>, ExportError> {
    let format = ExportFormat::of(path)?;
    format.check(square.pixels())?;
    if grid.width != square.pixels()
        || grid.height != square.pixels()
        || !grid.values.iter().all(|z| z.is_finite())
    {
        return Err(cannot_encode("the heights are not those of the square"));
    }
    let path = path.to_path_buf();
    match format {
        ExportFormat::GeoTiff => Ok(vec![(path, geotiff::encode(square, grid)?)]),
        ExportFormat::Grey => {
            let sidecar = path.with_extension("json");
            let (picture, text) = grey::encode(square, grid)?;
            Ok(vec![(path, picture), (sidecar, text)])
        }
        ExportFormat::Mesh => Ok(vec![(path, mesh::encode(square, grid)?)]),
    }
}

/// The files that [`encode`] makes for `path`, for [`check_outputs`](super::check_outputs).
///
/// # Errors
/// [`ExportError::Extension`]
pub fn outputs(path: &Path) -> Result<Vec<Output>, ExportError> {
    let mut outputs = vec![Output::named(path)];
    if ExportFormat::of(path)? == ExportFormat::Grey {
        outputs.push(Output::beside(path.with_extension("json")));
    }
    Ok(outputs)
}

/// Writes a square of the ground at the level that its pixels ask for; the extension of `path` says
/// in which format. Returns the files, which are written all or none.
///
/// ```
/// use bevy::math::DVec3;
/// use bevy_pangaea::io::export;
/// use bevy_pangaea::query::{AzimuthalEquidistant, Ground, GroundError, MapSquare};
///
/// /// Hills on a small planet.
/// struct Hills;
///
/// impl Ground for Hills {
///     fn radius_m(&self) -> f64 {
///         100_000.0
///     }
///
///     fn height(&self, direction: DVec3, _level: u8) -> Result<f32, GroundError> {
///         Ok((100.0 * (20.0 * direction.x).sin()) as f32)
///     }
/// }
///
/// # let folder = tempfile::tempdir()?;
/// let place = AzimuthalEquidistant::new(45.0, 7.0, Hills.radius_m())?;
/// let square = MapSquare::new(place, 1000.0, 16)?;
/// let files = export(&Hills, &square, &folder.path().join("hills.png"))?;
/// assert_eq!(files.len(), 2, "a picture and its sidecar");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ExportError`]; nothing is written then.
pub fn export(
    ground: &(impl Ground + ?Sized),
    square: &MapSquare,
    path: &Path,
) -> Result<Vec<PathBuf>, ExportError> {
    // Refused before the ground is asked a million times.
    ExportFormat::of(path)?.check(square.pixels())?;
    let grid = square.heights(ground, square.level())?;
    let files = encode(square, &grid, path)?;
    write_all(&outputs(path)?, |k, out| out.write_all(&files[k].1))?;
    Ok(files.into_iter().map(|(path, _)| path).collect())
}

#[cfg(all(test, feature = "dem"))]
mod tests;
