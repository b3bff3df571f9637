//! The files that a command reads, which it does not write over: a slip, by which a planet would be
//! lost.

use crate::error::CliError;
use std::fs;
use std::path::{Path, PathBuf};

/// The files that a command reads, by the names that the system gives them: without links, and as
/// large and small letters stand on the disk.
pub struct Inputs(Vec<PathBuf>);

impl Inputs {
    /// Of these paths. One that leads nowhere is passed over: whoever reads it says so.
    pub fn new(paths: impl IntoIterator<Item = PathBuf>) -> Self {
        let real = |path: PathBuf| fs::canonicalize(path).ok();
        Self(paths.into_iter().filter_map(real).collect())
    }

    /// Refuses to write over one of them.
    ///
    /// # Errors
    /// Names the file.
    pub fn check(&self, path: &Path) -> Result<(), CliError> {
        let Ok(place) = fs::canonicalize(path) else {
            return Ok(());
        };
        // A device is no file that could be lost.
        if place.is_file() && self.0.contains(&place) {
            let path = path.display();
            return Err(CliError::input(format!(
                "cannot write {path}: the command reads it"
            )));
        }
        Ok(())
    }
}
