//! Passes: edges are halved and faces quartered, as [`topology`](super::topology) describes.
//!
//! Every child edge and child face is written from its parent's data and that of the parent's
//! neighbours alone.

use super::rules::{EdgeKind, Rules, gully};
use super::topology::{Edge, Face, NONE, SplitMark, gather};
use super::vertex::Vertex;
use super::vertex_resolve::tributary;

/// The two halves of a split edge of a level. New dry land drains along one of them.
pub fn halve(
    rules: &Rules,
    level: u32,
    edge: &Edge,
    faces: &[Face],
    vertices: &[Vertex],
) -> [Edge; 2] {
    let [a, b] = edge.vertices;
    let [up, mid, down] = gather(vertices, [a, edge.mid, b]);
    [0, 1].map(|slot| {
        let (kind, reversed) = half_kind(rules, level, edge.kind, slot, [up, mid, down]);
        let (end, ends) = [(a, [a, edge.mid]), (b, [edge.mid, b])][slot];
        let mut half = Edge::new(kind, ends, children_at(end, edge, faces));
        if reversed {
            half.reverse();
        }
        if kind == EdgeKind::River {
            // The birth bounds the width of the valley; what arrives keeps the discharge whole.
            half.birth = edge.birth;
            half.arriving = [arriving_at(mid, up), edge.arriving][slot];
        }
        half
    })
}

/// The children that an edge's faces have at one of its ends, or [`NONE`].
fn children_at(end: u32, edge: &Edge, faces: &[Face]) -> [u32; 2] {
    edge.faces.map(|f| match faces.get(f as usize) {
        // Child k keeps corner k. A face of the halo has no children.
        Some(face) if face.mark == SplitMark::Split => face.child + face.corner(end) as u32,
        _ => NONE,
    })
}

/// The kind of a half of an edge, and whether it runs against the edge. The vertices are the edge's
/// ends and, between them, its middle.
///
/// R4a: on coarse levels a tributary goes on towards the land above its spring. R4b: later that
/// half is ground. New dry land drains along one half of its edge.
pub fn half_kind(
    rules: &Rules,
    level: u32,
    edge: EdgeKind,
    slot: usize,
    [up, mid, down]: [&Vertex; 3],
) -> (EdgeKind, bool) {
    match (edge, slot) {
        (EdgeKind::River, 0) if !up.is_wet() && level >= rules.extension_levels => {
            (EdgeKind::Terrain, false)
        }
        (EdgeKind::Terrain, 0) if gully::drains(rules, level, mid, up, down) => {
            (EdgeKind::Gully, true)
        }
        (EdgeKind::Terrain, 1) if gully::drains(rules, level, mid, down, up) => {
            (EdgeKind::Gully, false)
        }
        _ => (edge, false),
    }
}

/// Discharge that arrives at a new river vertex from upstream: all but what its tributary brings.
pub fn arriving_at(mid: &Vertex, up: &Vertex) -> u32 {
    // The tributary joins at the middle itself, not on the way to it.
    mid.discharge - if mid.branched { tributary(mid, up) } else { 0 }
}

/// The inner edge of a split face at a corner. `first` is the index of the face's first inner edge.
pub fn inner_edge(face: &Face, level: u32, k: usize, edges: &[Edge], vertices: &[Vertex]) -> Edge {
    let [first, second] = gather(edges, [face.edges[k], face.edges[(k + 2) % 3]]);
    let [corner, middle] = [face.child + k as u32, face.child + 3];
    let (kind, reversed) = face.inner[k].edge();
    // iₖ runs mₖ, mₖ₋₁ as the corner child winds, which is therefore the first of its faces.
    let mut edge = Edge::new(kind, [first.mid, second.mid], [corner, middle]);
    if reversed {
        edge.reverse();
    }
    if kind == EdgeKind::River {
        // A tributary joins the river at its second end.
        let river = if reversed { first } else { second };
        let [junction, upstream] = gather(vertices, [river.mid, river.vertices[0]]);
        edge.birth = level as u8 + 1;
        edge.arriving = tributary(junction, upstream);
    }
    edge
}

/// The four children of a split face. `first_inner` is the index of its first inner edge in the
/// next level.
pub fn quarter(face: &Face, index: u32, first_inner: u32, edges: &[Edge]) -> [Face; 4] {
    let along = gather(edges, face.edges);
    let mids = along.map(|e| e.mid);
    // The half of edge e that ends at a corner.
    let half = |e: usize, corner: u32| along[e].child + u32::from(along[e].vertices[0] != corner);
    let [c0, c1, c2] = [0, 1, 2].map(|k| {
        let (other, v) = ((k + 2) % 3, face.vertices[k]);
        let edges = [half(k, v), first_inner + k as u32, half(other, v)];
        Face::new([v, mids[k], mids[other]], edges, index)
    });
    // The middle winds m₀, m₁, m₂; mₖmₖ₊₁ is the inner edge that cuts corner k + 1 off.
    let inner = [first_inner + 1, first_inner + 2, first_inner];
    [c0, c1, c2, Face::new(mids, inner, index)]
}
