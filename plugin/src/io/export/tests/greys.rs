//! Greys and the sidecars that decode them.

use super::*;
use crate::io::load_dem;
use serde_json::Value;

/// The JSON of a file.
pub(super) fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

/// Greys of a raw file.
pub(super) fn raw(path: &Path) -> Vec<u16> {
    let bytes = fs::read(path).unwrap();
    bytes
        .as_chunks()
        .0
        .iter()
        .map(|&b| u16::from_le_bytes(b))
        .collect()
}

/// Greys of a PNG.
pub(super) fn png(path: &Path) -> Vec<u16> {
    let file = std::io::BufReader::new(fs::File::open(path).unwrap());
    let mut reader = ::png::Decoder::new(file).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    bytes
        .as_chunks()
        .0
        .iter()
        .map(|&b| u16::from_be_bytes(b))
        .collect()
}

#[test]
fn a_sidecar_says_where_its_picture_is() {
    let (folder, files) = exported("TILE.PNG", 64);
    assert_eq!(files[1], folder.path().join("TILE.json"));
    let [low, high] = heights(64).range().unwrap().map(f64::from);
    let expected = serde_json::json!({
        "generator": "Pangaea", "file": "TILE.PNG",
        "lat": -10.0, "lon": 20.0, "metres_per_pixel": 625.0, "min_m": low, "max_m": high,
    });
    assert_eq!(json(&files[1]), expected);
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

/// A ground at -7.5 m.
struct Plain;

impl Ground for Plain {
    fn radius_m(&self) -> f64 {
        R
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        checked(direction, level).map(|_| -7.5)
    }
}

#[test]
fn level_ground_is_a_picture_too() {
    let folder = tempfile::tempdir().unwrap();
    let files = export(&Plain, square(8), &folder.path().join("a.png")).unwrap();
    let json = json(&files[1]);
    assert_eq!(
        (&json["min_m"], &json["max_m"]),
        (&Value::from(-7.5), &Value::from(-7.5))
    );
    assert_eq!(png(&files[0]), [0; 64]);
}

#[test]
fn a_range_decides_what_greys_mean() {
    // A step of 0.1 m.
    let (_folder, files) = written("a.r16", square(64), Some([-1000.0, 5553.5]));
    let greys = raw(&files[0]);
    for (grey, z) in greys.iter().zip(&heights(64).values) {
        assert!((f64::from(*grey) * 0.1 - 1000.0 - f64::from(*z)).abs() <= 0.0502);
    }
    let json = json(&files[1]);
    assert_eq!(
        (&json["min_m"], &json["max_m"]),
        (&Value::from(-1000.0), &Value::from(5553.5))
    );
}

#[test]
fn ground_beyond_the_range_is_cut_off_and_it_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    assert!(is_cut_off(&path, [0.0, 9000.0]) && is_cut_off(&path, [-9000.0, 0.0]));
    let greys = png(&path);
    let is_high = heights(64).values.into_iter().map(|z| z >= 0.0);
    assert!(
        greys
            .into_iter()
            .zip(is_high)
            .all(|(grey, high)| !high || grey == 65_535)
    );
    assert!(!is_cut_off(&path, [-9000.0, 9000.0]));
}

/// Writes the mountain in greys of a range of metres; tells whether it reaches beyond it.
fn is_cut_off(path: &Path, range: [f64; 2]) -> bool {
    let job = ExportJob::new(square(64), path).unwrap();
    let done = job.with_range(range).unwrap().run(&Mountain, |_| true);
    done.unwrap().is_cut_off
}

#[test]
fn raw_files_and_pictures_have_the_same_greys() {
    let (_a, pictures) = exported("a.png", 50);
    let (_b, raws) = exported("b.raw", 50);
    assert_eq!(png(&pictures[0]), raw(&raws[0]));
    // Each tells of its own file, and of the same ground.
    let [mut picture, mut bytes] = [&pictures[1], &raws[1]].map(|path| json(path));
    assert_eq!(
        [picture["file"].take(), bytes["file"].take()],
        ["a.png", "b.raw"]
    );
    assert_eq!(picture, bytes);
}

#[test]
fn bad_ranges_are_refused() {
    let job = |name: &str| ExportJob::new(square(64), Path::new(name)).unwrap();
    for range in [
        [5.0, 5.0],
        [9.0, -9.0],
        [f64::NAN, 1.0],
        [0.0, f64::INFINITY],
    ] {
        let refused = job("a.png").with_range(range);
        assert!(matches!(refused, Err(ExportError::Range(..))));
    }
    for name in ["a.tif", "a.exr", "a.glb"] {
        let refused = job(name).with_range([0.0, 1.0]);
        assert!(matches!(refused, Err(ExportError::NoGreys(_))));
    }
}
