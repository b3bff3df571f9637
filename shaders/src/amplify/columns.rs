//! The ground's columns on a GPU: buffers, where passes bind them, and the passes over them.
//!
//! All passes see the same names: `columns.wgsl` declares every column once to be read, and once
//! more, as `out_` and its name, to be written. Group 0 holds the uniform of the level, group 1 the
//! columns; a pass binds those that it names. No pass binds more than eight storage buffers, and
//! none binds a column twice. The sizes of all levels are read as a uniform, which is no storage.
//!
//! Edges and faces exist for three levels: that of the control mesh, whose rows no pass but those
//! of level 0 touches, and two that take turns, as a level is no longer needed once the next has
//! grown and its leaves are triangles. Vertices and triangles are appended, level by level.

use super::carve::Carved;
use super::count::BLOCK;
use super::ground::FINEST;
use super::rows::level::GROUP;
use super::rows::{
    BlockCounts, EdgeJoins, EdgeState, FaceCorners, FaceSides, LevelArgs, LevelSizes, Row,
    RowLayout, VertexCore, VertexCourse, VertexLand, VertexRiver,
};

/// Rows of [`LevelSizes`] and [`LevelArgs`]: one a level, and one for what the finest would make.
pub const LEVELS: usize = FINEST as usize + 2;

/// Distance of the binding of a column that is written from that of the same to be read.
pub const WRITTEN: u32 = 32;

/// One column of the ground: a buffer of rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GpuColumn {
    /// Its name in WGSL where it is read.
    pub name: &'static str,
    /// Its binding in group 1 where it is read.
    pub binding: u32,
    /// Its rows.
    pub row: RowLayout,
    /// Whether it is read as a uniform of [`LEVELS`] rows, not as storage.
    pub is_uniform: bool,
}

/// A column of a kind of rows.
const fn column<R: Row>(name: &'static str, binding: u32) -> GpuColumn {
    GpuColumn {
        name,
        binding,
        row: R::LAYOUT,
        is_uniform: false,
    }
}

/// All columns. `finer_` names those of the next level.
pub const COLUMNS: [GpuColumn; 21] = [
    column::<VertexCore>("vertex_cores", 0),
    column::<EdgeJoins>("edge_joins", 1),
    column::<EdgeState>("edge_states", 2),
    column::<FaceSides>("face_sides", 3),
    column::<FaceCorners>("face_corners", 4),
    // 1 for a face that is split: a copy of the marks, which the halo's pass writes.
    column::<u32>("face_splits", 5),
    column::<BlockCounts>("block_counts", 6),
    // Edges that get a vertex, in the order of those vertices.
    column::<u32>("halved", 7),
    // Faces whose inner edges are decided.
    column::<u32>("decided", 8),
    GpuColumn {
        is_uniform: true,
        ..column::<LevelSizes>("level_sizes", 9)
    },
    column::<LevelArgs>("level_args", 10),
    column::<EdgeJoins>("finer_edge_joins", 11),
    column::<EdgeState>("finer_edge_states", 12),
    column::<FaceSides>("finer_face_sides", 13),
    column::<FaceCorners>("finer_face_corners", 14),
    // Corners of the leaves' triangles.
    column::<[u32; 3]>("triangles", 15),
    column::<VertexCourse>("vertex_courses", 16),
    column::<VertexLand>("vertex_lands", 17),
    column::<VertexRiver>("vertex_rivers", 18),
    // Final ground and water of vertices.
    column::<Carved>("carved", 19),
    // The same as a view shows them.
    column::<Carved>("shown", 20),
];

/// One compute pass over a level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ComputePass {
    /// Name of its entry point, that of its Rust twin.
    pub entry: &'static str,
    /// Path of its module.
    pub module: &'static str,
    /// Items in a group.
    pub group: usize,
    /// Columns that it reads alone.
    pub reads: &'static [&'static str],
    /// Columns that it writes, and may read its own rows of.
    pub writes: &'static [&'static str],
}

/// The passes in the order in which a level runs them.
pub const PASSES: [ComputePass; 18] = [
    // Once a control mesh.
    ComputePass {
        entry: "carve_base",
        module: "amplify/carve",
        group: GROUP,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "vertex_courses",
            "vertex_lands",
            "vertex_rivers",
        ],
        writes: &["carved"],
    },
    // Once a run.
    ComputePass {
        entry: "show_base",
        module: "amplify/show",
        group: GROUP,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "vertex_courses",
            "vertex_lands",
            "vertex_rivers",
            "carved",
        ],
        writes: &["shown"],
    },
    // Once a level.
    ComputePass {
        entry: "mark_split",
        module: "amplify/mark",
        group: GROUP,
        reads: &["level_sizes", "vertex_cores", "face_corners"],
        writes: &["face_splits"],
    },
    ComputePass {
        entry: "mark_halo",
        module: "amplify/mark",
        group: GROUP,
        reads: &["level_sizes", "face_splits", "edge_joins"],
        writes: &["face_sides"],
    },
    ComputePass {
        entry: "count_edges",
        module: "amplify/count",
        group: BLOCK,
        reads: &["level_sizes", "edge_joins", "face_sides"],
        writes: &["edge_states", "block_counts"],
    },
    ComputePass {
        entry: "count_faces",
        module: "amplify/count",
        group: BLOCK,
        reads: &["level_sizes", "face_sides"],
        writes: &["block_counts"],
    },
    ComputePass {
        entry: "scan",
        module: "amplify/scan",
        group: BLOCK,
        reads: &[],
        writes: &["block_counts", "level_sizes", "level_args"],
    },
    ComputePass {
        entry: "place_edges",
        module: "amplify/place",
        group: BLOCK,
        reads: &["level_sizes", "block_counts"],
        writes: &["edge_states", "halved"],
    },
    ComputePass {
        entry: "place_faces",
        module: "amplify/place",
        group: BLOCK,
        reads: &["level_sizes", "face_sides", "block_counts"],
        writes: &["face_corners", "decided"],
    },
    ComputePass {
        entry: "edge_split",
        module: "amplify/edge_split/mod",
        group: GROUP,
        reads: &[
            "level_sizes",
            "edge_joins",
            "edge_states",
            "face_corners",
            "halved",
        ],
        writes: &[
            "vertex_cores",
            "vertex_courses",
            "vertex_lands",
            "vertex_rivers",
        ],
    },
    ComputePass {
        entry: "face_decide",
        module: "amplify/face_decide",
        group: GROUP,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "vertex_courses",
            "edge_joins",
            "edge_states",
            "face_corners",
            "decided",
        ],
        writes: &["face_sides"],
    },
    ComputePass {
        entry: "vertex_resolve",
        module: "amplify/vertex_resolve/mod",
        group: GROUP,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "vertex_courses",
            "edge_joins",
            "edge_states",
            "face_sides",
            "face_corners",
            "halved",
        ],
        writes: &["vertex_rivers"],
    },
    ComputePass {
        entry: "carve_all",
        module: "amplify/carve",
        group: GROUP,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "vertex_courses",
            "vertex_lands",
            "vertex_rivers",
        ],
        writes: &["carved"],
    },
    ComputePass {
        entry: "show_all",
        module: "amplify/show",
        group: GROUP,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "vertex_courses",
            "vertex_lands",
            "vertex_rivers",
            "carved",
        ],
        writes: &["shown"],
    },
    ComputePass {
        entry: "grow_halves",
        module: "amplify/face_split",
        group: GROUP,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "vertex_rivers",
            "edge_joins",
            "edge_states",
            "face_corners",
            "halved",
        ],
        writes: &["finer_edge_joins", "finer_edge_states"],
    },
    ComputePass {
        entry: "grow_inner",
        module: "amplify/face_split",
        group: GROUP,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "edge_joins",
            "edge_states",
            "face_sides",
            "face_corners",
            "decided",
        ],
        writes: &["finer_edge_joins", "finer_edge_states"],
    },
    ComputePass {
        entry: "grow_faces",
        module: "amplify/face_split",
        group: GROUP,
        reads: &[
            "level_sizes",
            "edge_joins",
            "edge_states",
            "face_sides",
            "face_corners",
            "decided",
        ],
        writes: &["finer_face_sides", "finer_face_corners"],
    },
    ComputePass {
        entry: "emit_leaves",
        module: "amplify/emit",
        group: BLOCK,
        reads: &[
            "level_sizes",
            "vertex_cores",
            "edge_states",
            "face_sides",
            "face_corners",
            "block_counts",
        ],
        writes: &["triangles"],
    },
];

/// The column of a name.
pub fn column_named(name: &str) -> Option<GpuColumn> {
    COLUMNS.into_iter().find(|column| column.name == name)
}

/// The pass of an entry point.
pub fn pass_named(entry: &str) -> Option<ComputePass> {
    PASSES.into_iter().find(|pass| pass.entry == entry)
}

crate::wgsl::shared!(LEVELS = LEVELS as u32);
