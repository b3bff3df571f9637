//! The columns of one ground.
//!
//! Vertices and triangles are appended level by level. Edges and faces are kept for three levels:
//! that of the control mesh, and two that take turns.

use super::base::BaseRows;
use super::error::GpuError;
use super::pipelines::UNIFORM_BYTES;
use crate::amplify::columns::{COLUMNS, LEVELS};
use crate::amplify::count::BLOCK;
use crate::amplify::ground::FINEST;
use crate::amplify::rows::{LevelArgs, LevelCaps, LevelSizes, words};
use std::collections::BTreeMap;
use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device, ErrorFilter, Queue};

/// Columns of edges and faces, of which each level has its own.
const OF_LEVEL: [&str; 4] = ["edge_joins", "edge_states", "face_sides", "face_corners"];

/// What buffers hold beside the control mesh.
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

/// The buffers of one ground.
#[derive(Clone, Debug)]
pub struct GroundBuffers {
    pub(super) base: LevelSizes,
    pub(super) caps: LevelCaps,
    /// Those of the control mesh, and of two levels that take turns.
    pub(super) of_level: [BTreeMap<&'static str, Buffer>; 3],
    /// All others.
    pub(super) shared: BTreeMap<&'static str, Buffer>,
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
    /// [`GpuError::Limit`] where one of them is larger than the device binds, [`GpuError::Memory`].
    pub async fn new(
        device: &Device,
        queue: &Queue,
        base: &BaseRows,
        caps: &GroundCaps,
    ) -> Result<Self, GpuError> {
        let caps = caps.with(&base.sizes);
        let sizes = Sizes {
            base: base.sizes,
            caps,
        };
        sizes.check(device)?;
        let scope = device.push_error_scope(ErrorFilter::OutOfMemory);
        let buffers = sizes.allocate(device);
        if scope.pop().await.is_some() {
            let bytes = buffers.bytes;
            return Err(GpuError::Memory { bytes });
        }
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

    /// What the buffers hold.
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

/// How many rows buffers have.
struct Sizes {
    base: LevelSizes,
    caps: LevelCaps,
}

impl Sizes {
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

    /// Whether the device binds each of them.
    fn check(&self, device: &Device) -> Result<(), GpuError> {
        let limits = device.limits();
        let most = limits
            .max_storage_buffer_binding_size
            .min(limits.max_buffer_size);
        let bytes = COLUMNS.iter().map(|column| {
            let rows = self
                .rows(column.name, true)
                .max(self.rows(column.name, false));
            rows * column.row.size as u64
        });
        match bytes.max() {
            Some(needed) if needed > most => Err(GpuError::Limit {
                name: "maxStorageBufferBindingSize",
                found: most,
                needed,
            }),
            _ => Ok(()),
        }
    }

    fn allocate(self, device: &Device) -> GroundBuffers {
        let mut bytes = 0;
        let mut make = |label: &'static str, size: u64, usage| {
            bytes += size;
            device.create_buffer(&BufferDescriptor {
                label: Some(label),
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let mut of_level = [(); 3].map(|()| BTreeMap::new());
        let mut shared = BTreeMap::new();
        let places = |name| COLUMNS.iter().find(|column| column.name == name);
        for column in COLUMNS.iter().filter(|c| !c.name.starts_with("finer_")) {
            let size = |is_base| self.rows(column.name, is_base) * column.row.size as u64;
            if OF_LEVEL.contains(&column.name) {
                for (k, level) in of_level.iter_mut().enumerate() {
                    let buffer = make(column.name, size(k == 0), usages(column.name));
                    level.insert(column.name, buffer);
                }
            } else {
                let buffer = make(column.name, size(false), usages(column.name));
                shared.insert(column.name, buffer);
            }
        }
        debug_assert!(OF_LEVEL.iter().all(|name| places(*name).is_some()));
        let uniform = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let uniforms = (0..=FINEST).map(|_| make("level_uniform", UNIFORM_BYTES, uniform));
        let uniforms = uniforms.collect();
        let copied = BufferUsages::COPY_SRC | BufferUsages::COPY_DST;
        let start = [32, 64].map(|size| make("start", size, copied));
        GroundBuffers {
            base: self.base,
            caps: self.caps,
            of_level,
            shared,
            uniforms,
            start,
            bytes,
        }
    }
}

/// What a column's buffer is used for.
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
