//! The columns of one ground.
//!
//! Vertices and triangles are appended level by level. Edges and faces are kept for three levels:
//! that of the control mesh, and two that take turns.

use super::base::BaseRows;
use super::error::GpuError;
use super::pipelines::UNIFORM_BYTES;
use super::sizes::BufferSizes;
use crate::amplify::columns::{COLUMNS, GpuColumn};
use crate::amplify::ground::FINEST;
use crate::amplify::rows::{LevelArgs, LevelCaps, LevelSizes, words};
use std::collections::BTreeMap;
use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device, Queue};

/// Columns of edges and faces, of which each level has its own.
const OF_LEVEL: [&str; 4] = ["edge_joins", "edge_states", "face_sides", "face_corners"];

/// The items that buffers hold beside the control mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GroundCaps {
    /// New vertices of all levels.
    pub vertices: u32,
    /// Edges of a level.
    pub edges: u32,
    /// Faces of a level.
    pub faces: u32,
    /// Triangles, the control mesh's included.
    pub triangles: u32,
}

impl GroundCaps {
    /// Caps for a camera's ground of so many leaves: views of grown planets make 0.51 vertices a
    /// leaf, and the widest of their levels has a fifth of all edges and faces.
    pub const fn for_leaves(leaves: u32) -> Self {
        let fifth = leaves / 5 + 4_096;
        Self {
            vertices: leaves / 2 + leaves / 16 + 4_096,
            edges: fifth / 2 * 3,
            faces: fifth,
            triangles: leaves + leaves / 2 + 4_096,
        }
    }

    /// With the control mesh's vertices.
    pub(super) const fn with(&self, base: &LevelSizes) -> LevelCaps {
        LevelCaps {
            vertices: base.first_vertex + self.vertices,
            edges: self.edges,
            faces: self.faces,
            triangles: base.faces + self.triangles,
        }
    }
}

/// Buffers by the names of their columns.
type NamedBuffers = BTreeMap<&'static str, Buffer>;

/// The buffers of one ground.
#[derive(Clone, Debug)]
pub struct GroundBuffers {
    pub(super) base: LevelSizes,
    pub(super) caps: LevelCaps,
    /// Those of the control mesh, and of two levels that take turns.
    pub(super) of_level: [NamedBuffers; 3],
    /// All others.
    pub(super) shared: NamedBuffers,
    /// A uniform for each level.
    pub(super) uniforms: Vec<Buffer>,
    /// Sizes and groups of level 0, with which a run begins.
    pub(super) start: [Buffer; 2],
    bytes: u64,
}

impl GroundBuffers {
    /// Buffers for a control mesh, with its rows in them.
    ///
    /// # Errors
    /// [`GpuError::Limit`] where one of them is larger than the device binds.
    pub fn new(
        device: &Device,
        queue: &Queue,
        base: &BaseRows,
        caps: &GroundCaps,
    ) -> Result<Self, GpuError> {
        let caps = caps.with(&base.sizes);
        let sizes = BufferSizes {
            base: base.sizes,
            caps,
        };
        sizes.check(&device.limits())?;
        let buffers = Allocator { device, bytes: 0 }.ground(sizes);
        buffers.fill(queue, base);
        Ok(buffers)
    }

    /// Bytes of all of them.
    pub const fn bytes(&self) -> u64 {
        self.bytes
    }

    /// A column that all levels share, by its name in [`COLUMNS`].
    pub fn column(&self, name: &str) -> Option<&Buffer> {
        self.shared.get(name)
    }

    /// The items that the buffers hold.
    pub const fn caps(&self) -> &LevelCaps {
        &self.caps
    }

    /// Writes the rows of the control mesh.
    fn fill(&self, queue: &Queue, base: &BaseRows) {
        for (name, words) in &base.columns {
            let of_level = self.of_level[0].get(name);
            if let Some(buffer) = of_level.or_else(|| self.shared.get(name)) {
                queue.write_buffer(buffer, 0, bytes_of(words).as_slice());
            }
        }
        let start = [words([base.sizes]), words([LevelArgs::new(&base.sizes)])];
        for (buffer, words) in self.start.iter().zip(&start) {
            queue.write_buffer(buffer, 0, &bytes_of(words));
        }
    }
}

/// Words as a queue takes them.
pub(super) fn bytes_of(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_ne_bytes()).collect()
}

/// Buffers that are being made, and their bytes.
struct Allocator<'a> {
    device: &'a Device,
    bytes: u64,
}

impl Allocator<'_> {
    /// A buffer of a column: on the control mesh's level, or on another.
    fn column(&mut self, sizes: &BufferSizes, column: &GpuColumn, is_base: bool) -> Buffer {
        let size = sizes.bytes(column, is_base);
        self.buffer(column.name, size, usages(column.name))
    }

    fn columns(&mut self, sizes: &BufferSizes, all: &[&GpuColumn], is_base: bool) -> NamedBuffers {
        let named = |&column: &&GpuColumn| (column.name, self.column(sizes, column, is_base));
        all.iter().map(named).collect()
    }

    fn buffer(&mut self, label: &str, size: u64, usage: BufferUsages) -> Buffer {
        self.bytes += size;
        self.device.create_buffer(&BufferDescriptor {
            label: Some(label),
            size,
            usage,
            mapped_at_creation: false,
        })
    }

    /// All buffers of a ground.
    fn ground(mut self, sizes: BufferSizes) -> GroundBuffers {
        let own = COLUMNS.iter().filter(|c| !c.name.starts_with("finer_"));
        let (of_levels, shared): (Vec<_>, Vec<_>) = own.partition(|c| OF_LEVEL.contains(&c.name));
        let of_level =
            [true, false, false].map(|is_base| self.columns(&sizes, &of_levels, is_base));
        let shared = self.columns(&sizes, &shared, false);
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let uniforms = (0..=FINEST).map(|_| self.buffer("level_uniform", UNIFORM_BYTES, uniform));
        let uniforms = uniforms.collect();
        let copied = BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        let start = [32, 64].map(|size| self.buffer("start", size, copied));
        GroundBuffers {
            base: sizes.base,
            caps: sizes.caps,
            of_level,
            shared,
            uniforms,
            start,
            bytes: self.bytes,
        }
    }
}

/// The uses of a column's buffer.
fn usages(name: &str) -> BufferUsages {
    let all = BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
    match name {
        "level_sizes" => all | BufferUsages::UNIFORM,
        "level_args" => all | BufferUsages::INDIRECT,
        "triangles" => all | BufferUsages::INDEX,
        _ => all,
    }
}

const _: () = assert!(size_of::<LevelSizes>() == 32 && size_of::<LevelArgs>() == 64);
