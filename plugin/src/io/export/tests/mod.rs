mod boxes;
mod exr;
mod geotiff;
mod greys;
mod mesh;
mod tiles;

use super::*;
use crate::math;
use crate::query::{AzimuthalEquidistant, GroundError, HeightGrid, MapSquare, checked};
use bevy::math::{DVec2, DVec3};
use std::fs;

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
    written(name, square(pixels), None)
}

/// A folder with the files of an area of the mountain, and their paths.
fn written(
    name: &str,
    area: impl Into<ExportArea>,
    range: Option<[f64; 2]>,
) -> (tempfile::TempDir, Vec<PathBuf>) {
    let folder = tempfile::tempdir().unwrap();
    let mut job = ExportJob::new(area, &folder.path().join(name)).unwrap();
    if let Some(range) = range {
        job = job.with_range(range).unwrap();
    }
    let files = job.run(&Mountain, |_| true).unwrap().files;
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

/// Why a square cannot be exported to a file of that name.
fn refusal(folder: &Path, name: &str, pixels: usize) -> String {
    let error = export(&Mountain, square(pixels), &folder.join(name)).unwrap_err();
    let text = error.to_string();
    assert_eq!(text.lines().count(), 1);
    text
}

#[test]
fn files_that_cannot_be_written_are_refused_and_leave_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let refusal = |name, pixels| refusal(folder.path(), name, pixels);
    assert!(refusal("a.bmp", 16).contains(".tif, .png, .r16, .raw, .exr or .glb"));
    assert!(refusal("noname", 16).contains("noname"));
    assert!(refusal("a.glb", 9000).contains("8192"));
    assert!(refusal("no/folder/a.tif", 16).contains("no/folder"));
    fs::create_dir(folder.path().join("b.json")).unwrap();
    assert!(refusal("b.png", 16).contains("b.json"));
    let left = fs::read_dir(folder.path()).unwrap();
    let left: Vec<_> = left.map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["b.json"]);
}

/// A ground without a height in the east.
struct Holed;

impl Ground for Holed {
    fn radius_m(&self) -> f64 {
        R
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let (_, lon) = math::lat_lon(checked(direction, level)?);
        Ok(if lon > 20.0 { f32::NAN } else { 0.0 })
    }
}

#[test]
fn heights_that_are_nan_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let refused = export(&Holed, square(16), &folder.path().join("a.tif"));
    assert!(matches!(refused, Err(ExportError::Encode(_))));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn an_export_that_is_stopped_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let job = ExportJob::new(square(100), &folder.path().join("a.png")).unwrap();
    // While heights are asked for, and while the files are written.
    for most in [5000, 9999] {
        assert!(job.run(&Mountain, |points| points <= most).is_err());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}

#[test]
fn the_level_can_be_chosen() {
    let job = ExportJob::new(square(100), Path::new("a.png")).unwrap();
    assert_eq!(job.grid().level(), square(100).level());
    assert_eq!(job.clone().at_level(3).unwrap().grid().level(), 3);
    assert!(job.at_level(18).is_err());
}
