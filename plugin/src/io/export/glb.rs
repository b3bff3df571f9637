//! The frame of a binary glTF 2.0 (Khronos 2021, §4.4: GLB): one primitive with positions, normals
//! and u32 indices in one buffer.

use bevy::math::Vec3;
use serde_json::{Value, json};
use std::io::{self, Write};

/// Numbers of glTF: f32 and u32 components, vertex and index buffers.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34_962;
const ELEMENT_ARRAY_BUFFER: u32 = 34_963;

/// The sizes of a mesh.
#[derive(Clone, Copy)]
pub(super) struct MeshSize {
    /// Number of vertices.
    pub(super) vertices: usize,
    /// Number of indices.
    pub(super) indices: usize,
}

impl MeshSize {
    /// Bytes of the buffer: positions, normals, indices.
    fn bytes(self) -> usize {
        24 * self.vertices + 4 * self.indices
    }
}

/// All of a file that comes before the buffer. `bounds` are the corners of the box around the
/// positions.
///
/// # Errors
/// If the file would have four gigabytes or more.
pub(super) fn write_head(out: &mut dyn Write, size: MeshSize, bounds: [Vec3; 2]) -> io::Result<()> {
    let mut json = scene(size, bounds).to_string().into_bytes();
    // JSON may end in blanks; the buffer is a multiple of four bytes as it is.
    json.resize(json.len().next_multiple_of(4), b' ');
    let total = u32::try_from(12 + 8 + json.len() + 8 + size.bytes())
        .map_err(|_| io::Error::other("the mesh does not fit into a .glb file"))?;
    out.write_all(b"glTF")?;
    out.write_all(&2_u32.to_le_bytes())?;
    out.write_all(&total.to_le_bytes())?;
    write_chunk_head(out, *b"JSON", json.len())?;
    out.write_all(&json)?;
    write_chunk_head(out, *b"BIN\0", size.bytes())
}

fn write_chunk_head(out: &mut dyn Write, kind: [u8; 4], length: usize) -> io::Result<()> {
    out.write_all(&(length as u32).to_le_bytes())?;
    out.write_all(&kind)
}

/// The scene: one mesh.
fn scene(size: MeshSize, [low, high]: [Vec3; 2]) -> Value {
    let MeshSize { vertices, indices } = size;
    json!({
        "asset": { "version": "2.0", "generator": "Pangaea" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "mesh": 0, "name": "ground" }],
        "meshes": [{ "primitives": [{
            "attributes": { "POSITION": 0, "NORMAL": 1 }, "indices": 2, "material": 0
        }] }],
        "materials": [{
            "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 1.0 }
        }],
        "accessors": [
            {
                "bufferView": 0, "componentType": FLOAT, "count": vertices, "type": "VEC3",
                "min": low.to_array(), "max": high.to_array()
            },
            { "bufferView": 1, "componentType": FLOAT, "count": vertices, "type": "VEC3" },
            {
                "bufferView": 2, "componentType": UNSIGNED_INT, "count": indices,
                "type": "SCALAR"
            },
        ],
        "bufferViews": [
            buffer_view(0, 12 * vertices, ARRAY_BUFFER),
            buffer_view(12 * vertices, 12 * vertices, ARRAY_BUFFER),
            buffer_view(24 * vertices, 4 * indices, ELEMENT_ARRAY_BUFFER),
        ],
        "buffers": [{ "byteLength": size.bytes() }],
    })
}

/// A part of the buffer.
fn buffer_view(offset: usize, length: usize, target: u32) -> Value {
    json!({ "buffer": 0, "byteOffset": offset, "byteLength": length, "target": target })
}
