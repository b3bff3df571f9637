//! The ground of a planet file, as `export`, `relief` and `query` ask for it.

use crate::error::CliError;
use crate::headless::Headless;
use bevy_pangaea::control::PlanetBake;
use bevy_pangaea::io::load;
use bevy_pangaea::query::{PlanetGround, Rules};
use bevy_pangaea::spawn::PlanetState;
use std::path::Path;

/// Loads a planet, looks at its surface, and makes its climate and rivers.
///
/// # Errors
/// If the file is refused.
pub fn open_planet(path: &Path) -> Result<Headless, CliError> {
    bake(load(path)?)
}

fn bake(state: PlanetState) -> Result<Headless, CliError> {
    let mut headless = Headless::new(state);
    headless.look();
    headless.bake()?;
    Ok(headless)
}

/// The ground of a planet that was baked.
///
/// # Errors
/// If there is no ground for a planet of its radius.
pub fn ground(headless: &Headless) -> Result<PlanetGround, CliError> {
    Ok(PlanetGround::of_bake(headless.get::<PlanetBake>()?, Rules::default())?)
}

/// The ground of a planet that was loaded.
///
/// # Errors
/// As [`ground`].
pub fn ground_of(state: PlanetState) -> Result<PlanetGround, CliError> {
    ground(&bake(state)?)
}
