//! Squares of the ground as files.
//!
//! ```text
//! geotiff   *.tif: one band of f32 in m, georeferenced on the planet
//! grey      *.png: 16-bit grey, with a sidecar *.json to decode it
//! mesh      *.glb: triangles in m
//! ```
//!
//! All show the same: an azimuthal equidistant square, north up, values at the centres of pixels.

mod geotiff;

mod grey;

mod mesh;

use super::{IoError, write_all_atomically};
use crate::query::{Ground, GroundError, HeightGrid, MapSquare};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a square was not exported.
#[derive(Debug, Error)]
pub enum ExportError {
    /// The name's extension is none of those that are written.
    #[error("cannot write {}: the file must end in .tif, .png or .glb", .0.display())]
    Extension(PathBuf),
    /// More pixels than the format takes.
    #[error("{format} takes at most {most} pixels to a side, not {pixels}")]
    Pixels {
        /// The format's extension.
        format: &'static str,
        /// Most pixels to a side.
        most: usize,
        /// Pixels asked for.
        pixels: usize,
    },
    /// The ground could not be asked.
    #[error(transparent)]
    Ground(#[from] GroundError),
    /// The file could not be encoded.
    #[error("cannot encode the file: {0}")]
    Encode(String),
    /// The file could not be written.
    #[error(transparent)]
    Io(#[from] IoError),
}

/// The formats that squares are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// GeoTIFF, `.tif`.
    GeoTiff,
    /// 16-bit grey PNG with a sidecar, `.png`.
    Grey,
    /// Binary glTF, `.glb`.
    Mesh,
}

impl Format {
    /// The format that a file's extension asks for.
    ///
    /// # Errors
    /// [`ExportError::Extension`]
    pub fn of(path: &Path) -> Result<Self, ExportError> {
        match path
            .extension()
            .unwrap_or_default()
            .to_ascii_lowercase()
            .to_str()
        {
            Some("tif" | "tiff") => Ok(Self::GeoTiff),
            Some("png") => Ok(Self::Grey),
            Some("glb") => Ok(Self::Mesh),
            _ => Err(ExportError::Extension(path.to_path_buf())),
        }
    }

    /// The extension.
    pub fn name(self) -> &'static str {
        match self {
            Self::GeoTiff => ".tif",
            Self::Grey => ".png",
            Self::Mesh => ".glb",
        }
    }

    /// Most pixels to a side: a mesh of more would not fit into a file of four gigabytes.
    pub fn max_pixels(self) -> usize {
        match self {
            Self::GeoTiff | Self::Grey => MapSquare::MAX_PIXELS,
            Self::Mesh => 8192,
        }
    }

    /// Refuses more pixels to a side than the format takes.
    ///
    /// # Errors
    /// [`ExportError::Pixels`]
    pub fn check(self, pixels: usize) -> Result<(), ExportError> {
        let most = self.max_pixels();
        if pixels <= most {
            Ok(())
        } else {
            Err(ExportError::Pixels {
                format: self.name(),
                most,
                pixels,
            })
        }
    }
}

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
    let format = Format::of(path)?;
    format.check(square.pixels())?;
    if grid.width != square.pixels()
        || grid.height != square.pixels()
        || !grid.values.iter().all(|z| z.is_finite())
    {
        return Err(ExportError::Encode(
            "the heights are not those of the square".into(),
        ));
    }
    let path = path.to_path_buf();
    match format {
        Format::GeoTiff => Ok(vec![(path, geotiff::encode(square, grid)?)]),
        Format::Grey => {
            let sidecar = path.with_extension("json");
            let (picture, text) = grey::encode(square, grid)?;
            Ok(vec![(path, picture), (sidecar, text)])
        }
        Format::Mesh => Ok(vec![(path, mesh::encode(square, grid)?)]),
    }
}

/// Writes a square of the ground at the level that its pixels ask for; the extension of `path` says
/// in which format. Returns the files, which are written all or none.
///
/// # Errors
/// [`ExportError`]; nothing is written then.
pub fn export(
    ground: &(impl Ground + ?Sized),
    square: &MapSquare,
    path: &Path,
) -> Result<Vec<PathBuf>, ExportError> {
    // Refused before the ground is asked a million times.
    Format::of(path)?.check(square.pixels())?;
    let grid = square.heights(ground, square.level())?;
    let files = encode(square, &grid, path)?;
    write_all_atomically(&files)?;
    Ok(files.into_iter().map(|(path, _)| path).collect())
}

#[cfg(test)]
mod tests;
