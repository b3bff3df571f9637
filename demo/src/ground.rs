//! The ground of a planet file, as `export`, `relief` and `query` ask for it.

use crate::error::CliError;
use crate::headless::Headless;
use bevy_pangaea::crust::Surface;
use bevy_pangaea::io::load;
use bevy_pangaea::planet::{Lattice, Planet};
use bevy_pangaea::query::{CoarseGround, Ground};
use std::path::Path;

/// Loads a planet and looks at its surface.
///
/// # Errors
/// If the file is refused.
pub fn open_planet(path: &Path) -> Result<Headless, CliError> {
    let mut headless = Headless::new(load(path)?);
    headless.look();
    Ok(headless)
}

/// The ground of a planet that was looked at.
///
/// # Errors
/// If the planet makes no ground.
pub fn ground(headless: &Headless) -> Result<impl Ground + use<>, CliError> {
    let (lattice, surface) = (headless.get::<Lattice>()?, headless.get::<Surface>()?);
    let heights = (0..surface.len()).map(|i| 1000.0 * surface.elevation(i)).collect();
    Ok(CoarseGround::new(lattice.0.clone(), heights, 1000.0 * headless.get::<Planet>()?.radius)?)
}

/// The ground of the planet in a file.
///
/// # Errors
/// If the file is refused.
pub fn open_ground(path: &Path) -> Result<impl Ground + use<>, CliError> {
    ground(&open_planet(path)?)
}
