//! The twins in WGSL of this folder's modules.
//!
//! A function has its Rust twin's name; a method has its type's name before it, in snake case; a
//! function whose name another module has, too, or WGSL reserves, has its module's before it. A
//! type has its name and fields, with `i32` and `u32` for smaller integers. Caches, which save
//! work on the CPU, have no twin.
//!
//! Every name is global in WGSL; it may hide a built-in function, as `mix` and `length` do.

use super::rows::{edge, face, level};
use super::rules::noise;
use super::rules::ocean::phasor;
use super::{arith, columns, curve, fixed, geometry, seed, sight, view};
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
pub const MODULES: [WgslModule; 23] = [
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
    twin!("uniform", String::new, ["sight"]),
    twin!("rows/vertex", String::new, []),
    twin!("rows/edge", edge::shared_constants, []),
    twin!("rows/face", face::shared_constants, ["rows/edge"]),
    twin!("rows/level", level::shared_constants, []),
    twin!(
        "columns",
        columns::shared_constants,
        [
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
        ["sight", "rows/edge", "rows/face", "columns"]
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
        "face_split",
        String::new,
        [
            "integer",
            "fixed",
            "seed",
            "rows/vertex",
            "rows/edge",
            "rows/face",
            "columns"
        ]
    ),
    twin!(
        "emit",
        String::new,
        ["geometry", "rows/edge", "rows/face", "columns", "count"]
    ),
];
