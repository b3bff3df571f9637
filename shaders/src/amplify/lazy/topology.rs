//! Edges and faces, made as far as they are asked for: faces of the control mesh, halves of edges,
//! quarters of faces.

use super::{EdgeOrigin, LazyEdge, LazyFace, LazyGround};
use crate::amplify::base::Base;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, Face, NONE};
use crate::amplify::vertex::Vertex;
use core::ops::Deref;

impl<B: Deref<Target = Base>> LazyGround<B> {
    /// A face of the control mesh as a face of level 0.
    pub fn base_face(&mut self, face: u32) -> u32 {
        if let Some(&place) = self.placed.faces.get(&face) {
            return place;
        }
        let Face { vertices, edges } = self.base.level.faces[face as usize];
        let vertices = vertices.map(|v| self.base_vertex(v));
        let edges = edges.map(|e| self.base_edge(e));
        let faces = &mut self.levels[0].faces;
        let place = faces.len() as u32;
        faces.push(LazyFace::new(Face { vertices, edges }, face));
        self.placed.faces.insert(face, place);
        place
    }

    fn base_vertex(&mut self, vertex: u32) -> u32 {
        *self.placed.vertices.entry(vertex).or_insert_with(|| {
            self.vertices.push(self.base.vertices[vertex as usize]);
            self.origins.push((u8::MAX, NONE));
            self.vertices.len() as u32 - 1
        })
    }

    fn base_edge(&mut self, edge: u32) -> u32 {
        if let Some(&place) = self.placed.edges.get(&edge) {
            return place;
        }
        let from = self.base.level.edges[edge as usize];
        let made = Edge {
            vertices: from.vertices.map(|v| self.base_vertex(v)),
            faces: [NONE; 2],
            ..from
        };
        let edges = &mut self.levels[0].edges;
        let place = edges.len() as u32;
        edges.push(LazyEdge {
            has_kind: true,
            has_arriving: true,
            ..LazyEdge::new(made, EdgeOrigin::Base(edge))
        });
        self.placed.edges.insert(edge, place);
        place
    }

    /// Both faces of an edge.
    pub fn faces(&mut self, level: usize, edge: u32) -> [u32; 2] {
        for side in 0..2 {
            let known = *self.edge(level, edge);
            if known.edge.faces[side] != NONE {
                continue;
            }
            match known.origin {
                EdgeOrigin::Base(base) => {
                    let face = self.base.level.edges[base as usize].faces[side];
                    let face = self.base_face(face);
                    self.edge_mut(0, edge).edge.faces[side] = face;
                }
                EdgeOrigin::Half(parent, _) => {
                    // A half lies between children of the faces beside its parent.
                    let parents = self.faces(level - 1, parent);
                    // A half that was turned has its faces on the other sides.
                    self.quarter(level - 1, parents[side ^ usize::from(known.reversed)]);
                }
                // It was made with both of its faces.
                EdgeOrigin::Inner(..) => {}
            }
        }
        self.edge(level, edge).edge.faces
    }

    /// Makes the halves of an edge, and returns the first; their middle may stay pending.
    pub(super) fn halve(&mut self, level: usize, edge: u32) -> u32 {
        let made = self.edge(level, edge).child;
        if made != NONE {
            return made;
        }
        // First, as it may turn the edge around, and its halves run as it does.
        self.settle_kind(level, edge);
        // The vertex is named here, and computed by `split` when it is asked for.
        let mid = self.vertices.len() as u32;
        self.vertices.push(Vertex::default());
        self.origins.push((level as u8, edge));
        let [a, b] = self.edge(level, edge).edge.vertices;
        let halves = &mut self.levels[level + 1].edges;
        let child = halves.len() as u32;
        for (slot, ends) in [(0, [a, mid]), (1, [mid, b])] {
            let half = Edge::new(EdgeKind::Terrain, ends, [NONE; 2]);
            halves.push(LazyEdge::new(half, EdgeOrigin::Half(edge, slot)));
        }
        let known = self.edge_mut(level, edge);
        known.mid = mid;
        known.child = child;
        child
    }

    /// Makes the children of a face; their vertices may stay pending. Returns the first.
    pub fn quarter(&mut self, level: usize, face: u32) -> u32 {
        let LazyFace {
            face: made,
            child: known,
            ..
        } = self.levels[level].faces[face as usize];
        if known != NONE {
            return known;
        }
        let child = self.levels[level + 1].faces.len() as u32;
        let sides = [0, 1, 2].map(|k| self.halve_side(level, &made, k, child));
        let mids = sides.map(|side| side.mid);
        let inner = self.add_inner_edges(level, face, mids, child);
        let corners = [0, 1, 2].map(|k| {
            let other = (k + 2) % 3;
            let vertices = [made.vertices[k], mids[k], mids[other]];
            let edges = [sides[k].from_start, inner + k as u32, sides[other].from_end];
            Face { vertices, edges }
        });
        let middle = Face {
            vertices: mids,
            edges: [inner + 1, inner + 2, inner],
        };
        let children = corners.into_iter().chain([middle]);
        self.levels[level + 1]
            .faces
            .extend(children.map(|child| LazyFace::new(child, face)));
        self.levels[level].faces[face as usize].child = child;
        child
    }

    /// Adds the three inner edges of a face, between its corner children, the first of which is
    /// `child`, and its middle child; returns the first.
    fn add_inner_edges(&mut self, level: usize, face: u32, mids: [u32; 3], child: u32) -> u32 {
        let finer = &mut self.levels[level + 1].edges;
        let first = finer.len() as u32;
        for (k, slot) in (0..3).zip(0..) {
            let ends = [mids[k], mids[(k + 2) % 3]];
            let faces = [child + u32::from(slot), child + 3];
            let edge = Edge::new(EdgeKind::Terrain, ends, faces);
            finer.push(LazyEdge::new(edge, EdgeOrigin::Inner(face, slot)));
        }
        first
    }

    /// Halves the `k`th edge of a face and gives its halves the face's children, the first of which
    /// is `child`.
    fn halve_side(&mut self, level: usize, face: &Face, k: usize, child: u32) -> HalvedSide {
        let first = self.halve(level, face.edges[k]);
        let LazyEdge { edge, mid, .. } = *self.edge(level, face.edges[k]);
        // 1 where the edge runs against the face's winding.
        let against = u32::from(edge.vertices[0] != face.vertices[k]);
        let side = HalvedSide {
            mid,
            from_start: first + against,
            from_end: first + 1 - against,
        };
        for (half, corner) in [(side.from_start, k), (side.from_end, (k + 1) % 3)] {
            let half = self.edge_mut(level + 1, half);
            // The first face has the edge in its winding; a half that was turned exchanges both.
            let slot = against as usize ^ usize::from(half.reversed);
            half.edge.faces[slot] = child + corner as u32;
        }
        side
    }
}

/// An edge of a face, cut in two.
#[derive(Clone, Copy)]
struct HalvedSide {
    mid: u32,
    /// The half at the corner where the face's winding enters the edge.
    from_start: u32,
    /// The half at the next corner.
    from_end: u32,
}
