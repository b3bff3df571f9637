//! Why heights were not exported.

use crate::io::IoError;
use crate::query::GroundError;
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why heights were not exported.
#[derive(Debug, Error)]
pub enum ExportError {
    /// Files with the name's extension are not written.
    #[error(
        "cannot write {}: the file must end in .tif, .png, .r16, .raw, .exr or .glb",
        .0.display()
    )]
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
    /// A range of greys that is empty or not finite.
    #[error("the range of greys must go up, not from {0} to {1} m")]
    Range(f64, f64),
    /// A range for a format without greys.
    #[error("a range of greys is for .png, .r16 and .raw; {0} holds metres")]
    NoGreys(&'static str),
    /// A mesh of a box of degrees.
    #[error("a box of degrees is not written as a mesh: give .tif, .png, .r16, .raw or .exr")]
    MeshOfBox,
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

/// The error of a write that the caller stopped, or that lacks memory.
pub(super) fn as_io_error(error: GroundError) -> io::Error {
    match error {
        GroundError::Memory => io::ErrorKind::OutOfMemory.into(),
        error => io::Error::other(error),
    }
}
