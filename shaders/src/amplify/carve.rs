//! Pass: every vertex gets its final ground and water from its river's valley (paper 002 §6).
//!
//! Reads and writes one vertex; see [`rules::valley`](super::rules::valley) for the profile.

use super::planet::Planet;
pub use super::rules::ocean::Kept;
use super::rules::valley;
pub use super::rules::valley::Carved;
use super::vertex::Vertex;

/// Final ground and water of a vertex. `kept` is what an earlier one left, best one near it; it
/// changes no bit.
#[inline]
pub fn carve(kept: &mut Kept, planet: &Planet, vertex: &Vertex) -> Carved {
    valley::carve(kept, vertex, planet.edge_grains(0))
}

/// Final ground and water of a column of vertices.
pub fn carve_all(planet: &Planet, vertices: &[Vertex]) -> Vec<Carved> {
    let mut kept = Kept::default();
    vertices
        .iter()
        .map(|vertex| carve(&mut kept, planet, vertex))
        .collect()
}
