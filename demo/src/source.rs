//! Where the planet of a picture comes from: a file, or a recipe and a plan.

use crate::cli::GrowthArgs;
use crate::error::CliError;
use crate::growth::GrowthPlan;
use crate::headless::{Headless, initial_planet};
use crate::output::say;
use bevy_pangaea::io::load_planet_with_notes;
use bevy_pangaea::planet::PlanetRecipe;
use bevy_pangaea::spawn::PlanetState;
use std::path::Path;

/// The planet of a file; what is to say of its maps is said.
///
/// # Errors
/// If the file, or one that it names, is refused.
pub fn load_planet(path: &Path) -> Result<PlanetState, CliError> {
    let loaded = load_planet_with_notes(path)?;
    loaded.notes.iter().for_each(|note| say(note));
    Ok(loaded.planet)
}

/// A planet, or all that is needed to grow it.
pub enum PlanetSource {
    /// A planet of a file, which stays as it is.
    Saved(Box<PlanetState>),
    /// A planet that is still to grow.
    Recipe(Box<PlanetRecipe>, GrowthPlan),
}

impl PlanetSource {
    /// The planet in a file, or the one that the options describe.
    ///
    /// # Errors
    /// If the file, or an option, is refused.
    pub fn new(file: Option<&Path>, args: &GrowthArgs) -> Result<Self, CliError> {
        if let Some(path) = file {
            return Ok(Self::Saved(Box::new(load_planet(path)?)));
        }
        let recipe = args.recipe.checked()?;
        let plan = GrowthPlan::new(args, recipe.params.time_step)?;
        Ok(Self::Recipe(Box::new(recipe), plan))
    }

    /// Radius in km.
    pub fn radius(&self) -> f64 {
        match self {
            Self::Saved(state) => state.planet.radius,
            Self::Recipe(recipe, _) => recipe.radius,
        }
    }

    /// The planet, grown with a progress bar if it comes from a recipe; that may take minutes.
    ///
    /// # Errors
    /// If a command of the scenario is refused, or the user interrupts it.
    pub fn planet(self) -> Result<PlanetState, CliError> {
        match self {
            Self::Saved(state) => Ok(*state),
            Self::Recipe(recipe, plan) => {
                let mut headless = Headless::new(initial_planet(&recipe)?.0);
                plan.run(&mut headless)?;
                headless.state()
            }
        }
    }
}
