//! Why bytes are no elevation model.

use thiserror::Error;

/// Most pixels to a side.
pub(in crate::io) const MAX_SIDE: u32 = 100_000;

/// Size of the largest text that is read.
pub(super) const MAX_BYTES: u64 = 1 << 26;

/// Why bytes are no elevation model.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum DemError {
    /// Files with the name's extension are not read.
    #[error("elevation models are .hgt, .tif, .tiff or .png files")]
    Extension,
    /// The archive is of something else than .hgt files, which alone are read from archives.
    #[error("it is an archive, from which only .hgt files are read: unpack it")]
    Archive,
    /// The archive holds no, or several, .hgt files.
    #[error("the archive holds {0} .hgt files; it must be one")]
    ArchiveContent(usize),
    /// A text or an archive is larger than any that is read.
    #[error("the file is too large for one of its kind")]
    TooLarge,
    /// An .hgt file of a size that none has.
    #[error(
        "an .hgt file has 1201 x 1201, 1801 x 3601, 3601 x 3601 or 7201 x 7201 values of two \
         bytes, not {0} bytes"
    )]
    HgtSize(u64),
    /// An .hgt file whose name is no corner.
    #[error("an .hgt file is named by its south west corner, like N44W072.hgt")]
    HgtName,
    /// More, or fewer, pixels than are read.
    #[error("the picture has {0} x {1} pixels; it must have from 2 to {MAX_SIDE} a side")]
    Size(u32, u32),
    /// The file's content makes no sense.
    #[error("{0}")]
    Invalid(String),
    /// There is not enough memory for the file's values, of so many bytes.
    #[error("not enough memory for {0} bytes of values")]
    Memory(u64),
    /// The file has no heights, only voids.
    #[error("the file has no heights, only voids")]
    OnlyVoids,
}

/// The error of content that makes no sense.
pub(super) fn invalid(problem: impl Into<String>) -> DemError {
    DemError::Invalid(problem.into())
}
