//! Where engines put tiles, and how they scale them: in an engine's own units and axes, so that
//! every height comes out in true metres above the sea, and neighbours join.
//!
//! ```text
//! Unreal    x east, y south, z up, in cm; z = (grey - 32768) / 128 * scale + location
//! Unity     x east, y up, z north, in m; y = grey / 65536 * height + position
//! Godot     x east, y up, z south, in m
//! Blender   x east, y north, z up, in m
//! ```

use super::format::ExportFormat;
use super::greys::GreyRange;
use crate::query::{MapGrid, TileBlock};
use serde_json::{Map, Value, json};

/// Heights of the grey in the middle, at Unreal's location, and of one unit of its scale.
const UNREAL_MIDDLE: f64 = 32_768.0;
const UNREAL_STEPS_PER_CM: f64 = 128.0;

/// Greys by which Unity divides.
const UNITY_GREYS: f64 = 65_536.0;

/// Figures of an engine: its name, what all tiles have in common, and the place of each tile.
type EngineFigures = (&'static str, Value, fn(&TileFrame) -> Value);

/// A tile, as engines are told of it.
pub(super) struct TileFrame {
    west: f64,
    north: f64,
    side: f64,
    /// Height of black; 0 for metres.
    base: f64,
    /// Height at Unreal's location: that of the grey in the middle, or of 0 m.
    middle: f64,
}

impl TileFrame {
    pub(super) fn new(tile: &MapGrid, block: &TileBlock, range: Option<GreyRange>) -> Self {
        let corner = tile.plane(0, 0);
        let (base, span) = range.map_or((0.0, 1.0), |range| (range.low, range.high - range.low));
        Self {
            west: corner.x,
            north: corner.y,
            side: block.tile_m(),
            base,
            middle: range.map_or(0.0, |_| base + span * UNREAL_MIDDLE / 65_535.0),
        }
    }

    /// The corner of the first vertex in cm; z is the height of the middle grey.
    fn unreal(&self) -> Value {
        let location = [self.west, 0.0 - self.north, self.middle];
        json!(location.map(|m| 100.0 * m))
    }

    /// The south western corner; y is the height of black.
    fn unity(&self) -> Value {
        json!([self.west, self.base, self.north - self.side])
    }

    /// The corner of the first vertex.
    fn godot(&self) -> Value {
        json!([self.west, 0.0, 0.0 - self.north])
    }

    /// The middle of the block, about which the vertices of all meshes are.
    fn of_block(&self) -> Value {
        json!([0.0, 0.0, 0.0])
    }

    /// The middle; z is the height of black.
    fn blender(&self) -> Value {
        let half = 0.5 * self.side;
        json!([self.west + half, self.north - half, self.base])
    }
}

/// The engines that take a format, with what all tiles of a block have in common.
fn engines(
    format: ExportFormat,
    block: &TileBlock,
    range: Option<GreyRange>,
) -> Vec<EngineFigures> {
    match (format, range) {
        (ExportFormat::Grey, Some(range)) => vec![unreal(block, range), blender(block, range)],
        (ExportFormat::Raw, Some(range)) => vec![
            unreal(block, range),
            unity(block, range),
            godot(block, Some(range)),
        ],
        (ExportFormat::Mesh, _) => ["unreal", "unity", "godot", "blender"]
            .map(|name| {
                (
                    name,
                    json!({ "metres_per_unit": 1.0 }),
                    TileFrame::of_block as fn(&_) -> _,
                )
            })
            .into(),
        // Heights in metres: by EXR they are imported as they are, by GeoTIFF through other programs.
        _ => vec![
            unreal_in_metres(block),
            unity_in_metres(block),
            godot(block, None),
            blender(block, METRE),
        ],
    }
}

/// The range of heights in metres as greys: a unit is a metre.
const METRE: GreyRange = GreyRange {
    low: 0.0,
    high: 1.0,
};

/// The scale of a landscape or a mesh whose heights are metres.
fn unreal_in_metres(block: &TileBlock) -> EngineFigures {
    let spacing_cm = 100.0 * block.spacing_m();
    let scale = [spacing_cm, spacing_cm, 100.0];
    ("unreal", json!({ "scale": scale }), TileFrame::unreal)
}

/// The size of a terrain whose heights are metres, of which one is 1.
fn unity_in_metres(block: &TileBlock) -> EngineFigures {
    let figures = json!({
        "terrain_size": [block.tile_m(), 1.0, block.tile_m()],
        "heightmap_resolution": block.vertices(),
    });
    ("unity", figures, TileFrame::unity)
}

fn unreal(block: &TileBlock, range: GreyRange) -> EngineFigures {
    let spacing_cm = 100.0 * block.spacing_m();
    let grey_cm = 100.0 * (range.high - range.low) / 65_535.0;
    let scale = [spacing_cm, spacing_cm, UNREAL_STEPS_PER_CM * grey_cm];
    ("unreal", json!({ "scale": scale }), TileFrame::unreal)
}

fn unity(block: &TileBlock, range: GreyRange) -> EngineFigures {
    let height = (range.high - range.low) * UNITY_GREYS / 65_535.0;
    let figures = json!({
        "terrain_size": [block.tile_m(), height, block.tile_m()],
        "heightmap_resolution": block.vertices(),
        "depth": "16 bit",
        "byte_order": "Windows",
        "flip_vertically": true,
    });
    ("unity", figures, TileFrame::unity)
}

/// Of the terrain of Terrain3D.
fn godot(block: &TileBlock, range: Option<GreyRange>) -> EngineFigures {
    let mut figures = json!({ "vertex_spacing": block.spacing_m() });
    match range {
        Some(range) => {
            figures["r16_range"] = json!([range.low, range.high]);
            figures["r16_size"] = json!([block.vertices(), block.vertices()]);
        }
        None => {
            figures["import_scale"] = json!(1.0);
            figures["height_offset"] = json!(0.0);
        }
    }
    ("godot", figures, TileFrame::godot)
}

/// Of a plane with a modifier "Displace". A picture fills it to the edges of its pixels.
fn blender(block: &TileBlock, range: GreyRange) -> EngineFigures {
    let figures = json!({
        "plane_size": block.tile_m() + block.spacing_m(),
        "displace_strength": range.high - range.low,
        "displace_midlevel": 0.0,
    });
    ("blender", figures, TileFrame::blender)
}

/// The figures of all engines that take a format, by name, that all tiles have in common.
pub(super) fn common_figures(
    format: ExportFormat,
    block: &TileBlock,
    range: Option<GreyRange>,
) -> Map<String, Value> {
    let engines = engines(format, block, range).into_iter();
    engines
        .map(|(name, figures, _)| (name.to_string(), figures))
        .collect()
}

/// The place of a tile in each of these engines, by name.
pub(super) fn placements(
    format: ExportFormat,
    block: &TileBlock,
    tile: &MapGrid,
    range: Option<GreyRange>,
) -> Map<String, Value> {
    let frame = TileFrame::new(tile, block, range);
    let engines = engines(format, block, range).into_iter();
    engines
        .map(|(name, _, place)| (name.to_string(), place(&frame)))
        .collect()
}
