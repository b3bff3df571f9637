//! The ground that a rule gives to a new vertex.

use crate::amplify::control::VertexKind;

/// The ground that a rule gives to a new vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexGround {
    /// Kind of the vertex.
    pub kind: VertexKind,
    /// Ground, grains.
    pub height: i32,
    /// River bed or lake floor, grains; equals `height` at dry vertices.
    pub bed: i32,
    /// Water surface, grains; equals `bed` at dry vertices.
    pub water: i32,
}

impl VertexGround {
    /// Dry ground of one kind.
    #[inline]
    pub const fn dry(kind: VertexKind, height: i32) -> Self {
        Self {
            kind,
            height,
            bed: height,
            water: height,
        }
    }
}
