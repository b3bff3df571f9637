//! Files that are read whole, unless they are too long.

use super::IoError;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// The bytes of a file; `None` if it has more than `most`.
///
/// # Errors
/// [`IoError::Read`] if it cannot be read.
pub(super) fn read_at_most(path: &Path, most: u64) -> Result<Option<Vec<u8>>, IoError> {
    // One byte more than allowed tells a long file from a full one.
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(most + 1).read_to_end(&mut bytes))
        .map_err(|source| IoError::read(path, source))?;
    Ok((bytes.len() as u64 <= most).then_some(bytes))
}
