//! Files by their names, and their content.

use super::error::{DemError, MAX_BYTES};
use crate::io::IoError;
use crate::io::limited::read_at_most;
use std::fs::{self, File};
use std::io;
use std::path::Path;

/// The extension of a file in lower case, without the number that a copy may have behind it.
pub(in crate::io) fn extension(path: &Path) -> Option<String> {
    let name = path.file_name()?.to_str()?;
    let is_mark = |c: char| c.is_ascii_digit() || matches!(c, ' ' | '.' | '(' | ')');
    let kept = name.trim_end_matches(is_mark);
    // A number that follows letters at once belongs to them.
    let behind = &name[kept.len()..];
    let name = if behind.starts_with(|c: char| c.is_ascii_digit()) {
        name
    } else {
        kept
    };
    let extension = Path::new(name).extension()?.to_str()?;
    Some(extension.to_ascii_lowercase())
}

/// Opens a file to be read a part at a time. A pipe is refused: opening it would wait for a writer.
pub(in crate::io) fn open(path: &Path) -> Result<File, IoError> {
    let unread = |source| IoError::read(path, source);
    let facts = fs::metadata(path).map_err(unread)?;
    if !facts.is_file() && !facts.is_dir() {
        return Err(unread(io::Error::other(
            "it is a pipe or a device, and no file",
        )));
    }
    File::open(path).map_err(unread)
}

/// The bytes of a file that is not too large.
pub(in crate::io) fn read_limited(path: &Path) -> Result<Vec<u8>, IoError> {
    let bytes = read_at_most(path, MAX_BYTES)?;
    bytes.ok_or_else(|| IoError::dem(path, DemError::TooLarge))
}
