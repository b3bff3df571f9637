//! Edges and faces of one level, and their parts in the next.
//!
//! A face (v₀, v₁, v₂) with midpoints m₀ (of v₀v₁), m₁, m₂ becomes the corner faces cₖ = (vₖ, mₖ,
//! mₖ₋₁) and the middle c₃ = (m₀, m₁, m₂). Its inner edge iₖ = (mₖ, mₖ₋₁) cuts the corner k off.

use super::rules::EdgeKind;

/// No vertex, edge or face.
pub const NONE: u32 = u32::MAX;

/// Items of a column by their indices.
#[inline]
pub fn gather<T, const N: usize>(column: &[T], indices: [u32; N]) -> [&T; N] {
    indices.map(|i| &column[i as usize])
}

/// How far an edge or a face takes part in a level's subdivision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum SplitMark {
    /// It takes no part: it is a leaf, or beside leaves only.
    #[default]
    Leaf = 0,
    /// Beside a split face: its midpoints are computed and its inner edges decided, because the
    /// split face's vertices depend on them, but it stays whole.
    Halo = 1,
    /// It is split.
    Split = 2,
}

/// One edge, 32 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Edge {
    /// Its ends.
    pub vertices: [u32; 2],
    /// The faces of its level on both sides, or [`NONE`]; the first has the edge in its winding
    /// direction.
    pub faces: [u32; 2],
    /// The vertex that halves it, or [`NONE`].
    pub mid: u32,
    /// Its first half in the next level, or [`NONE`]; the second follows.
    pub child: u32,
    /// Discharge that arrives at the second vertex of a river edge, as
    /// [`Vertex::discharge`](super::vertex::Vertex::discharge).
    pub arriving: u32,
    /// Kind: ground, river or gully.
    pub kind: EdgeKind,
    /// Level at which its river was born; 0 for a river of the control mesh.
    pub birth: u8,
    /// Whether it is split.
    pub mark: SplitMark,
}

const _: () = assert!(size_of::<Edge>() == 32);

impl Edge {
    /// An edge that is not split yet.
    #[inline]
    pub const fn new(kind: EdgeKind, vertices: [u32; 2], faces: [u32; 2]) -> Self {
        Self {
            vertices,
            faces,
            mid: NONE,
            child: NONE,
            arriving: 0,
            kind,
            birth: 0,
            mark: SplitMark::Leaf,
        }
    }

    /// Turns it around: ends and faces change sides.
    #[inline]
    pub const fn reverse(&mut self) {
        self.vertices.swap(0, 1);
        self.faces.swap(0, 1);
    }
}

/// Drainage that a face lays along one of its inner edges (rules Ia to Ic).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Inner {
    /// Ground.
    #[default]
    Terrain = 0,
    /// A tributary from mₖ₋₁ to mₖ.
    RiverToFirst = 1,
    /// A tributary from mₖ to mₖ₋₁.
    RiverToSecond = 2,
    /// A gully from mₖ₋₁ down to mₖ.
    GullyToFirst = 3,
    /// A gully from mₖ down to mₖ₋₁.
    GullyToSecond = 4,
}

impl Inner {
    /// The kind of the inner edge, and whether it runs from mₖ₋₁ to mₖ.
    pub const fn edge(self) -> (EdgeKind, bool) {
        match self {
            Self::Terrain => (EdgeKind::Terrain, false),
            Self::RiverToFirst => (EdgeKind::River, true),
            Self::RiverToSecond => (EdgeKind::River, false),
            Self::GullyToFirst => (EdgeKind::Gully, true),
            Self::GullyToSecond => (EdgeKind::Gully, false),
        }
    }
}

/// One face, 36 bytes, counter-clockwise from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Face {
    /// Its corners.
    pub vertices: [u32; 3],
    /// Its edges; `edges[i]` joins `vertices[i]` and `vertices[(i + 1) % 3]`.
    pub edges: [u32; 3],
    /// Its first child in the next level, or [`NONE`]: corners 0, 1, 2, then the middle.
    pub child: u32,
    /// The face of the level above; of level 0, the face of the control mesh.
    pub parent: u32,
    /// Drainage along its inner edges.
    pub inner: [Inner; 3],
    /// Whether it is split.
    pub mark: SplitMark,
}

const _: () = assert!(size_of::<Face>() == 36);

impl Face {
    /// A face that is not split yet.
    #[inline]
    pub const fn new(vertices: [u32; 3], edges: [u32; 3], parent: u32) -> Self {
        Self {
            vertices,
            edges,
            child: NONE,
            parent,
            inner: [Inner::Terrain; 3],
            mark: SplitMark::Leaf,
        }
    }

    /// The number of the corner that is a vertex; 3 without one.
    #[inline]
    pub const fn corner(&self, vertex: u32) -> usize {
        let mut k = 0;
        while k < 3 && self.vertices[k] != vertex {
            k += 1;
        }
        k
    }

    /// The corner that an edge of this face does not touch.
    #[inline]
    pub const fn opposite(&self, edge: u32) -> u32 {
        let mut k = 0;
        while k < 2 && self.edges[k] != edge {
            k += 1;
        }
        self.vertices[(k + 2) % 3]
    }
}

/// Edges and faces of one level. A finest level may lack its edges; its faces name them all the
/// same.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Level {
    /// Edges.
    pub edges: Vec<Edge>,
    /// Faces.
    pub faces: Vec<Face>,
}
