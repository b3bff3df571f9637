//! The formats that heights are written in.

use super::error::ExportError;
use crate::named::named_enum;
use crate::query::MapSquare;
use std::path::Path;

named_enum! {
    /// The formats that heights are written in. Their names are extensions.
    pub enum ExportFormat {
        /// GeoTIFF, `.tif`: f32 in m.
        GeoTiff = ".tif",
        /// 16-bit grey PNG with a sidecar, `.png`.
        Grey = ".png",
        /// 16-bit greys without a header, little endian, with a sidecar: `.r16`, `.raw`.
        Raw = ".r16",
        /// OpenEXR, `.exr`: f32 in m.
        Exr = ".exr",
        /// Binary glTF, `.glb`: triangles in m.
        Mesh = ".glb",
    }
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
