//! A mesh as binary glTF 2.0 (Khronos 2021, §4.4: GLB): one primitive with positions, normals and
//! u32 indices.
//!
//! A vertex stands at the centre of each pixel, where it is on the planet: the mesh is curved as
//! the planet is. The origin is the middle of the square at sea level; +x is east, +y up, -z north,
//! as glTF has it. Lengths are in m.

use super::error::{ExportError, cannot_encode};
use crate::query::{HeightGrid, MapSquare, grid_triangles};
use bevy::math::{DVec3, Vec3};
use rayon::prelude::*;
use serde_json::{Value, json};

/// Numbers of glTF: f32 and u32 components, vertex and index buffers.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34_962;
const ELEMENT_ARRAY_BUFFER: u32 = 34_963;

/// The file of a square.
pub(super) fn encode(square: &MapSquare, grid: &HeightGrid) -> Result<Vec<u8>, ExportError> {
    let positions = positions(square, grid);
    let normals = normals(square.pixels(), &positions);
    let triangles = grid_triangles(square.pixels());
    // One buffer: positions, normals, indices.
    let json = scene(&positions, 3 * triangles.len()).to_string();
    let vectors = [&positions, &normals].into_iter().flatten();
    let floats = vectors
        .flat_map(|v| v.to_array())
        .flat_map(f32::to_le_bytes);
    let indices = triangles.iter().flatten().flat_map(|i| i.to_le_bytes());
    let mut binary = Vec::with_capacity(24 * positions.len() + 12 * triangles.len());
    binary.extend(floats.chain(indices));
    glb(json.into_bytes(), &binary)
}

/// The scene: one mesh with a buffer of positions, then normals, then the indices of its `corners`.
fn scene(positions: &[Vec3], corners: usize) -> Value {
    let vertices = positions.len();
    let low = bound(positions, Vec3::min);
    let high = bound(positions, Vec3::max);
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
                "min": low, "max": high
            },
            { "bufferView": 1, "componentType": FLOAT, "count": vertices, "type": "VEC3" },
            {
                "bufferView": 2, "componentType": UNSIGNED_INT, "count": corners,
                "type": "SCALAR"
            },
        ],
        "bufferViews": [
            buffer_view(0, 12 * vertices, ARRAY_BUFFER),
            buffer_view(12 * vertices, 12 * vertices, ARRAY_BUFFER),
            buffer_view(24 * vertices, 4 * corners, ELEMENT_ARRAY_BUFFER),
        ],
        "buffers": [{ "byteLength": 24 * vertices + 4 * corners }],
    })
}

/// A corner of the box around the positions.
fn bound(positions: &[Vec3], best: fn(Vec3, Vec3) -> Vec3) -> [f32; 3] {
    let corner = positions.iter().copied().reduce(best);
    corner.unwrap_or_default().to_array()
}

/// A part of the buffer.
fn buffer_view(offset: usize, length: usize, target: u32) -> Value {
    json!({ "buffer": 0, "byteOffset": offset, "byteLength": length, "target": target })
}

/// A header and two chunks, each a multiple of four bytes long.
fn glb(mut json: Vec<u8>, binary: &[u8]) -> Result<Vec<u8>, ExportError> {
    // JSON may end in blanks; the binary chunk is a multiple of four bytes as it is.
    json.resize(json.len().next_multiple_of(4), b' ');
    let total = u32::try_from(12 + 8 + json.len() + 8 + binary.len())
        .map_err(|_| cannot_encode("the mesh does not fit into a .glb file"))?;
    let mut bytes = Vec::with_capacity(total as usize);
    bytes.extend(b"glTF");
    bytes.extend([2, total].into_iter().flat_map(u32::to_le_bytes));
    for (kind, content) in [(b"JSON", json.as_slice()), (b"BIN\0", binary)] {
        bytes.extend((content.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(content);
    }
    Ok(bytes)
}

/// Where the centre of each pixel is.
fn positions(square: &MapSquare, grid: &HeightGrid) -> Vec<Vec3> {
    (0..grid.values.len())
        .into_par_iter()
        .map(|i| position(square, grid, i))
        .collect()
}

/// Where the centre of pixel `i` is: relative to the middle of the square, before it is an f32, or
/// the planet's radius would cost its metres.
fn position(square: &MapSquare, grid: &HeightGrid, i: usize) -> Vec3 {
    let projection = square.projection();
    let (up, (east, north)) = (projection.centre(), projection.axes());
    let origin = up * projection.radius_m();
    let direction = square.direction(i % grid.width, i / grid.width);
    let p = direction * (projection.radius_m() + f64::from(grid.values[i])) - origin;
    DVec3::new(p.dot(east), p.dot(up), -p.dot(north)).as_vec3()
}

/// Unit normals of the surface through the neighbours of each vertex.
fn normals(side: usize, positions: &[Vec3]) -> Vec<Vec3> {
    (0..positions.len())
        .into_par_iter()
        .map(|i| normal(side, positions, i % side, i / side))
        .collect()
}

/// The normal at a vertex, from central differences; at the rim from one-sided ones.
fn normal(side: usize, positions: &[Vec3], x: usize, y: usize) -> Vec3 {
    let at = |x: usize, y: usize| positions[y * side + x].as_dvec3();
    let eastward = at((x + 1).min(side - 1), y) - at(x.saturating_sub(1), y);
    let northward = at(x, y.saturating_sub(1)) - at(x, (y + 1).min(side - 1));
    let normal = eastward.cross(northward).try_normalize();
    normal.unwrap_or(DVec3::Y).as_vec3()
}
