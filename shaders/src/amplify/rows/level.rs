//! Rows about whole levels and blocks of items: what they make, and how many groups run over them.

use super::row;
use crate::amplify::count::{BLOCK, LevelCounts};

/// Items in a group of the passes that run over single items.
pub const GROUP: usize = 64;

/// Items of a block that are summed one after the other, and rows of so many in a block.
const SUM_ROW: usize = 16;

const _: () = assert!(SUM_ROW * SUM_ROW == BLOCK);

row!(LevelCounts {
    mids,
    halves,
    children,
    decided,
});

/// Items that a block makes, before `scan`; after it those that the blocks before it make. The
/// blocks of faces follow on those of edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct BlockCounts {
    /// Items of the next level.
    pub made: LevelCounts,
    /// Triangles of leaves.
    pub triangles: u32,
    /// Nothing: it fills the row.
    pub unused: [u32; 3],
}

row!(BlockCounts {
    made,
    triangles,
    unused,
});

/// Sizes of a level, and what it makes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct LevelSizes {
    /// Edges.
    pub edges: u32,
    /// Faces.
    pub faces: u32,
    /// Vertices of all coarser levels and of itself: the number of the first that it makes.
    pub first_vertex: u32,
    /// Triangles of all coarser levels.
    pub first_triangle: u32,
    /// Items of the next level.
    pub made: LevelCounts,
}

row!(LevelSizes {
    edges,
    faces,
    first_vertex,
    first_triangle,
    made,
});

/// The items that the buffers of a run hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct LevelCaps {
    /// Vertices of all levels, those of the control mesh among them.
    pub vertices: u32,
    /// Edges of a level.
    pub edges: u32,
    /// Faces of a level.
    pub faces: u32,
    /// Triangles of all leaves.
    pub triangles: u32,
}

row!(LevelCaps {
    vertices,
    edges,
    faces,
    triangles,
});

impl Default for LevelCaps {
    /// No caps.
    fn default() -> Self {
        Self {
            vertices: u32::MAX,
            edges: u32::MAX,
            faces: u32::MAX,
            triangles: u32::MAX,
        }
    }
}

/// Groups that the passes of a level run with: arguments of indirect dispatches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C)]
pub struct LevelArgs {
    /// Over its faces, in groups of [`GROUP`].
    pub faces: [u32; 3],
    /// Over its edges, in blocks.
    pub edge_blocks: [u32; 3],
    /// Over its faces, in blocks.
    pub face_blocks: [u32; 3],
    /// Over its edges that get a vertex, in groups.
    pub halved: [u32; 3],
    /// Over its faces that decide, in groups.
    pub decided: [u32; 3],
    /// Nothing: it fills the row.
    pub unused: u32,
}

row!(LevelArgs {
    faces,
    edge_blocks,
    face_blocks,
    halved,
    decided,
    unused,
});

crate::wgsl::shared!(
    BLOCK = BLOCK as u32,
    GROUP = GROUP as u32,
    SUM_ROW = SUM_ROW as u32,
    SUM_ROWS = (BLOCK / SUM_ROW) as u32,
);
