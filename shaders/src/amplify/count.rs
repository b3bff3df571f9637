//! Passes: what a level makes, counted in blocks of items, and the edges' marks on the way.
//!
//! A block's counts are the sums of its items', whichever is looked at first.

use super::topology::{EdgeSplit, FaceSplit, LevelMesh, SplitMark};

/// Items in a block, as a workgroup has them.
pub const BLOCK: usize = 256;

/// Numbers of items that edges and faces make in the next level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct LevelCounts {
    /// New vertices: of split and halo edges.
    pub mids: u32,
    /// Halves of split edges.
    pub halves: u32,
    /// Children of split faces.
    pub children: u32,
    /// Faces whose inner edges are decided: split and halo.
    pub decided: u32,
}

impl LevelCounts {
    /// Items that an edge of a mark makes.
    #[inline]
    pub fn of_edge(mark: SplitMark) -> Self {
        Self {
            mids: u32::from(mark != SplitMark::Leaf),
            halves: 2 * u32::from(mark == SplitMark::Split),
            ..Self::default()
        }
    }

    /// Items that a face of a mark makes.
    #[inline]
    pub fn of_face(mark: SplitMark) -> Self {
        Self {
            children: 4 * u32::from(mark == SplitMark::Split),
            decided: u32::from(mark != SplitMark::Leaf),
            ..Self::default()
        }
    }

    /// Both.
    #[must_use]
    #[inline]
    pub const fn and(self, other: Self) -> Self {
        Self {
            mids: self.mids + other.mids,
            halves: self.halves + other.halves,
            children: self.children + other.children,
            decided: self.decided + other.decided,
        }
    }

    /// Edges of the next level: halves, and three inner edges for every four faces.
    pub const fn edges(&self) -> u32 {
        self.halves + self.children / 4 * 3
    }
}

/// Marks edges as the greater of their faces' marks, and counts a block of them.
pub fn count_edges(
    mesh: &LevelMesh,
    block: &[u32],
    faces: &[FaceSplit],
    edges: &mut [EdgeSplit],
) -> LevelCounts {
    block.iter().fold(LevelCounts::default(), |counts, &e| {
        let [left, right] = mesh.edges[e as usize]
            .faces
            .map(|f| faces.get(f as usize).map_or(SplitMark::Leaf, |f| f.mark));
        let mark = left.max(right);
        edges[e as usize].mark = mark;
        counts.and(LevelCounts::of_edge(mark))
    })
}

/// Counts a block of faces.
pub fn count_faces(block: &[u32], faces: &[FaceSplit]) -> LevelCounts {
    block.iter().fold(LevelCounts::default(), |counts, &f| {
        counts.and(LevelCounts::of_face(faces[f as usize].mark))
    })
}
