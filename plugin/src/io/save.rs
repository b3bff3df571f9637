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
use super::{IoError, write_atomically};
use crate::spawn::PlanetState;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use thiserror::Error;

const MAGIC: &[u8; 8] = b"PANGAEA\x1a";

/// The version of the format that this program writes and reads.
pub const VERSION: u32 = 3;

/// Bytes of magic and version, and of the hash at the end.
const HEAD: usize = 12;
const HASH: usize = 32;

/// Why bytes are no planet.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SaveError {
    /// The magic is missing.
    #[error("this is no Pangaea planet")]
    NotASave,
    /// The file was written in another version of the format.
    #[error("format version {found} is {}; this program reads version {VERSION}", age(*found))]
    Version {
        /// The file's version.
        found: u32,
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

fn age(found: u32) -> &'static str {
    if found > VERSION {
        "newer than this program"
    } else {
        "no longer supported"
    }
}

/// Passes on what is written, and hashes it.
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
/// What `out` returns.
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
    for section in sections::SECTIONS {
        let content = (section.encode)(state);
        out.put(section.tag)?;
        out.put(&(content.len() as u64).to_le_bytes())?;
        out.put(&content)?;
    }
    let hash = out.hasher.finalize();
    out.out.write_all(hash.as_bytes())?;
    Ok(hash)
}

/// Reads a planet and makes its mesh.
///
/// # Errors
/// [`SaveError`] for anything but what [`write_to`] wrote.
pub fn read_from(bytes: &[u8]) -> Result<PlanetState, SaveError> {
    if bytes.get(..MAGIC.len()) != Some(MAGIC) {
        return Err(SaveError::NotASave);
    }
    let found = Decoder(&bytes[MAGIC.len()..]).u32()?;
    if found != VERSION {
        return Err(SaveError::Version { found });
    }
    let content = bytes
        .len()
        .checked_sub(HASH)
        .filter(|&end| end >= HEAD)
        .ok_or(SaveError::Truncated)?;
    if blake3::hash(&bytes[..content]).as_bytes()[..] != bytes[content..] {
        return Err(SaveError::Checksum);
    }
    let mut decoder = Decoder(&bytes[HEAD..content]);
    let mut contents = Vec::with_capacity(sections::SECTIONS.len());
    for section in sections::SECTIONS {
        if decoder.take(4)? != section.tag {
            return Err(SaveError::Invalid("a section is missing".into()));
        }
        let length = usize::try_from(decoder.u64()?).map_err(|_| SaveError::Truncated)?;
        contents.push(decoder.take(length)?);
    }
    decoder.end()?;
    sections::decode(&contents)
}

/// Saves a planet, whole or not at all.
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
    // A device may never end, and no save is that large.
    if !meta.is_dir() && (!meta.is_file() || meta.len() > MAX_SIZE) {
        return Err(IoError::Save {
            path: path.to_path_buf(),
            source: SaveError::NotASave,
        });
    }
    let bytes = fs::read(path).map_err(|source| IoError::read(path, source))?;
    read_from(&bytes).map_err(|source| IoError::Save {
        path: path.to_path_buf(),
        source,
    })
}

/// Larger files hold no planet: two million samples take 140 MB.
const MAX_SIZE: u64 = 1 << 30;

#[cfg(test)]
#[path = "save_tests.rs"]
mod tests;
