//! `pangaea info`: the facts of a planet file.

use crate::cli::InfoArgs;
use crate::error::CliError;
use crate::headless::Headless;
use crate::output::print;
use bevy_pangaea::authoring::Recording;
use bevy_pangaea::io::{Stats, Timings, digest, load, save};
use bevy_pangaea::planet::Planet;
use std::fmt::Write;

/// Runs the command.
///
/// # Errors
/// If the file is refused.
pub fn info(args: &InfoArgs) -> Result<(), CliError> {
    let state = load(&args.file)?;
    let hash = digest(&state);
    let headless = Headless::new(state);
    let stats = Stats::new(
        &headless.stats_input(headless.plates().rows().len())?,
        hash,
        Timings::default(),
    );
    print(&facts(&headless, &stats)?)
}

/// The facts as lines of a name and a value.
fn facts(headless: &Headless, stats: &Stats) -> Result<String, CliError> {
    let planet = headless.get::<Planet>()?;
    let commands = headless.get::<Recording>()?.0.len();
    let origin = [
        ("format", save::VERSION.to_string()),
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
    let mut text = String::new();
    for (name, value) in origin.into_iter().chain(measures(stats)) {
        let _ = writeln!(text, "{name:<12} {value}");
    }
    Ok(text)
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
