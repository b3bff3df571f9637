//! The ground at a direction without a view: the leaf of a level that contains it, with the bits that any view gives.
//!
//! Per level only a patch is kept: the faces around a target face. Splitting the target and all faces that touch it
//! (13 or so) makes every child's next patch, exactly: a vertex depends on its edge's two faces, those faces' decisions
//! on all their new vertices, and these on the faces beyond. Children leave their parent's outline, so the child that
//! contains the direction may belong to a neighbour of the target; the patch then moves there, from as far up as
//! needed. From [`STRAIGHT_LEVEL`] on a face far from rivers needs no neighbours at all.
//!
//! The stack of patches stays: a query nearby begins where its way parts from the last one's.

use super::base::Base;
use super::carve::{Carved, carve};
use super::cull::compact;
use super::edge_split::STRAIGHT_LEVEL;
use super::ground::FINEST;
use super::locate::{depth, sides};
use super::mark::halo;
use super::rules::{EdgeKind, Rules};
use super::step::step;
use super::topology::{Face, Level, Mark, NONE};
use super::vertex::Vertex;
use core::ops::Deref;

/// A leaf of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Its corners, counter-clockwise from outside.
    pub vertices: [Vertex; 3],
    /// Their final ground and water, grains.
    pub carved: [Carved; 3],
    /// Its level.
    pub level: u32,
    /// The face of the control mesh it descends from.
    pub base_face: u32,
}

impl Leaf {
    /// Shares of the corners at a direction in the leaf; they sum to 1.
    pub fn weights(&self, direction: [i32; 3]) -> [f64; 3] {
        let [a, b, c] = &self.vertices;
        let s = sides(direction, [a, b, c]).map(|x| x.max(0.0));
        let sum = s[0] + s[1] + s[2];
        if sum > 0.0 { [s[1] / sum, s[2] / sum, s[0] / sum] } else { [1.0 / 3.0; 3] }
    }

    /// Height of the ground at a direction in the leaf, metres.
    pub fn height_m(&self, direction: [i32; 3]) -> f64 {
        let w = self.weights(direction);
        (0..3).map(|i| w[i] * f64::from(self.carved[i].ground)).sum::<f64>() / 1024.0
    }
}

/// Answers queries about one planet's ground; keeps the patches of the last one. `B` is a reference to the planet's
/// level 0, or an `Arc` of it.
#[derive(Clone, Debug)]
pub struct Local<B> {
    base: B,
    rules: Rules,
    vertices: Vec<Vertex>,
    levels: Vec<Level>,
    /// Vertices before the step of each level.
    counts: [usize; FINEST as usize],
    /// The face around which each level was split.
    targets: [u32; FINEST as usize],
    /// Whether a level was split at its target alone.
    alone: [bool; FINEST as usize],
    /// Levels that are split.
    depth: usize,
    /// The face of the control mesh in the middle of level 0.
    centre: u32,
}

impl<B: Deref<Target = Base>> Local<B> {
    /// An engine that has answered nothing yet.
    pub fn new(base: B, rules: &Rules) -> Self {
        Self {
            base,
            rules: *rules,
            vertices: Vec::new(),
            levels: vec![Level::default(); FINEST as usize + 1],
            counts: [0; FINEST as usize],
            targets: [NONE; FINEST as usize],
            alone: [false; FINEST as usize],
            depth: 0,
            centre: NONE,
        }
    }

    /// The planet's level 0.
    pub fn base(&self) -> &Base {
        &self.base
    }

    /// The leaf of a level, at most [`FINEST`], that contains a direction. `hint` is a face of the control mesh near
    /// it, if the caller knows one.
    pub fn leaf(&mut self, direction: [i32; 3], level: u32, hint: Option<u32>) -> Leaf {
        let last = Some(self.centre).filter(|&f| f != NONE);
        let face = self.base.locate(direction, hint.or(last));
        if face != self.centre {
            self.recentre(face);
        }
        let level = level.min(FINEST) as usize;
        let mut at = 0;
        let mut target = self.centre_index();
        // Each turn descends a level or moves a patch to a neighbour; far more turns than that never come.
        for _ in 0..16 * FINEST {
            if at >= level {
                break;
            }
            if self.depth <= at || self.targets[at] != target {
                self.split(at, target);
            }
            let child = self.containing(at + 1, direction, target);
            let parent = self.levels[at + 1].faces[child as usize].parent;
            if parent == target {
                target = child;
                at += 1;
            } else {
                target = self.retarget(at, parent);
            }
        }
        self.result(at, target)
    }

    /// The leaf as its caller sees it.
    fn result(&self, level: usize, face: u32) -> Leaf {
        let vertices = self.levels[level].faces[face as usize].vertices.map(|v| self.vertices[v as usize]);
        let carved = vertices.map(|v| carve(&self.base.planet, &self.rules, &v));
        let mut at = face;
        for above in (1..=level).rev() {
            at = self.levels[above].faces[at as usize].parent;
        }
        let base_face = self.levels[0].faces[at as usize].parent;
        Leaf { vertices, carved, level: level as u32, base_face }
    }

    /// Makes level 0 the patch around a face of the control mesh: two rings of faces.
    fn recentre(&mut self, face: u32) {
        let ring = |faces: &[u32]| {
            let corners = faces.iter().flat_map(|&f| self.base.level.faces[f as usize].vertices);
            let mut ring: Vec<u32> =
                corners.flat_map(|v| self.base.faces_around(v).iter().copied()).collect();
            ring.sort_unstable();
            ring.dedup();
            ring
        };
        let kept = ring(&ring(&[face]));
        (self.vertices, self.levels[0]) = compact(&self.base, &kept);
        (self.centre, self.depth) = (face, 0);
    }

    /// Where the centre lies in level 0.
    fn centre_index(&self) -> u32 {
        let faces = &self.levels[0].faces;
        faces.binary_search_by_key(&self.centre, |f| f.parent).map_or(0, |i| i as u32)
    }

    /// Splits a level around a face: the face and all that touch it, or the face alone where that is enough.
    fn split(&mut self, at: usize, target: u32) {
        if self.depth > at {
            self.vertices.truncate(self.counts[at]);
        }
        let (before, after) = self.levels.split_at_mut(at + 1);
        let (level, next) = (&mut before[at], &mut after[0]);
        let alone = at as u32 >= STRAIGHT_LEVEL && is_dry(level, target);
        mark(level, target, alone, at as u32);
        (self.counts[at], self.targets[at], self.alone[at]) = (self.vertices.len(), target, alone);
        self.depth = at + 1;
        step(&self.base.planet, &self.rules, at as u32, level, next, &mut self.vertices);
    }

    /// The face of a split level that contains a direction, its target's children first.
    fn containing(&self, at: usize, direction: [i32; 3], target: u32) -> u32 {
        let faces = &self.levels[at].faces;
        let own = self.levels[at - 1].faces[target as usize].child;
        let inside = |f: &Face| depth(sides(direction, f.vertices.map(|v| &self.vertices[v as usize])));
        let mut best = (own, f64::MIN);
        let order = (own..own + 4).chain((0..faces.len() as u32).filter(|&i| i < own || i >= own + 4));
        for i in order {
            let depth = inside(&faces[i as usize]);
            if depth >= 0.0 {
                return i;
            }
            if depth > best.1 {
                best = (i, depth);
            }
        }
        best.0
    }

    /// Makes a face the target of its level, moving the patches above where it is not in the middle; returns where the
    /// face is then.
    fn retarget(&mut self, at: usize, face: u32) -> u32 {
        if at == 0 {
            let centre = self.levels[0].faces[face as usize].parent;
            self.recentre(centre);
            return self.centre_index();
        }
        let parent = self.levels[at].faces[face as usize].parent;
        let slot = face - self.levels[at - 1].faces[parent as usize].child;
        let mut above = parent;
        if parent != self.targets[at - 1] {
            above = self.retarget(at - 1, parent);
            self.split(at - 1, above);
        }
        self.levels[at - 1].faces[above as usize].child + slot
    }
}

/// Whether no river or gully runs along the edges of a face and of those beside it, all of which must exist.
fn is_dry(level: &Level, face: u32) -> bool {
    let dry = |f: &Face| f.edges.iter().all(|&e| level.edges[e as usize].kind == EdgeKind::Terrain);
    level.faces[face as usize].edges.iter().all(|&e| {
        let edge = &level.edges[e as usize];
        edge.faces.iter().all(|&f| level.faces.get(f as usize).is_none_or(dry))
    })
}

/// Marks a target, the faces that touch it unless it is alone, and their halo.
fn mark(level: &mut Level, target: u32, alone: bool, at: u32) {
    let corners = level.faces[target as usize].vertices;
    for (i, face) in (0..).zip(&mut level.faces) {
        let touches = i == target || (!alone && face.vertices.iter().any(|v| corners.contains(v)));
        face.mark = if touches { Mark::Split } else { Mark::Leaf };
    }
    if at >= STRAIGHT_LEVEL {
        return;
    }
    for i in 0..level.faces.len() {
        let faces = &level.faces;
        let mark = halo(&faces[i], i as u32, &level.edges, |f| faces[f as usize].mark == Mark::Split);
        level.faces[i].mark = mark;
    }
}
