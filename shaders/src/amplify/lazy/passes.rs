//! The passes of vertices and faces, each run once everything that it reads has come far enough.

use super::{LazyEdge, LazyGround, VertexProgress};
use crate::amplify::base::Base;
use crate::amplify::edge_split;
use crate::amplify::face_decide::{self, FaceContext};
use crate::amplify::rules::{EdgeKind, STRAIGHT_LEVEL, ocean};
use crate::amplify::segment::is_lost;
use crate::amplify::topology::{Inner, NONE};
use crate::amplify::vertex::{RiverSegment, Vertex};
use crate::amplify::vertex_resolve::{DrainBeside, Requests, Settled, VertexContext, resolve};
use core::ops::Deref;

/// The surroundings of an edge by their places, [`NONE`] for the absent; the vertices among them
/// have come far enough to be read.
#[derive(Clone, Copy)]
struct AroundEdge {
    opposite: [u32; 2],
    requests: Requests,
    /// Edges of both faces that run along a river or a gully.
    drains: [u32; 4],
}

impl<B: Deref<Target = Base>> LazyGround<B> {
    /// Ensures that a vertex is final.
    pub fn ensure(&mut self, vertex: u32) {
        let (level, edge) = self.origins[vertex as usize];
        if level != u8::MAX {
            self.resolve(usize::from(level), edge);
        }
    }

    /// Ensures that a vertex has its place and ground.
    pub fn ensure_place(&mut self, vertex: u32) {
        let (level, edge) = self.origins[vertex as usize];
        if level != u8::MAX {
            self.split(usize::from(level), edge);
        }
    }

    /// A vertex; `None` for [`NONE`].
    fn vertex_at(&self, vertex: u32) -> Option<&Vertex> {
        self.vertices.get(vertex as usize)
    }

    /// Pass `edge_split` for one edge.
    pub(super) fn split(&mut self, level: usize, edge: u32) {
        if self.edge(level, edge).progress != VertexProgress::Pending {
            return;
        }
        // The topology first: it names the vertex before it is computed.
        self.halve(level, edge);
        let ends = self.edge(level, edge).edge.vertices;
        // Ends and corners were made by coarser levels, so the recursion ends.
        for v in ends {
            self.ensure(v);
        }
        let is_river = self.edge(level, edge).edge.kind == EdgeKind::River;
        let opposite = if is_river || (level as u32) < STRAIGHT_LEVEL {
            self.ensure_opposite(level, edge)
        } else {
            [NONE; 2]
        };
        if is_river {
            self.settle_arriving(level, edge);
        }
        let LazyEdge {
            edge: edge_now,
            mid,
            ..
        } = *self.edge(level, edge);
        let mut new = edge_split::split(
            &self.base.scale,
            &self.rules,
            &edge_now,
            level as u32,
            ends.map(|v| self.vertex(v)),
            opposite.map(|v| self.vertex_at(v)),
        );
        let ends = ends.map(|v| &self.vertices[v as usize]);
        ocean::settle(&mut self.sea, &mut new, ends);
        self.vertices[mid as usize] = new;
        let known = self.edge_mut(level, edge);
        // Faces read the kind that the edge gave, whichever of them settles the vertex first.
        known.split_kind = new.kind;
        known.progress = VertexProgress::Split;
    }

    /// The corners opposite to an edge, final.
    fn ensure_opposite(&mut self, level: usize, edge: u32) -> [u32; 2] {
        let faces = self.faces(level, edge);
        let opposite = faces.map(|f| self.face(level, f).opposite(edge));
        for v in opposite {
            self.ensure(v);
        }
        opposite
    }

    /// Pass `face_decide` for one face.
    pub(super) fn decide(&mut self, level: usize, face: u32) -> [Inner; 3] {
        let known = self.levels[level].faces[face as usize];
        if known.decided || level as u32 >= STRAIGHT_LEVEL {
            return known.inner;
        }
        // A face without drainage decides nothing, and asks for no vertex.
        let kinds = known.face.edges.map(|e| self.settle_kind(level, e));
        let inner = if kinds == [EdgeKind::Terrain; 3] {
            [Inner::Terrain; 3]
        } else {
            self.decide_drained(level, face, kinds)
        };
        let known = &mut self.levels[level].faces[face as usize];
        known.inner = inner;
        known.decided = true;
        inner
    }

    /// The inner edges of a face beside a river or a gully.
    fn decide_drained(&mut self, level: usize, face: u32, kinds: [EdgeKind; 3]) -> [Inner; 3] {
        let made = *self.face(level, face);
        let mut beyond = [NONE; 3];
        for k in 0..3 {
            self.split(level, made.edges[k]);
            self.ensure(made.vertices[k]);
            // Only beside a drained edge does the face beyond take part in the draw.
            if kinds[k] != EdgeKind::Terrain {
                beyond[k] = self.ensure_beyond(level, face, made.edges[k]);
            }
        }
        let edges = made.edges.map(|e| self.edge(level, e));
        let context = FaceContext {
            corners: made.vertices,
            vertices: made.vertices.map(|v| self.vertex(v)),
            edges: edges.map(|e| &e.edge),
            mids: edges.map(|e| self.vertex(e.mid)),
            kinds: edges.map(|e| e.split_kind),
            beyond: beyond.map(|v| self.vertex_at(v)),
        };
        face_decide::decide(&self.base.scale, &self.rules, level as u32, &context)
    }

    /// The corner beyond an edge of a face, final.
    fn ensure_beyond(&mut self, level: usize, face: u32, edge: u32) -> u32 {
        self.faces(level, edge);
        let neighbour = self.edge(level, edge).edge.beyond(face);
        let corner = self.face(level, neighbour).opposite(edge);
        self.ensure(corner);
        corner
    }

    /// Pass `vertex_resolve` for one edge.
    fn resolve(&mut self, level: usize, edge: u32) {
        if self.edge(level, edge).progress == VertexProgress::Resolved {
            return;
        }
        self.split(level, edge);
        let around = self.ensure_around(level, edge);
        let mid = self.edge(level, edge).mid;
        let settled = self.settled(level, edge, &around);
        settled.write(&mut self.vertices[mid as usize]);
        self.edge_mut(level, edge).progress = VertexProgress::Resolved;
    }

    /// Brings everything around an edge as far as `vertex_resolve` reads it.
    fn ensure_around(&mut self, level: usize, edge: u32) -> AroundEdge {
        let mut around = AroundEdge {
            opposite: [NONE; 2],
            requests: Requests::default(),
            drains: [NONE; 4],
        };
        let is_straight = level as u32 >= STRAIGHT_LEVEL;
        // Far from all drainage a vertex follows from its parents alone.
        if is_straight && self.is_dry_edge(level, edge) {
            return around;
        }
        for (side, f) in self.faces(level, edge).into_iter().enumerate() {
            let inner = self.decide(level, f);
            let face = *self.face(level, f);
            let k = face.edges.iter().position(|&e| e == edge).unwrap_or(0);
            around.requests = around.requests.and(Requests::of(&inner, k));
            for j in 0..2 {
                let other = face.edges[(k + 1 + j) % 3];
                if self.ensure_drain(level, other) {
                    around.drains[side * 2 + j] = other;
                }
            }
            if !is_straight {
                around.opposite[side] = face.opposite(edge);
                self.ensure(around.opposite[side]);
            }
        }
        around
    }

    /// Brings an edge as far as `vertex_resolve` reads it, if it runs along a river or a gully;
    /// returns whether it does.
    fn ensure_drain(&mut self, level: usize, edge: u32) -> bool {
        let kind = self.settle_kind(level, edge);
        if kind == EdgeKind::Terrain {
            return false;
        }
        if kind == EdgeKind::River {
            self.settle_arriving(level, edge);
        }
        for v in self.edge(level, edge).edge.vertices {
            self.ensure(v);
        }
        if (level as u32) < STRAIGHT_LEVEL {
            // While edges still move, the vertex is measured against the halves.
            self.split(level, edge);
        }
        true
    }

    /// Runs `vertex_resolve` on surroundings that have come far enough.
    fn settled(&self, level: usize, edge: u32, around: &AroundEdge) -> Settled {
        let LazyEdge { edge, mid, .. } = self.edge(level, edge);
        let context = VertexContext {
            edge,
            ends: edge.vertices.map(|v| self.vertex(v)),
            opposite: around.opposite.map(|v| self.vertex_at(v)),
            requests: around.requests,
            beside: around.drains.map(|e| self.drain_beside(level, e)),
        };
        let new = self.vertex(*mid);
        resolve(&self.base.scale, &self.rules, level as u32, new, &context)
    }

    fn drain_beside(&self, level: usize, edge: u32) -> Option<DrainBeside<'_>> {
        let LazyEdge { edge, mid, .. } = self.levels[level].edges.get(edge as usize)?;
        let is_straight = level as u32 >= STRAIGHT_LEVEL;
        Some(DrainBeside {
            edge,
            ends: edge.vertices.map(|v| self.vertex(v)),
            // In straight levels the whole edge serves, whether another query made its middle or
            // not.
            mid: self.vertex_at(*mid).filter(|_| !is_straight),
        })
    }

    /// The piece of river along an edge of a level; `None` where none runs.
    pub fn river_of(&mut self, level: usize, edge: u32) -> Option<RiverSegment> {
        if self.settle_kind(level, edge) != EdgeKind::River {
            return None;
        }
        self.settle_arriving(level, edge);
        let edge = self.edge(level, edge).edge;
        for v in edge.vertices {
            self.ensure(v);
        }
        let ends = edge.vertices.map(|v| self.vertex(v));
        let (scale, at) = (&self.base.scale, level as u32);
        let own = || RiverSegment::between(edge.birth, at, ends, edge.arriving);
        let kept = RiverSegment::kept(scale, &self.rules, &edge, at, ends);
        // No river runs above a spring.
        kept.or_else(|| (ends[0].is_wet() && !is_lost(ends)).then(own))
    }
}
