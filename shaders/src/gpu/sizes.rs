//! How large the buffers of a ground are.

use super::error::GpuError;
use crate::amplify::columns::{COLUMNS, GpuColumn, LEVELS};
use crate::amplify::count::BLOCK;
use crate::amplify::rows::{LevelCaps, LevelSizes};
use wgpu::Limits;

/// How many rows buffers have.
pub(super) struct BufferSizes {
    pub(super) base: LevelSizes,
    pub(super) caps: LevelCaps,
}

impl BufferSizes {
    /// Rows of a column: on the control mesh's level, or on another.
    fn rows(&self, name: &str, is_base: bool) -> u64 {
        let Self { base, caps } = self;
        let [edges, faces] = if is_base {
            [base.edges, base.faces]
        } else {
            [caps.edges, caps.faces]
        };
        let most_edges = base.edges.max(caps.edges);
        let most_faces = base.faces.max(caps.faces);
        let blocks = |items: u32| items.div_ceil(BLOCK as u32);
        let rows = match name {
            "edge_joins" | "edge_states" => edges,
            "face_sides" | "face_corners" => faces,
            "face_splits" | "decided" => most_faces,
            "halved" => most_edges,
            "block_counts" => blocks(most_edges) + blocks(most_faces),
            "level_sizes" | "level_args" => LEVELS as u32,
            "triangles" => caps.triangles,
            _ => caps.vertices,
        };
        u64::from(rows.max(1))
    }

    /// Bytes of a column's buffer: on the control mesh's level, or on another.
    pub(super) fn bytes(&self, column: &GpuColumn, is_base: bool) -> u64 {
        self.rows(column.name, is_base) * column.row.size as u64
    }

    /// Whether a device binds each of them.
    pub(super) fn check(&self, limits: &Limits) -> Result<(), GpuError> {
        let most = limits
            .max_storage_buffer_binding_size
            .min(limits.max_buffer_size);
        let bytes = COLUMNS.iter();
        let bytes = bytes.map(|c| self.bytes(c, true).max(self.bytes(c, false)));
        match bytes.max() {
            Some(needed) if needed > most => Err(GpuError::Limit {
                name: "maxStorageBufferBindingSize",
                found: most,
                needed,
            }),
            _ => Ok(()),
        }
    }
}
