//! Why a file could not be read or written.

#[cfg(feature = "dem")]
use super::dem::DemError;
#[cfg(feature = "dem")]
use super::maps::MapFileError;
use crate::crust::ColumnError;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Why a file could not be read or written.
#[derive(Debug, Error)]
pub enum IoError {
    /// The file cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// The file cannot be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// The file cannot be written, and others that belong to it are new already.
    #[error("cannot write {}: {source}; {done} of {total} files are new", path.display())]
    Half {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
        /// Files that have been replaced.
        done: usize,
        /// Files to replace.
        total: usize,
    },
    /// The file is no save of a planet, or a damaged one.
    #[error("{}: {source}", path.display())]
    Save {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: SaveError,
    },
    /// The file is no elevation model, or one that is not read.
    #[cfg(feature = "dem")]
    #[error("{}: {source}", path.display())]
    Dem {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: DemError,
    },
    /// The file is no map of a planet, or one that is not read.
    #[cfg(feature = "dem")]
    #[error("{}: {source}", path.display())]
    Map {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: MapFileError,
    },
    /// The text of a preset or a scenario is refused.
    #[error("{}{}: {problem}", path.display(), in_line(*line))]
    Text {
        /// The file.
        path: PathBuf,
        /// Line of the problem, from 1; 0 if the problem is in no line in particular.
        line: usize,
        /// The reason.
        problem: String,
    },
}

fn in_line(line: usize) -> String {
    if line == 0 {
        String::new()
    } else {
        format!(" line {line}")
    }
}

impl IoError {
    pub(super) fn read(path: &Path, source: io::Error) -> Self {
        Self::Read {
            path: path.to_path_buf(),
            source,
        }
    }

    pub(super) fn write(path: &Path, source: io::Error) -> Self {
        Self::Write {
            path: path.to_path_buf(),
            source,
        }
    }

    pub(super) fn half(path: &Path, source: io::Error, [done, total]: [usize; 2]) -> Self {
        Self::Half {
            path: path.to_path_buf(),
            source,
            done,
            total,
        }
    }

    pub(super) fn save(path: &Path, source: SaveError) -> Self {
        Self::Save {
            path: path.to_path_buf(),
            source,
        }
    }

    #[cfg(feature = "dem")]
    pub(super) fn dem(path: &Path, source: DemError) -> Self {
        Self::Dem {
            path: path.to_path_buf(),
            source,
        }
    }

    #[cfg(feature = "dem")]
    pub(super) fn map(path: &Path, source: MapFileError) -> Self {
        Self::Map {
            path: path.to_path_buf(),
            source,
        }
    }
}

/// Why bytes are no planet.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SaveError {
    /// The magic is missing.
    #[error("this is no Pangaea planet")]
    NotASave,
    /// The file was written in another version of the format.
    #[error(
        "format version {found} is {}; this program reads version {supported}",
        age(*found, *supported)
    )]
    Version {
        /// The file's version.
        found: u32,
        /// The version that this program reads.
        supported: u32,
    },
    /// The file ends too early.
    #[error("the file is cut short")]
    Truncated,
    /// The content was changed since it was written.
    #[error("the file is damaged: its checksum does not match")]
    Checksum,
    /// The content makes no planet.
    #[error("the file is damaged: {0}")]
    Invalid(String),
}

impl From<ColumnError> for SaveError {
    fn from(error: ColumnError) -> Self {
        Self::Invalid(error.to_string())
    }
}

fn age(found: u32, supported: u32) -> &'static str {
    if found > supported {
        "newer than this program"
    } else {
        "no longer supported"
    }
}
