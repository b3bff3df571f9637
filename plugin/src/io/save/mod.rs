//! The save file `*.pangaea`: all state of a planet.
//!
//! ```text
//! 8 bytes     magic
//! u32         format version
//! sections    tag (4 letters), length (u64), content
//! 32 bytes    BLAKE3 hash of everything before
//! ```
//! All numbers are little-endian. Fibonacci samples are not stored, they are made again from their
//! number. Neither the wall clock nor the speed and pauses of the geological clock are state: equal
//! planets give equal files.
//!
//! # Older and newer files
//!
//! The format is made to outlive additions to the model:
//!
//! - Sections are known by their tags, a column of the crust has one each. A section that a program
//!   does not know is passed over where its tag begins with a small letter (`note`), and refused by
//!   name where it begins with a capital (`NOTE`): without it the planet would be another one. A
//!   column that the file lacks has its default where that claims nothing, else the file is refused.
//! - Parameters and switches of processes are known by their names. One that the file lacks has its
//!   default, and must be within its limits like any other; one that the program does not know
//!   refuses the file by name.
//! - Causes of the ledger are known by their place: new ones come last.
//! - The version counts changes that older programs could not read right. Version 4 added the
//!   section `CLIM`: the maps that replace fields of the climate, compressed without loss, together
//!   at most 2^27 pixels. Version 3 is still read; older ones are not.
//! - The section `TERR` holds the maps that a planet is made of, in the same way.

use super::codec::Decoder;
use super::sections::{self, SectionTag};
use super::{IoError, SaveError, write_atomically};
use crate::climate::ClimateMaps;
use crate::spawn::PlanetState;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::Path;

pub(super) const MAGIC: &[u8; 8] = b"PANGAEA\x1a";

/// The version of the format that this program writes, and the newest that it reads.
pub const VERSION: u32 = 4;

/// The oldest version of the format that this program reads.
pub const OLDEST_VERSION: u32 = 3;

/// Bytes of magic and version.
const HEADER_BYTES: usize = 12;
/// Bytes of the hash at the end.
const HASH_BYTES: usize = 32;

/// Larger files hold no planet: two million samples take 140 MB, the largest maps 512 MiB for each
/// of two sections.
const MAX_FILE_BYTES: u64 = 2 << 30;

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

    fn put_section(&mut self, (tag, content): (SectionTag, Vec<u8>)) -> io::Result<()> {
        self.put(&sections::head(tag, &content))?;
        self.put(&content)
    }
}

/// Refuses maps that no save can hold, so that it is known before a planet grows.
///
/// # Errors
/// [`SaveError::TooLarge`].
pub fn check_maps(maps: &ClimateMaps) -> Result<(), SaveError> {
    sections::check_pixels(maps.iter().map(|(_, map)| map))
}

fn check_all_maps(state: &PlanetState) -> Result<(), SaveError> {
    check_maps(&state.climate)?;
    let terrain = state.terrain.iter().flat_map(|terrain| terrain.iter());
    sections::check_pixels(terrain.map(|(_, map)| map))
}

/// Writes a planet. Equal state gives equal bytes.
///
/// # Errors
/// The error of `out`, or [`io::ErrorKind::InvalidInput`] with a [`SaveError`] for maps with
/// more pixels than a save holds.
pub fn write_to(state: &PlanetState, out: &mut (impl Write + ?Sized)) -> io::Result<()> {
    check_all_maps(state).map_err(|error| io::Error::new(io::ErrorKind::InvalidInput, error))?;
    let mut out = Hashing {
        out,
        hasher: blake3::Hasher::new(),
    };
    out.put(MAGIC)?;
    out.put(&VERSION.to_le_bytes())?;
    for section in sections::encode(state) {
        out.put_section(section)?;
    }
    for section in sections::encode_maps(state) {
        out.put_section(section)?;
    }
    // The hash is not part of what it covers.
    let hash = out.hasher.finalize();
    out.out.write_all(hash.as_bytes())
}

/// Reads a planet and makes its mesh.
///
/// # Errors
/// [`SaveError`] for bytes that no [`write_to`] of a version that is read has written.
pub fn read_from(bytes: &[u8]) -> Result<PlanetState, SaveError> {
    sections::decode(checked(bytes)?)
}

/// The sections of a file with a good header and hash.
fn checked(bytes: &[u8]) -> Result<&[u8], SaveError> {
    let found = version(bytes)?;
    if !(OLDEST_VERSION..=VERSION).contains(&found) {
        return Err(SaveError::Version {
            found,
            oldest: OLDEST_VERSION,
            newest: VERSION,
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

/// The version of the format that the first bytes of a file name.
fn version(bytes: &[u8]) -> Result<u32, SaveError> {
    match bytes.strip_prefix(MAGIC) {
        Some(rest) => Decoder(rest).u32(),
        None => Err(SaveError::NotASave),
    }
}

/// The version of the format that a file was written in.
///
/// # Errors
/// As [`load`]; nothing but the beginning of the file is read.
pub fn version_of(path: &Path) -> Result<u32, IoError> {
    let mut beginning = Vec::new();
    File::open(path)
        .and_then(|file| file.take(HEADER_BYTES as u64).read_to_end(&mut beginning))
        .map_err(|source| IoError::read(path, source))?;
    version(&beginning).map_err(|source| IoError::save(path, source))
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
