use super::*;
use crate::io::load_dem;
use crate::math;
use crate::query::{AzimuthalEquidistant, GroundError, checked};
use bevy::math::{DVec2, DVec3, Vec3};
use serde_json::Value;
use std::fs;
use std::io::Cursor;
use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::Tag;

const R: f64 = 3_000_000.0;

/// A cone of 3000 m on a shelf at -200 m, about 10° S 20° E; and a slope to the north, so that up
/// and down differ.
struct Mountain;

impl Ground for Mountain {
    fn radius_m(&self) -> f64 {
        R
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let up = checked(direction, level)?;
        let away = R * math::angle_between(up, math::direction(-10.0, 20.0));
        let north = R * (math::asin(up.z) + 10.0_f64.to_radians());
        Ok(((3000.0 - 0.2 * away).max(-200.0) + 0.01 * north) as f32)
    }
}

fn square(pixels: usize) -> MapSquare {
    let projection = AzimuthalEquidistant::new(-10.0, 20.0, R).unwrap();
    MapSquare::new(projection, 40_000.0, pixels).unwrap()
}

/// The heights of the mountain on a square.
fn heights(pixels: usize) -> HeightGrid {
    square(pixels)
        .heights(&Mountain, square(pixels).level())
        .unwrap()
}

/// A folder with the files of an exported square, and their paths.
fn exported(name: &str, pixels: usize) -> (tempfile::TempDir, Vec<PathBuf>) {
    let folder = tempfile::tempdir().unwrap();
    let files = export(&Mountain, &square(pixels), &folder.path().join(name)).unwrap();
    let mut found: Vec<PathBuf> = fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    let mut expected = files.clone();
    found.sort();
    expected.sort();
    assert_eq!(found, expected, "what is said is there, and nothing else");
    (folder, files)
}

/// The height of the mountain at `x` m east and `y` m north of its middle.
fn height(x: f64, y: f64) -> f32 {
    let map = AzimuthalEquidistant::new(-10.0, 20.0, R).unwrap();
    Mountain.height(map.direction(DVec2::new(x, y)), 0).unwrap()
}

/// The tags of a GeoTIFF.
struct WrittenTags {
    scale: Vec<f64>,
    tie: Vec<f64>,
    keys: Vec<[u16; 4]>,
    doubles: Vec<f64>,
    text: String,
}

impl WrittenTags {
    fn read(decoder: &mut Decoder<Cursor<&Vec<u8>>>) -> Self {
        let directory = decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap();
        Self {
            scale: decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag).unwrap(),
            tie: decoder.get_tag_f64_vec(Tag::ModelTiepointTag).unwrap(),
            keys: directory.as_chunks().0.to_vec(),
            doubles: decoder.get_tag_f64_vec(Tag::GeoDoubleParamsTag).unwrap(),
            text: decoder
                .get_tag_ascii_string(Tag::GeoAsciiParamsTag)
                .unwrap(),
        }
    }

    /// The value of a key that points to the doubles.
    fn double(&self, key: u16) -> f64 {
        let entry = self.keys.iter().find(|entry| entry[0] == key).unwrap();
        assert_eq!(entry[1..3], [34_736, 1]);
        self.doubles[usize::from(entry[3])]
    }
}

#[test]
fn a_geotiff_says_where_it_is() {
    let (_folder, files) = exported("a.tif", 100);
    let bytes = fs::read(&files[0]).unwrap();
    let mut decoder = Decoder::new(Cursor::new(&bytes)).unwrap();
    let tags = WrittenTags::read(&mut decoder);
    assert_eq!(tags.scale, [400.0, 400.0, 0.0]);
    assert_eq!(tags.tie, [0.0, 0.0, 0.0, -20_000.0, 20_000.0, 0.0]);
    assert_eq!((tags.double(2057), tags.double(2058)), (R, R));
    assert_eq!((tags.double(3088), tags.double(3089)), (20.0, -10.0));
    let shorts = [
        (1024, 1),
        (1025, 1),
        (3072, 32_767),
        (3075, 12),
        (3076, 9001),
    ];
    for (key, value) in shorts {
        assert!(tags.keys.contains(&[key, 0, 1, value]), "{key}");
    }
}

#[test]
fn the_keys_of_a_geotiff_ascend_and_their_texts_end() {
    let (_folder, files) = exported("a.tif", 100);
    let bytes = fs::read(&files[0]).unwrap();
    let mut decoder = Decoder::new(Cursor::new(&bytes)).unwrap();
    let tags = WrittenTags::read(&mut decoder);
    let (head, keys) = tags.keys.split_first().unwrap();
    assert_eq!(*head, [1, 1, 0, keys.len() as u16]);
    assert!(keys.is_sorted_by(|a, b| a[0] < b[0]));
    for &[_, _, length, start] in keys.iter().filter(|key| key[1] == 34_737) {
        let text = &tags.text[usize::from(start)..usize::from(start + length)];
        assert!(text.ends_with('|'), "{text}");
    }
}

#[test]
fn a_geotiff_holds_metres() {
    let (_folder, files) = exported("a.tif", 100);
    let bytes = fs::read(&files[0]).unwrap();
    let mut decoder = Decoder::new(Cursor::new(&bytes)).unwrap();
    assert_eq!(decoder.dimensions().unwrap(), (100, 100));
    assert_eq!(decoder.colortype().unwrap(), tiff::ColorType::Gray(32));
    let DecodingResult::F32(values) = decoder.read_image().unwrap() else {
        panic!("f32")
    };
    // Row 10, column 30 is 7800 m to the west and 15,800 m to the north.
    assert!((values[10 * 100 + 30] - height(-7800.0, 15_800.0)).abs() < 1e-3);
    // It is read again as ground, too.
    let dem = load_dem(&files[0]).unwrap();
    assert_eq!((dem.grid.pixel_m, dem.grid.values), ([400.0; 2], values));
}

#[test]
fn a_sidecar_says_where_its_picture_is() {
    let (folder, files) = exported("TILE.PNG", 64);
    assert_eq!(files[1], folder.path().join("TILE.json"));
    let json: Value = serde_json::from_slice(&fs::read(&files[1]).unwrap()).unwrap();
    let [low, high] = heights(64).range().unwrap().map(f64::from);
    let expected = serde_json::json!({
        "generator": "Pangaea",
        "lat": -10.0, "lon": 20.0, "metres_per_pixel": 625.0, "min_m": low, "max_m": high,
    });
    assert_eq!(json, expected);
}

#[test]
fn a_picture_and_its_sidecar_give_the_heights_again() {
    let (_folder, files) = exported("TILE.PNG", 64);
    let expected = heights(64);
    let [low, high] = expected.range().unwrap();
    let step = (high - low) / 65_535.0;
    let dem = load_dem(&files[0]).unwrap();
    for (found, expected) in dem.grid.values.iter().zip(&expected.values) {
        assert!((found - expected).abs() <= 0.51 * step + 1e-3);
    }
}

#[test]
fn level_ground_is_a_picture_too() {
    let grid = HeightGrid {
        width: 8,
        height: 8,
        values: vec![-7.5; 64],
        pixel_m: [5000.0; 2],
    };
    let files = encode(&square(8), &grid, Path::new("a.png")).unwrap();
    let json: Value = serde_json::from_slice(&files[1].1).unwrap();
    assert_eq!(
        (&json["min_m"], &json["max_m"]),
        (&Value::from(-7.5), &Value::from(-7.5))
    );
}

/// A .glb file, taken apart.
struct Glb {
    json: Value,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    indices: Vec<u32>,
}

impl Glb {
    fn read(bytes: &[u8]) -> Self {
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

/// Why a square cannot be exported to a file of that name.
fn refusal(folder: &Path, name: &str, pixels: usize) -> String {
    let error = export(&Mountain, &square(pixels), &folder.join(name)).unwrap_err();
    let text = error.to_string();
    assert_eq!(text.lines().count(), 1);
    text
}

#[test]
fn files_that_cannot_be_written_are_refused_and_leave_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let refusal = |name, pixels| refusal(folder.path(), name, pixels);
    assert!(refusal("a.bmp", 16).contains(".tif, .png or .glb"));
    assert!(refusal("noname", 16).contains("noname"));
    assert!(refusal("a.glb", 9000).contains("8192"));
    assert!(refusal("no/folder/a.tif", 16).contains("no/folder"));
    fs::create_dir(folder.path().join("b.json")).unwrap();
    assert!(refusal("b.png", 16).contains("b.json"));
    let left = fs::read_dir(folder.path()).unwrap();
    let left: Vec<_> = left.map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["b.json"]);
}

#[test]
fn heights_that_are_nan_are_refused() {
    let mut grid = heights(16);
    grid.values[5] = f32::NAN;
    let refused = encode(&square(16), &grid, Path::new("a.tif"));
    assert!(matches!(refused, Err(ExportError::Encode(_))));
}
