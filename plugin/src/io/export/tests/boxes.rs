//! Boxes of degrees as files.

use super::geotiff::read;
use super::greys::json;
use super::*;
use crate::query::DegreeBox;

/// Heights in m that are the degrees east, from -180 to 180.
struct Meridians;

impl Ground for Meridians {
    fn radius_m(&self) -> f64 {
        R
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        Ok(math::lat_lon(checked(direction, level)?).1 as f32)
    }
}

fn degrees(bounds: [f64; 4], pixels: [usize; 2]) -> DegreeBox {
    DegreeBox::new(bounds, R, pixels).unwrap()
}

#[test]
fn a_geotiff_of_a_box_is_in_degrees_on_the_sphere_of_the_planet() {
    let planet = degrees([-90.0, -180.0, 90.0, 180.0], [72, 36]);
    let (_folder, files) = written("a.tif", planet, None);
    let (tags, size, _) = read(&files[0]);
    assert_eq!(size, (72, 36));
    assert_eq!(tags.scale, [5.0, 5.0, 0.0]);
    assert_eq!(tags.tie, [0.0, 0.0, 0.0, -180.0, 90.0, 0.0]);
    // Geographic, areas, degrees; no projection.
    for (key, value) in [(1024, 2), (1025, 1), (2054, 9102), (2051, 8901)] {
        assert!(tags.keys.contains(&[key, 0, 1, value]), "{key}");
    }
    assert!(tags.keys.iter().all(|key| key[0] < 3072 || key[0] == 4099));
    assert_eq!((tags.double(2057), tags.double(2058)), (R, R));
}

#[test]
fn a_box_goes_on_across_the_date_line() {
    let folder = tempfile::tempdir().unwrap();
    let across = degrees([-20.0, 170.0, -10.0, -170.0], [20, 10]);
    let files = export(&Meridians, across, &folder.path().join("a.tif")).unwrap();
    let (tags, _, values) = read(&files[0]);
    assert_eq!(tags.tie[3..5], [170.0, -10.0]);
    for (x, lon) in values[..20].iter().enumerate() {
        let expected = 170.5 + x as f32 - if x < 10 { 0.0 } else { 360.0 };
        assert!((lon - expected).abs() < 1e-3, "{x} {lon}");
    }
}

#[test]
fn a_box_reaches_the_poles() {
    let cap = degrees([80.0, -180.0, 90.0, 180.0], [36, 10]);
    let (_folder, files) = written("a.tif", cap, None);
    let (_, _, values) = read(&files[0]);
    // 10 m to the kilometre from 10° S, and a shelf at -200 m.
    let north = |lat: f64| (-200.0 + 0.01 * R * (lat + 10.0).to_radians()) as f32;
    assert!(values[..36].iter().all(|z| (z - north(89.5)).abs() < 0.01));
    assert!((values[9 * 36] - north(80.5)).abs() < 0.01);
}

/// Takes a number out of an object.
fn take(json: &mut serde_json::Value, key: &str) -> f64 {
    let taken = json.as_object_mut().unwrap().remove(key);
    taken.unwrap().as_f64().unwrap()
}

#[test]
fn the_sidecar_of_a_box_tells_its_bounds() {
    let pixels = degrees([-20.0, 170.0, -10.0, -170.0], [40, 10]);
    let (_folder, files) = written("a.png", pixels, Some([-500.0, 500.0]));
    let mut found = json(&files[1]);
    // A degree is 52.36 km long, and at 15° S 0.9659 of that from west to east.
    let keys = ["metres_per_pixel", "metres_per_pixel_across", "lat", "lon"];
    let [down, across, lat, lon] = keys.map(|key| take(&mut found, key));
    assert!((down - 52_359.877_56).abs() < 1e-3, "{down}");
    assert!(
        (across - 0.5 * 0.965_925_826_3 * 52_359.877_56).abs() < 1e-3,
        "{across}"
    );
    assert!((lat + 15.0).abs() < 1e-9 && (lon.abs() - 180.0).abs() < 1e-9);
    let expected = serde_json::json!({
        "generator": "Pangaea", "file": "a.png",
        "min_m": -500.0, "max_m": 500.0, "degrees_per_pixel": [0.5, 1.0],
        "south": -20.0, "west": 170.0, "north": -10.0, "east": 190.0,
    });
    assert_eq!(found, expected);
}

#[test]
fn a_box_is_no_mesh() {
    let planet = degrees([-90.0, -180.0, 90.0, 180.0], [72, 36]);
    let refused = ExportJob::new(planet, Path::new("a.glb"));
    assert!(matches!(refused, Err(ExportError::MeshOfBox)));
}
