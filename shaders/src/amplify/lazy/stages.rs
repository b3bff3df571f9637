//! The passes of vertices and faces, each run once what it reads has come far enough.

use super::{LazyGround, VertexProgress};
use crate::amplify::base::Base;
use crate::amplify::edge_split::{self, STRAIGHT_LEVEL};
use crate::amplify::face_decide::{self, FaceContext};
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Face, Inner, NONE};
use crate::amplify::vertex_resolve::{Beside, VertexContext, asks, resolve};
use core::ops::Deref;

impl<B: Deref<Target = Base>> LazyGround<B> {
    /// Ensures that a vertex is settled.
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

    /// Pass `edge_split` for one edge.
    pub(super) fn split(&mut self, level: usize, edge: u32) {
        if self.edge(level, edge).stage != VertexProgress::Pending {
            return;
        }
        self.halve(level, edge);
        let [a, b] = self.edge(level, edge).edge.vertices;
        self.ensure(a);
        self.ensure(b);
        let mut far = [NONE; 2];
        if (level as u32) < STRAIGHT_LEVEL {
            far = self
                .faces(level, edge)
                .map(|f| self.face(level, f).opposite(edge));
            for v in far {
                self.ensure(v);
            }
        }
        if self.edge(level, edge).edge.kind == EdgeKind::River {
            self.settle_arriving(level, edge);
        }
        let known = self.edge(level, edge);
        let far = far.map(|v| self.vertices.get(v as usize));
        let ends = [a, b].map(|v| &self.vertices[v as usize]);
        let scale = &self.base.scale;
        let new = edge_split::split(scale, &self.rules, &known.edge, level as u32, ends, far);
        let mid = known.edge.mid;
        self.vertices[mid as usize] = new;
        let known = self.edge_mut(level, edge);
        (known.split_kind, known.stage) = (new.kind, VertexProgress::Split);
    }

    /// Pass `face_decide` for one face.
    pub(super) fn decide(&mut self, level: usize, face: u32) -> [Inner; 3] {
        let known = self.layers[level].faces[face as usize];
        if known.decided || level as u32 >= STRAIGHT_LEVEL {
            return known.face.inner;
        }
        let Face {
            vertices, edges, ..
        } = known.face;
        let kinds = edges.map(|e| self.settle_kind(level, e));
        let mut inner = [Inner::Terrain; 3];
        if kinds != [EdgeKind::Terrain; 3] {
            let mut beyond = [NONE; 3];
            for k in 0..3 {
                self.split(level, edges[k]);
                self.ensure(vertices[k]);
                if kinds[k] != EdgeKind::Terrain {
                    let [f, g] = self.faces(level, edges[k]);
                    beyond[k] = self
                        .face(level, if f == face { g } else { f })
                        .opposite(edges[k]);
                    self.ensure(beyond[k]);
                }
            }
            let sight = FaceContext {
                corners: vertices,
                vertices: vertices.map(|v| &self.vertices[v as usize]),
                edges: edges.map(|e| &self.edge(level, e).edge),
                mids: edges.map(|e| &self.vertices[self.edge(level, e).edge.mid as usize]),
                kinds: edges.map(|e| self.edge(level, e).split_kind),
                beyond: beyond.map(|v| self.vertices.get(v as usize)),
            };
            inner = face_decide::decide(&self.rules, level as u32, &sight);
        }
        let known = &mut self.layers[level].faces[face as usize];
        (known.face.inner, known.decided) = (inner, true);
        inner
    }

    /// Pass `vertex_resolve` for one edge.
    fn resolve(&mut self, level: usize, edge: u32) {
        if self.edge(level, edge).stage == VertexProgress::Resolved {
            return;
        }
        self.split(level, edge);
        let straight = level as u32 >= STRAIGHT_LEVEL;
        let (mut opposite, mut others) = ([NONE; 2], [NONE; 4]);
        let mut asked = (false, false, false);
        if !straight || !self.is_dry_edge(level, edge) {
            for (side, f) in self.faces(level, edge).into_iter().enumerate() {
                let inner = self.decide(level, f);
                let face = *self.face(level, f);
                opposite[side] = face.opposite(edge);
                let k = face.edges.iter().position(|&e| e == edge).unwrap_or(0);
                let (gully, river, junction) = asks(&inner, k);
                asked = (asked.0 | gully, asked.1 | river, asked.2 | junction);
                for j in 0..2 {
                    let other = face.edges[(k + 1 + j) % 3];
                    let kind = self.settle_kind(level, other);
                    if kind == EdgeKind::River {
                        self.settle_arriving(level, other);
                    }
                    if kind != EdgeKind::Terrain {
                        others[side * 2 + j] = other;
                        let ends = self.edge(level, other).edge.vertices;
                        for v in ends {
                            self.ensure(v);
                        }
                        if !straight {
                            self.split(level, other);
                        }
                    }
                }
                if !straight {
                    self.ensure(opposite[side]);
                }
            }
        }
        let known = self.edge(level, edge);
        let at = |v: u32| self.vertices.get(v as usize);
        let beside = others.map(|e| -> Option<Beside> {
            let other = &self.layers[level].edges.get(e as usize)?.edge;
            let mid = if straight { None } else { at(other.mid) };
            Some((
                other,
                other.vertices.map(|v| &self.vertices[v as usize]),
                mid,
            ))
        });
        let around = VertexContext {
            edge: &known.edge,
            ends: known.edge.vertices.map(|v| &self.vertices[v as usize]),
            opposite: if straight {
                [None; 2]
            } else {
                opposite.map(at)
            },
            gully_tip: asked.0,
            river_tip: asked.1,
            branched: asked.2,
            beside,
        };
        let mid = known.edge.mid;
        let settled = resolve(
            &self.base.scale,
            &self.rules,
            level as u32,
            &self.vertices[mid as usize],
            &around,
        );
        settled.write(&mut self.vertices[mid as usize]);
        self.edge_mut(level, edge).stage = VertexProgress::Resolved;
    }
}
