//! Meshes, as another reader finds them.

use super::*;
use bevy::math::Vec3;
use serde_json::Value;

/// A .glb file, taken apart.
pub(super) struct Glb {
    json: Value,
    pub(super) positions: Vec<Vec3>,
    pub(super) normals: Vec<Vec3>,
    indices: Vec<u32>,
}

impl Glb {
    pub(super) fn read(bytes: &[u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!(&bytes[..4], b"glTF");
        assert_eq!((word(4), word(8)), (2, bytes.len()));
        assert_eq!(&bytes[16..20], b"JSON");
        let end = 20 + word(12);
        assert_eq!(&bytes[end + 4..end + 8], b"BIN\0");
        let binary = &bytes[end + 8..];
        assert!(word(12) % 4 == 0 && word(end) == binary.len());
        let json = serde_json::from_slice(&bytes[20..end]).unwrap();
        let (indices, _) = accessor(&json, binary, 2).as_chunks();
        Self {
            positions: vectors(accessor(&json, binary, 0)),
            normals: vectors(accessor(&json, binary, 1)),
            indices: indices.iter().map(|&b| u32::from_le_bytes(b)).collect(),
            json,
        }
    }
}

fn vectors(bytes: &[u8]) -> Vec<Vec3> {
    let (words, _) = bytes.as_chunks();
    let floats: Vec<f32> = words.iter().map(|&b| f32::from_le_bytes(b)).collect();
    floats.chunks(3).map(Vec3::from_slice).collect()
}

/// The bytes that an accessor sees.
fn accessor<'a>(json: &Value, binary: &'a [u8], k: usize) -> &'a [u8] {
    let number = |value: &Value| value.as_u64().unwrap() as usize;
    let view = &json["bufferViews"][number(&json["accessors"][k]["bufferView"])];
    let start = number(&view["byteOffset"]);
    &binary[start..start + number(&view["byteLength"])]
}

/// The mesh of 41 pixels to a side.
fn mesh_41() -> Glb {
    let (_folder, files) = exported("a.glb", 41);
    Glb::read(&fs::read(&files[0]).unwrap())
}

#[test]
fn a_mesh_has_a_vertex_per_pixel_and_says_how_low_it_goes() {
    let mesh = mesh_41();
    assert_eq!((mesh.positions.len(), mesh.normals.len()), (1681, 1681));
    assert_eq!(mesh.indices.len(), 6 * 1600);
    assert_eq!(mesh.json["buffers"][0]["byteLength"], 1681 * 24 + 9600 * 4);
    let least = mesh.positions.iter().copied().reduce(Vec3::min).unwrap();
    let said = mesh.json["accessors"][0]["min"][1].as_f64().unwrap();
    assert_eq!(said as f32, least.y);
}

#[test]
fn a_mesh_is_the_ground_in_metres() {
    let positions = mesh_41().positions;
    // The middle is the summit, above the origin; the first vertex is in the north west: -x, -z.
    assert!((positions[20 * 41 + 20] - Vec3::new(0.0, 3000.0, 0.0)).length() < 0.5);
    assert!(positions[0].x < -19_000.0 && positions[0].z < -19_000.0);
    let at = |k: usize| (k as f64 - 20.0) * 40_000.0 / 41.0;
    for (i, p) in positions.iter().enumerate().step_by(29) {
        let above_sea = (p.as_dvec3() + DVec3::new(0.0, R, 0.0)).length() - R;
        let expected = height(at(i % 41), -at(i / 41));
        assert!((above_sea - f64::from(expected)).abs() < 0.01);
    }
}

#[test]
fn a_mesh_faces_upwards() {
    let mesh = mesh_41();
    // Half way down the western flank the ground falls to the west, one in five.
    let normal = mesh.normals[20 * 41 + 14];
    assert!((normal.x / normal.y + 0.2).abs() < 0.01, "{normal}");
    assert!((normal.length() - 1.0).abs() < 1e-6, "{normal}");
    for triangle in mesh.indices.as_chunks().0 {
        let [a, b, c] = triangle.map(|k| mesh.positions[k as usize]);
        assert!((b - a).cross(c - a).y > 0.0);
    }
}
