//! Maps of a user, as the sections `CLIM` and `TERR` hold them.
//!
//! ```text
//! u32         number of maps
//! each        its name; width and height (u32); length (u64); packed values
//! ```

use crate::climate::{EquirectMap, MapError};
use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, invalid};
use crate::io::planes::{pack, unpack};

/// Most pixels of all maps of a section together: 512 MiB of numbers, four maps of the largest size
/// that is read from files. It bounds the memory that a file can ask for, whose bytes may stand for
/// a thousand times as many.
const MAX_MAP_PIXELS: u64 = 1 << 27;

/// Least bytes of a map: lengths of its name and values, its size.
const LEAST_BYTES: usize = 20;

/// Refuses maps with more pixels together than a section holds.
pub(in crate::io) fn check_pixels<'a>(
    maps: impl Iterator<Item = &'a EquirectMap>,
) -> Result<(), SaveError> {
    within_limit(maps.map(|map| pixels(map.size())).sum())
}

fn within_limit(pixels: u64) -> Result<(), SaveError> {
    if pixels <= MAX_MAP_PIXELS {
        return Ok(());
    }
    Err(SaveError::TooLarge {
        pixels,
        max: MAX_MAP_PIXELS,
    })
}

fn pixels([width, height]: [u32; 2]) -> u64 {
    u64::from(width) * u64::from(height)
}

/// The section of maps with their names.
pub(super) fn write<'a>(maps: impl Iterator<Item = (&'static str, &'a EquirectMap)>) -> Vec<u8> {
    let maps: Vec<_> = maps.collect();
    let mut out = Encoder::default();
    out.u32(maps.len() as u32);
    for (name, map) in maps {
        let [width, height] = map.size();
        out.text(name);
        out.u32(width);
        out.u32(height);
        let packed = pack(map.values());
        out.u64(packed.len() as u64);
        out.0.extend(packed);
    }
    out.0
}

/// The maps of a section, each handed on with its name before the next one is read.
pub(super) fn read(
    bytes: &[u8],
    mut take: impl FnMut(&str, EquirectMap) -> Result<(), SaveError>,
) -> Result<(), SaveError> {
    let mut read = Decoder(bytes);
    let mut left = MAX_MAP_PIXELS;
    for _ in 0..read.count(LEAST_BYTES)? {
        let name = read.text()?;
        let map = read_map(&mut read, left)?;
        left -= pixels(map.size());
        take(name, map)?;
    }
    read.end()
}

/// A map of at most `most` pixels.
fn read_map(read: &mut Decoder, most: u64) -> Result<EquirectMap, SaveError> {
    let (width, height) = (read.u32()?, read.u32()?);
    EquirectMap::check_size(width, height).map_err(refused)?;
    let count = pixels([width, height]);
    if count > most {
        within_limit(MAX_MAP_PIXELS - most + count)?;
    }
    let length = usize::try_from(read.u64()?).map_err(|_| SaveError::Truncated)?;
    let values = unpack(read.take(length)?, count as usize)?;
    EquirectMap::new(width, height, values).map_err(refused)
}

/// Puts a map in its place, which must be free.
pub(super) fn put(
    place: &mut Option<EquirectMap>,
    name: &str,
    map: EquirectMap,
) -> Result<(), SaveError> {
    match place.replace(map) {
        None => Ok(()),
        Some(_) => Err(invalid(format!("it has two maps of {name}"))),
    }
}

pub(super) fn refused(error: MapError) -> SaveError {
    invalid(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_save_holds_four_maps_of_the_largest_size_and_no_more() {
        let largest = 4 * pixels([8192, 4096]);
        assert_eq!(within_limit(largest), Ok(()));
        let problem = within_limit(largest + 1).unwrap_err().to_string();
        assert!(problem.contains("134217729 pixels"), "{problem}");
        assert_eq!(check_pixels(core::iter::empty()), Ok(()));
    }
}
