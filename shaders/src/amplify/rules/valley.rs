//! Transverse valleys and river beds, carved once the subdivision is done (paper 002 §6, Fig. 17).

use super::super::vertex::Vertex;
use super::preset::Rules;

/// Ground and water after carving.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Carved {
    /// Ground, grains.
    pub ground: i32,
    /// Water surface, grains; at most `ground` where it is dry.
    pub water: i32,
}

/// The ground of a vertex after its river has carved it.
pub fn carve(_rules: &Rules, vertex: &Vertex, _radius_m: u32) -> Carved {
    Carved { ground: vertex.height, water: vertex.water }
}
