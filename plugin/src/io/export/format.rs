//! The formats that heights are written in.

use super::error::ExportError;
use crate::query::MapSquare;
use bevy::prelude::*;
use std::path::Path;

/// The formats that heights are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Reflect)]
pub enum ExportFormat {
    /// GeoTIFF, `.tif`: f32 in m.
    GeoTiff,
    /// 16-bit grey PNG with a sidecar, `.png`.
    Grey,
    /// 16-bit greys without a header, little endian, with a sidecar: `.r16`, `.raw`.
    Raw,
    /// OpenEXR, `.exr`: f32 in m.
    Exr,
    /// Binary glTF, `.glb`: triangles in m.
    Mesh,
}

impl ExportFormat {
    /// The format that a file's extension asks for.
    ///
    /// # Errors
    /// [`ExportError::Extension`]
    pub fn of(path: &Path) -> Result<Self, ExportError> {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("tif" | "tiff") => Ok(Self::GeoTiff),
            Some("png") => Ok(Self::Grey),
            Some("r16" | "raw") => Ok(Self::Raw),
            Some("exr") => Ok(Self::Exr),
            Some("glb") => Ok(Self::Mesh),
            _ => Err(ExportError::Extension(path.to_path_buf())),
        }
    }

    /// The extension.
    pub fn name(self) -> &'static str {
        match self {
            Self::GeoTiff => ".tif",
            Self::Grey => ".png",
            Self::Raw => ".r16",
            Self::Exr => ".exr",
            Self::Mesh => ".glb",
        }
    }

    /// Whether heights become 16-bit greys, which need a sidecar and take a range.
    pub fn has_greys(self) -> bool {
        matches!(self, Self::Grey | Self::Raw)
    }

    /// Most pixels to a side: a mesh of more would not fit into a file of four gigabytes.
    pub fn max_pixels(self) -> usize {
        match self {
            Self::Mesh => 8192,
            _ => MapSquare::MAX_PIXELS,
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
