//! Lazy evaluation of the passes: any one vertex of any level, from no more than it depends on.
//!
//! Edges and faces are made without a vertex being computed (`topology`); a vertex, a face's
//! decision (`passes`) and an edge's kind (`kinds`) are computed by the passes' own functions when
//! first asked for, and kept. So the bits are those of a whole refinement, and away from rivers a
//! level costs half a dozen vertices.

mod kinds;
mod passes;
mod topology;

use super::base::Base;
use super::control::VertexKind;
use super::ground::FINEST;
use super::rules::Rules;
use super::rules::ocean::OceanCache;
use super::sparse::Places;
use super::topology::{Edge, Face, Inner, NONE};
use super::vertex::Vertex;
use core::ops::Deref;

/// How far a vertex has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum VertexProgress {
    /// It is named only.
    Pending,
    /// It has its place and ground.
    Split,
    /// It is final.
    Resolved,
}

/// Origin of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EdgeOrigin {
    /// An edge of the control mesh.
    Base(u32),
    /// First (0) or second (1) half of an edge of the level above.
    Half(u32, u8),
    /// The inner edge of a face of the level above that cuts its corner 0, 1 or 2 off.
    Inner(u32, u8),
}

/// An edge, and everything known of it.
#[derive(Clone, Copy, Debug)]
struct LazyEdge {
    edge: Edge,
    /// The vertex that halves it, or [`NONE`].
    mid: u32,
    /// Its first half, or [`NONE`].
    child: u32,
    origin: EdgeOrigin,
    /// Whether the edge's kind, birth and direction are known.
    has_kind: bool,
    /// Whether it runs against the edge that it halves.
    reversed: bool,
    /// Whether the discharge that arrives along the edge is known.
    has_arriving: bool,
    /// From the straight levels on: whether no river or gully runs beside it.
    dry: Option<bool>,
    progress: VertexProgress,
    /// Kind of its vertex before the faces settled it.
    split_kind: VertexKind,
}

impl LazyEdge {
    #[inline]
    const fn new(edge: Edge, origin: EdgeOrigin) -> Self {
        Self {
            edge,
            mid: NONE,
            child: NONE,
            origin,
            has_kind: false,
            reversed: false,
            has_arriving: false,
            dry: None,
            progress: VertexProgress::Pending,
            split_kind: VertexKind::Terrain,
        }
    }
}

/// A face, and everything known of it.
#[derive(Clone, Copy, Debug)]
struct LazyFace {
    face: Face,
    /// The face of the level above; of level 0, the face of the control mesh.
    parent: u32,
    /// Its first child, or [`NONE`].
    child: u32,
    inner: [Inner; 3],
    /// Whether its inner edges are decided.
    decided: bool,
    /// From the straight levels on: whether none of its edges is a river or gully.
    dry: Option<bool>,
}

impl LazyFace {
    #[inline]
    const fn new(face: Face, parent: u32) -> Self {
        Self {
            face,
            parent,
            child: NONE,
            inner: [Inner::Terrain; 3],
            decided: false,
            dry: None,
        }
    }
}

#[derive(Clone, Debug, Default)]
struct LazyLevel {
    edges: Vec<LazyEdge>,
    faces: Vec<LazyFace>,
}

/// Where vertices, edges and faces of the control mesh are held: of half a million items, some
/// hundred.
#[derive(Clone, Debug, Default)]
struct BasePlaces {
    vertices: Places,
    edges: Places,
    faces: Places,
}

/// The part of a planet's ground that was computed so far.
#[derive(Clone, Debug)]
pub struct LazyGround<B> {
    base: B,
    rules: Rules,
    vertices: Vec<Vertex>,
    /// Level and edge that each vertex halves; level 255 for a vertex of the control mesh.
    origins: Vec<(u8, u32)>,
    levels: Vec<LazyLevel>,
    placed: BasePlaces,
    sea: Box<OceanCache>,
}

impl<B: Deref<Target = Base>> LazyGround<B> {
    /// Nothing computed yet.
    pub fn new(base: B, rules: &Rules) -> Self {
        Self {
            base,
            rules: *rules,
            vertices: Vec::new(),
            origins: Vec::new(),
            levels: vec![LazyLevel::default(); FINEST as usize + 1],
            placed: BasePlaces::default(),
            sea: Box::default(),
        }
    }

    /// The planet's level 0.
    pub fn base(&self) -> &Base {
        &self.base
    }

    /// The rules.
    pub fn rules(&self) -> &Rules {
        &self.rules
    }

    /// Vertices held, computed or not.
    pub fn len(&self) -> usize {
        self.vertices.len()
    }

    /// Whether nothing is held.
    pub fn is_empty(&self) -> bool {
        self.vertices.is_empty()
    }

    /// Numbers of vertices: named only; with their place and ground; final.
    pub fn counts(&self) -> [usize; 3] {
        let mut counts = [0; 3];
        for edge in self.levels.iter().flat_map(|l| &l.edges) {
            if edge.mid != NONE {
                counts[edge.progress as usize] += 1;
            }
        }
        counts
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.placed.vertices.clear();
        self.placed.edges.clear();
        self.placed.faces.clear();
        self.vertices.clear();
        self.origins.clear();
        for level in &mut self.levels {
            level.edges.clear();
            level.faces.clear();
        }
    }

    /// A face of a level, by its place there.
    #[inline]
    pub fn face(&self, level: usize, face: u32) -> &Face {
        &self.levels[level].faces[face as usize].face
    }

    /// The face of the level above that a face is a child of; of level 0, the face of the control
    /// mesh.
    #[inline]
    pub fn parent(&self, level: usize, face: u32) -> u32 {
        self.levels[level].faces[face as usize].parent
    }

    #[inline]
    fn edge(&self, level: usize, edge: u32) -> &LazyEdge {
        &self.levels[level].edges[edge as usize]
    }

    #[inline]
    fn edge_mut(&mut self, level: usize, edge: u32) -> &mut LazyEdge {
        &mut self.levels[level].edges[edge as usize]
    }

    /// A vertex that has been asked for.
    #[inline]
    pub fn vertex(&self, vertex: u32) -> &Vertex {
        &self.vertices[vertex as usize]
    }
}
