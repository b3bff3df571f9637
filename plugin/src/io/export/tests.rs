use super::*;
use crate::io::dem::load_dem;
use crate::math;
use crate::query::{AzimuthalEquidistant, checked};
use bevy::math::{DVec2, DVec3, Vec3};
use serde_json::Value;
use std::fs;
use std::io::Cursor;
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

#[test]
fn a_geotiff_says_where_it_is_and_holds_metres() {
    let (_folder, files) = exported("a.tif", 100);
    let bytes = fs::read(&files[0]).unwrap();
    let mut decoder = tiff::decoder::Decoder::new(Cursor::new(&bytes)).unwrap();
    assert_eq!(decoder.dimensions().unwrap(), (100, 100));
    assert_eq!(decoder.colortype().unwrap(), tiff::ColorType::Gray(32));
    assert_eq!(
        decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag).unwrap(),
        [400.0, 400.0, 0.0]
    );
    let tie = decoder.get_tag_f64_vec(Tag::ModelTiepointTag).unwrap();
    assert_eq!(tie, [0.0, 0.0, 0.0, -20_000.0, 20_000.0, 0.0]);
    let keys = decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap();
    let doubles = decoder.get_tag_f64_vec(Tag::GeoDoubleParamsTag).unwrap();
    let text = decoder
        .get_tag_ascii_string(Tag::GeoAsciiParamsTag)
        .unwrap();
    assert_eq!(keys[..4], [1, 1, 0, keys.len() as u16 / 4 - 1]);
    let entries: Vec<&[u16]> = keys[4..].chunks(4).collect();
    assert!(
        entries.windows(2).all(|pair| pair[0][0] < pair[1][0]),
        "keys ascend"
    );
    let double = |key: u16| {
        let entry = entries.iter().find(|entry| entry[0] == key).unwrap();
        assert_eq!((entry[1], entry[2]), (34_736, 1));
        doubles[usize::from(entry[3])]
    };
    assert_eq!((double(2057), double(2058)), (R, R));
    assert_eq!((double(3088), double(3089)), (20.0, -10.0));
    for (key, value) in [
        (1024, 1),
        (1025, 1),
        (3072, 32_767),
        (3075, 12),
        (3076, 9001),
    ] {
        assert!(entries.contains(&&[key, 0, 1, value][..]), "{key}");
    }
    for entry in entries.iter().filter(|entry| entry[1] == 34_737) {
        let (start, end) = (usize::from(entry[3]), usize::from(entry[3] + entry[2]));
        assert!(text[start..end].ends_with('|'), "{text}");
    }
    let tiff::decoder::DecodingResult::F32(values) = decoder.read_image().unwrap() else {
        panic!("f32")
    };
    // Row 10, column 30 is 7800 m to the west and 15,800 m to the north.
    assert!((values[10 * 100 + 30] - height(-7800.0, 15_800.0)).abs() < 1e-3);
    // It is read again as ground, too.
    let dem = load_dem(&files[0]).unwrap();
    assert_eq!((dem.grid.pixel_m, dem.grid.values), ([400.0; 2], values));
}

#[test]
fn a_picture_and_its_sidecar_give_the_heights_again() {
    let (folder, files) = exported("TILE.PNG", 64);
    assert_eq!(files[1], folder.path().join("TILE.json"));
    let json: Value = serde_json::from_slice(&fs::read(&files[1]).unwrap()).unwrap();
    let mut keys: Vec<&str> = json
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    keys.sort_unstable();
    assert_eq!(keys, ["lat", "lon", "max_m", "metres_per_pixel", "min_m"]);
    assert_eq!(json["metres_per_pixel"], 625.0);
    assert_eq!(
        (&json["lat"], &json["lon"]),
        (&Value::from(-10.0), &Value::from(20.0))
    );
    let grid = square(64).heights(&Mountain, square(64).level()).unwrap();
    let [low, high] = grid.range().unwrap();
    assert_eq!(
        (json["min_m"].as_f64(), json["max_m"].as_f64()),
        (Some(low.into()), Some(high.into()))
    );
    let dem = load_dem(&files[0]).unwrap();
    let step = (high - low) / 65_535.0;
    for (found, expected) in dem.grid.values.iter().zip(&grid.values) {
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

/// The parts of a .glb file: its JSON and its binary chunk.
fn glb(bytes: &[u8]) -> (Value, &[u8]) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!(
        (&bytes[..4], word(4), word(8)),
        (&b"glTF"[..], 2, bytes.len())
    );
    assert_eq!(&bytes[16..20], b"JSON");
    let json = word(12);
    assert_eq!(&bytes[20 + json + 4..20 + json + 8], b"BIN\0");
    let start = 20 + json + 8;
    assert!(json % 4 == 0 && word(20 + json) == bytes.len() - start);
    (
        serde_json::from_slice(&bytes[20..20 + json]).unwrap(),
        &bytes[start..],
    )
}

#[test]
fn a_mesh_is_the_ground_in_metres_with_its_normals() {
    let (_folder, files) = exported("a.glb", 41);
    let bytes = fs::read(&files[0]).unwrap();
    let (json, binary) = glb(&bytes);
    let accessor = |k: usize| -> Vec<f32> {
        let view =
            &json["bufferViews"][json["accessors"][k]["bufferView"].as_u64().unwrap() as usize];
        let (start, length) = (
            view["byteOffset"].as_u64().unwrap() as usize,
            view["byteLength"].as_u64().unwrap() as usize,
        );
        binary[start..start + length]
            .chunks(4)
            .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
            .collect()
    };
    let vectors = |k: usize| -> Vec<Vec3> { accessor(k).chunks(3).map(Vec3::from_slice).collect() };
    let (positions, normals) = (vectors(0), vectors(1));
    let indices: Vec<u32> = accessor(2).iter().map(|bits| bits.to_bits()).collect();
    assert_eq!(
        (positions.len(), normals.len(), indices.len()),
        (1681, 1681, 6 * 1600)
    );
    assert_eq!(
        json["buffers"][0]["byteLength"].as_u64().unwrap() as usize,
        binary.len()
    );
    let least = positions.iter().copied().reduce(Vec3::min).unwrap();
    assert_eq!(
        json["accessors"][0]["min"][1].as_f64().unwrap() as f32,
        least.y
    );
    // The middle is the summit, above the origin; the first vertex is in the north west: -x, -z.
    assert!((positions[20 * 41 + 20] - Vec3::new(0.0, 3000.0, 0.0)).length() < 0.5);
    assert!(positions[0].x < -19_000.0 && positions[0].z < -19_000.0);
    for (i, p) in positions.iter().enumerate().step_by(29) {
        let from_centre = (p.as_dvec3() + DVec3::new(0.0, R, 0.0)).length() - R;
        let at = |k: usize| (k as f64 - 20.0) * 40_000.0 / 41.0;
        assert!((from_centre - f64::from(height(at(i % 41), -at(i / 41)))).abs() < 0.01);
    }
    // Half way down the western flank the ground falls to the west, one in five.
    let normal = normals[20 * 41 + 14];
    assert!(
        (normal.x / normal.y + 0.2).abs() < 0.01 && (normal.length() - 1.0).abs() < 1e-6,
        "{normal}"
    );
    for triangle in indices.chunks(3) {
        let [a, b, c] = [0, 1, 2].map(|k| positions[triangle[k] as usize]);
        assert!((b - a).cross(c - a).y > 0.0, "triangles face upwards");
    }
}

#[test]
fn what_cannot_be_written_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |name: &str, pixels| {
        let text = export(&Mountain, &square(pixels), &folder.path().join(name))
            .unwrap_err()
            .to_string();
        assert_eq!(text.lines().count(), 1);
        text
    };
    assert!(refused("a.bmp", 16).contains(".tif, .png or .glb"));
    assert!(refused("noname", 16).contains("noname"));
    assert!(refused("a.glb", 9000).contains("8192"));
    assert!(refused("no/folder/a.tif", 16).contains("no/folder"));
    fs::create_dir(folder.path().join("b.json")).unwrap();
    assert!(refused("b.png", 16).contains("b.json"));
    let left: Vec<_> = fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name())
        .collect();
    assert_eq!(left, ["b.json"]);
    let mut grid = square(16).heights(&Mountain, 3).unwrap();
    grid.values[5] = f32::NAN;
    assert!(matches!(
        encode(&square(16), &grid, Path::new("a.tif")),
        Err(ExportError::Encode(_))
    ));
}
