//! A tile on cells of 92.6 m, for figures that hang on the size of pixels.
//!
//! 92.6 m are the three arc seconds of SRTM, and the pixels of the tiles around sites. Pixels
//! within 5 % of it are cells as they are, each way on its own; of smaller ones a cell is the mean
//! over its area. Larger pixels lack what such figures are about: there are no cells.

use crate::query::HeightGrid;
use rayon::prelude::*;
use std::borrow::Cow;

/// Side of a cell in m.
pub(super) const CELL_M: f64 = 92.6;

/// Pixels whose side differs by no more than this share are cells as they are.
const TOLERANCE: f64 = 0.05;

/// Fewest values to a side of a tile.
const FEWEST_VALUES: usize = 3;

/// Whether size, pixels and values of a tile make sense.
pub(super) fn is_whole(tile: &HeightGrid) -> bool {
    let is_pixel = |&size: &f64| size > 0.0 && size.is_finite();
    tile.width >= FEWEST_VALUES
        && tile.height >= FEWEST_VALUES
        && tile.values.len() == tile.width * tile.height
        && tile.pixel_m.iter().all(is_pixel)
        && tile.values.iter().all(|z| z.is_finite())
}

/// The tile on cells; `None` of one that is broken, too coarse, or smaller than `fewest` cells to a
/// side.
pub(super) fn on_cells(tile: &HeightGrid, fewest: usize) -> Option<Cow<'_, HeightGrid>> {
    if !is_whole(tile) || tile.pixel_m.iter().any(|&pixel| pixel > largest_cell()) {
        return None;
    }
    let cells = if tile.pixel_m.into_iter().all(is_cell) {
        Cow::Borrowed(tile)
    } else {
        Cow::Owned(averaged(tile))
    };
    (cells.width >= fewest && cells.height >= fewest).then_some(cells)
}

fn largest_cell() -> f64 {
    CELL_M * (1.0 + TOLERANCE)
}

/// Whether a side of a pixel is one of a cell.
fn is_cell(pixel_m: f64) -> bool {
    (pixel_m / CELL_M - 1.0).abs() <= TOLERANCE
}

/// The means of the cells.
fn averaged(tile: &HeightGrid) -> HeightGrid {
    let [pixel_x, pixel_y] = tile.pixel_m;
    let columns = footprints(tile.width, pixel_x);
    let rows = footprints(tile.height, pixel_y);
    let values = rows
        .par_iter()
        .flat_map_iter(|row| columns.iter().map(|column| mean(tile, column, row)))
        .collect();
    HeightGrid {
        width: columns.len(),
        height: rows.len(),
        values,
        pixel_m: tile.pixel_m.map(|m| if is_cell(m) { m } else { CELL_M }),
    }
}

/// The pixels that a cell covers along a side.
#[derive(Clone, Debug, PartialEq)]
struct Footprint {
    /// The first of them.
    first: usize,
    /// The share of the cell that each covers.
    shares: Vec<f64>,
}

/// The footprints of all whole cells along a side, which is cut off evenly at both ends.
fn footprints(pixels: usize, pixel_m: f64) -> Vec<Footprint> {
    let pixels_per_cell = if is_cell(pixel_m) {
        1.0
    } else {
        CELL_M / pixel_m
    };
    let cells = (pixels as f64 / pixels_per_cell) as usize;
    let start = 0.5 * (pixels as f64 - cells as f64 * pixels_per_cell);
    (0..cells)
        .map(|i| {
            let from = start + i as f64 * pixels_per_cell;
            footprint(from, from + pixels_per_cell, pixels)
        })
        .collect()
}

/// The footprint of a cell between two places along a side, counted in pixels.
fn footprint(from: f64, to: f64, pixels: usize) -> Footprint {
    let first = from as usize;
    let end = (to.ceil() as usize).min(pixels);
    let covered = |i: usize| to.min((i + 1) as f64) - from.max(i as f64);
    Footprint {
        first,
        shares: (first..end).map(|i| covered(i) / (to - from)).collect(),
    }
}

/// Mean height of a cell in m.
fn mean(tile: &HeightGrid, column: &Footprint, row: &Footprint) -> f32 {
    let mut sum = 0.0;
    for (y, of_row) in (row.first..).zip(&row.shares) {
        let heights = &tile.row(y)[column.first..];
        let along: f64 = heights
            .iter()
            .zip(&column.shares)
            .map(|(&z, share)| f64::from(z) * share)
            .sum();
        sum += of_row * along;
    }
    sum as f32
}

#[cfg(test)]
#[path = "cells_tests.rs"]
mod tests;
