//! Numbers, geometry, views.

use super::twin;
use crate::amplify::{arith, curve, fixed, geometry, seed, sight, view};
use crate::wgsl::WgslModule;

/// Each after those that it needs.
pub(super) const MODULES: [WgslModule; 9] = [
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
];
