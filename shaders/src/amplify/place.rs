//! Passes: every item that makes others gets the place of the first of them, and joins the list of
//! those that do.
//!
//! A place is that of the item's block and what the block's items before it make, so the order of
//! what is made is that of the items.

use super::count::LevelCounts;
use super::topology::{EdgeSplit, FaceSplit, SplitMark};

/// Places what a block of edges makes. `before` is what the blocks before it make, `first_vertex`
/// the number of the level's first new vertex. `halved` holds the edges that get a vertex, in the
/// order of those vertices.
pub fn place_edges(
    block: &[u32],
    mut before: LevelCounts,
    first_vertex: u32,
    edges: &mut [EdgeSplit],
    halved: &mut [u32],
) {
    for &e in block {
        let edge = &mut edges[e as usize];
        if edge.mark != SplitMark::Leaf {
            halved[before.mids as usize] = e;
            edge.mid = first_vertex + before.mids;
            edge.child = before.halves;
        }
        before = before.and(LevelCounts::of_edge(edge.mark));
    }
}

/// Places what a block of faces makes. `decided` holds the faces whose inner edges are decided.
pub fn place_faces(
    block: &[u32],
    mut before: LevelCounts,
    faces: &mut [FaceSplit],
    decided: &mut [u32],
) {
    for &f in block {
        let face = &mut faces[f as usize];
        if face.mark != SplitMark::Leaf {
            decided[before.decided as usize] = f;
            face.child = before.children;
        }
        before = before.and(LevelCounts::of_face(face.mark));
    }
}
