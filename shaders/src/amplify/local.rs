//! The ground at a direction without a view: the leaf of a level that contains it, with the same
//! bits as in any view.
//!
//! From the face of the control mesh down, the child that contains the direction is taken. Children
//! leave their parent's outline when its edges' middles move sideways, so the child may belong to
//! one of the three neighbours; never to a face farther off, because a middle stays within the two
//! faces of its edge.
//!
//! Results are kept until there are too many, so a query near earlier ones is quick.

mod water;

use super::base::Base;
use super::carve::{CarveCache, Carved, carve};
use super::ground::FINEST;
use super::lazy::LazyGround;
use super::locate::{depth, sides};
use super::rules::Rules;
use super::show::show;
use super::vertex::Vertex;
use core::ops::Deref;

/// Vertices kept between queries: 200,000, about 60 MB with what joins them.
const MOST_KEPT: usize = 200_000;

/// A leaf of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaf {
    /// Its corners, counter-clockwise from outside.
    pub vertices: [Vertex; 3],
    /// Their ground and water as its level shows them, grains.
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
        if sum > 0.0 {
            // The share of corner a is the area over the edge opposite to it, bc.
            [s[1] / sum, s[2] / sum, s[0] / sum]
        } else {
            [1.0 / 3.0; 3]
        }
    }

    /// Height of the ground at a direction in the leaf, metres.
    pub fn height_m(&self, direction: [i32; 3]) -> f64 {
        let w = self.weights(direction);
        (0..3)
            .map(|i| w[i] * f64::from(self.carved[i].ground))
            .sum::<f64>()
            / 1024.0
    }
}

/// Answers queries about one planet's ground. It is not shared between threads: each takes its own.
/// `B` is a reference to the planet's level 0, or an `Arc` of it.
///
/// ```
/// use pangaea_shaders::amplify::base::Base;
/// use pangaea_shaders::amplify::local::LocalGround;
/// use pangaea_shaders::amplify::rules::Rules;
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let base = Base::new(&control_mesh(6_371_000, 3, 1))?;
/// let at = base.vertices[7].direction;
/// let mut ground = LocalGround::new(&base, &Rules::default());
/// let leaf = ground.leaf(at, 17, None);
/// assert_eq!(leaf.level, 17);
/// assert!(leaf.height_m(at).abs() < 12_000.0);
/// # Ok::<(), pangaea_shaders::amplify::base::BadMesh>(())
/// ```
#[derive(Clone, Debug)]
pub struct LocalGround<B> {
    lazy: LazyGround<B>,
    cache: Box<CarveCache>,
    /// Faces of the last answer, one of every level down to its leaf.
    path: Vec<u32>,
}

impl<B: Deref<Target = Base>> LocalGround<B> {
    /// An engine without results.
    pub fn new(base: B, rules: &Rules) -> Self {
        Self {
            lazy: LazyGround::new(base, rules),
            cache: Box::default(),
            path: Vec::new(),
        }
    }

    /// Everything computed so far.
    pub fn lazy(&self) -> &LazyGround<B> {
        &self.lazy
    }

    /// The planet's level 0.
    pub fn base(&self) -> &Base {
        self.lazy.base()
    }

    /// The leaf of a level, at most [`FINEST`], that contains a direction. `hint` is a face of the
    /// control mesh near it, if the caller knows one. The answer depends on neither the hint nor
    /// earlier queries.
    pub fn leaf(&mut self, direction: [i32; 3], level: u32, hint: Option<u32>) -> Leaf {
        // All at once: what is kept refers to each other. Results are the same bits when made
        // again.
        if self.lazy.len() > MOST_KEPT {
            self.lazy.clear();
            self.path.clear();
        }
        let level = level.min(FINEST) as usize;
        let mut face = self.start(direction, level, hint);
        for above in self.path.len() - 1..level {
            face = self.child(above, face, direction);
            self.path.push(face);
        }
        let vertices = self.lazy.face(level, face).vertices.map(|v| {
            self.lazy.ensure(v);
            *self.lazy.vertex(v)
        });
        let base_face = self.base_face(face, level);
        let scale = self.base().scale;
        let rules = *self.lazy.rules();
        let carved = vertices.map(|v| {
            let own = carve(&mut self.cache, &scale, &rules, &v);
            show(&scale, &rules, &v, own, level as u32)
        });
        Leaf {
            vertices,
            carved,
            level: level as u32,
            base_face,
        }
    }

    /// The face of the control mesh that a face of a level descends from.
    fn base_face(&self, face: u32, level: usize) -> u32 {
        // Past level 0 the parent is the number in the control mesh.
        let parent = |at, level| self.lazy.parent(level, at);
        (0..=level).rev().fold(face, parent)
    }

    /// Where the way down to a direction begins: the finest face of the last answer's path that has
    /// it inside and is no finer than `level`, else the face of level 0. The way from the top
    /// would lead there too: faces of a level do not overlap.
    fn start(&mut self, direction: [i32; 3], level: usize, hint: Option<u32>) -> u32 {
        self.path.truncate(level + 1);
        while let Some(&face) = self.path.last() {
            let corners = self.lazy.face(self.path.len() - 1, face).vertices;
            let inward = sides(direction, corners.map(|v| self.lazy.vertex(v)));
            // Strictly inside: on an edge the way from the top might take the neighbour.
            if inward.iter().all(|&side| side > 0.0) {
                return face;
            }
            self.path.pop();
        }
        let face = self.base().locate(direction, hint);
        let face = self.lazy.base_face(face);
        self.path.push(face);
        face
    }

    /// The face of the next level that contains a direction: a child of `face`, or of a neighbour.
    fn child(&mut self, level: usize, face: u32, direction: [i32; 3]) -> u32 {
        if let Some(child) = self.inside(level, face, direction) {
            return child;
        }
        // On an edge that moved: the direction may have passed to a neighbour.
        let mut best = self.deepest(level, face, direction);
        for edge in self.lazy.face(level, face).edges {
            for neighbour in self.lazy.faces(level, edge) {
                if neighbour != face {
                    let found = self.deepest(level, neighbour, direction);
                    if found.1 > best.1 {
                        best = found;
                    }
                }
            }
        }
        best.0
    }

    /// The child of a face that a direction lies in, if it is one of them. On an edge between two
    /// it is the first.
    fn inside(&mut self, level: usize, face: u32, direction: [i32; 3]) -> Option<u32> {
        let first = self.lazy.quarter(level, face);
        let middle = self.lazy.face(level + 1, first + 3).vertices;
        for v in middle {
            self.lazy.ensure_place(v);
        }
        let inward = sides(direction, middle.map(|v| self.lazy.vertex(v)));
        // The middle child is tried first: it is the most likely one.
        if inward.iter().all(|&side| side > 0.0) {
            return Some(first + 3);
        }
        // The middle's edge k cuts corner k + 1 off; children do not overlap.
        let corner = (0..3).find(|&k| {
            let child = self.lazy.face(level + 1, first + k).vertices;
            let inside = sides(direction, child.map(|v| self.lazy.vertex(v)));
            inward[(k as usize + 2) % 3] <= 0.0 && inside.iter().all(|&side| side >= 0.0)
        });
        corner.map(|k| first + k)
    }

    /// The child of a face in which a direction lies deepest, and how deep; below 0 it lies in
    /// none.
    fn deepest(&mut self, level: usize, face: u32, direction: [i32; 3]) -> (u32, f64) {
        let first = self.lazy.quarter(level, face);
        let mut best = (first, f64::MIN);
        for child in first..first + 4 {
            let corners = self.lazy.face(level + 1, child).vertices;
            for v in corners {
                self.lazy.ensure_place(v);
            }
            let inside = depth(sides(direction, corners.map(|v| self.lazy.vertex(v))));
            if inside > best.1 {
                best = (child, inside);
            }
        }
        best
    }
}
