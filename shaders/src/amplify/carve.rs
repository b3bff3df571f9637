//! Pass: every vertex gets its final ground and water from its river's valley (paper 002 §6).
//!
//! Reads and writes one vertex; see [`rules::valley`](super::rules::valley) for the profile.

use super::rules::Rules;
pub use super::rules::valley::{CarveCache, Carved, NO_WATER};
use super::rules::{lake, valley};
use super::scale::PlanetScale;
use super::vertex::Vertex;

/// Final ground and water of a vertex. `cache` holds noise of an earlier vertex, best one near it;
/// it changes no bit.
#[inline]
pub fn carve(
    cache: &mut CarveCache,
    scale: &PlanetScale,
    rules: &Rules,
    vertex: &Vertex,
) -> Carved {
    lake::held(vertex, valley::carve(cache, scale, rules, vertex))
}

/// Final ground and water of a column of vertices.
pub fn carve_all<'a>(
    scale: &PlanetScale,
    rules: &Rules,
    vertices: impl IntoIterator<Item = &'a Vertex>,
) -> Vec<Carved> {
    let mut cache = CarveCache::default();
    let carved = vertices
        .into_iter()
        .map(|vertex| carve(&mut cache, scale, rules, vertex));
    carved.collect()
}

/// Heights of the water's surface over the corners of a triangle, grains; `None` where none of them
/// is wet.
///
/// Over dry corners the surface goes on at a level of the wet ones, and under the ground: water
/// never climbs its banks, and no other river or lake beyond them tilts it.
pub fn sheet(corners: [Carved; 3]) -> Option<[i32; 3]> {
    let wet = || corners.iter().filter(|c| c.is_wet()).map(|c| c.water);
    let (low, high) = (wet().min()?, wet().max()?);
    Some(corners.map(|corner| {
        if corner.is_wet() {
            corner.water
        } else {
            corner.water.clamp(low, high).min(corner.ground)
        }
    }))
}

#[cfg(test)]
#[path = "carve_tests.rs"]
mod tests;
