//! The passes on demand: any one vertex of any level, from no more than it depends on.
//!
//! What joins what is made without a vertex being computed (`joins`); a vertex, a face's decision
//! (`stages`), an edge's kind (`kinds`) are computed by the passes' own functions when first asked
//! for, and kept. So the bits are those of a whole refinement, and away from rivers a level costs
//! half a dozen vertices.

mod joins;
mod kinds;
mod stages;

use super::base::Base;
use super::control::VertexKind;
use super::ground::FINEST;
use super::rules::Rules;
use super::sparse::Places;
use super::topology::{Edge, Face, NONE};
use super::vertex::Vertex;
use core::ops::Deref;

/// How far a vertex has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum VertexProgress {
    Pending,
    Split,
    Resolved,
}

/// An edge, and what is known of it.
#[derive(Clone, Copy, Debug)]
struct LazyEdge {
    edge: Edge,
    /// The edge that it halves (slots 0, 1), the face whose corner 0..3 it cuts off (slots 2..5),
    /// or the edge of the control mesh.
    parent: u32,
    slot: u8,
    has_kind: bool,
    /// Whether it runs against the edge that it halves.
    reversed: bool,
    has_arriving: bool,
    /// From the straight levels on: whether no river or gully runs beside it.
    dry: Option<bool>,
    stage: VertexProgress,
    /// Kind of its vertex before the faces settled it.
    split_kind: VertexKind,
}

impl LazyEdge {
    #[inline]
    const fn new(edge: Edge, parent: u32, slot: u8) -> Self {
        Self {
            edge,
            parent,
            slot,
            has_kind: false,
            reversed: false,
            has_arriving: false,
            dry: None,
            stage: VertexProgress::Pending,
            split_kind: VertexKind::Terrain,
        }
    }
}

/// A face, and what is known of it.
#[derive(Clone, Copy, Debug)]
struct LazyFace {
    face: Face,
    decided: bool,
    dry: Option<bool>,
}

#[derive(Clone, Debug, Default)]
struct LazyLevel {
    edges: Vec<LazyEdge>,
    faces: Vec<LazyFace>,
}

/// Everything computed so far.
#[derive(Clone, Debug)]
pub struct LazyGround<B> {
    base: B,
    rules: Rules,
    vertices: Vec<Vertex>,
    /// Level and edge that each vertex halves; level 255 for a vertex of the control mesh.
    origins: Vec<(u8, u32)>,
    layers: Vec<LazyLevel>,
    /// Where vertices, edges and faces of the control mesh are: of half a million items, some
    /// hundred.
    placed: [Places; 3],
}

impl<B: Deref<Target = Base>> LazyGround<B> {
    /// Nothing computed yet.
    pub fn new(base: B, rules: &Rules) -> Self {
        Self {
            base,
            rules: *rules,
            vertices: Vec::new(),
            origins: Vec::new(),
            layers: vec![LazyLevel::default(); FINEST as usize + 1],
            placed: Default::default(),
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

    /// How many vertices are named only, have their place, are settled.
    pub fn counts(&self) -> [usize; 3] {
        let mut counts = [0; 3];
        for known in self
            .layers
            .iter()
            .flat_map(|l| &l.edges)
            .filter(|k| k.edge.mid != NONE)
        {
            counts[known.stage as usize] += 1;
        }
        counts
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        for places in &mut self.placed {
            places.clear();
        }
        self.vertices.clear();
        self.origins.clear();
        for layer in &mut self.layers {
            layer.edges.clear();
            layer.faces.clear();
        }
    }

    /// A face's record.
    #[inline]
    pub fn face(&self, level: usize, face: u32) -> &Face {
        &self.layers[level].faces[face as usize].face
    }

    #[inline]
    fn edge(&self, level: usize, edge: u32) -> &LazyEdge {
        &self.layers[level].edges[edge as usize]
    }

    #[inline]
    fn edge_mut(&mut self, level: usize, edge: u32) -> &mut LazyEdge {
        &mut self.layers[level].edges[edge as usize]
    }

    /// A vertex that has been asked for.
    #[inline]
    pub fn vertex(&self, vertex: u32) -> &Vertex {
        &self.vertices[vertex as usize]
    }
}
