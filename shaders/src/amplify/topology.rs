//! Edges and faces of one level, and their parts in the next.
//!
//! A face (v₀, v₁, v₂) with midpoints m₀ (of v₀v₁), m₁, m₂ becomes the corner faces cₖ = (vₖ, mₖ,
//! mₖ₋₁) and the middle c₃ = (m₀, m₁, m₂). Its inner edge iₖ = (mₖ, mₖ₋₁) cuts the corner k off.

use super::rules::EdgeKind;
use std::sync::Arc;

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

impl SplitMark {
    /// The mark with this number; [`SplitMark::Leaf`] for a number that has none.
    pub const fn from_number(number: u8) -> Self {
        match number {
            1 => Self::Halo,
            2 => Self::Split,
            _ => Self::Leaf,
        }
    }
}

/// One edge as the level above made it, 24 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Edge {
    /// Its ends.
    pub vertices: [u32; 2],
    /// The faces of its level on both sides, or [`NONE`]; the first has the edge in its winding
    /// direction.
    pub faces: [u32; 2],
    /// Discharge that arrives at the second vertex of a river edge, as
    /// [`Vertex::discharge`](super::vertex::Vertex::discharge).
    pub arriving: u32,
    /// Kind: ground, river or gully.
    pub kind: EdgeKind,
    /// Level at which its river was born; 0 for a river of the control mesh.
    pub birth: u8,
    /// Whether dry land drains along it without a gully: nothing on it may stand above its ends.
    /// Settled on levels that have gullies; finer ones hand it on.
    pub is_descent: bool,
}

const _: () = assert!(size_of::<Edge>() == 24);

impl Edge {
    /// An edge without a river's discharge.
    #[inline]
    pub const fn new(kind: EdgeKind, vertices: [u32; 2], faces: [u32; 2]) -> Self {
        Self {
            vertices,
            faces,
            arriving: 0,
            kind,
            birth: 0,
            is_descent: false,
        }
    }

    /// The face on the other side of one of its faces, or [`NONE`].
    #[inline]
    pub const fn beyond(&self, face: u32) -> u32 {
        self.faces[(self.faces[0] == face) as usize]
    }

    /// Turns it around: ends and faces change sides.
    #[inline]
    pub const fn reverse(&mut self) {
        self.vertices.swap(0, 1);
        self.faces.swap(0, 1);
    }
}

/// A run's part in an edge. Zeros are those of an edge that takes no part.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct EdgeSplit {
    /// The vertex that halves it, where it is no leaf.
    pub mid: u32,
    /// Its first half in the next level, where it is split; the second follows.
    pub child: u32,
    /// Whether it is split: the greater of its faces' marks.
    pub mark: SplitMark,
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

/// One face as the level above made it, 24 bytes; counter-clockwise from outside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct Face {
    /// Its corners.
    pub vertices: [u32; 3],
    /// Its edges; `edges[i]` joins `vertices[i]` and `vertices[(i + 1) % 3]`.
    pub edges: [u32; 3],
}

const _: () = assert!(size_of::<Face>() == 24);

impl Face {
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

/// A run's part in a face. Zeros are those of a leaf.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct FaceSplit {
    /// Its first child in the next level, where it is split: corners 0, 1, 2, then the middle.
    pub child: u32,
    /// Drainage along its inner edges.
    pub inner: [Inner; 3],
    /// Whether it is split.
    pub mark: SplitMark,
}

const _: () = assert!(size_of::<FaceSplit>() == 8);

/// Edges and faces of one level as the level above made them: nothing changes them any more. A
/// finest level may lack its edges; its faces name them all the same.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LevelMesh {
    /// Edges.
    pub edges: Vec<Edge>,
    /// Faces.
    pub faces: Vec<Face>,
}

impl LevelMesh {
    /// The corner of a face of an edge that the edge does not touch; `None` beyond the rim.
    #[inline]
    pub fn opposite(&self, edge: u32, side: usize) -> Option<u32> {
        self.corner_off(self.edges[edge as usize].faces[side], edge)
    }

    /// The corner beyond an edge of a face; `None` beyond the rim.
    #[inline]
    pub fn beyond(&self, edge: u32, face: u32) -> Option<u32> {
        self.corner_off(self.edges[edge as usize].beyond(face), edge)
    }

    #[inline]
    fn corner_off(&self, face: u32, edge: u32) -> Option<u32> {
        Some(self.faces.get(face as usize)?.opposite(edge))
    }
}

/// Numbers of the edges and faces of a level that its passes run over, ascending.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Items {
    /// Edges.
    pub edges: Vec<u32>,
    /// Faces.
    pub faces: Vec<u32>,
}

impl Items {
    /// All of a level.
    pub fn all(mesh: &LevelMesh) -> Self {
        let [edges, faces] = [mesh.edges.len(), mesh.faces.len()].map(|n| (0..n as u32).collect());
        Self { edges, faces }
    }
}

/// One level of a run: its mesh, which level 0 shares with all runs of a planet, and the run's part
/// in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Level {
    /// The mesh that the level above made.
    pub mesh: Arc<LevelMesh>,
    /// The edges' and faces' numbers that the passes run over: all, but of the control mesh those
    /// that the view reaches.
    pub items: Items,
    /// The run's part in each edge of the mesh.
    pub edges: Vec<EdgeSplit>,
    /// The run's part in each face of the mesh.
    pub faces: Vec<FaceSplit>,
}

impl Level {
    /// A level whose faces are leaves.
    pub fn new(mesh: Arc<LevelMesh>, items: Items) -> Self {
        Self {
            edges: vec![EdgeSplit::default(); mesh.edges.len()],
            faces: vec![FaceSplit::default(); mesh.faces.len()],
            items,
            mesh,
        }
    }

    /// The edges that the passes run over.
    pub fn edges(&self) -> impl Iterator<Item = (&Edge, &EdgeSplit)> {
        let edges = self.items.edges.iter().map(|&e| e as usize);
        edges.map(|e| (&self.mesh.edges[e], &self.edges[e]))
    }

    /// The faces that the passes run over.
    pub fn faces(&self) -> impl Iterator<Item = (&Face, &FaceSplit)> {
        let faces = self.items.faces.iter().map(|&f| f as usize);
        faces.map(|f| (&self.mesh.faces[f], &self.faces[f]))
    }
}
