//! One hash over all state: two planets are the same, to the last bit, if their digests are.

use super::save::write_hashed;
use crate::spawn::PlanetState;

/// The digest of a planet: the BLAKE3 hash of its save file in hexadecimal digits.
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
    // A sink takes everything: there is no error to report.
    write_hashed(state, &mut std::io::sink())
        .map_or_else(|_| String::new(), |hash| hash.to_hex().to_string())
}
