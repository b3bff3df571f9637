//! The ground of a planet file, as `export`, `relief` and `query` ask for it.

use crate::error::CliError;
use crate::headless::Headless;
use bevy_pangaea::climate::ClimateMaps;
use bevy_pangaea::control::PlanetBake;
use bevy_pangaea::io::load;
use bevy_pangaea::query::{PlanetGround, Rules};
use bevy_pangaea::spawn::PlanetState;
use std::path::Path;

/// Loads a planet, looks at its surface, and makes its climate, but for what `maps` give, and its
/// rivers.
///
/// # Errors
/// If the file is refused.
pub fn open_planet(path: &Path, maps: ClimateMaps) -> Result<Headless, CliError> {
    bake(load(path)?, maps)
}

fn bake(state: PlanetState, maps: ClimateMaps) -> Result<Headless, CliError> {
    let mut headless = Headless::new(state);
    headless.look();
    headless.bake(maps)?;
    Ok(headless)
}

/// The ground of a planet that was baked.
///
/// # Errors
/// If there is no ground for a planet of its radius.
pub fn ground(headless: &Headless) -> Result<PlanetGround, CliError> {
    Ok(PlanetGround::of_bake(
        headless.get::<PlanetBake>()?,
        Rules::default(),
    )?)
}

/// The ground of a planet that was loaded, with the climate that `maps` give.
///
/// # Errors
/// As [`ground`].
pub fn ground_of(state: PlanetState, maps: ClimateMaps) -> Result<PlanetGround, CliError> {
    ground(&bake(state, maps)?)
}
