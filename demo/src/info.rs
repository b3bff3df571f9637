//! `pangaea info`: the facts of a planet file, and its commands as a scenario.

use crate::cli::InfoArgs;
use crate::error::CliError;
use crate::headless::Headless;
use crate::inputs::Inputs;
use crate::output::{check_file, print, write_file};
use crate::source::load_planet;
use bevy_pangaea::authoring::Recording;
use bevy_pangaea::climate::{ClimateMaps, EquirectMap};
use bevy_pangaea::hydrology::TerrainMaps;
use bevy_pangaea::io::scenario::scenario_of;
use bevy_pangaea::io::{PlanetFileKind, Stats, Timings, digest, map_digest, planet_files, save};
use bevy_pangaea::planet::Planet;
use std::fmt::Write;
use std::path::Path;

/// Runs the command.
///
/// # Errors
/// If the file is refused, or the scenario cannot be written.
pub fn info(args: &InfoArgs) -> Result<(), CliError> {
    let scenario_out = args.scenario_out.as_deref();
    if let Some(path) = scenario_out {
        check_file(path, &Inputs::new(planet_files(&args.file)))?;
    }
    let state = load_planet(&args.file)?;
    let format = format(&args.file)?;
    if let Some(path) = scenario_out {
        write_file(path, scenario_of(&state).as_bytes())?;
    }
    let hash = digest(&state);
    let headless = Headless::new(state);
    let stats = Stats::new(
        &headless.stats_input(headless.plates().rows().len())?,
        hash,
        Timings::default(),
    );
    print(&facts(format, &headless, &stats)?)
}

/// The format of a planet file: the version of a save.
fn format(path: &Path) -> Result<String, CliError> {
    Ok(match PlanetFileKind::of(path) {
        PlanetFileKind::Save => save::version_of(path)?.to_string(),
        PlanetFileKind::Terrain => "terrain file".into(),
        PlanetFileKind::Elevation => "map of the elevation".into(),
    })
}

/// The facts as lines of a name and a value.
fn facts(format: String, headless: &Headless, stats: &Stats) -> Result<String, CliError> {
    let planet = headless.get::<Planet>()?;
    let commands = headless.get::<Recording>()?.0.len();
    let origin = [
        ("format", format),
        ("digest", stats.digest.clone()),
        ("seed", planet.seed.to_string()),
        ("radius", format!("{} km", planet.radius)),
        ("samples", stats.samples.to_string()),
        ("plates", stats.plates.to_string()),
        (
            "time",
            format!("{} My in {} steps", stats.time_my, stats.steps),
        ),
        ("commands", commands.to_string()),
    ];
    let maps = maps(headless)?;
    let mut text = String::new();
    for (name, value) in origin.into_iter().chain(maps).chain(measures(stats)) {
        let _ = writeln!(text, "{name:<12} {value}");
    }
    Ok(text)
}

/// The maps that a planet is made of, and those that replace fields of its climate.
fn maps(headless: &Headless) -> Result<Vec<(&'static str, String)>, CliError> {
    // Planets that were grown have no terrain.
    let terrain = headless.get::<TerrainMaps>().ok();
    let terrain = terrain.into_iter().flat_map(TerrainMaps::iter);
    let climate = headless.get::<ClimateMaps>()?.iter();
    let climate = climate.map(|(field, map)| (field.name(), map));
    Ok(terrain
        .chain(climate)
        .map(|(name, map)| ("map", described(name, map)))
        .collect())
}

/// A map in words, with enough of its checksum to tell it from others.
fn described(name: &str, map: &EquirectMap) -> String {
    let [width, height] = map.size();
    format!(
        "{name}, {width} x {height} pixels, {} of them void, BLAKE3 {:.16}",
        map.voids(),
        map_digest(map)
    )
}

/// The facts that were measured on the surface.
fn measures(stats: &Stats) -> [(&'static str, String); 7] {
    let elevation = stats.elevation_km;
    [
        ("land", percent(stats.land_fraction)),
        ("continental", percent(stats.continental_fraction)),
        (
            "elevation",
            format!(
                "{:.2} to {:.2} km, mean {:.2} km",
                elevation.min, elevation.max, elevation.mean
            ),
        ),
        (
            "ocean age",
            format!(
                "{:.0} My, oldest {:.0} My",
                stats.ocean_age_my.mean, stats.ocean_age_my.max
            ),
        ),
        ("Andean", percent(stats.orogeny_fraction.andean)),
        ("Himalayan", percent(stats.orogeny_fraction.himalayan)),
        (
            "unexplained",
            format!(
                "{:.1e} of the continental area",
                stats.ledger.unexplained_max
            ),
        ),
    ]
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}
