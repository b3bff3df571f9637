//! The row of a vertex that the passes of the topology read.

use super::row;
use crate::amplify::vertex::Vertex;

/// Where a vertex is, how high, its seed and its water.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct VertexCore {
    /// Unit direction, as [`Vertex::direction`].
    pub direction: [i32; 3],
    /// Ground above sea level before carving, grains.
    pub height: i32,
    /// Seed of its random numbers.
    pub seed: u32,
    /// River bed or lake floor, grains.
    pub bed: i32,
    /// Water surface, grains.
    pub water: i32,
    /// Discharge, as [`Vertex::discharge`].
    pub discharge: u32,
}

row!(VertexCore {
    direction,
    height,
    seed,
    bed,
    water,
    discharge,
});

impl From<&Vertex> for VertexCore {
    fn from(vertex: &Vertex) -> Self {
        Self {
            direction: vertex.direction,
            height: vertex.height,
            seed: vertex.seed,
            bed: vertex.bed,
            water: vertex.water,
            discharge: vertex.discharge,
        }
    }
}
