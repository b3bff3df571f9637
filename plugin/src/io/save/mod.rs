//! The save file `*.pangaea`: all state of a planet.
//!
//! ```text
//! 8 bytes     magic
//! u32         format version
//! sections    tag (4 letters), length (u64), content; all present, in a fixed order
//! 32 bytes    BLAKE3 hash of everything before
//! ```
//! All numbers are little-endian. Fibonacci samples are not stored, they are made again from their
//! number. Neither the wall clock nor the speed and pauses of the geological clock are state: equal
//! planets give equal files.

use super::codec::Decoder;
use super::sections;
use super::{IoError, SaveError, write_atomically};
use crate::spawn::PlanetState;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

const MAGIC: &[u8; 8] = b"PANGAEA\x1a";

/// The version of the format that this program writes and reads.
pub const VERSION: u32 = 3;

/// Bytes of magic and version.
const HEADER_BYTES: usize = 12;
/// Bytes of the hash at the end.
const HASH_BYTES: usize = 32;

/// Larger files hold no planet: two million samples take 140 MB.
const MAX_FILE_BYTES: u64 = 1 << 30;

/// Passes bytes on, and hashes them.
struct Hashing<W> {
    out: W,
    hasher: blake3::Hasher,
}

impl<W: Write> Hashing<W> {
    fn put(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.hasher.update(bytes);
        self.out.write_all(bytes)
    }
}

/// Writes a planet. Equal state gives equal bytes.
///
/// # Errors
/// The error of `out`.
pub fn write_to(state: &PlanetState, out: &mut (impl Write + ?Sized)) -> io::Result<()> {
    write_hashed(state, out).map(|_| ())
}

/// Writes a planet and returns its hash.
pub(super) fn write_hashed(
    state: &PlanetState,
    out: &mut (impl Write + ?Sized),
) -> io::Result<blake3::Hash> {
    let mut out = Hashing {
        out,
        hasher: blake3::Hasher::new(),
    };
    out.put(MAGIC)?;
    out.put(&VERSION.to_le_bytes())?;
    for (tag, content) in sections::encode(state) {
        out.put(tag)?;
        out.put(&(content.len() as u64).to_le_bytes())?;
        out.put(&content)?;
    }
    // The hash is not part of what it covers.
    let hash = out.hasher.finalize();
    out.out.write_all(hash.as_bytes())?;
    Ok(hash)
}

/// Reads a planet and makes its mesh.
///
/// # Errors
/// [`SaveError`] for bytes that [`write_to`] did not write.
pub fn read_from(bytes: &[u8]) -> Result<PlanetState, SaveError> {
    sections::decode(&split(checked(bytes)?)?)
}

/// The sections of a file with a good header and hash.
fn checked(bytes: &[u8]) -> Result<&[u8], SaveError> {
    if bytes.get(..MAGIC.len()) != Some(MAGIC) {
        return Err(SaveError::NotASave);
    }
    let found = Decoder(&bytes[MAGIC.len()..]).u32()?;
    if found != VERSION {
        return Err(SaveError::Version {
            found,
            supported: VERSION,
        });
    }
    let end = bytes
        .len()
        .checked_sub(HASH_BYTES)
        .filter(|&end| end >= HEADER_BYTES)
        .ok_or(SaveError::Truncated)?;
    // Before anything is read: what follows may trust that no bit has changed by accident.
    if blake3::hash(&bytes[..end]).as_bytes()[..] != bytes[end..] {
        return Err(SaveError::Checksum);
    }
    Ok(&bytes[HEADER_BYTES..end])
}

/// The contents of all sections.
fn split(sections: &[u8]) -> Result<Vec<&[u8]>, SaveError> {
    let mut decoder = Decoder(sections);
    let mut contents = Vec::new();
    for tag in sections::tags() {
        if decoder.take(4)? != tag {
            return Err(SaveError::Invalid("a section is missing".into()));
        }
        let length = usize::try_from(decoder.u64()?).map_err(|_| SaveError::Truncated)?;
        contents.push(decoder.take(length)?);
    }
    decoder.end()?;
    Ok(contents)
}

/// Saves a planet, whole or not at all.
///
/// ```
/// use bevy_pangaea::{io, prelude::*, spawn::PlanetState};
///
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("planet.pangaea");
/// let recipe = PlanetRecipe { samples: 1000, plate_count: 8, ..PlanetRecipe::default() };
/// let planet = PlanetState::new(&recipe)?;
/// io::save(&planet, &path)?;
/// assert_eq!(io::digest(&io::load(&path)?), io::digest(&planet));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::Write`]; an older file of that name is untouched then.
pub fn save(state: &PlanetState, path: &Path) -> Result<(), IoError> {
    write_atomically(path, |out| write_to(state, out))
}

/// Loads a planet.
///
/// # Errors
/// [`IoError::Read`] if the file cannot be read, [`IoError::Save`] if it is no planet.
pub fn load(path: &Path) -> Result<PlanetState, IoError> {
    let meta = fs::metadata(path).map_err(|source| IoError::read(path, source))?;
    // A device may never end, and no save is that large. Folders are refused by the read.
    if !meta.is_dir() && (!meta.is_file() || meta.len() > MAX_FILE_BYTES) {
        return Err(IoError::save(path, SaveError::NotASave));
    }
    let bytes = fs::read(path).map_err(|source| IoError::read(path, source))?;
    read_from(&bytes).map_err(|source| IoError::save(path, source))
}

#[cfg(test)]
mod tests;
