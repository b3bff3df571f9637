//! `pangaea generate`: grows a planet and writes it, its maps and its figures.

use crate::cli::GenerateArgs;
use crate::error::CliError;
use crate::ground::bake_planet;
use crate::growth::GrowthPlan;
use crate::headless::{Headless, initial_planet};
use crate::inputs::Inputs;
use crate::interrupt;
use crate::maps::MapSet;
use crate::output::{Files, json, say_written};
use bevy_pangaea::climate::ClimateMaps;
use bevy_pangaea::control::PlanetBake;
use bevy_pangaea::io::scenario::scenario_of;
use bevy_pangaea::io::{MarkedJson, Stats, Timings, digest, save};
use bevy_pangaea::planet::PlanetRecipe;
use bevy_pangaea::spawn::PlanetState;
use std::time::Instant;

/// The save file.
const PLANET_FILE: &str = "planet.pangaea";
/// The figures.
const STATS_FILE: &str = "stats.json";

/// Runs the command.
///
/// # Errors
/// If an option, or a command of the scenario, is refused, or the user interrupts it; nothing is
/// written then.
pub fn generate(args: &GenerateArgs) -> Result<(), CliError> {
    interrupt::watch();
    let recipe = args.growth.recipe.checked()?;
    let plan = GrowthPlan::new(&args.growth, recipe.params.time_step)?;
    let climate = args.climate.load()?;
    // Refused before minutes are spent on growing.
    save::check_maps(&climate).map_err(CliError::input)?;
    let maps = MapSet::default();
    let inputs = Inputs::new(args.growth.files().chain(args.climate.files()));
    let scenario_out = args.scenario_out.as_deref();
    let mut files = Files::new(&args.out, file_names(&maps), scenario_out, &inputs)?;
    let (state, timings) = grow(&recipe, climate, plan)?;
    let digest = add_planet(&state, &mut files)?;
    let scenario = scenario_of(&state);
    // Maps and figures are those that whoever loads the save gets.
    let headless = bake_planet(state, ClimateMaps::default())?;
    maps.draw(&headless, &mut files)?;
    files.add(STATS_FILE, stats(&headless, digest, timings)?);
    interrupt::check()?;
    let in_folder = files.count();
    if let Some(path) = scenario_out {
        files.add_named(path, scenario.into_bytes());
    }
    let written = files.write()?;
    say_written(&written[..in_folder], &args.out);
    Ok(())
}

/// The names of all files.
fn file_names(maps: &MapSet) -> impl Iterator<Item = String> {
    let of_generate = [PLANET_FILE, STATS_FILE].map(String::from);
    of_generate.into_iter().chain(maps.names())
}

/// Grows a planet with maps of its climate, and says how long that took.
fn grow(
    recipe: &PlanetRecipe,
    climate: ClimateMaps,
    plan: GrowthPlan,
) -> Result<(PlanetState, Timings), CliError> {
    let start = Instant::now();
    let (mut state, mesh_ms) = initial_planet(recipe)?;
    state.climate = climate;
    let mut headless = Headless::new(state);
    plan.run(&mut headless)?;
    let total_ms = start.elapsed().as_secs_f64() * 1e3;
    let timings = headless.timings(mesh_ms, total_ms)?;
    Ok((headless.state()?, timings))
}

/// Adds the save file and returns the digest.
fn add_planet(state: &PlanetState, files: &mut Files) -> Result<String, CliError> {
    let mut bytes = Vec::new();
    save::write_to(state, &mut bytes).map_err(CliError::input)?;
    files.add(PLANET_FILE, bytes);
    Ok(digest(state))
}

/// The file of statistics.
fn stats(headless: &Headless, digest: String, timings: Timings) -> Result<Vec<u8>, CliError> {
    let input = headless.stats_input(headless.plates().rows().len())?;
    let stats = Stats::new(&input, digest, timings);
    json(&MarkedJson::new(
        stats.with_bake(headless.get::<PlanetBake>()?),
    ))
}
