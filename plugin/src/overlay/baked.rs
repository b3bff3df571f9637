//! Overlays of a bake: climate, discharge, basins and lakes, on the base mesh of the ground.
//!
//! Maps look at the base mesh itself, which may be finer than the crust's samples; on it lie the
//! lines of `rivers`. A colour per sample of the crust shows what lies at the sample.

mod map;
mod shown;

use super::Overlay;
use super::palette::Rgba;
use crate::control::Bake;
use crate::hydrology::ShoreClass;
use crate::parallel;
use crate::sphere::{Location, SphereMesh};
use shown::Shown;

pub(super) use map::draw;
pub(super) use shown::{RAIN_MAX, TEMPERATURE_MAX, TEMPERATURE_MIN};

/// A place of the base mesh.
struct BasePlace {
    at: Location,
    /// Whether the sea covers it. Hollows of the land may lie below its level.
    is_sea: bool,
}

impl BasePlace {
    fn new(bake: &Bake, at: Location) -> Self {
        let drainage = &bake.drainage;
        let ground = at.interpolate(|k| f64::from(drainage.ground[k as usize]));
        let is_sea = ground < 0.0 && drainage.shore[at.nearest as usize] != ShoreClass::Land;
        Self { at, is_sea }
    }
}

/// Colours of the samples of the crust.
pub(super) fn colors(overlay: Overlay, bake: &Bake, lattice: &SphereMesh) -> Vec<Rgba> {
    let base = bake.mesh();
    let shown = Shown::new(overlay, bake);
    parallel::map(lattice.len(), |i| {
        shown.at(&BasePlace::new(bake, base.locate(lattice.point(i))))
    })
}

#[cfg(test)]
pub(crate) mod tests;
