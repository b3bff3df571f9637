//! Passes: edges are halved and faces quartered, as [`topology`](super::topology) describes.
//!
//! Every child edge and child face is written from its parent's data and that of the parent's
//! neighbours alone.

use super::fixed::mul_high;
use super::rules::{EdgeKind, Rules, gully};
use super::seed::share;
use super::topology::{Edge, Face, FaceSplit, Level, NONE, SplitMark, gather};
use super::uniform::LevelUniform;
use super::vertex::Vertex;
use super::vertices::VertexView;

/// Pass: the two halves of every split edge. New dry land drains along one of them.
pub fn grow_halves(
    uniform: LevelUniform,
    level: &Level,
    vertices: VertexView,
    halved: &[u32],
    finer: &mut [Edge],
) {
    for &e in halved {
        let (edge, split) = (&level.mesh.edges[e as usize], &level.edges[e as usize]);
        if split.mark == SplitMark::Split {
            let child = split.child as usize;
            let halves = halve(
                uniform,
                level,
                [edge.vertices[0], split.mid],
                edge,
                vertices,
            );
            finer[child..child + 2].copy_from_slice(&halves);
        }
    }
}

/// The two halves of a split edge.
fn halve(
    LevelUniform { rules, level, .. }: LevelUniform,
    of: &Level,
    [a, m]: [u32; 2],
    edge: &Edge,
    vertices: VertexView,
) -> [Edge; 2] {
    let b = edge.vertices[1];
    let [up, mid, down] = vertices.gather([a, m, b]);
    [0, 1].map(|slot| {
        let along = half_kind(rules, level, edge, slot, [up, mid, down]);
        let (end, ends) = [(a, [a, m]), (b, [m, b])][slot];
        let mut half = Edge::new(along.kind, ends, children_at(end, edge, of));
        half.is_descent = along.is_descent;
        if along.is_reversed {
            half.reverse();
        }
        if along.kind == EdgeKind::River {
            // The birth bounds the width of the valley; what arrives keeps the discharge whole.
            half.birth = edge.birth;
            half.arriving = [arriving_at(mid, up), edge.arriving][slot];
        }
        half
    })
}

/// The children that an edge's faces have at one of its ends, or [`NONE`].
fn children_at(end: u32, edge: &Edge, level: &Level) -> [u32; 2] {
    edge.faces.map(|f| match level.faces.get(f as usize) {
        // Child k keeps corner k. A face of the halo has no children.
        Some(face) if face.mark == SplitMark::Split => {
            face.child + level.mesh.faces[f as usize].corner(end) as u32
        }
        _ => NONE,
    })
}

/// Kind and direction of a half of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HalfKind {
    /// Ground, river or gully.
    pub kind: EdgeKind,
    /// Whether it runs against the edge.
    pub is_reversed: bool,
    /// [`Edge::is_descent`].
    pub is_descent: bool,
}

/// Kind and direction of a half of an edge. The vertices are the edge's ends and, between them, its
/// middle.
///
/// R4a: on coarse levels a tributary goes on towards the land above its spring. R4b: later that
/// half is ground. New dry land drains along one half of its edge, by a gully or without one.
pub fn half_kind(
    rules: &Rules,
    level: u32,
    edge: &Edge,
    slot: usize,
    [up, mid, down]: [&Vertex; 3],
) -> HalfKind {
    let whole = HalfKind {
        kind: edge.kind,
        is_reversed: false,
        is_descent: edge.is_descent,
    };
    let [end, other] = if slot == 0 { [up, down] } else { [down, up] };
    match edge.kind {
        // The land above the spring drained along the river, and goes on so.
        EdgeKind::River if slot == 0 && !up.is_wet() && level >= rules.extension_levels => {
            HalfKind {
                kind: EdgeKind::Terrain,
                is_descent: true,
                ..whole
            }
        }
        EdgeKind::Terrain if gully::drains(rules, level, mid, end, other) => HalfKind {
            kind: EdgeKind::Gully,
            is_reversed: slot == 0,
            is_descent: false,
        },
        // Edges of finer levels keep between their ends, and their halves depend on no vertex.
        EdgeKind::Terrain if level < rules.gully_levels => HalfKind {
            is_descent: edge.is_descent || gully::leads_down(mid, end, other),
            ..whole
        },
        _ => whole,
    }
}

/// Discharge that arrives at a new river vertex from upstream: all but what its tributary brings.
pub fn arriving_at(mid: &Vertex, up: &Vertex) -> u32 {
    // The tributary joins at the middle itself, not on the way to it.
    mid.discharge - if mid.branched { tributary(mid, up) } else { 0 }
}

/// Discharge that a tributary brings to a junction: a quarter to a half of what its river has
/// gained since the upstream vertex, so that what came from upstream and what the tributary brings
/// make the junction's discharge.
#[inline]
pub fn tributary(junction: &Vertex, upstream: &Vertex) -> u32 {
    let gain = junction.discharge.saturating_sub(upstream.discharge);
    let quarter = gain / 4;
    quarter + mul_high(quarter, (share(junction.seed, 20) as u32) << 16)
}

/// Number of the first inner edge of a split face among the next level's edges: they follow the
/// halves, three a face.
const fn first_inner(face: &FaceSplit, halves: u32) -> u32 {
    halves + face.child / 4 * 3
}

/// Pass: the three inner edges of every split face. `halves` is the number of halves before them.
pub fn grow_inner(
    uniform: LevelUniform,
    level: &Level,
    vertices: VertexView,
    decided: &[u32],
    halves: u32,
    finer: &mut [Edge],
) {
    for &f in decided {
        let (face, split) = (&level.mesh.faces[f as usize], &level.faces[f as usize]);
        if split.mark == SplitMark::Split {
            let first = first_inner(split, halves) as usize;
            for k in 0..3 {
                finer[first + k] = inner_edge(uniform.level, level, face, split, k, vertices);
            }
        }
    }
}

/// The inner edge of a split face at a corner.
fn inner_edge(
    index: u32,
    level: &Level,
    face: &Face,
    split: &FaceSplit,
    k: usize,
    vertices: VertexView,
) -> Edge {
    let beside = [face.edges[k], face.edges[(k + 2) % 3]];
    let [first, second] = gather(&level.mesh.edges, beside);
    let mids = gather(&level.edges, beside).map(|e| e.mid);
    let (kind, reversed) = split.inner[k].edge();
    // iₖ runs mₖ, mₖ₋₁ as the corner child winds, which is therefore the first of its faces.
    let mut edge = Edge::new(kind, mids, [split.child + k as u32, split.child + 3]);
    if reversed {
        edge.reverse();
    }
    if kind == EdgeKind::River {
        // A tributary joins the river at its second end.
        let (river, junction) = [(second, mids[1]), (first, mids[0])][usize::from(reversed)];
        let [junction, upstream] = vertices.gather([junction, river.vertices[0]]);
        edge.birth = index as u8 + 1;
        edge.arriving = tributary(junction, upstream);
    }
    edge
}

/// Pass: the four children of every split face. `halves` is the number of halves before the inner
/// edges.
pub fn grow_faces(level: &Level, decided: &[u32], halves: u32, finer: &mut [Face]) {
    for &f in decided {
        let (face, split) = (&level.mesh.faces[f as usize], &level.faces[f as usize]);
        if split.mark == SplitMark::Split {
            let child = split.child as usize;
            let children = quarter(level, face, first_inner(split, halves));
            finer[child..child + 4].copy_from_slice(&children);
        }
    }
}

/// The four children of a split face, whose first inner edge is given.
fn quarter(level: &Level, face: &Face, first_inner: u32) -> [Face; 4] {
    let along = gather(&level.mesh.edges, face.edges);
    let splits = gather(&level.edges, face.edges);
    let mids = splits.map(|e| e.mid);
    // The half of edge e that ends at a corner.
    let half = |e: usize, corner| splits[e].child + u32::from(along[e].vertices[0] != corner);
    let [c0, c1, c2] = [0, 1, 2].map(|k| {
        let (other, v) = ((k + 2) % 3, face.vertices[k]);
        Face {
            vertices: [v, mids[k], mids[other]],
            edges: [half(k, v), first_inner + k as u32, half(other, v)],
        }
    });
    let middle = Face {
        vertices: mids,
        // The middle winds m₀, m₁, m₂; mₖmₖ₊₁ is the inner edge that cuts corner k + 1 off.
        edges: [first_inner + 1, first_inner + 2, first_inner],
    };
    [c0, c1, c2, middle]
}
