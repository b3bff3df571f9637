//! Why a command fails, as one line on stderr and an exit code.

use bevy_pangaea::io::{DemError, ExportError, IoError, MapFileError};
use bevy_pangaea::planet::PlanetError;
use bevy_pangaea::query::GroundError;
use std::fmt::Display;
use std::io::{self, ErrorKind};
use std::process::ExitCode;
use thiserror::Error;

/// Why a command fails.
#[derive(Debug, Error)]
pub enum CliError {
    /// Something that the user gave is refused: a number, a name, a file, a folder. Exit code 2.
    #[error("{0}")]
    Input(String),
    /// The machine lacks something that the command needs, such as a GPU adapter. Exit code 1.
    #[error("{0}")]
    Failed(String),
    /// A signal of this number ended the command. Exit code 128 and the number, as from a shell: 130
    /// after Ctrl-C.
    #[error("interrupted; nothing is written")]
    Interrupted(u8),
}

impl CliError {
    /// Bad input, in the words of `problem`.
    pub fn input(problem: impl Display) -> Self {
        Self::Input(problem.to_string())
    }

    /// A file, or stdout, that could not be written, in the words of `problem`: by a fault of its
    /// name, or for lack of room.
    pub fn unwritten(source: &io::Error, problem: impl Display) -> Self {
        match source.kind() {
            ErrorKind::StorageFull
            | ErrorKind::QuotaExceeded
            | ErrorKind::FileTooLarge
            | ErrorKind::OutOfMemory => Self::Failed(problem.to_string()),
            _ => Self::input(problem),
        }
    }

    /// The exit code of the program.
    pub fn exit_code(&self) -> ExitCode {
        match self {
            Self::Input(_) => ExitCode::from(2),
            Self::Failed(_) => ExitCode::from(1),
            Self::Interrupted(signal) => ExitCode::from(128 + signal),
        }
    }
}

impl From<IoError> for CliError {
    fn from(error: IoError) -> Self {
        match &error {
            IoError::Write { source, .. } | IoError::Half { source, .. } => {
                Self::unwritten(source, &error)
            }
            IoError::Dem {
                source: DemError::Memory(_),
                ..
            }
            | IoError::Map {
                source: MapFileError::Raster(DemError::Memory(_)),
                ..
            } => Self::Failed(error.to_string()),
            _ => Self::input(error),
        }
    }
}

impl From<PlanetError> for CliError {
    fn from(error: PlanetError) -> Self {
        Self::input(error)
    }
}

impl From<GroundError> for CliError {
    fn from(error: GroundError) -> Self {
        match error {
            GroundError::Memory => Self::Failed(error.to_string()),
            other => Self::input(other),
        }
    }
}

impl From<ExportError> for CliError {
    fn from(error: ExportError) -> Self {
        match error {
            ExportError::Encode(_) => Self::Failed(error.to_string()),
            ExportError::Ground(error) => error.into(),
            ExportError::Io(error) => error.into(),
            other => Self::input(other),
        }
    }
}
