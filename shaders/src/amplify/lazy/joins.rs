//! What joins what, made as far as it is asked for: faces of the control mesh, halves of edges,
//! quarters of faces.

use super::{LazyEdge, LazyFace, LazyGround};
use crate::amplify::base::Base;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, Face, NONE};
use crate::amplify::vertex::Vertex;
use core::ops::Deref;

impl<B: Deref<Target = Base>> LazyGround<B> {
    /// A face of the control mesh as a face of level 0.
    pub fn base_face(&mut self, face: u32) -> u32 {
        if let Some(&place) = self.placed[2].get(&face) {
            return place;
        }
        let Face {
            vertices, edges, ..
        } = self.base.level.faces[face as usize];
        let vertices = vertices.map(|v| self.base_vertex(v));
        let edges = edges.map(|e| self.base_edge(e));
        let faces = &mut self.layers[0].faces;
        faces.push(LazyFace {
            face: Face::new(vertices, edges, face),
            decided: false,
            dry: None,
        });
        let place = faces.len() as u32 - 1;
        self.placed[2].insert(face, place);
        place
    }

    fn base_vertex(&mut self, vertex: u32) -> u32 {
        *self.placed[0].entry(vertex).or_insert_with(|| {
            self.vertices.push(self.base.vertices[vertex as usize]);
            self.origins.push((u8::MAX, NONE));
            self.vertices.len() as u32 - 1
        })
    }

    fn base_edge(&mut self, edge: u32) -> u32 {
        if let Some(&place) = self.placed[1].get(&edge) {
            return place;
        }
        let from = self.base.level.edges[edge as usize];
        let vertices = from.vertices.map(|v| self.base_vertex(v));
        let made = LazyEdge::new(
            Edge {
                vertices,
                faces: [NONE; 2],
                ..from
            },
            edge,
            0,
        );
        let edges = &mut self.layers[0].edges;
        edges.push(LazyEdge {
            has_kind: true,
            has_arriving: true,
            ..made
        });
        let place = edges.len() as u32 - 1;
        self.placed[1].insert(edge, place);
        place
    }

    /// Both faces of an edge.
    pub fn faces(&mut self, level: usize, edge: u32) -> [u32; 2] {
        for side in 0..2 {
            let known = *self.edge(level, edge);
            if known.edge.faces[side] == NONE {
                if level == 0 {
                    let face = self.base.level.edges[known.parent as usize].faces[side];
                    let face = self.base_face(face);
                    self.edge_mut(0, edge).edge.faces[side] = face;
                } else {
                    let parent =
                        self.faces(level - 1, known.parent)[side ^ usize::from(known.reversed)];
                    self.quarter(level - 1, parent);
                }
            }
        }
        self.edge(level, edge).edge.faces
    }

    /// Makes the halves of an edge; their middle may stay pending.
    pub(super) fn halve(&mut self, level: usize, edge: u32) -> u32 {
        if self.edge(level, edge).edge.child == NONE {
            self.settle_kind(level, edge);
            let mid = self.vertices.len() as u32;
            self.vertices.push(Vertex::default());
            self.origins.push((level as u8, edge));
            let [a, b] = self.edge(level, edge).edge.vertices;
            let halves = &mut self.layers[level + 1].edges;
            let child = halves.len() as u32;
            for (slot, ends) in [(0, [a, mid]), (1, [mid, b])] {
                halves.push(LazyEdge::new(
                    Edge::new(EdgeKind::Terrain, ends, [NONE; 2]),
                    edge,
                    slot,
                ));
            }
            let known = self.edge_mut(level, edge);
            (known.edge.mid, known.edge.child) = (mid, child);
        }
        self.edge(level, edge).edge.child
    }

    /// Makes the children of a face; their vertices may stay pending. Returns the first.
    pub fn quarter(&mut self, level: usize, face: u32) -> u32 {
        let made = *self.face(level, face);
        if made.child != NONE {
            return made.child;
        }
        let mut mids = [0; 3];
        // Halves from corner k, and to corner k + 1, along edge k.
        let mut halves = [[0; 2]; 3];
        let child = self.layers[level + 1].faces.len() as u32;
        for k in 0..3 {
            let first = self.halve(level, made.edges[k]);
            let edge = self.edge(level, made.edges[k]).edge;
            let along = usize::from(edge.vertices[0] != made.vertices[k]);
            mids[k] = edge.mid;
            halves[k] = [first + along as u32, first + 1 - along as u32];
            for (half, corner) in halves[k].into_iter().zip([k, (k + 1) % 3]) {
                let half = self.edge_mut(level + 1, half);
                half.edge.faces[along ^ usize::from(half.reversed)] = child + corner as u32;
            }
        }
        let layer = &mut self.layers[level + 1];
        let inner = layer.edges.len() as u32;
        for k in 0..3 {
            let other = (k + 2) % 3;
            let edge = Edge::new(
                EdgeKind::Terrain,
                [mids[k], mids[other]],
                [child + k as u32, child + 3],
            );
            layer.edges.push(LazyEdge::new(edge, face, 2 + k as u8));
            let edges = [halves[k][0], inner + k as u32, halves[other][1]];
            let corner = Face::new([made.vertices[k], mids[k], mids[other]], edges, face);
            layer.faces.push(LazyFace {
                face: corner,
                decided: false,
                dry: None,
            });
        }
        let middle = Face::new(mids, [inner + 1, inner + 2, inner], face);
        layer.faces.push(LazyFace {
            face: middle,
            decided: false,
            dry: None,
        });
        self.layers[level].faces[face as usize].face.child = child;
        child
    }
}
