//! The two rows of an edge.

use super::row;
use crate::amplify::rules::EdgeKind;
use crate::amplify::topology::{Edge, EdgeSplit, NONE, SplitMark};

/// Everything that an edge joins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct EdgeJoins {
    /// Its ends, as [`Edge::vertices`].
    pub vertices: [u32; 2],
    /// The faces on both sides, as [`Edge::faces`].
    pub faces: [u32; 2],
}

row!(EdgeJoins { vertices, faces });

/// The kind of an edge, and a run's part in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct EdgeState {
    /// The vertex that halves it; [`NONE`] where it is a leaf.
    pub mid: u32,
    /// Its first half in the next level; [`NONE`] where it is not split.
    pub child: u32,
    /// Discharge that arrives at its second end, as [`Edge::arriving`].
    pub arriving: u32,
    /// Kind, birth, whether it is a descent, and mark, a byte each from the lowest.
    pub marks: u32,
}

row!(EdgeState {
    mid,
    child,
    arriving,
    marks,
});

/// Lowest bit of the birth in [`EdgeState::marks`].
const BIRTH: u32 = 8;

/// Bit of a descent in [`EdgeState::marks`].
const DESCENT: u32 = 16;

/// Lowest bit of the mark in [`EdgeState::marks`].
const MARK: u32 = 24;

crate::wgsl::shared!(
    NONE,
    LEAF = SplitMark::Leaf as u32,
    HALO = SplitMark::Halo as u32,
    SPLIT = SplitMark::Split as u32,
    EDGE_BIRTH = BIRTH,
    EDGE_DESCENT = DESCENT,
    EDGE_MARK = MARK,
);

impl From<&Edge> for EdgeJoins {
    fn from(edge: &Edge) -> Self {
        Self {
            vertices: edge.vertices,
            faces: edge.faces,
        }
    }
}

/// An edge without a run's part has [`EdgeSplit::default`].
impl From<(&Edge, &EdgeSplit)> for EdgeState {
    fn from((edge, split): (&Edge, &EdgeSplit)) -> Self {
        let birth = u32::from(edge.birth) << BIRTH;
        let descent = u32::from(edge.is_descent) << DESCENT;
        let only = |is: bool, number| if is { number } else { NONE };
        Self {
            mid: only(split.mark != SplitMark::Leaf, split.mid),
            child: only(split.mark == SplitMark::Split, split.child),
            arriving: edge.arriving,
            marks: edge.kind as u32 | birth | descent | (split.mark as u32) << MARK,
        }
    }
}

impl From<(EdgeJoins, EdgeState)> for Edge {
    fn from((joins, state): (EdgeJoins, EdgeState)) -> Self {
        Self {
            arriving: state.arriving,
            birth: (state.marks >> BIRTH) as u8,
            is_descent: state.marks >> DESCENT & 1 != 0,
            ..Self::new(kind(state.marks), joins.vertices, joins.faces)
        }
    }
}

/// Numbers of things that an edge has not are 0.
impl From<EdgeState> for EdgeSplit {
    fn from(state: EdgeState) -> Self {
        let some = |number| if number == NONE { 0 } else { number };
        Self {
            mid: some(state.mid),
            child: some(state.child),
            mark: SplitMark::from_number((state.marks >> MARK) as u8),
        }
    }
}

/// The kind of an edge of some marks; ground for a number that no kind has.
const fn kind(marks: u32) -> EdgeKind {
    match marks as u8 {
        1 => EdgeKind::River,
        2 => EdgeKind::Gully,
        _ => EdgeKind::Terrain,
    }
}
