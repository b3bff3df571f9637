//! Files that a command writes, all of them or not one, and text on stdout.

use crate::error::CliError;
use bevy_pangaea::io::{write_all_atomically, write_atomically};
use serde::Serialize;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Files for one folder, kept in memory until all are there.
pub struct Files {
    folder: PathBuf,
    /// Folders that were made for the files, the innermost first.
    made: Vec<PathBuf>,
    files: Vec<(PathBuf, Vec<u8>)>,
}

impl Files {
    /// Makes the folder where it is missing, and tries whether files of these names can be written
    /// to it.
    ///
    /// # Errors
    /// If one of them cannot be written.
    pub fn new<'a>(
        folder: &Path,
        names: impl IntoIterator<Item = &'a str>,
    ) -> Result<Self, CliError> {
        // From here on an early return removes the folders that were made.
        let files = Self {
            folder: folder.to_path_buf(),
            made: missing_folders(folder),
            files: Vec::new(),
        };
        fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))?;
        for name in names {
            check_file(&folder.join(name))?;
        }
        let probe = folder.join(format!(".pangaea.{}.part", std::process::id()));
        let probed = fs::write(&probe, [0; 4096]);
        let _ = fs::remove_file(&probe);
        probed.map_err(|error| unwritable(folder, &error))?;
        Ok(files)
    }

    /// Adds a file.
    pub fn add(&mut self, name: &str, content: Vec<u8>) {
        self.files.push((self.folder.join(name), content));
    }

    /// Writes all files, or not one, and returns their paths in the order in which they were added.
    ///
    /// # Errors
    /// If one cannot be written; no file is changed then.
    pub fn write(mut self) -> Result<Vec<PathBuf>, CliError> {
        write_all_atomically(&self.files)?;
        self.made.clear();
        Ok(self.files.drain(..).map(|(path, _)| path).collect())
    }
}

impl Drop for Files {
    /// Folders that were made for files that never came go again, unless someone else uses them by
    /// now.
    fn drop(&mut self) {
        for folder in &self.made {
            let _ = fs::remove_dir(folder);
        }
    }
}

/// The folders of a path that do not exist, the innermost first.
fn missing_folders(folder: &Path) -> Vec<PathBuf> {
    folder
        .ancestors()
        .take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists())
        .map(Path::to_path_buf)
        .collect()
}

fn unwritable(folder: &Path, error: &io::Error) -> CliError {
    CliError::input(format!("cannot write to {}: {error}", folder.display()))
}

/// Refuses a path at which no file can be, before minutes are spent on its content.
///
/// # Errors
/// If it is a folder, or its folder does not exist.
pub fn check_file(path: &Path) -> Result<(), CliError> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let problem = if path.is_dir() {
        "it is a folder"
    } else if folder.is_some_and(|folder| !folder.is_dir()) {
        "its folder does not exist"
    } else {
        return Ok(());
    };
    Err(CliError::input(format!(
        "cannot write {}: {problem}",
        path.display()
    )))
}

/// Writes one file, whole or not at all.
///
/// # Errors
/// If it cannot be written.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), CliError> {
    Ok(write_atomically(path, |out| out.write_all(content))?)
}

/// A value as the text of a JSON file.
///
/// # Errors
/// If it has no form in JSON.
pub fn json(value: &impl Serialize) -> Result<Vec<u8>, CliError> {
    let mut json =
        serde_json::to_vec_pretty(value).map_err(|error| CliError::Failed(error.to_string()))?;
    json.push(b'\n');
    Ok(json)
}

/// Prints to stdout. A reader that has gone away is no error.
///
/// # Errors
/// If stdout cannot take the text, as on a full disk.
pub fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(CliError::input(format!("cannot write to stdout: {error}")))
        }
        _ => Ok(()),
    }
}

/// Says something on stderr; whether anyone hears it does not matter.
pub fn say(text: &str) {
    let _ = writeln!(io::stderr(), "{text}");
}
