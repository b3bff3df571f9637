//! The ground as files: squares, blocks of tiles, boxes of degrees.
//!
//! ```text
//! geotiff   *.tif: one band of f32 in m, georeferenced on the planet by its geo_keys
//! greys     *.png, *.r16, *.raw: 16-bit grey, with a sidecar *.json to decode it
//! exr       *.exr: f32 in m
//! mesh      *.glb: triangles in m, in the frame of glb
//!
//! format    which of them a name asks for
//! names     the files of an export
//! area      the part of the planet
//! scratch   its heights on the disk, while files are written
//! encoding  one file at work
//! manifest  *.json of tiles, with the figures of engines
//! job       from the ground to the files
//! ```
//!
//! All show the same: heights at points of a map, rows from the north. Squares and tiles are
//! azimuthal equidistant, boxes plate carrée. Writers stream: the size of an export is bounded by
//! the disk.

mod error;

mod format;

mod names;

mod area;

mod scratch;

mod encoding;

mod geo_keys;

mod geotiff;

mod greys;

mod exr;

mod glb;

mod mesh;

mod engines;

mod manifest;

mod job;

pub use area::ExportArea;
pub use error::ExportError;
pub use format::ExportFormat;
pub use job::{ExportJob, Exported};
pub use names::ExportFiles;

use crate::query::Ground;
use std::path::{Path, PathBuf};

/// Writes an area of the ground at the level that its pixels ask for; the extension of `path` says
/// in which format. Returns the files, which are written all or none. [`ExportJob`] does it with
/// more to choose.
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
/// let files = export(&Hills, square, &folder.path().join("hills.png"))?;
/// assert_eq!(files.len(), 2, "a picture and its sidecar");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ExportError`]; nothing is written then.
pub fn export(
    ground: &(impl Ground + ?Sized),
    area: impl Into<ExportArea>,
    path: &Path,
) -> Result<Vec<PathBuf>, ExportError> {
    let job = ExportJob::new(area, path)?;
    Ok(job.run(ground, |_| true)?.files)
}

#[cfg(all(test, feature = "dem"))]
mod tests;
