//! The ground of a planet file, as `export`, `relief` and `query` ask for it.

use crate::error::CliError;
use crate::headless::Headless;
use bevy_pangaea::climate::ClimateMaps;
use bevy_pangaea::control::PlanetBake;
use bevy_pangaea::query::{PlanetGround, Rules};
use bevy_pangaea::spawn::PlanetState;

/// Projects the surface of a planet that was loaded, and bakes its climate, in which `maps` replace
/// fields, and its rivers.
///
/// # Errors
/// If the planet cannot be baked.
pub fn bake_planet(state: PlanetState, maps: ClimateMaps) -> Result<Headless, CliError> {
    let mut headless = Headless::new(state);
    headless.project();
    headless.bake(maps)?;
    Ok(headless)
}

/// The ground of a planet that was baked.
///
/// # Errors
/// If there is no ground for a planet of its radius.
pub fn ground(headless: &Headless) -> Result<PlanetGround, CliError> {
    let bake = headless.get::<PlanetBake>()?;
    Ok(PlanetGround::of_bake(bake, Rules::default())?)
}
