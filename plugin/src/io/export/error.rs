//! Why a square was not exported.

use crate::io::IoError;
use crate::query::GroundError;
use std::path::PathBuf;
use thiserror::Error;

/// Why a square was not exported.
#[derive(Debug, Error)]
pub enum ExportError {
    /// Files with the name's extension are not written.
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

/// The error of a file that could not be encoded.
pub(super) fn cannot_encode(error: impl ToString) -> ExportError {
    ExportError::Encode(error.to_string())
}
