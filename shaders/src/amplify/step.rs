//! One level of the subdivision: the passes in their order.
//!
//! The marks of the level's faces are given; the next level's vertices, edges and faces come out.
//! Vertices of all levels share one column; those that a level makes come after those of the
//! coarser ones, in the order of the edges.

use super::edge_split::{self, STRAIGHT_LEVEL};
use super::face_decide::{self, FaceContext};
use super::face_split;
use super::mark::edge_mark;
use super::rules::{EdgeKind, Rules};
use super::scale::PlanetScale;
use super::scan::scan;
use super::topology::{Edge, Face, Inner, Level, SplitMark, gather};
use super::vertex::Vertex;
use super::vertex_resolve::{DrainBeside, Requests, Settled, VertexContext, resolve};

/// Splits the marked faces of a level; returns the next. `vertices` grows. Without `edges` the next
/// level has faces alone, which a finest level needs no more than; its faces name the edges all the
/// same.
pub fn step(
    scale: &PlanetScale,
    rules: &Rules,
    index: u32,
    level: &mut Level,
    vertices: &mut Vec<Vertex>,
    edges: bool,
) -> Level {
    let passes = LevelPasses {
        scale,
        rules,
        index,
    };
    mark_edges(level);
    let counts = place(level, vertices.len() as u32);
    vertices.reserve(counts.vertices);
    // New vertices, then decisions that read them, then what the decisions settle.
    passes.split_edges(level, vertices);
    passes.decide_faces(level, vertices);
    passes.resolve_vertices(level, vertices);
    let edges = if edges {
        passes.grow_edges(level, vertices, counts.edges())
    } else {
        Vec::new()
    };
    Level {
        edges,
        faces: grow_faces(level, &counts),
    }
}

/// Numbers of items that a level makes.
struct LevelCounts {
    vertices: usize,
    halves: usize,
    faces: usize,
}

impl LevelCounts {
    /// Edges of the next level: halves, and three inner edges for every four faces.
    fn edges(&self) -> usize {
        self.halves + self.faces / 4 * 3
    }
}

fn mark_edges(level: &mut Level) {
    for edge in &mut level.edges {
        edge.mark = edge_mark(edge, &level.faces);
    }
}

/// Gives midpoints, halves and children their places.
fn place(level: &mut Level, first_vertex: u32) -> LevelCounts {
    let Level { edges, faces } = level;
    let has_mid = |e: &Edge| u32::from(e.mark != SplitMark::Leaf);
    let halves_of = |e: &Edge| 2 * u32::from(e.mark == SplitMark::Split);
    let children_of = |f: &Face| 4 * u32::from(f.mark == SplitMark::Split);
    // Vertices of all levels share a column, edges and faces begin anew in each.
    let mids = scan(edges, first_vertex, has_mid, |e, place| e.mid = place);
    let halves = scan(edges, 0, halves_of, |e, place| e.child = place);
    let children = scan(faces, 0, children_of, |f, place| f.child = place);
    LevelCounts {
        vertices: mids as usize,
        halves: halves as usize,
        faces: children as usize,
    }
}

/// The passes of one level of a planet.
struct LevelPasses<'a> {
    scale: &'a PlanetScale,
    rules: &'a Rules,
    /// The level that is split.
    index: u32,
}

impl LevelPasses<'_> {
    fn split_edges(&self, level: &Level, vertices: &mut Vec<Vertex>) {
        for (i, edge) in (0..).zip(&level.edges) {
            if edge.mark != SplitMark::Leaf {
                let new = self.split_edge(level, vertices, i);
                vertices.push(new);
            }
        }
    }

    /// The vertex that halves the `i`th edge.
    fn split_edge(&self, level: &Level, vertices: &[Vertex], i: u32) -> Vertex {
        let edge = &level.edges[i as usize];
        let ends = gather(vertices, edge.vertices);
        // Straight edges do not move sideways and need no corners; rivers keep their course.
        let corners = if self.index < STRAIGHT_LEVEL || edge.kind == EdgeKind::River {
            [0, 1].map(|side| opposite(level, vertices, i, side))
        } else {
            [None; 2]
        };
        edge_split::split(self.scale, self.rules, edge, self.index, ends, corners)
    }

    fn decide_faces(&self, level: &mut Level, vertices: &[Vertex]) {
        if self.index >= STRAIGHT_LEVEL {
            return;
        }
        for f in 0..level.faces.len() {
            if level.faces[f].mark != SplitMark::Leaf {
                level.faces[f].inner = self.decide_face(level, vertices, f as u32);
            }
        }
    }

    /// The inner edges of the `f`th face.
    fn decide_face(&self, level: &Level, vertices: &[Vertex], f: u32) -> [Inner; 3] {
        let face = &level.faces[f as usize];
        let edges = gather(&level.edges, face.edges);
        // Most faces have no drainage: then nothing is to be decided.
        if edges.iter().all(|e| e.kind == EdgeKind::Terrain) {
            return [Inner::Terrain; 3];
        }
        let mids = gather(vertices, edges.map(|e| e.mid));
        let context = FaceContext {
            corners: face.vertices,
            vertices: gather(vertices, face.vertices),
            edges,
            mids,
            kinds: mids.map(|mid| mid.kind),
            beyond: face.edges.map(|e| beyond(level, vertices, e, f)),
        };
        face_decide::decide(self.scale, self.rules, self.index, &context)
    }

    fn resolve_vertices(&self, level: &Level, vertices: &mut [Vertex]) {
        for (i, edge) in (0..).zip(&level.edges) {
            if edge.mark == SplitMark::Split {
                let settled = self.resolve_vertex(level, vertices, i);
                settled.write(&mut vertices[edge.mid as usize]);
            }
        }
    }

    /// Settles the new vertex of the `i`th edge from the faces beside it.
    fn resolve_vertex(&self, level: &Level, vertices: &[Vertex], i: u32) -> Settled {
        let edge = &level.edges[i as usize];
        let new = &vertices[edge.mid as usize];
        let around = around_edge(level, vertices, i);
        resolve(self.scale, self.rules, self.index, new, &around)
    }

    /// The next level's edges: halves, then inner edges.
    fn grow_edges(&self, level: &Level, vertices: &[Vertex], count: usize) -> Vec<Edge> {
        let mut edges = Vec::with_capacity(count);
        for edge in &level.edges {
            if edge.mark == SplitMark::Split {
                let halves =
                    face_split::halve(self.rules, self.index, edge, &level.faces, vertices);
                edges.extend(halves);
            }
        }
        for face in &level.faces {
            if face.mark == SplitMark::Split {
                edges.extend(
                    [0, 1, 2].map(|k| {
                        face_split::inner_edge(face, self.index, k, &level.edges, vertices)
                    }),
                );
            }
        }
        edges
    }
}

/// The surroundings of the vertex that halves the `i`th edge.
fn around_edge<'a>(level: &'a Level, vertices: &'a [Vertex], i: u32) -> VertexContext<'a> {
    let edge = &level.edges[i as usize];
    let mut around = VertexContext {
        edge,
        ends: gather(vertices, edge.vertices),
        opposite: [None; 2],
        requests: Requests::default(),
        beside: [None; 4],
    };
    for side in 0..2 {
        let Some(face) = level.faces.get(edge.faces[side] as usize) else {
            continue;
        };
        around.opposite[side] = Some(&vertices[face.opposite(i) as usize]);
        let k = face.edges.iter().position(|&e| e == i).unwrap_or(0);
        around.requests = around.requests.and(Requests::of(&face.inner, k));
        for j in 0..2 {
            // The face's other two edges, in the order of its winding.
            let other = &level.edges[face.edges[(k + 1 + j) % 3] as usize];
            around.beside[side * 2 + j] = drain_beside(other, vertices);
        }
    }
    around
}

/// The corner of a face of an edge that the edge does not touch.
fn opposite<'a>(
    level: &Level,
    vertices: &'a [Vertex],
    edge: u32,
    side: usize,
) -> Option<&'a Vertex> {
    let face = level.edges[edge as usize].faces[side];
    let face = level.faces.get(face as usize)?;
    Some(&vertices[face.opposite(edge) as usize])
}

/// The corner beyond an edge of a face.
fn beyond<'a>(level: &Level, vertices: &'a [Vertex], edge: u32, face: u32) -> Option<&'a Vertex> {
    // The side of the edge that is not the face's own.
    let side = usize::from(level.edges[edge as usize].faces[0] == face);
    opposite(level, vertices, edge, side)
}

/// An edge that runs along a river or a gully; `None` for another.
fn drain_beside<'a>(edge: &'a Edge, vertices: &'a [Vertex]) -> Option<DrainBeside<'a>> {
    (edge.kind != EdgeKind::Terrain).then(|| DrainBeside {
        edge,
        ends: gather(vertices, edge.vertices),
        mid: vertices.get(edge.mid as usize),
    })
}

/// The next level's faces.
fn grow_faces(level: &Level, counts: &LevelCounts) -> Vec<Face> {
    let mut faces = Vec::with_capacity(counts.faces);
    // Inner edges follow the halves, three a face, as `grow_edges` lays them.
    let mut inner = counts.halves as u32;
    for (f, face) in (0..).zip(&level.faces) {
        if face.mark == SplitMark::Split {
            faces.extend(face_split::quarter(face, f, inner, &level.edges));
            inner += 3;
        }
    }
    faces
}

#[cfg(test)]
#[path = "step_tests.rs"]
mod tests;
