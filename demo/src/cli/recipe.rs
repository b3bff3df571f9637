//! A planet at time 0, how it grows, and on how many threads.

use crate::error::CliError;
use crate::values::{land, plates, samples, seed, threads, time_span};
use bevy_pangaea::io::load_preset;
use bevy_pangaea::planet::PlanetRecipe;
use clap::Args;
use std::path::PathBuf;

/// The planet at time 0. An option given here replaces what the preset says.
#[derive(Args, Debug, Default, Clone)]
pub struct RecipeArgs {
    /// Seed of everything random [default: 1]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = seed)]
    pub seed: Option<u64>,
    /// Number of samples of the sphere, 100 to 2,000,000 [default: 60000]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = samples)]
    pub samples: Option<u32>,
    /// Number of initial plates, 2 to 1000 [default: 40]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = plates)]
    pub plates: Option<u32>,
    /// Share of land, 0 to 0.9 [default: 0.3]
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true, value_parser = land)]
    pub land: Option<f64>,
    /// Recipe of the planet, *.planet.ron
    #[arg(long, value_name = "FILE")]
    pub preset: Option<PathBuf>,
}

impl RecipeArgs {
    /// The recipe that preset and options make together, checked.
    ///
    /// # Errors
    /// A preset that cannot be read, or a number that is refused.
    pub fn checked(&self) -> Result<PlanetRecipe, CliError> {
        let mut recipe = match &self.preset {
            Some(path) => load_preset(path)?,
            None => PlanetRecipe::default(),
        };
        recipe.seed = self.seed.unwrap_or(recipe.seed);
        recipe.samples = self.samples.unwrap_or(recipe.samples);
        if let Some(plates) = self.plates {
            if !recipe.plates.is_empty() {
                return Err(preset_lists("--plates", "plates"));
            }
            recipe.plate_count = plates;
        }
        if let Some(land) = self.land {
            if !recipe.continents.is_empty() {
                return Err(preset_lists("--land", "continents"));
            }
            recipe.land = land;
        }
        recipe.validate()?;
        Ok(recipe)
    }
}

/// A number is given for something that the preset lists one by one.
fn preset_lists(option: &str, what: &str) -> CliError {
    CliError::input(format!(
        "{option} cannot be used with a preset that lists its {what}"
    ))
}

/// How to grow a planet.
#[derive(Args, Debug, Default, Clone)]
pub struct GrowthArgs {
    /// The planet at time 0.
    #[command(flatten)]
    pub recipe: RecipeArgs,
    /// Geological time to simulate in My, rounded up to whole steps [default: 250]
    #[arg(long, value_name = "MY", allow_hyphen_values = true, value_parser = time_span)]
    pub until: Option<f64>,
    /// Commands to carry out while the planet grows, *.scenario.ron
    #[arg(long, value_name = "FILE")]
    pub scenario: Option<PathBuf>,
    /// Threads to grow it on.
    #[command(flatten)]
    pub threads: ThreadsArgs,
}

impl GrowthArgs {
    /// The preset and the scenario.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        let both = [&self.recipe.preset, &self.scenario];
        both.into_iter().flatten().cloned()
    }

    /// Geological time to simulate in My where `--until` is not given.
    pub const UNTIL: f64 = 250.0;

    /// Geological time to simulate in My.
    pub fn until(&self) -> f64 {
        self.until.unwrap_or(Self::UNTIL)
    }
}

/// The threads of all parallel loops.
#[derive(Args, Debug, Default, Clone)]
pub struct ThreadsArgs {
    /// Number of threads [default: one per core]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = threads)]
    pub threads: Option<usize>,
}
