//! `pangaea generate`: grows a planet and writes it, its maps and its figures.

use crate::cli::GenerateArgs;
use crate::error::CliError;
use crate::growth::GrowthPlan;
use crate::headless::{Headless, initial_planet};
use crate::interrupt;
use crate::output::{Files, json, say};
use crate::progress;
use bevy_pangaea::control::PlanetBake;
use bevy_pangaea::crust::PlanetSurface;
use bevy_pangaea::io::{MarkedJson, Stats, Timings, digest, png, save};
use bevy_pangaea::overlay::{MapProjection, Overlay};
use bevy_pangaea::planet::PlanetRecipe;
use std::fmt::Display;
use std::time::Instant;

/// Size of the maps in pixels.
const MAP_SIZE: (u32, u32) = (2048, 1024);

/// The save file.
const PLANET_FILE: &str = "planet.pangaea";
/// The elevation in 16 bits.
const ELEVATION_FILE: &str = "elevation.png";
/// The figures.
const STATS_FILE: &str = "stats.json";

/// Runs the command.
///
/// # Errors
/// If an option, or a command of the scenario, is refused, or the user interrupts it; nothing is
/// written then.
pub fn generate(args: &GenerateArgs) -> Result<(), CliError> {
    interrupt::watch();
    args.growth.threads.start()?;
    let recipe = args.growth.recipe.checked()?;
    let plan = GrowthPlan::new(&args.growth, recipe.params.time_step)?;
    let climate = args.climate.load()?;
    // Refused before minutes are spent on growing.
    let mut files = Files::new(&args.out, file_names().iter().map(String::as_str))?;
    let (mut headless, timings) = grow(&recipe, plan)?;
    headless.project();
    headless.bake(climate)?;
    let digest = add_planet(&headless, &mut files)?;
    add_maps(&headless, &mut files)?;
    files.add(STATS_FILE, stats(&headless, digest, timings)?);
    interrupt::check()?;
    let written = files.write()?;
    say(&format!(
        "{} files in {}",
        written.len(),
        args.out.display()
    ));
    Ok(())
}

/// The names of all files.
fn file_names() -> Vec<String> {
    [PLANET_FILE, ELEVATION_FILE, STATS_FILE]
        .map(String::from)
        .into_iter()
        .chain(Overlay::ALL.map(map_name))
        .collect()
}

/// Grows a planet, and says how long that took.
fn grow(recipe: &PlanetRecipe, plan: GrowthPlan) -> Result<(Headless, Timings), CliError> {
    let start = Instant::now();
    let (state, mesh_ms) = initial_planet(recipe)?;
    let mut headless = Headless::new(state);
    plan.run(&mut headless)?;
    let total_ms = start.elapsed().as_secs_f64() * 1e3;
    let timings = headless.timings(mesh_ms, total_ms)?;
    Ok((headless, timings))
}

/// Adds the save file and returns the digest.
fn add_planet(headless: &Headless, files: &mut Files) -> Result<String, CliError> {
    let state = headless.state()?;
    let mut bytes = Vec::new();
    save::write_to(&state, &mut bytes).map_err(CliError::input)?;
    files.add(PLANET_FILE, bytes);
    Ok(digest(&state))
}

/// Adds the elevation in 16 bits and a colour map of every overlay, with a progress bar.
fn add_maps(headless: &Headless, files: &mut Files) -> Result<(), CliError> {
    let plates = headless.plates();
    let input = headless.overlay_input(&plates)?;
    let map = MapProjection::new(input.mesh, MAP_SIZE.0, MAP_SIZE.1);
    let elevation = map.elevation(headless.get::<PlanetSurface>()?);
    let grey = png::elevation_png(map.width(), &elevation).map_err(not_encoded)?;
    files.add(ELEVATION_FILE, grey);
    let bar = progress::bar(Overlay::ALL.len() as u64, "maps", "drawing");
    for overlay in Overlay::ALL {
        interrupt::check()?;
        let picture = png::rgb_png(&map.draw(overlay, &input)).map_err(not_encoded)?;
        files.add(&map_name(overlay), picture);
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

fn not_encoded(error: impl Display) -> CliError {
    CliError::Failed(format!("cannot encode a map: {error}"))
}

/// The file name of an overlay's colour map; `elevation.png` is the grey one.
fn map_name(overlay: Overlay) -> String {
    match overlay {
        Overlay::Elevation => "elevation_color.png".into(),
        other => format!("{}.png", other.name()),
    }
}

/// The file of statistics.
fn stats(headless: &Headless, digest: String, timings: Timings) -> Result<Vec<u8>, CliError> {
    let input = headless.stats_input(headless.plates().rows().len())?;
    let stats = Stats::new(&input, digest, timings);
    json(&MarkedJson::new(
        stats.with_bake(headless.get::<PlanetBake>()?),
    ))
}
