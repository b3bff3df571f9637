//! Blocks of tiles: neighbours meet, and engines put them where they belong.

use super::geotiff::read;
use super::greys::{json, png, raw};
use super::mesh::Glb;
use super::*;
use crate::query::TileBlock;
use serde_json::Value;

/// Vertices to the side of a tile of 4 km: 250 m apart.
const N: usize = 17;

/// Two columns and three rows about the mountain.
fn block() -> TileBlock {
    let about = AzimuthalEquidistant::new(-10.0, 20.0, R).unwrap();
    TileBlock::new(about, 4000.0, N, [2, 3]).unwrap()
}

/// The files of a column and row in a list of tiles.
fn tile(files: &[PathBuf], column: usize, row: usize) -> &Path {
    &files[row * 2 + column]
}

fn column<T: Copy>(values: &[T], x: usize) -> Vec<T> {
    values.iter().skip(x).step_by(N).copied().collect()
}

fn row<T: Copy>(values: &[T], y: usize) -> Vec<T> {
    values[y * N..(y + 1) * N].to_vec()
}

/// Asserts that neighbouring tiles have the same values along the edge they share.
fn assert_meets<T: Copy + PartialEq + std::fmt::Debug>(read: impl Fn(usize, usize) -> Vec<T>) {
    for y in 0..3 {
        assert_eq!(column(&read(0, y), N - 1), column(&read(1, y), 0));
    }
    for (x, y) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        assert_eq!(row(&read(x, y), N - 1), row(&read(x, y + 1), 0));
    }
}

#[test]
fn tiles_are_named_by_column_and_row_from_the_north_west() {
    let (folder, files) = written("t.tif", block(), None);
    let names = [
        "t_0_0.tif",
        "t_1_0.tif",
        "t_0_1.tif",
        "t_1_1.tif",
        "t_0_2.tif",
        "t_1_2.tif",
    ];
    assert_eq!(files[..6], names.map(|name| folder.path().join(name)));
    assert_eq!(files[6..], [folder.path().join("t.json")]);
}

#[test]
fn edges_are_shared_to_the_last_bit_in_every_format() {
    let (_a, files) = written("t.tif", block(), None);
    assert_meets(|x, y| read(tile(&files, x, y)).2);
    let (_b, files) = written("t.png", block(), None);
    assert_meets(|x, y| png(tile(&files, x, y)));
    let (_c, files) = written("t.r16", block(), None);
    assert_meets(|x, y| raw(tile(&files, x, y)));
    let (_d, files) = written("t.glb", block(), None);
    let mesh = |x, y| Glb::read(&fs::read(tile(&files, x, y)).unwrap());
    assert_meets(|x, y| mesh(x, y).positions);
    assert_meets(|x, y| mesh(x, y).normals);
}

#[test]
fn a_tile_is_the_ground_where_it_says_it_is() {
    let (_folder, files) = written("t.tif", block(), None);
    let (tags, size, values) = read(tile(&files, 1, 2));
    assert_eq!(size, (17, 17));
    assert_eq!(tags.scale, [250.0, 250.0, 0.0]);
    // The first vertex; the raster's points are points.
    assert_eq!(tags.tie, [0.0, 0.0, 0.0, 0.0, -2000.0, 0.0]);
    assert!(tags.keys.contains(&[1025, 0, 1, 2]));
    assert_eq!((tags.double(3088), tags.double(3089)), (20.0, -10.0));
    assert!((values[3 * N + 5] - height(1250.0, -2750.0)).abs() < 1e-3);
}

/// Heights of a file of greys by its figures in an engine: `(grey, figures, placement)`.
fn assert_heights(files: &[PathBuf], z: impl Fn(f64, &Value) -> f64) {
    let manifest = json(files.last().unwrap());
    for (k, entry) in manifest["files"].as_array().unwrap().iter().enumerate() {
        let (west, north) = (number(&entry["west_m"]), number(&entry["north_m"]));
        for (i, grey) in raw(&files[k]).into_iter().enumerate().step_by(7) {
            let (x, y) = ((i % N) as f64 * 250.0, (i / N) as f64 * 250.0);
            let expected = f64::from(height(west + x, north - y));
            let found = z(f64::from(grey), entry);
            // Half a step of 65,535 in 3.4 km.
            assert!((found - expected).abs() < 0.03, "{found} {expected}");
        }
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

#[test]
fn unreal_has_the_height_of_every_grey() {
    let (_folder, files) = written("t.r16", block(), None);
    let manifest = json(files.last().unwrap());
    let scale = manifest["engines"]["unreal"]["scale"].clone();
    assert_eq!(
        (&scale[0], &scale[1]),
        (&Value::from(25_000.0), &Value::from(25_000.0))
    );
    assert_heights(&files, |grey, tile| {
        let up = number(&tile["engines"]["unreal"][2]);
        ((grey - 32_768.0) / 128.0 * number(&scale[2]) + up) / 100.0
    });
    // x east, y south, in cm.
    let corner = &manifest["files"][5]["engines"]["unreal"];
    assert_eq!((number(&corner[0]), number(&corner[1])), (0.0, 200_000.0));
}

#[test]
fn unity_has_the_height_of_every_grey() {
    let (_folder, files) = written("t.raw", block(), None);
    let manifest = json(files.last().unwrap());
    let unity = manifest["engines"]["unity"].clone();
    assert_eq!(unity["heightmap_resolution"], 17);
    let size = unity["terrain_size"].clone();
    assert_eq!((number(&size[0]), number(&size[2])), (4000.0, 4000.0));
    assert_heights(&files, |grey, tile| {
        let ground = number(&tile["engines"]["unity"][1]);
        grey / 65_536.0 * number(&size[1]) + ground
    });
    // x east, z north, of the south western corner.
    let corner = &manifest["files"][5]["engines"]["unity"];
    assert_eq!((number(&corner[0]), number(&corner[2])), (0.0, -6000.0));
}

#[test]
fn godot_and_blender_have_their_places() {
    let (_a, files) = written("t.r16", block(), Some([-1000.0, 4000.0]));
    let manifest = json(files.last().unwrap());
    let godot = &manifest["engines"]["godot"];
    assert_eq!(godot["r16_range"], serde_json::json!([-1000.0, 4000.0]));
    assert_eq!(godot["vertex_spacing"], 250.0);
    let corner = &manifest["files"][1]["engines"]["godot"];
    assert_eq!(*corner, serde_json::json!([0.0, 0.0, -6000.0]));
    let (_b, files) = written("t.exr", block(), None);
    let manifest = json(files.last().unwrap());
    assert_eq!(manifest["engines"]["blender"]["displace_strength"], 1.0);
    let middle = &manifest["files"][5]["engines"]["blender"];
    assert_eq!(*middle, serde_json::json!([2000.0, -4000.0, 0.0]));
}

#[test]
fn every_format_has_its_place_in_every_engine() {
    for name in ["t.tif", "t.exr", "t.glb"] {
        let (_folder, files) = written(name, block(), None);
        let manifest = json(files.last().unwrap());
        assert_eq!(manifest["sea_level_m"], 0.0);
        for engine in ["unreal", "unity", "godot", "blender"] {
            assert!(manifest["engines"][engine].is_object(), "{name}, {engine}");
            let place = &manifest["files"][5]["engines"][engine];
            assert_eq!(place.as_array().unwrap().len(), 3, "{name}, {engine}");
        }
        // Heights in metres: sea level is at 0, in Unreal too.
        let unreal = &manifest["files"][5]["engines"]["unreal"];
        assert_eq!(unreal[2], 0.0);
    }
}

#[test]
fn formats_of_one_name_do_not_take_each_others_texts() {
    let (folder, files) = written("t.png", block(), None);
    let manifest = fs::read(files.last().unwrap()).unwrap();
    let path = folder.path().join("t.r16");
    let refused = ExportJob::new(block(), &path)
        .unwrap()
        .run(&Mountain, |_| true);
    let problem = refused.unwrap_err().to_string();
    assert!(
        problem.contains("another format") && problem.contains(".json"),
        "{problem}"
    );
    assert_eq!(fs::read(files.last().unwrap()).unwrap(), manifest);
    let again = ExportJob::new(block(), &folder.path().join("t.png")).unwrap();
    assert!(again.run(&Mountain, |_| true).is_ok());
}

#[test]
fn the_manifest_tells_the_range_of_all_and_the_sea() {
    let (_folder, files) = written("t.png", block(), None);
    let manifest = json(files.last().unwrap());
    for k in 0..6 {
        let sidecar = json(&files[6 + k]);
        assert_eq!(
            (&sidecar["min_m"], &sidecar["max_m"]),
            (&manifest["min_m"], &manifest["max_m"])
        );
        assert_eq!(sidecar["metres_per_pixel"], 250.0);
    }
    let [low, high] = [number(&manifest["min_m"]), number(&manifest["max_m"])];
    let sea = number(&manifest["sea_level_grey"]);
    assert!((low + sea / 65_535.0 * (high - low)).abs() < 1e-6);
    let pixels = (0..6).flat_map(|k| png(&files[k]));
    let (least, most) = pixels.fold((u16::MAX, 0), |(a, b), grey| (a.min(grey), b.max(grey)));
    assert_eq!((least, most), (0, 65_535));
}

#[test]
fn a_tile_that_was_changed_is_not_written_over() {
    for name in ["t.tif", "t.png", "t.r16", "t.exr", "t.glb"] {
        let (folder, files) = written(name, block(), None);
        let job = ExportJob::new(block(), &folder.path().join(name)).unwrap();
        job.run(&Mountain, |_| true).unwrap();
        // The mark of its format stays.
        let edited = [fs::read(&files[1]).unwrap(), vec![0; 4]].concat();
        fs::write(&files[1], &edited).unwrap();
        let problem = job.run(&Mountain, |_| true).unwrap_err().to_string();
        let named = files[1].file_name().unwrap().to_string_lossy();
        assert!(
            problem.contains(&*named) && problem.contains("was changed"),
            "{problem}"
        );
        assert_eq!(fs::read(&files[1]).unwrap(), edited, "{name}");
        fs::remove_file(&files[1]).unwrap();
        job.run(&Mountain, |_| true).unwrap();
    }
}
