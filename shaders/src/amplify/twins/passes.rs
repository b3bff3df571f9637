//! Rows, columns, and the passes over them.

use super::twin;
use crate::amplify::columns;
use crate::amplify::edge_split::{course, place};
use crate::amplify::rows::{edge, face, level, vertex as vertex_rows};
use crate::amplify::vertex_resolve::river as nearest_river;
use crate::wgsl::WgslModule;

/// Each after those that it needs.
pub(super) const MODULES: [WgslModule; 21] = [
    twin!("rows/vertex", vertex_rows::shared_constants, ["vertex"]),
    twin!("rows/edge", edge::shared_constants, ["rules/edge_kind"]),
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
