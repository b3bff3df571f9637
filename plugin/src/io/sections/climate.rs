//! Maps that replace fields of the climate. The section is there only where the planet has maps.
//!
//! ```text
//! u32         number of maps
//! each        name of its field; width and height (u32); length (u64); packed values
//! ```

use crate::climate::{ClimateField, ClimateMaps, EquirectMap, MapError};
use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, invalid};
use crate::io::planes::{pack, unpack};

/// Most pixels of all maps of a planet together: 2 GiB of numbers. It bounds the memory that a file
/// can ask for, whose bytes may stand for a thousand times as many.
pub(in crate::io) const MAX_MAP_PIXELS: u64 = 1 << 29;

/// Least bytes of a map: lengths of its name and values, its size.
const LEAST_BYTES: usize = 20;

/// Refuses maps with more pixels than a save holds.
pub(in crate::io) fn check_pixels(maps: &ClimateMaps) -> Result<(), SaveError> {
    let pixels: u64 = maps.iter().map(|(_, map)| pixels(map.size())).sum();
    within_limit(pixels)
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

pub(super) fn write(maps: &ClimateMaps) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(maps.iter().count() as u32);
    for (field, map) in maps.iter() {
        let [width, height] = map.size();
        out.text(field.name());
        out.u32(width);
        out.u32(height);
        let packed = pack(map.values());
        out.u64(packed.len() as u64);
        out.0.extend(packed);
    }
    out.0
}

pub(super) fn read(bytes: &[u8]) -> Result<ClimateMaps, SaveError> {
    let mut read = Decoder(bytes);
    let mut maps = ClimateMaps::default();
    let mut left = MAX_MAP_PIXELS;
    for _ in 0..read.count(LEAST_BYTES)? {
        let name = read.text()?;
        let field = ClimateField::from_name(name)
            .ok_or_else(|| SaveError::unknown("map of the climate", name))?;
        if maps.get(field).is_some() {
            return Err(invalid(format!("it has two maps of {name}")));
        }
        let map = read_map(&mut read, left)?;
        left -= pixels(map.size());
        maps.set(field, map);
    }
    read.end()?;
    maps.check().map_err(refused)?;
    Ok(maps)
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

fn refused(error: MapError) -> SaveError {
    invalid(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_save_holds_one_map_of_the_largest_size_and_no_more() {
        let side = EquirectMap::MAX_SIDE;
        let largest = pixels([side, side / 2]);
        assert_eq!(within_limit(largest), Ok(()));
        let problem = within_limit(largest + 1).unwrap_err().to_string();
        assert!(problem.contains("536870913 pixels"), "{problem}");
        assert_eq!(check_pixels(&ClimateMaps::default()), Ok(()));
    }
}
