//! The elevation models of a folder, and what is wrong with those that are passed over.

use super::figures::ReliefFigures;
use crate::dem::tell_means;
use crate::error::CliError;
use crate::output::say;
use bevy_pangaea::io::{dem_files, load_dem};
use bevy_pangaea::relief_stats::ReliefStats;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

/// The figures of the elevation models in a folder. Files that are none are passed over with a
/// warning; it is an error if nothing is left.
pub(super) fn tile_figures(folder: &Path) -> Result<Vec<ReliefFigures>, CliError> {
    let mut figures: Vec<ReliefFigures> = Vec::new();
    let files = dem_files(folder)?;
    let mut problems = strangers(folder, &files);
    for path in files {
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

/// Extensions of elevation models that are not read, of archives and of half a download.
const NOT_READ: &str = "7z adf asc bil bin bip bsq bz2 crdownload dem dt0 dt1 dt2 flt grd gz img jp2 \
                        nc part rar tar tgz vrt xz zip";

/// Reasons why things in a folder that look like elevation models are not among `files`: folders and
/// pipes of such names, and models in forms that are not read.
fn strangers(folder: &Path, files: &[PathBuf]) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    paths.retain(|path| !files.contains(path) && !text(path.file_name()).starts_with('.'));
    paths.sort();
    paths
        .iter()
        .filter_map(|path| Some(format!("{}: {}", path.display(), stranger(path)?)))
        .collect()
}

/// The reason of one of them; none of a file that may be anything else.
fn stranger(path: &Path) -> Option<&'static str> {
    let extension = text(path.extension()).to_lowercase();
    let is_file = path.is_file();
    match extension.as_str() {
        "hgt" | "tif" | "tiff" | "png" if !is_file => Some("it is no file"),
        other if is_file && NOT_READ.split(' ').any(|known| known == other) => {
            Some("no elevation model is read in this form")
        }
        _ => None,
    }
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
    tell_means(path, &tile);
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
