//! One level of the subdivision: the passes in their order.
//!
//! The marks of the level's faces are given; the next level's vertices, edges and faces come out.
//! Vertices of all levels share one column; what a level makes comes after what the coarser ones
//! made, in the order of the edges.

use super::edge_split;
use super::face_decide::{self, FaceContext};
use super::face_split;
use super::mark::edge_mark;
use super::rules::{EdgeKind, Rules};
use super::scale::PlanetScale;
use super::scan::scan;
use super::topology::{Edge, Face, Inner, Level, SplitMark};
use super::vertex::Vertex;
use super::vertex_resolve::{Settled, VertexContext, asks, resolve};

/// Splits the marked faces of a level; returns the next. `vertices` grows. Without `edges` the next
/// level has faces alone, which is all that a finest level needs; what their edges would be called
/// is the same.
pub fn step(
    scale: &PlanetScale,
    rules: &Rules,
    index: u32,
    level: &mut Level,
    vertices: &mut Vec<Vertex>,
    edges: bool,
) -> Level {
    mark_edges(level);
    let made = place(level, vertices.len() as u32);
    vertices.reserve(made.vertices);
    split_edges(scale, rules, index, level, vertices);
    decide_faces(rules, index, level, vertices);
    resolve_vertices(scale, rules, index, level, vertices);
    Level {
        edges: if edges {
            grow_edges(rules, index, level, vertices, made.edges())
        } else {
            Vec::new()
        },
        faces: grow_faces(level, &made),
    }
}

/// How much a level makes.
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
    let mids = scan(
        edges,
        first_vertex,
        |e| u32::from(e.mark != SplitMark::Leaf),
        |e, place| e.mid = place,
    );
    let halves = scan(
        edges,
        0,
        |e| 2 * u32::from(e.mark == SplitMark::Split),
        |e, place| e.child = place,
    );
    let children = scan(
        faces,
        0,
        |f| 4 * u32::from(f.mark == SplitMark::Split),
        |f, place| f.child = place,
    );
    LevelCounts {
        vertices: mids as usize,
        halves: halves as usize,
        faces: children as usize,
    }
}

/// The corner of a face of an edge that the edge does not touch.
fn opposite<'a>(
    level: &Level,
    vertices: &'a [Vertex],
    edge: u32,
    side: usize,
) -> Option<&'a Vertex> {
    let face = level.edges[edge as usize].faces[side];
    level
        .faces
        .get(face as usize)
        .map(|f| &vertices[f.opposite(edge) as usize])
}

fn split_edges(
    scale: &PlanetScale,
    rules: &Rules,
    index: u32,
    level: &Level,
    vertices: &mut Vec<Vertex>,
) {
    for (i, edge) in (0..).zip(&level.edges) {
        if edge.mark != SplitMark::Leaf {
            let ends = edge.vertices.map(|v| &vertices[v as usize]);
            let far = match index {
                edge_split::STRAIGHT_LEVEL.. => [None; 2],
                _ => [0, 1].map(|side| opposite(level, vertices, i, side)),
            };
            let new = edge_split::split(scale, rules, edge, index, ends, far);
            vertices.push(new);
        }
    }
}

fn decide_faces(rules: &Rules, index: u32, level: &mut Level, vertices: &[Vertex]) {
    if index >= edge_split::STRAIGHT_LEVEL {
        return;
    }
    for f in 0..level.faces.len() {
        let face = level.faces[f];
        if face.mark == SplitMark::Leaf {
            continue;
        }
        let edges = face.edges.map(|e| &level.edges[e as usize]);
        if edges.iter().all(|e| e.kind == EdgeKind::Terrain) {
            continue;
        }
        let beyond = [0, 1, 2].map(|k| {
            let side = usize::from(edges[k].faces[0] == f as u32);
            opposite(level, vertices, face.edges[k], side)
        });
        let sight = FaceContext {
            corners: face.vertices,
            vertices: face.vertices.map(|v| &vertices[v as usize]),
            edges,
            mids: edges.map(|e| &vertices[e.mid as usize]),
            kinds: edges.map(|e| vertices[e.mid as usize].kind),
            beyond,
        };
        level.faces[f].inner = face_decide::decide(rules, index, &sight);
    }
}

fn resolve_vertices(
    scale: &PlanetScale,
    rules: &Rules,
    index: u32,
    level: &Level,
    vertices: &mut [Vertex],
) {
    for (i, edge) in (0..).zip(&level.edges) {
        if edge.mark == SplitMark::Split {
            let settled = resolved((scale, rules), index, level, i, vertices);
            settled.write(&mut vertices[edge.mid as usize]);
        }
    }
}

/// What the faces beside an edge settle of its new vertex.
fn resolved(
    (scale, rules): (&PlanetScale, &Rules),
    index: u32,
    level: &Level,
    i: u32,
    vertices: &[Vertex],
) -> Settled {
    let edge = &level.edges[i as usize];
    let mut around = VertexContext {
        edge,
        ends: edge.vertices.map(|v| &vertices[v as usize]),
        opposite: [None; 2],
        gully_tip: false,
        river_tip: false,
        branched: false,
        beside: [None; 4],
    };
    for side in 0..2 {
        let Some(face) = level.faces.get(edge.faces[side] as usize) else {
            continue;
        };
        around.opposite[side] = Some(&vertices[face.opposite(i) as usize]);
        let k = face.edges.iter().position(|&e| e == i).unwrap_or(0);
        if face.inner != [Inner::Terrain; 3] {
            let (gully, river, junction) = asks(&face.inner, k);
            around.gully_tip |= gully;
            around.river_tip |= river;
            around.branched |= junction;
        }
        for j in 0..2 {
            let other = &level.edges[face.edges[(k + 1 + j) % 3] as usize];
            if other.kind != EdgeKind::Terrain {
                let ends = other.vertices.map(|v| &vertices[v as usize]);
                let mid = vertices.get(other.mid as usize);
                around.beside[side * 2 + j] = Some((other, ends, mid));
            }
        }
    }
    resolve(scale, rules, index, &vertices[edge.mid as usize], &around)
}

/// The next level's edges: halves, then inner edges.
fn grow_edges(
    rules: &Rules,
    index: u32,
    level: &Level,
    vertices: &[Vertex],
    count: usize,
) -> Vec<Edge> {
    let mut edges = Vec::with_capacity(count);
    for edge in level.edges.iter().filter(|e| e.mark == SplitMark::Split) {
        edges.extend(face_split::halve(
            rules,
            index,
            edge,
            &level.faces,
            vertices,
        ));
    }
    for face in level.faces.iter().filter(|f| f.mark == SplitMark::Split) {
        for k in 0..3 {
            edges.push(face_split::inner_edge(
                face,
                index,
                k,
                &level.edges,
                vertices,
            ));
        }
    }
    edges
}

/// The next level's faces.
fn grow_faces(level: &Level, made: &LevelCounts) -> Vec<Face> {
    let mut faces = Vec::with_capacity(made.faces);
    let mut inner = made.halves as u32;
    for (f, face) in (0..)
        .zip(&level.faces)
        .filter(|(_, f): &(u32, &Face)| f.mark == SplitMark::Split)
    {
        faces.extend(face_split::quarter(face, f, inner, &level.edges));
        inner += 3;
    }
    faces
}
