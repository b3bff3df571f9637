//! The twins in WGSL of this folder's modules.
//!
//! A function has its Rust twin's name; a method has its type's name before it, in snake case; a
//! function whose name another module has, too, or WGSL reserves, has its module's before it. A
//! type has its name and fields, with `i32` and `u32` for smaller integers. Caches, which save
//! work on the CPU, have no twin.
//!
//! Every name is global in WGSL; it may hide a built-in function, as `mix` and `length` do.

use super::edge_split::{course, place};
use super::rows::{edge, face, level, vertex as vertex_rows};
use super::rules::lake::{new, shore};
use super::rules::ocean::phasor;
use super::rules::valley::{carve, place as river_place, plain, reach, section};
use super::rules::{
    coarse, coast, crest, divide, edge_land, estuary, fine, fold, gully, lake, landform, meander,
    nodes, noise, ocean, preset, rise, river, shift, slope, terrain, threshold,
};
use super::vertex_resolve::river as nearest_river;
use super::{arith, columns, curve, fixed, geometry, seed, sight, vertex, view};
use crate::wgsl::WgslModule;

/// A module beside which a twin stands: `twin!("path", module, [needs])`.
macro_rules! twin {
    ($path:literal, $constants:expr, [$($needs:literal),*]) => {
        WgslModule {
            path: concat!("amplify/", $path),
            wgsl: include_str!(concat!($path, ".wgsl")),
            needs: &[$(concat!("amplify/", $needs)),*],
            constants: $constants,
        }
    };
}

/// All modules, each after those that it needs.
pub const MODULES: [WgslModule; 64] = [
    twin!("integer", String::new, []),
    twin!("fixed", fixed::shared_constants, ["integer"]),
    twin!("arith", arith::shared_constants, ["integer", "fixed"]),
    twin!("seed", seed::shared_constants, ["fixed"]),
    twin!(
        "geometry",
        geometry::shared_constants,
        ["integer", "fixed", "arith"]
    ),
    twin!(
        "curve",
        curve::shared_constants,
        ["integer", "fixed", "arith", "geometry"]
    ),
    twin!("scale", String::new, ["fixed", "arith"]),
    twin!(
        "view",
        view::shared_constants,
        ["integer", "fixed", "arith", "geometry", "scale"]
    ),
    twin!(
        "sight",
        sight::shared_constants,
        ["integer", "fixed", "arith", "geometry", "scale", "view"]
    ),
    twin!("rules/noise", noise::shared_constants, ["fixed", "arith"]),
    twin!(
        "rules/ocean/phasor",
        phasor::shared_constants,
        ["integer", "fixed", "arith", "rules/noise"]
    ),
    twin!("vertex", vertex::shared_constants, ["fixed", "arith"]),
    twin!("rules/preset", preset::shared_constants, []),
    twin!("rules/vertex_ground", String::new, []),
    twin!("rules/nodes", nodes::shared_constants, ["fixed", "arith"]),
    twin!(
        "rules/landform",
        landform::shared_constants,
        ["fixed", "arith", "vertex", "rules/preset"]
    ),
    twin!(
        "rules/fine",
        fine::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/vertex_ground",
            "rules/noise",
            "rules/landform"
        ]
    ),
    twin!(
        "rules/gully",
        gully::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/vertex_ground"
        ]
    ),
    twin!(
        "rules/ocean/mod",
        ocean::shared_constants,
        [
            "fixed",
            "arith",
            "seed",
            "geometry",
            "vertex",
            "rules/noise",
            "rules/ocean/phasor"
        ]
    ),
    twin!(
        "rules/fold",
        fold::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/noise",
            "rules/ocean/phasor",
            "rules/ocean/mod"
        ]
    ),
    twin!(
        "rules/edge_land",
        edge_land::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "rules/landform",
            "rules/fold"
        ]
    ),
    twin!(
        "rules/divide",
        divide::shared_constants,
        ["fixed", "arith", "vertex", "rules/preset", "rules/fold"]
    ),
    twin!(
        "rules/threshold",
        threshold::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "rules/edge_land",
            "rules/divide"
        ]
    ),
    twin!(
        "rules/rise",
        rise::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "rules/fine",
            "rules/gully",
            "rules/edge_land",
            "rules/divide",
            "rules/threshold"
        ]
    ),
    twin!(
        "rules/crest",
        crest::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/vertex_ground",
            "rules/nodes",
            "rules/fine",
            "rules/rise"
        ]
    ),
    twin!(
        "rules/slope",
        slope::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/vertex_ground",
            "rules/nodes",
            "rules/fine",
            "rules/rise"
        ]
    ),
    twin!(
        "rules/terrain",
        terrain::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "integer",
            "seed",
            "rules/vertex_ground",
            "rules/nodes",
            "rules/landform",
            "rules/rise"
        ]
    ),
    twin!(
        "rules/coast",
        coast::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/vertex_ground",
            "rules/noise"
        ]
    ),
    twin!(
        "rules/river",
        river::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/vertex_ground"
        ]
    ),
    twin!(
        "rules/shift",
        shift::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/landform",
            "rules/river"
        ]
    ),
    twin!(
        "rules/estuary",
        estuary::shared_constants,
        ["fixed", "arith"]
    ),
    twin!(
        "rules/meander",
        meander::shared_constants,
        [
            "fixed",
            "arith",
            "seed",
            "geometry",
            "vertex",
            "rules/estuary"
        ]
    ),
    twin!(
        "rules/valley/reach",
        reach::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "scale",
            "rules/estuary"
        ]
    ),
    twin!(
        "segment",
        String::new,
        [
            "fixed",
            "arith",
            "curve",
            "scale",
            "vertex",
            "rules/preset",
            "rules/valley/reach"
        ]
    ),
    twin!(
        "rules/valley/place",
        river_place::shared_constants,
        [
            "fixed",
            "arith",
            "geometry",
            "curve",
            "scale",
            "vertex",
            "rules/preset",
            "rules/meander",
            "rules/valley/reach",
            "segment"
        ]
    ),
    twin!(
        "rules/valley/section",
        section::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "integer",
            "scale",
            "rules/valley/reach",
            "segment"
        ]
    ),
    twin!(
        "rules/valley/plain",
        plain::shared_constants,
        ["fixed", "arith", "rules/noise", "rules/valley/reach"]
    ),
    twin!(
        "rules/valley/carve",
        carve::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "scale",
            "rules/ocean/mod",
            "rules/valley/reach",
            "rules/valley/section",
            "rules/valley/plain"
        ]
    ),
    twin!(
        "rules/lake/mod",
        lake::shared_constants,
        [
            "vertex",
            "rules/preset",
            "rules/vertex_ground",
            "rules/crest",
            "rules/valley/carve"
        ]
    ),
    twin!(
        "rules/lake/new",
        new::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "seed",
            "rules/vertex_ground",
            "rules/landform",
            "rules/lake/mod"
        ]
    ),
    twin!(
        "rules/lake/shore",
        shore::shared_constants,
        [
            "fixed",
            "arith",
            "vertex",
            "rules/preset",
            "rules/vertex_ground",
            "rules/noise",
            "rules/landform",
            "rules/rise",
            "rules/lake/mod"
        ]
    ),
    twin!(
        "rules/coarse",
        coarse::shared_constants,
        ["fixed", "arith", "vertex", "rules/preset", "rules/landform"]
    ),
    twin!(
        "rules/mod",
        String::new,
        [
            "vertex",
            "rules/preset",
            "rules/vertex_ground",
            "rules/fine",
            "rules/gully",
            "rules/crest",
            "rules/slope",
            "rules/terrain",
            "rules/coast",
            "rules/river",
            "rules/lake/mod",
            "rules/lake/new",
            "rules/lake/shore"
        ]
    ),
    twin!("rows/vertex", vertex_rows::shared_constants, ["vertex"]),
    twin!("rows/edge", edge::shared_constants, []),
    twin!("rows/face", face::shared_constants, ["rows/edge"]),
    twin!("rows/level", level::shared_constants, []),
    twin!(
        "uniform",
        String::new,
        ["sight", "rules/preset", "rows/level"]
    ),
    twin!(
        "columns",
        columns::shared_constants,
        [
            "rules/valley/carve",
            "uniform",
            "rows/vertex",
            "rows/edge",
            "rows/face",
            "rows/level"
        ]
    ),
    twin!(
        "mark",
        String::new,
        [
            "fixed",
            "arith",
            "view",
            "sight",
            "rows/edge",
            "rows/face",
            "columns"
        ]
    ),
    twin!(
        "count",
        String::new,
        ["rows/edge", "rows/face", "rows/level", "columns"]
    ),
    twin!("scan", String::new, ["rows/level", "columns", "count"]),
    twin!(
        "place",
        String::new,
        ["rows/edge", "rows/face", "columns", "count"]
    ),
    twin!(
        "face_decide",
        String::new,
        [
            "fixed",
            "arith",
            "seed",
            "geometry",
            "vertex",
            "rules/preset",
            "rules/gully",
            "rules/valley/reach",
            "rows/vertex",
            "rows/edge",
            "rows/face",
            "columns"
        ]
    ),
    twin!(
        "edge_split/place",
        place::shared_constants,
        [
            "fixed",
            "arith",
            "geometry",
            "vertex",
            "rules/preset",
            "rules/shift",
            "rules/ocean/mod"
        ]
    ),
    twin!(
        "edge_split/course",
        course::shared_constants,
        [
            "fixed",
            "arith",
            "seed",
            "geometry",
            "curve",
            "vertex",
            "edge_split/place"
        ]
    ),
    twin!(
        "edge_split/lakes",
        String::new,
        ["seed", "vertex", "rules/preset"]
    ),
    twin!(
        "edge_split/mod",
        String::new,
        [
            "integer",
            "fixed",
            "arith",
            "seed",
            "geometry",
            "curve",
            "scale",
            "vertex",
            "segment",
            "rules/meander",
            "rules/gully",
            "rules/ocean/mod",
            "rules/fold",
            "rules/mod",
            "rows/vertex",
            "rows/edge",
            "rows/face",
            "columns",
            "face_decide",
            "edge_split/place",
            "edge_split/course",
            "edge_split/lakes"
        ]
    ),
    twin!(
        "vertex_resolve/river",
        nearest_river::shared_constants,
        [
            "vertex",
            "scale",
            "segment",
            "rules/preset",
            "rules/valley/reach",
            "rules/valley/place",
            "rules/valley/section"
        ]
    ),
    twin!(
        "vertex_resolve/mod",
        String::new,
        [
            "vertex",
            "segment",
            "rows/vertex",
            "rows/edge",
            "rows/face",
            "columns",
            "vertex_resolve/river"
        ]
    ),
    twin!(
        "face_split",
        String::new,
        [
            "integer",
            "fixed",
            "seed",
            "vertex",
            "rules/gully",
            "rows/vertex",
            "rows/edge",
            "rows/face",
            "columns"
        ]
    ),
    twin!(
        "carve",
        String::new,
        [
            "vertex",
            "rules/lake/mod",
            "rules/valley/carve",
            "rows/vertex",
            "columns"
        ]
    ),
    twin!(
        "show",
        String::new,
        [
            "scale",
            "vertex",
            "rules/valley/carve",
            "rules/coarse",
            "rows/vertex",
            "columns",
            "mark"
        ]
    ),
    twin!(
        "emit",
        String::new,
        ["geometry", "rows/edge", "rows/face", "columns", "count"]
    ),
];
