//! The ground of a planet file, as `export`, `relief` and `query` ask for it.

use crate::error::CliError;
use crate::headless::Headless;
use bevy_pangaea::control::{Bake, BakeFrame, BakeRules, BakeSource};
use bevy_pangaea::crust::Surface;
use bevy_pangaea::hydrology::base::SPACING;
use bevy_pangaea::io::load;
use bevy_pangaea::planet::{Lattice, Planet};
use bevy_pangaea::query::{PlanetGround, Rules};
use std::path::Path;
use std::sync::Arc;

/// Loads a planet and looks at its surface.
///
/// # Errors
/// If the file is refused.
pub fn open_planet(path: &Path) -> Result<Headless, CliError> {
    let mut headless = Headless::new(load(path)?);
    headless.look();
    Ok(headless)
}

/// Climate, rivers and control maps of a planet that was looked at.
///
/// # Errors
/// If the planet has none.
pub fn bake(headless: &Headless) -> Result<Bake, CliError> {
    let (lattice, surface) = (headless.get::<Lattice>()?, headless.get::<Surface>()?);
    let planet = headless.get::<Planet>()?;
    let frame = BakeFrame::new(planet.seed, SPACING, Some(lattice)).map_err(CliError::input)?;
    let source = BakeSource::Surface(surface);
    Ok(Bake::new(&Arc::new(frame), planet.radius, &source, &BakeRules::default()))
}

/// The ground of a planet that was looked at.
///
/// # Errors
/// If the planet makes no ground.
pub fn ground(headless: &Headless) -> Result<PlanetGround, CliError> {
    Ok(PlanetGround::of_bake(&bake(headless)?, Rules::default())?)
}

/// The ground of the planet in a file.
///
/// # Errors
/// If the file is refused.
pub fn open_ground(path: &Path) -> Result<PlanetGround, CliError> {
    ground(&open_planet(path)?)
}
