//! Pass: every vertex gets its final ground and water from its river's valley (paper 002 §6).
//!
//! Reads and writes one vertex; see [`rules::valley`](super::rules::valley) for the profile.

use super::planet::Planet;
pub use super::rules::valley::Carved;
use super::rules::{Rules, valley};
use super::vertex::Vertex;

/// Final ground and water of a vertex.
#[inline]
pub fn carve(planet: &Planet, rules: &Rules, vertex: &Vertex) -> Carved {
    valley::carve(rules, vertex, planet.edge_grains(0))
}

/// Final ground and water of a column of vertices.
pub fn carve_all(planet: &Planet, rules: &Rules, vertices: &[Vertex]) -> Vec<Carved> {
    vertices.iter().map(|vertex| carve(planet, rules, vertex)).collect()
}
