//! The formats that squares are written in.

use super::error::ExportError;
use crate::query::MapSquare;
use bevy::prelude::*;
use std::path::Path;

/// The formats that squares are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Reflect)]
pub enum ExportFormat {
    /// GeoTIFF, `.tif`.
    GeoTiff,
    /// 16-bit grey PNG with a sidecar, `.png`.
    Grey,
    /// Binary glTF, `.glb`.
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
