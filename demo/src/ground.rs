//! The climate and the ground of a planet file, as `export`, `relief`, `query` and `maps` ask for
//! them.

use crate::error::CliError;
use crate::headless::Headless;
use crate::output::say;
use bevy_pangaea::climate::ClimateMaps;
use bevy_pangaea::control::PlanetBake;
use bevy_pangaea::query::{PlanetGround, Rules};
use bevy_pangaea::spawn::PlanetState;

/// Projects the surface of a planet that was loaded, and bakes its climate and its rivers. Maps
/// that the user gives replace those of the save.
///
/// # Errors
/// If the planet cannot be baked.
pub fn bake_planet(mut state: PlanetState, given: ClimateMaps) -> Result<Headless, CliError> {
    replace_maps(&mut state.climate, &given);
    let mut headless = Headless::new(state);
    headless.project();
    headless.bake()?;
    Ok(headless)
}

/// Replaces maps of the climate that a planet came with by those that the user gives, and says so
/// where they differ.
pub fn replace_maps(saved: &mut ClimateMaps, given: &ClimateMaps) {
    for (field, map) in given.iter() {
        let name = field.name();
        if saved.get(field).is_some_and(|saved| saved != map) {
            say(&format!(
                "warning: --{name} replaces the map of {name} that the planet came with"
            ));
        }
        saved.set(field, map.clone());
    }
}

/// The ground of a planet that was baked.
///
/// # Errors
/// If there is no ground for a planet of its radius.
pub fn ground(headless: &Headless) -> Result<PlanetGround, CliError> {
    let bake = headless.get::<PlanetBake>()?;
    Ok(PlanetGround::of_bake(bake, Rules::default())?)
}
