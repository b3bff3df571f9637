//! The passes on demand: any one vertex of any level, from no more than it depends on.
//!
//! What joins what is made without a vertex being computed; a vertex, a face's decision, an edge's kind are computed by
//! the passes' own functions when first asked for, and kept. So the bits are those of a whole refinement, and away
//! from rivers a level costs half a dozen vertices.

use super::base::Base;
use super::control::VertexKind;
use super::edge_split::{self, STRAIGHT_LEVEL};
use super::face_decide::{self, Sight};
use super::face_split::{arriving_at, half_kind};
use super::ground::FINEST;
use super::rules::{EdgeKind, Rules};
use super::sparse::Places;
use super::topology::{Edge, Face, Inner, NONE};
use super::vertex::Vertex;
use super::vertex_resolve::{Beside, Surroundings, asks, resolve, tributary};
use core::ops::Deref;

/// How far a vertex has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Stage {
    Pending,
    Split,
    Resolved,
}

/// An edge, and what is known of it.
#[derive(Clone, Copy, Debug)]
struct Known {
    edge: Edge,
    /// The edge that it halves (slots 0, 1), the face whose corner 0..3 it cuts off (slots 2..5), or the edge of the
    /// control mesh.
    parent: u32,
    slot: u8,
    has_kind: bool,
    /// Whether it runs against the edge that it halves.
    reversed: bool,
    has_arriving: bool,
    /// From the straight levels on: whether no river or gully runs beside it.
    dry: Option<bool>,
    stage: Stage,
    /// Kind of its vertex before the faces settled it.
    split_kind: VertexKind,
}

impl Known {
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
            stage: Stage::Pending,
            split_kind: VertexKind::Terrain,
        }
    }
}

/// A face, and what is known of it.
#[derive(Clone, Copy, Debug)]
struct KnownFace {
    face: Face,
    decided: bool,
    dry: Option<bool>,
}

#[derive(Clone, Debug, Default)]
struct Layer {
    edges: Vec<Known>,
    faces: Vec<KnownFace>,
}

/// Everything computed so far.
#[derive(Clone, Debug)]
pub struct Demand<B> {
    base: B,
    rules: Rules,
    vertices: Vec<Vertex>,
    /// Level and edge that each vertex halves; level 255 for a vertex of the control mesh.
    origins: Vec<(u8, u32)>,
    layers: Vec<Layer>,
    /// Where vertices, edges and faces of the control mesh are: of half a million items, some hundred.
    placed: [Places; 3],
}

impl<B: Deref<Target = Base>> Demand<B> {
    /// Nothing computed yet.
    pub fn new(base: B, rules: &Rules) -> Self {
        Self {
            base,
            rules: *rules,
            vertices: Vec::new(),
            origins: Vec::new(),
            layers: vec![Layer::default(); FINEST as usize + 1],
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
        for known in self.layers.iter().flat_map(|l| &l.edges).filter(|k| k.edge.mid != NONE) {
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

    /// A face of the control mesh as a face of level 0.
    pub fn base_face(&mut self, face: u32) -> u32 {
        if let Some(&place) = self.placed[2].get(&face) {
            return place;
        }
        let Face { vertices, edges, .. } = self.base.level.faces[face as usize];
        let vertices = vertices.map(|v| self.base_vertex(v));
        let edges = edges.map(|e| self.base_edge(e));
        let faces = &mut self.layers[0].faces;
        faces.push(KnownFace { face: Face::new(vertices, edges, face), decided: false, dry: None });
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
        let made = Known::new(Edge { vertices, faces: [NONE; 2], ..from }, edge, 0);
        let edges = &mut self.layers[0].edges;
        edges.push(Known { has_kind: true, has_arriving: true, ..made });
        let place = edges.len() as u32 - 1;
        self.placed[1].insert(edge, place);
        place
    }

    /// A face's record.
    #[inline]
    pub fn face(&self, level: usize, face: u32) -> &Face {
        &self.layers[level].faces[face as usize].face
    }

    #[inline]
    fn edge(&self, level: usize, edge: u32) -> &Known {
        &self.layers[level].edges[edge as usize]
    }

    #[inline]
    fn edge_mut(&mut self, level: usize, edge: u32) -> &mut Known {
        &mut self.layers[level].edges[edge as usize]
    }

    /// A vertex that has been asked for.
    #[inline]
    pub fn vertex(&self, vertex: u32) -> &Vertex {
        &self.vertices[vertex as usize]
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
                    let parent = self.faces(level - 1, known.parent)[side ^ usize::from(known.reversed)];
                    self.quarter(level - 1, parent);
                }
            }
        }
        self.edge(level, edge).edge.faces
    }

    /// Makes the halves of an edge; their middle may stay pending.
    fn halve(&mut self, level: usize, edge: u32) -> u32 {
        if self.edge(level, edge).edge.child == NONE {
            self.settle_kind(level, edge);
            let mid = self.vertices.len() as u32;
            self.vertices.push(Vertex::default());
            self.origins.push((level as u8, edge));
            let [a, b] = self.edge(level, edge).edge.vertices;
            let halves = &mut self.layers[level + 1].edges;
            let child = halves.len() as u32;
            for (slot, ends) in [(0, [a, mid]), (1, [mid, b])] {
                halves.push(Known::new(Edge::new(EdgeKind::Terrain, ends, [NONE; 2]), edge, slot));
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
            let edge = Edge::new(EdgeKind::Terrain, [mids[k], mids[other]], [child + k as u32, child + 3]);
            layer.edges.push(Known::new(edge, face, 2 + k as u8));
            let edges = [halves[k][0], inner + k as u32, halves[other][1]];
            let corner = Face::new([made.vertices[k], mids[k], mids[other]], edges, face);
            layer.faces.push(KnownFace { face: corner, decided: false, dry: None });
        }
        let middle = Face::new(mids, [inner + 1, inner + 2, inner], face);
        layer.faces.push(KnownFace { face: middle, decided: false, dry: None });
        self.layers[level].faces[face as usize].face.child = child;
        child
    }

    /// Settles what an edge is, and with it its direction.
    fn settle_kind(&mut self, level: usize, edge: u32) -> EdgeKind {
        let known = *self.edge(level, edge);
        if known.has_kind {
            return known.edge.kind;
        }
        let (kind, birth, reversed);
        if known.slot < 2 {
            let parent = self.edge(level - 1, known.parent).edge;
            let [up, down] = parent.vertices;
            let above = level as u32 - 1;
            // Only here does the kind of a half depend on vertices.
            if parent.kind == EdgeKind::River
                || (parent.kind == EdgeKind::Terrain && above < self.rules.gully_levels)
            {
                for v in [up, parent.mid, down] {
                    self.ensure(v);
                }
            }
            let along = [up, parent.mid, down].map(|v| self.vertex(v));
            (kind, reversed) = half_kind(&self.rules, above, parent.kind, usize::from(known.slot), along);
            birth = parent.birth;
        } else {
            let inner = self.decide(level - 1, known.parent)[known.slot as usize - 2];
            (kind, reversed) = match inner {
                Inner::Terrain => (EdgeKind::Terrain, false),
                Inner::RiverToFirst => (EdgeKind::River, true),
                Inner::RiverToSecond => (EdgeKind::River, false),
                Inner::GullyToFirst => (EdgeKind::Gully, true),
                Inner::GullyToSecond => (EdgeKind::Gully, false),
            };
            birth = level as u8;
        }
        let birth = if kind == EdgeKind::River { birth } else { 0 };
        let known = self.edge_mut(level, edge);
        (known.edge.kind, known.edge.birth, known.has_kind, known.reversed) = (kind, birth, true, reversed);
        if reversed {
            known.edge.vertices.swap(0, 1);
            known.edge.faces.swap(0, 1);
        }
        kind
    }

    /// Settles the discharge that arrives along a river edge.
    fn settle_arriving(&mut self, level: usize, edge: u32) {
        let known = *self.edge(level, edge);
        if known.has_arriving {
            return;
        }
        let arriving = match known.slot {
            0 => {
                let parent = self.edge(level - 1, known.parent).edge;
                self.ensure(parent.mid);
                arriving_at(self.vertex(parent.mid), self.vertex(parent.vertices[0]))
            }
            1 => {
                self.settle_arriving(level - 1, known.parent);
                self.edge(level - 1, known.parent).edge.arriving
            }
            _ => {
                // A tributary: its second vertex is the junction, on an edge of the face.
                let (at, river) = self.origins[known.edge.vertices[1] as usize];
                self.split(usize::from(at), river);
                let river = self.edge(usize::from(at), river).edge;
                tributary(self.vertex(river.mid), self.vertex(river.vertices[0]))
            }
        };
        let known = self.edge_mut(level, edge);
        (known.edge.arriving, known.has_arriving) = (arriving, true);
    }

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
    fn split(&mut self, level: usize, edge: u32) {
        if self.edge(level, edge).stage != Stage::Pending {
            return;
        }
        self.halve(level, edge);
        let [a, b] = self.edge(level, edge).edge.vertices;
        self.ensure(a);
        self.ensure(b);
        let mut far = [NONE; 2];
        if (level as u32) < STRAIGHT_LEVEL {
            far = self.faces(level, edge).map(|f| self.face(level, f).opposite(edge));
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
        let planet = &self.base.planet;
        let new = edge_split::split(planet, &self.rules, &known.edge, level as u32, ends, far);
        let mid = known.edge.mid;
        self.vertices[mid as usize] = new;
        let known = self.edge_mut(level, edge);
        (known.split_kind, known.stage) = (new.kind, Stage::Split);
    }

    /// Pass `face_decide` for one face.
    fn decide(&mut self, level: usize, face: u32) -> [Inner; 3] {
        let known = self.layers[level].faces[face as usize];
        if known.decided || level as u32 >= STRAIGHT_LEVEL {
            return known.face.inner;
        }
        let Face { vertices, edges, .. } = known.face;
        let kinds = edges.map(|e| self.settle_kind(level, e));
        let mut inner = [Inner::Terrain; 3];
        if kinds != [EdgeKind::Terrain; 3] {
            let mut beyond = [NONE; 3];
            for k in 0..3 {
                self.split(level, edges[k]);
                self.ensure(vertices[k]);
                if kinds[k] != EdgeKind::Terrain {
                    let [f, g] = self.faces(level, edges[k]);
                    beyond[k] = self.face(level, if f == face { g } else { f }).opposite(edges[k]);
                    self.ensure(beyond[k]);
                }
            }
            let sight = Sight {
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
        if self.edge(level, edge).stage == Stage::Resolved {
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
                    if self.settle_kind(level, other) != EdgeKind::Terrain {
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
            Some((other, other.vertices.map(|v| &self.vertices[v as usize]), mid))
        });
        let around = Surroundings {
            edge: &known.edge,
            ends: known.edge.vertices.map(|v| &self.vertices[v as usize]),
            opposite: if straight { [None; 2] } else { opposite.map(at) },
            gully_tip: asked.0,
            river_tip: asked.1,
            branched: asked.2,
            beside,
        };
        let mid = known.edge.mid;
        let settled = resolve(&self.base.planet, level as u32, &self.vertices[mid as usize], &around);
        settled.write(&mut self.vertices[mid as usize]);
        self.edge_mut(level, edge).stage = Stage::Resolved;
    }

    /// Whether no river or gully runs beside an edge of a straight level, nor ever will.
    fn is_dry_edge(&mut self, level: usize, edge: u32) -> bool {
        let known = *self.edge(level, edge);
        if let Some(dry) = known.dry {
            return dry;
        }
        let dry = if level as u32 == STRAIGHT_LEVEL {
            let [f, g] = self.faces(level, edge);
            self.is_dry_face(level, f) && self.is_dry_face(level, g)
        } else if known.slot < 2 {
            self.is_dry_edge(level - 1, known.parent)
        } else {
            self.is_dry_face(level - 1, known.parent)
        };
        self.edge_mut(level, edge).dry = Some(dry);
        dry
    }

    /// Whether none of a face's edges is a river or gully; in the straight levels that holds for its children too.
    fn is_dry_face(&mut self, level: usize, face: u32) -> bool {
        let known = self.layers[level].faces[face as usize];
        if let Some(dry) = known.dry {
            return dry;
        }
        let dry = if level as u32 == STRAIGHT_LEVEL {
            known.face.edges.into_iter().all(|e| self.settle_kind(level, e) == EdgeKind::Terrain)
        } else {
            self.is_dry_face(level - 1, known.face.parent)
        };
        self.layers[level].faces[face as usize].dry = Some(dry);
        dry
    }
}
