//! Levels of detail.
//!
//! Level 0 is the control mesh with edges of about 52 km on an Earth-sized planet (paper 002 §4);
//! every level halves them. Rules go by level, not by length: a planet of any radius has the same
//! levels.

/// The finest level: edges of 0.4 m on an Earth-sized planet.
pub const LEVELS: u8 = 17;

/// Edge of the control mesh in planet radii: 52 km on a planet of 6370 km (paper 002 §4).
const BASE_EDGE_RADII: f64 = 52.0 / 6370.0;

/// Mean length of an edge at a level in m.
pub fn spacing(radius_m: f64, level: u8) -> f64 {
    radius_m * BASE_EDGE_RADII / (1_u64 << level.min(63)) as f64
}

/// The coarsest level whose edges are not longer than `spacing_m`; the finest where no edge is
/// short enough.
///
/// ```
/// use bevy_pangaea::query::{level_for, spacing};
///
/// let earth = 6_370_000.0;
/// assert_eq!(level_for(earth, 100.0), 10);
/// assert!(spacing(earth, 10) < 100.0 && spacing(earth, 9) > 100.0);
/// ```
pub fn level_for(radius_m: f64, spacing_m: f64) -> u8 {
    (0..LEVELS)
        .find(|&level| spacing(radius_m, level) <= spacing_m)
        .unwrap_or(LEVELS)
}

/// The coarsest level of a raster whose level nobody has chosen. Every level shows the same land;
/// coarser ones draw most of it from a mean of many places, finer ones from the place itself.
const COARSEST_RASTER_LEVEL: u8 = 3;

/// The level for a raster whose values are `spacing_m` apart, on a planet of `radius_m`.
pub(super) fn raster_level(radius_m: f64, spacing_m: f64) -> u8 {
    level_for(radius_m, spacing_m).max(COARSEST_RASTER_LEVEL)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_reach_from_the_control_mesh_to_the_ground() {
        let earth = 6_370_000.0;
        assert!((spacing(earth, 0) - 52_000.0).abs() < 1e-6);
        assert!((spacing(earth, LEVELS) - 0.397).abs() < 1e-3);
        assert_eq!(level_for(earth, 92.6), 10);
        assert_eq!(level_for(earth, 1e9), 0);
        for tiny in [0.5, 1e-9, f64::NAN] {
            assert_eq!(level_for(earth, tiny), LEVELS);
        }
        // A planet of a hundredth of the size has the same levels.
        assert_eq!(level_for(63_700.0, 0.926), level_for(earth, 92.6));
    }
}
