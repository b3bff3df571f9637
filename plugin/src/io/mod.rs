//! Files: saves, presets, scenarios, pictures and figures.
//!
//! ```text
//! save       *.pangaea: all state of a planet, checksummed
//! digest     one hash over all state
//! capture    from a planet in a world to its state
//! preset     *.planet.ron: recipes
//! scenario   *.scenario.ron: commands to come
//! png        16-bit elevation, RGB maps
//! stats      figures of a planet
//! export     squares of the ground: GeoTIFF, 16-bit PNG, glTF
//! dem        elevation models of real ground
//! maps       maps of the whole planet: climate, terrain
//! floor      the time of one sweep over the crust, by which timings are measured
//! ```
//!
//! What is read is never trusted: every error is one line that names the file, and no input makes a
//! loader panic or allocate more than the input's own size allows. What is written is there whole
//! or not at all.

mod codec;

mod sections;

pub mod save;

pub mod digest;

pub mod capture;

pub mod preset;

pub mod scenario;

pub mod png;

pub mod stats;

pub mod export;

pub mod dem;

pub mod maps;

mod floor;

pub use capture::capture;
pub use dem::{Dem, DemError, dem_files, load_dem};
pub use digest::digest;
pub use export::{ExportError, export};
pub use floor::floor;
pub use maps::{MapFileError, load_map};
pub use preset::{PlanetPreset, PlanetRecipeLoader, PresetPlugin, load_preset};
pub use save::{SaveError, load, save};
pub use scenario::load_scenario;
pub use stats::{Stats, Timings};

use std::fs::{self, File};
use std::io::{self, BufWriter, Read, Write};
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
    /// The file is no save of a planet, or a damaged one.
    #[error("{}: {source}", path.display())]
    Save {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: SaveError,
    },
    /// The file is no elevation model, or one that is not read.
    #[error("{}: {source}", path.display())]
    Dem {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: DemError,
    },
    /// The file is no map of a planet, or one that is not read.
    #[error("{}: {source}", path.display())]
    Map {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: MapFileError,
    },
    /// The text of a preset or a scenario is refused.
    #[error("{}{}: {problem}", path.display(), at(*line))]
    Text {
        /// The file.
        path: PathBuf,
        /// Line of the problem, from 1; 0 where none can be named.
        line: usize,
        /// What is wrong with it.
        problem: String,
    },
}

fn at(line: usize) -> String {
    if line == 0 {
        String::new()
    } else {
        format!(" line {line}")
    }
}

impl IoError {
    fn read(path: &Path, source: io::Error) -> Self {
        Self::Read {
            path: path.to_path_buf(),
            source,
        }
    }

    fn write(path: &Path, source: io::Error) -> Self {
        Self::Write {
            path: path.to_path_buf(),
            source,
        }
    }
}

/// Longest preset or scenario in bytes.
const MAX_TEXT: u64 = 8 << 20;

fn read_text(path: &Path) -> Result<String, IoError> {
    let mut text = String::new();
    File::open(path)
        .and_then(|file| file.take(MAX_TEXT + 1).read_to_string(&mut text))
        .map_err(|source| IoError::read(path, source))?;
    if text.len() as u64 > MAX_TEXT {
        let problem = format!("the file is longer than {MAX_TEXT} bytes");
        return Err(IoError::Text {
            path: path.to_path_buf(),
            line: 0,
            problem,
        });
    }
    Ok(text)
}

/// Writes a file whole or not at all: into a hidden file beside it, which is flushed to the disk
/// and then renamed. What is no plain file (a device, a pipe) is written directly.
///
/// # Errors
/// [`IoError::Write`]; the file is as it was before.
pub fn write_atomically(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), IoError> {
    // A link stays a link: what it points to is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let result = match fs::metadata(&target) {
        Ok(meta) if meta.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(meta) if !meta.is_file() => {
            File::create(&target).and_then(|file| fill(file, content, false))
        }
        _ => replace(&target, content),
    };
    result.map_err(|source| IoError::write(path, source))
}

/// Writes several files of given content, all or none: all of them under hidden names first.
///
/// # Errors
/// [`IoError::Write`]; the files are as they were before, but if a rename fails half way through.
pub fn write_all_atomically(files: &[(PathBuf, Vec<u8>)]) -> Result<(), IoError> {
    let target = |path: &Path| fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let plain =
        |path: &Path| fs::metadata(path).is_ok_and(|meta| !meta.is_file() && !meta.is_dir());
    if let Some((path, _)) = files.iter().find(|(path, _)| path.is_dir()) {
        return Err(IoError::write(path, io::ErrorKind::IsADirectory.into()));
    }
    // A device is written directly: there is nothing to rename.
    if let [(path, content)] = files
        && plain(path)
    {
        return write_atomically(path, |out| out.write_all(content));
    }
    let mut parts: Vec<(PathBuf, PathBuf)> = Vec::with_capacity(files.len());
    let write = |parts: &mut Vec<(PathBuf, PathBuf)>| {
        for (path, content) in files {
            let target = target(path);
            let part = hidden_beside(&target).map_err(|source| IoError::write(path, source))?;
            parts.push((part.clone(), target));
            File::create(&part)
                .and_then(|file| fill(file, |out| out.write_all(content), true))
                .map_err(|source| IoError::write(path, source))?;
        }
        for ((part, target), (path, _)) in parts.iter().zip(files) {
            fs::rename(part, target).map_err(|source| IoError::write(path, source))?;
        }
        Ok(())
    };
    let result = write(&mut parts);
    if result.is_err() {
        for (part, _) in &parts {
            let _ = fs::remove_file(part);
        }
    }
    result
}

/// The hidden name that a file has while it is written.
fn hidden_beside(target: &Path) -> io::Result<PathBuf> {
    let name = target.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    Ok(target.with_file_name(format!(
        ".{}.{}.part",
        name.to_string_lossy(),
        std::process::id()
    )))
}

fn replace(
    target: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let part = hidden_beside(target)?;
    let result = File::create(&part)
        .and_then(|file| fill(file, content, true))
        .and_then(|()| fs::rename(&part, target));
    if result.is_err() {
        let _ = fs::remove_file(&part);
    }
    result
}

fn fill(
    file: File,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    sync: bool,
) -> io::Result<()> {
    let mut writer = BufWriter::new(file);
    content(&mut writer)?;
    let file = writer
        .into_inner()
        .map_err(io::IntoInnerError::into_error)?;
    if sync { file.sync_all() } else { Ok(()) }
}
