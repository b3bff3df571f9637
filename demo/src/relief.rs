//! `pangaea relief`: relief statistics of a planet by what built the relief, beside those of real
//! ground.

mod figures;

mod table;

mod tiles;

use crate::cli::ReliefArgs;
use crate::error::CliError;
use crate::ground::{bake_planet, ground};
use crate::headless::Headless;
use crate::inputs::Inputs;
use crate::output::{self, check_file, print, write_file};
use crate::progress;
use crate::source::load_planet;
use bevy_pangaea::crust::PlanetSurface;
use bevy_pangaea::io::{dem_files, raster_files};
use bevy_pangaea::planet::{Lattice, Planet};
use bevy_pangaea::relief_stats::{ReliefClass, SiteInput, class_relief, sites};
use figures::{ReliefFigures, all_figures, compare};
use table::tables;
use tiles::tile_figures;

/// Runs the command.
///
/// # Errors
/// If the planet, all tiles or the file for the figures are refused. A bad tile beside good ones is
/// passed over with a warning.
pub fn relief(args: &ReliefArgs) -> Result<(), CliError> {
    if let Some(path) = &args.json {
        check_file(path, &inputs(args))?;
    }
    let climate = args.ground.climate.load()?;
    // A folder without a good tile is refused before the planet is measured.
    let mut tiles = match &args.dem {
        Some(folder) => tile_figures(folder)?,
        None => Vec::new(),
    };
    let headless = bake_planet(load_planet(&args.ground.planet)?, climate)?;
    let mut classes = class_figures(&headless, args.sites)?;
    compare(&mut classes, &mut tiles);
    if let Some(path) = &args.json {
        write_file(path, &output::json(&all_figures(&classes, &tiles))?)?;
    }
    print(&tables(&classes, &tiles))
}

/// The files that are read: those of the planet, and the tiles.
fn inputs(args: &ReliefArgs) -> Inputs {
    let tiles = args.dem.iter().filter_map(|folder| dem_files(folder).ok());
    let tiles = tiles.flatten().flat_map(|tile| raster_files(&tile));
    Inputs::new(args.ground.files().chain(tiles))
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
    Ok(ReliefClass::ALL
        .into_iter()
        .map(|class| (class, sites(&input, class).into_iter().take(most).collect()))
        .collect())
}

#[cfg(test)]
mod tests;
