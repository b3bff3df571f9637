//! `pangaea relief`: relief statistics of a planet by what built the relief, beside those of real
//! ground.

use crate::cli::ReliefArgs;
use crate::error::CliError;
use crate::ground::{ground, open_planet};
use crate::headless::Headless;
use crate::output::{check_file, print, write_file};
use crate::progress;
use bevy_pangaea::crust::PlanetSurface;
use bevy_pangaea::io::{dem_files, load_dem};
use bevy_pangaea::planet::{Lattice, Planet};
use bevy_pangaea::relief_stats::{CLASSES, ReliefStats, SiteInput, class_relief, medians, sites};
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;

/// Figures of a class of sites, or of one tile.
struct Row {
    name: String,
    sites: usize,
    relief10_median_m: Option<f64>,
    slope_p90_deg: Option<f64>,
    spectral_exponent: Option<f64>,
}

impl Row {
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
pub fn relief(args: &ReliefArgs) -> Result<(), CliError> {
    if let Some(path) = &args.json {
        check_file(path)?;
    }
    let climate = args.climate.load()?;
    // Bad tiles are told before the planet is measured.
    let tiles = args
        .dem
        .as_deref()
        .map(tiles)
        .transpose()?
        .unwrap_or_default();
    let classes = classes(&open_planet(&args.planet, climate)?, args.sites as usize)?;
    if let Some(path) = &args.json {
        let mut text = serde_json::to_string_pretty(&figures(&classes, &tiles))
            .map_err(|error| CliError::Failed(error.to_string()))?;
        text.push('\n');
        write_file(path, text.as_bytes())?;
    }
    print(&table(&classes, &tiles))
}

/// The figures of every class, of at most `most` sites each.
fn classes(headless: &Headless, most: usize) -> Result<Vec<Row>, CliError> {
    let (lattice, surface) = (headless.get::<Lattice>()?, headless.get::<PlanetSurface>()?);
    let elevation: Vec<f32> = (0..surface.len()).map(|i| surface.elevation(i)).collect();
    let input = SiteInput {
        mesh: &lattice.0,
        elevation: &elevation,
        orogeny: &surface.crust.orogeny,
        orogeny_age: &surface.crust.orogeny_age,
        seed: headless.get::<Planet>()?.seed,
    };
    let drawn = CLASSES.map(|class| {
        (
            class,
            sites(&input, class)
                .into_iter()
                .take(most)
                .collect::<Vec<_>>(),
        )
    });
    let ground = ground(headless)?;
    let bar = progress::bar(
        drawn.iter().map(|(_, sites)| sites.len() as u64).sum(),
        "sites",
        "measuring",
    );
    let mut rows = Vec::new();
    for (class, sites) in &drawn {
        let reliefs = class_relief(&ground, &lattice.0, sites, || bar.inc(1))?;
        rows.push(Row::new(class.name().into(), &reliefs));
    }
    bar.finish_and_clear();
    Ok(rows)
}

/// The figures of every elevation model in a folder.
fn tiles(folder: &Path) -> Result<Vec<Row>, CliError> {
    let files = dem_files(folder)?;
    if files.is_empty() {
        let problem = "it has no .hgt, .tif or .png files";
        return Err(CliError::input(format!(
            "cannot compare with {}: {problem}",
            folder.display()
        )));
    }
    let mut rows: Vec<Row> = Vec::new();
    for path in files {
        let name = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        // Two files may differ in their extension only.
        let taken = rows.iter().any(|row| row.name == name);
        let name = if taken {
            path.file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned()
        } else {
            name
        };
        let found = ReliefStats::of(&load_dem(&path)?.grid)
            .ok_or_else(|| CliError::input(format!("{}: the tile is too small", path.display())))?;
        rows.push(Row::new(name, &[found]));
    }
    Ok(rows)
}

fn figures(classes: &[Row], tiles: &[Row]) -> Value {
    let map = |rows: &[Row]| {
        rows.iter()
            .map(|row| (row.name.clone(), row.json()))
            .collect::<Map<_, _>>()
    };
    let mut all = map(classes);
    all.insert("tiles".into(), Value::Object(map(tiles)));
    Value::Object(all)
}

fn table(classes: &[Row], tiles: &[Row]) -> String {
    let number =
        |value: Option<f64>, digits: usize| value.map_or("-".into(), |x| format!("{x:.digits$}"));
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
            number(row.relief10_median_m, 0),
            number(row.slope_p90_deg, 1),
            number(row.spectral_exponent, 2)
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_the_documented_form() {
        let none = Row::new("plains".into(), &[]);
        let tile = Row {
            name: "N44W072".into(),
            sites: 1,
            relief10_median_m: Some(653.4),
            slope_p90_deg: Some(18.06),
            spectral_exponent: Some(3.159),
        };
        let json = figures(&[none], &[tile]);
        assert_eq!(json["plains"]["sites"], 0);
        assert!(json["plains"]["slope_p90_deg"].is_null());
        assert_eq!(json["tiles"]["N44W072"]["relief10_median_m"], 653.4);
        let keys: Vec<&str> = json["plains"]
            .as_object()
            .unwrap()
            .keys()
            .map(String::as_str)
            .collect();
        assert_eq!(keys.len(), 4);
        let text = table(&[Row::new("plains".into(), &[])], &[]);
        assert!(text.contains("plains") && text.lines().count() == 2);
    }
}
