//! `pangaea generate`: grows a planet and writes it, its maps and its figures.

use crate::bench::floor::memory_floor_ms;
use crate::cli::GenerateArgs;
use crate::course::Course;
use crate::error::CliError;
use crate::headless::{Headless, set_threads, sprout};
use crate::interrupt;
use crate::output::{Files, say};
use crate::progress;
use bevy_pangaea::control::PlanetBake;
use bevy_pangaea::crust::{Crust, PlanetSurface};
use bevy_pangaea::io::{Stats, Timings, digest, png, save};
use bevy_pangaea::overlay::{MapProjection, Overlay};
use bevy_pangaea::schedule::StageTimings;
use std::time::Instant;

/// Size of the maps in pixels.
const MAP: (u32, u32) = (2048, 1024);

/// The save file.
const PLANET: &str = "planet.pangaea";
/// The elevation in 16 bits.
const ELEVATION: &str = "elevation.png";
/// The figures.
const STATS: &str = "stats.json";

/// Runs the command.
pub fn generate(args: &GenerateArgs) -> Result<(), CliError> {
    interrupt::watch();
    set_threads(args.growth.threads)?;
    let recipe = args.growth.recipe.checked()?;
    let course = Course::new(&args.growth, recipe.params.time_step)?;
    let climate = args.climate.load()?;
    let maps = Overlay::ALL.map(map_name);
    let names = [PLANET, ELEVATION, STATS]
        .into_iter()
        .chain(maps.iter().map(String::as_str));
    let mut files = Files::new(&args.out, names)?;
    let start = Instant::now();
    let (state, mesh_ms) = sprout(&recipe)?;
    let mut headless = Headless::new(state);
    course.run(&mut headless)?;
    let total = start.elapsed().as_secs_f64() * 1e3;
    headless.look();
    headless.bake(climate)?;

    let timings = Timings {
        mesh: Some(mesh_ms),
        total: Some(total),
        floor: Some(memory_floor_ms(headless.get::<Crust>()?)),
        ..Timings::of_stages(headless.get::<StageTimings>()?)
    };
    let hash = add_planet(&headless, &mut files)?;
    let bar = progress::bar(Overlay::ALL.len() as u64, "maps", "drawing");
    add_maps(&headless, &mut files, |drawn| bar.set_position(drawn))?;
    bar.finish_and_clear();
    files.add(STATS, figures(&headless, hash, timings)?);
    interrupt::check()?;
    let written = files.write()?;
    say(&format!(
        "{} files in {}",
        written.len(),
        args.out.display()
    ));
    Ok(())
}

/// Adds the save file and returns the digest.
fn add_planet(headless: &Headless, files: &mut Files) -> Result<String, CliError> {
    let state = headless.state()?;
    let mut bytes = Vec::new();
    save::write_to(&state, &mut bytes).map_err(CliError::input)?;
    files.add(PLANET, bytes);
    Ok(digest(&state))
}

/// Adds the elevation in 16 bits and a colour map of every overlay.
fn add_maps(
    headless: &Headless,
    files: &mut Files,
    mut drawn: impl FnMut(u64),
) -> Result<(), CliError> {
    let plates = headless.plates();
    let input = headless.overlay_input(&plates)?;
    let surface = headless.get::<PlanetSurface>()?;
    let broken = |error| CliError::Failed(format!("cannot encode a map: {error}"));
    let map = MapProjection::new(input.mesh, MAP.0, MAP.1);
    let elevation = map.elevation(surface);
    files.add(
        ELEVATION,
        png::elevation_png(map.width(), &elevation).map_err(broken)?,
    );
    for (count, overlay) in Overlay::ALL.into_iter().enumerate() {
        interrupt::check()?;
        let picture = png::rgb_png(&map.draw(overlay, &input)).map_err(broken)?;
        files.add(&map_name(overlay), picture);
        drawn(count as u64 + 1);
    }
    Ok(())
}

/// The file name of an overlay's colour map; `elevation.png` is the grey one.
fn map_name(overlay: Overlay) -> String {
    match overlay {
        Overlay::Elevation => "elevation_color.png".into(),
        other => format!("{}.png", other.name()),
    }
}

fn figures(headless: &Headless, digest: String, timings: Timings) -> Result<Vec<u8>, CliError> {
    let input = headless.stats_input(headless.plates().rows().len())?;
    let stats = Stats::new(&input, digest, timings).with_bake(headless.get::<PlanetBake>()?);
    let mut json = serde_json::to_string_pretty(&stats)
        .map_err(|error| CliError::Failed(error.to_string()))?;
    json.push('\n');
    Ok(json.into_bytes())
}
