//! The twins in WGSL of this folder's modules.
//!
//! A function has its Rust twin's name; a method has its type's name before it, in snake case; a
//! function whose name another module has, too, or WGSL reserves, has its module's before it. A
//! type has its name and fields, with `i32` and `u32` for smaller integers. Caches, which save
//! work on the CPU, have no twin.
//!
//! Every name is global in WGSL; it may hide a built-in function, as `mix` and `length` do.

use super::rules::noise;
use super::rules::ocean::phasor;
use super::{arith, curve, fixed, geometry, seed, sight, view};
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
pub const MODULES: [WgslModule; 11] = [
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
];
