//! `pangaea relief`: relief statistics of a planet by what built the relief, beside those of real
//! ground.

use crate::cli::ReliefArgs;
use crate::error::CliError;
use crate::ground::{bake_planet, ground};
use crate::headless::Headless;
use crate::output::{self, check_file, print, say, write_file};
use crate::progress;
use bevy_pangaea::crust::PlanetSurface;
use bevy_pangaea::io::{dem_files, load_dem, load_planet};
use bevy_pangaea::planet::{Lattice, Planet};
use bevy_pangaea::relief_stats::{
    CLASSES, ReliefClass, ReliefStats, SiteInput, class_relief, medians, sites,
};
use serde_json::{Map, Value, json};
use std::ffi::OsStr;
use std::fmt::Write;
use std::path::Path;

/// Relief figures of a class of sites, or of one tile of real ground.
struct ReliefFigures {
    name: String,
    sites: usize,
    relief10_median_m: Option<f64>,
    slope_p90_deg: Option<f64>,
    spectral_exponent: Option<f64>,
}

impl ReliefFigures {
    fn new(name: String, reliefs: &[ReliefStats]) -> Self {
        let [relief10_median_m, slope_p90_deg, spectral_exponent] = medians(reliefs);
        Self {
            name,
            sites: reliefs.len(),
            relief10_median_m,
            slope_p90_deg,
            spectral_exponent,
        }
    }

    fn json(&self) -> Value {
        json!({
            "sites": self.sites,
            "relief10_median_m": self.relief10_median_m,
            "slope_p90_deg": self.slope_p90_deg,
            "spectral_exponent": self.spectral_exponent,
        })
    }
}

/// Runs the command.
///
/// # Errors
/// If the planet, all tiles or the file for the figures are refused. A bad tile beside good ones is
/// passed over with a warning.
pub fn relief(args: &ReliefArgs) -> Result<(), CliError> {
    if let Some(path) = &args.json {
        check_file(path)?;
    }
    let climate = args.ground.climate.load()?;
    // A folder without a good tile is refused before the planet is measured.
    let tiles = match &args.dem {
        Some(folder) => tile_figures(folder)?,
        None => Vec::new(),
    };
    let headless = bake_planet(load_planet(&args.ground.planet)?, climate)?;
    let classes = class_figures(&headless, args.sites)?;
    if let Some(path) = &args.json {
        write_file(path, &output::json(&all_figures(&classes, &tiles))?)?;
    }
    print(&table(&classes, &tiles))
}

/// The figures of every class, of at most `most` sites each.
fn class_figures(headless: &Headless, most: usize) -> Result<Vec<ReliefFigures>, CliError> {
    let mesh = &headless.get::<Lattice>()?.0;
    let chosen = choose_sites(headless, most)?;
    let ground = ground(headless)?;
    let count = chosen.iter().map(|(_, sites)| sites.len() as u64).sum();
    let bar = progress::bar(count, "sites", "measuring");
    let mut figures = Vec::new();
    for (class, sites) in &chosen {
        let reliefs = class_relief(&ground, mesh, sites, || bar.inc(1))?;
        figures.push(ReliefFigures::new(class.name().into(), &reliefs));
    }
    bar.finish_and_clear();
    Ok(figures)
}

/// At most `most` sites of every class.
fn choose_sites(
    headless: &Headless,
    most: usize,
) -> Result<Vec<(ReliefClass, Vec<u32>)>, CliError> {
    let surface = headless.get::<PlanetSurface>()?;
    let elevation: Vec<f32> = (0..surface.len()).map(|i| surface.elevation(i)).collect();
    let input = SiteInput {
        mesh: &headless.get::<Lattice>()?.0,
        elevation: &elevation,
        orogeny: &surface.crust.orogeny,
        orogeny_age: &surface.crust.orogeny_age,
        seed: headless.get::<Planet>()?.seed,
    };
    Ok(CLASSES
        .into_iter()
        .map(|class| (class, sites(&input, class).into_iter().take(most).collect()))
        .collect())
}

/// The figures of the elevation models in a folder. Files that are none are passed over with a
/// warning; it is an error if nothing is left.
fn tile_figures(folder: &Path) -> Result<Vec<ReliefFigures>, CliError> {
    let mut figures: Vec<ReliefFigures> = Vec::new();
    let mut problems = Vec::new();
    for path in dem_files(folder)? {
        match tile_relief(&path) {
            Ok(relief) => {
                let name = tile_name(&path, &figures);
                figures.push(ReliefFigures::new(name, &[relief]));
            }
            Err(problem) => problems.push(problem.to_string()),
        }
    }
    if figures.is_empty() {
        return Err(nothing_left(folder, &problems));
    }
    for problem in problems {
        say(&format!("warning: {problem}; it is passed over"));
    }
    Ok(figures)
}

/// Share of voids in a tile that is no more than a flaw.
const MOST_VOIDS: f64 = 0.1;

/// The relief of an elevation model; much of it that is filled is said.
fn tile_relief(path: &Path) -> Result<ReliefStats, CliError> {
    // Such as the `._NAME` that macOS puts beside every NAME.
    if text(path.file_name()).starts_with('.') {
        return Err(refused(path, "it is a hidden file"));
    }
    let tile = load_dem(path)?;
    let relief =
        ReliefStats::of(&tile.grid).ok_or_else(|| refused(path, "the tile is too small"))?;
    let share = tile.voids as f64 / tile.grid.values.len() as f64;
    if share > MOST_VOIDS {
        let percent = (100.0 * share).round();
        say(&format!(
            "warning: {}: {percent} % of it are voids, filled from their neighbours",
            path.display()
        ));
    }
    Ok(relief)
}

fn refused(path: &Path, problem: &str) -> CliError {
    CliError::input(format!("{}: {problem}", path.display()))
}

/// The name of a tile, with its extension if there are two that differ in that alone.
fn tile_name(path: &Path, others: &[ReliefFigures]) -> String {
    let stem = text(path.file_stem());
    if others.iter().any(|tile| tile.name == stem) {
        text(path.file_name())
    } else {
        stem
    }
}

/// The error of a folder in which no file is an elevation model.
fn nothing_left(folder: &Path, problems: &[String]) -> CliError {
    let reason = match problems {
        [] => "it has no .hgt, .tif or .png files".into(),
        [only] => only.clone(),
        [first, others @ ..] => format!("{first} (refused, too: {} more)", others.len()),
    };
    CliError::input(format!(
        "cannot compare with {}: {reason}",
        folder.display()
    ))
}

/// A part of a path as text.
fn text(part: Option<&OsStr>) -> String {
    part.unwrap_or_default().to_string_lossy().into_owned()
}

/// The figures of classes by their names, and those of tiles by theirs under `tiles`.
fn all_figures(classes: &[ReliefFigures], tiles: &[ReliefFigures]) -> Value {
    let mut all = by_name(classes);
    all.insert("tiles".into(), Value::Object(by_name(tiles)));
    Value::Object(all)
}

fn by_name(figures: &[ReliefFigures]) -> Map<String, Value> {
    figures
        .iter()
        .map(|figures| (figures.name.clone(), figures.json()))
        .collect()
}

fn table(classes: &[ReliefFigures], tiles: &[ReliefFigures]) -> String {
    let mut text = format!(
        "{:<24} {:>5} {:>18} {:>14} {:>18}\n",
        "", "sites", "relief in 10 km, m", "slope p90, deg", "spectral exponent"
    );
    for row in classes.iter().chain(tiles) {
        let _ = writeln!(
            text,
            "{:<24} {:>5} {:>18} {:>14} {:>18}",
            row.name,
            row.sites,
            cell(row.relief10_median_m, 0),
            cell(row.slope_p90_deg, 1),
            cell(row.spectral_exponent, 2)
        );
    }
    text
}

/// A figure with so many digits, or a dash where there is none.
fn cell(value: Option<f64>, digits: usize) -> String {
    value.map_or("-".into(), |value| format!("{value:.digits$}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_the_documented_form() {
        let empty = ReliefFigures::new("plains".into(), &[]);
        let tile = ReliefFigures {
            name: "N44W072".into(),
            sites: 1,
            relief10_median_m: Some(653.4),
            slope_p90_deg: Some(18.06),
            spectral_exponent: Some(3.159),
        };
        let json = all_figures(&[empty], &[tile]);
        assert_eq!(json["plains"]["sites"], 0);
        assert!(json["plains"]["slope_p90_deg"].is_null());
        assert_eq!(json["tiles"]["N44W072"]["relief10_median_m"], 653.4);
        assert_eq!(json["plains"].as_object().unwrap().len(), 4);
    }

    #[test]
    fn a_class_without_sites_has_a_line() {
        let text = table(&[ReliefFigures::new("plains".into(), &[])], &[]);
        assert!(text.contains("plains") && text.lines().count() == 2);
    }
}
