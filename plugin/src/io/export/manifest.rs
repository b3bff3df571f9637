//! The manifest of tiles, `NAME.json`: the scale of all, and where each one lies.

use super::engines::{common_figures, placements};
use super::format::ExportFormat;
use super::greys::{GreyRange, middle};
use super::names::{ExportFiles, HASH};
use crate::query::{MapGrid, TileBlock};
use serde_json::{Value, json};

/// The manifest of a block of tiles whose heights go from `heights[0]` to `heights[1]` m. `range`
/// is that of greys.
pub(super) fn manifest(
    files: &ExportFiles,
    block: &TileBlock,
    level: u8,
    heights: [f32; 2],
    range: Option<GreyRange>,
) -> Value {
    let format = files.format();
    let (lat, lon) = block.projection().lat_lon();
    let mut manifest = json!({
        "format": format.name(),
        "radius_m": block.projection().radius_m(),
        "lat": lat,
        "lon": lon,
        "level": level,
        "tiles": block.tiles(),
        "vertices": block.vertices(),
        "tile_m": block.tile_m(),
        "spacing_m": block.spacing_m(),
        "lowest_m": heights[0],
        "highest_m": heights[1],
        "sea_level_m": 0.0,
        "engines": common_figures(format, block, range),
        "files": tiles(files, block, range),
    });
    if let Some(range) = range {
        manifest["min_m"] = json!(range.low);
        manifest["max_m"] = json!(range.high);
        manifest["sea_level_grey"] = json!(range.exact_grey(0.0));
    }
    manifest
}

/// Adds the hashes of the tiles, as they were written.
pub(super) fn add_hashes(manifest: &mut Value, hashes: &[String]) {
    let files = manifest.get_mut("files").and_then(Value::as_array_mut);
    for (tile, hash) in files.into_iter().flatten().zip(hashes) {
        tile[HASH] = json!(hash);
    }
}

fn tiles(files: &ExportFiles, block: &TileBlock, range: Option<GreyRange>) -> Vec<Value> {
    let columns = block.tiles()[0];
    let paths = files.named().into_iter().enumerate();
    paths
        .map(|(k, path)| {
            let (column, row) = (k % columns, k / columns);
            let grid = block.tile(column, row);
            let mut entry = entry(files.format(), block, &grid, range);
            entry["file"] = json!(path.file_name().unwrap_or_default().to_string_lossy());
            entry["column"] = json!(column);
            entry["row"] = json!(row);
            entry
        })
        .collect()
}

/// Where a tile lies: from the middle of the block, in the plane of its projection; the middle of
/// the tile on the planet; and its place in engines.
fn entry(
    format: ExportFormat,
    block: &TileBlock,
    grid: &MapGrid,
    range: Option<GreyRange>,
) -> Value {
    let (north_west, side) = (grid.plane(0, 0), block.tile_m());
    let (lat, lon) = middle(grid);
    json!({
        "west_m": north_west.x,
        "north_m": north_west.y,
        "east_m": north_west.x + side,
        "south_m": north_west.y - side,
        "lat": lat,
        "lon": lon,
        "engines": placements(format, block, grid, range),
    })
}
