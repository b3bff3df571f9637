//! Pass: every vertex gets its final ground and water from its river's valley (paper 002 §6).
//!
//! Reads and writes one vertex; see [`rules::valley`](super::rules::valley) for the profile.

pub use super::rules::ocean::OceanCache;
pub use super::rules::valley::Carved;
use super::rules::{lake, valley};
use super::scale::PlanetScale;
use super::vertex::Vertex;

/// Final ground and water of a vertex. `cache` holds noise of an earlier vertex, best one near it;
/// it changes no bit.
#[inline]
pub fn carve(cache: &mut OceanCache, scale: &PlanetScale, vertex: &Vertex) -> Carved {
    lake::held(vertex, valley::carve(cache, vertex, scale.edge_grains(0)))
}

/// Final ground and water of a column of vertices.
pub fn carve_all(scale: &PlanetScale, vertices: &[Vertex]) -> Vec<Carved> {
    let mut cache = OceanCache::default();
    vertices
        .iter()
        .map(|vertex| carve(&mut cache, scale, vertex))
        .collect()
}
