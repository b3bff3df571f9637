//! One hash over all state: two planets are the same, to the last bit, if their digests are.

use super::save::MAGIC;
use super::sections;
use crate::climate::EquirectMap;
use crate::spawn::PlanetState;

/// The version of the format that digests begin with, the one in which they were first given: a
/// planet keeps its digest when the format goes on.
const BEGINNING: u32 = 3;

/// The digest of a planet in hexadecimal digits: the BLAKE3 hash of all its state, as a save holds
/// it but for the compression of maps.
///
/// ```
/// use bevy_pangaea::{io, prelude::*, spawn::PlanetState};
///
/// let recipe = PlanetRecipe { samples: 1000, plate_count: 8, ..PlanetRecipe::default() };
/// let digest = |seed| {
///     PlanetState::new(&PlanetRecipe { seed, ..recipe.clone() }).map(|planet| io::digest(&planet))
/// };
/// assert_eq!(digest(1)?, digest(1)?);
/// assert_ne!(digest(1)?, digest(2)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn digest(state: &PlanetState) -> String {
    let mut hasher = blake3::Hasher::new();
    hasher.update(MAGIC);
    hasher.update(&BEGINNING.to_le_bytes());
    for (tag, content) in sections::encode(state) {
        hasher.update(&sections::head(tag, &content));
        hasher.update(&content);
    }
    let climate = state.climate.iter();
    add_maps(&mut hasher, climate.map(|(field, map)| (field.name(), map)));
    let terrain = state.terrain.iter().flat_map(|terrain| terrain.iter());
    add_maps(&mut hasher, terrain);
    hasher.finalize().to_hex().to_string()
}

/// The digest of a map in hexadecimal digits: the BLAKE3 hash of its size and the bits of its
/// values.
///
/// ```
/// use bevy_pangaea::{climate::EquirectMap, io};
///
/// let dry = EquirectMap::from_fn(4, |_, _| 50.0)?;
/// let same = EquirectMap::new(8, 4, vec![50.0; 32])?;
/// assert_eq!(io::map_digest(&dry), io::map_digest(&same));
/// # Ok::<(), bevy_pangaea::climate::MapError>(())
/// ```
pub fn map_digest(map: &EquirectMap) -> String {
    map_hash(map).to_hex().to_string()
}

fn add_maps<'a>(
    hasher: &mut blake3::Hasher,
    maps: impl Iterator<Item = (&'static str, &'a EquirectMap)>,
) {
    for (name, map) in maps {
        hasher.update(name.as_bytes());
        hasher.update(map_hash(map).as_bytes());
    }
}

fn map_hash(map: &EquirectMap) -> blake3::Hash {
    let mut hasher = blake3::Hasher::new();
    for side in map.size() {
        hasher.update(&side.to_le_bytes());
    }
    // Values go in by rows: the hash is slow with few bytes at a time.
    let mut row = Vec::new();
    for values in map.values().chunks(map.size()[0] as usize) {
        row.clear();
        row.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        hasher.update(&row);
    }
    hasher.finalize()
}
