//! Maps of the whole planet.

use super::pictures::{JSON_WORDS, PNG_WORDS, Place, TIFF_WORDS, geotiffs, mended, pngs};
use bevy_pangaea::io::load_map;
use bevy_pangaea::math::direction;
use pangaea_tests::fuzz::{Format, fuzz};
use std::fs;
use std::path::Path;

const SIZE: [u32; 2] = [8, 4];

/// A whole planet, from -180 and 90 on.
const WHOLE: Place = Place {
    pixel: 45.0,
    corner: [-180.0, 90.0],
    is_geographic: true,
};

/// Loads a map; one that is accepted has a number wherever it is not void, and somewhere at all.
fn read(path: &Path, grey: Option<[f32; 2]>) {
    match load_map(path, grey) {
        Ok(map) => {
            let [width, height] = map.size();
            assert_eq!(width, 2 * height);
            assert!(map.voids() < width as usize * height as usize);
            for (lat, lon) in [(90.0, 0.0), (12.0, -180.0), (-45.0, 77.0), (-90.0, 180.0)] {
                assert!(map.at(direction(lat, lon)).is_none_or(f32::is_finite));
            }
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
}

#[test]
fn damaged_geotiff_maps_are_refused_or_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.tif");
    let format = Format {
        name: "GeoTIFF maps",
        good: geotiffs(SIZE, WHOLE),
        words: TIFF_WORDS,
    };
    fuzz(&format, |bytes| {
        fs::write(&path, bytes).unwrap();
        read(&path, None);
    });
}

#[test]
fn damaged_grey_maps_are_refused_or_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.png");
    let format = Format {
        name: "grey maps",
        good: pngs(SIZE),
        words: PNG_WORDS,
    };
    fuzz(&format, |bytes| {
        fs::write(&path, mended(bytes)).unwrap();
        read(&path, Some([-40.0, 35.0]));
    });
}

#[test]
fn damaged_sidecars_of_maps_are_refused_or_finite() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.png");
    fs::write(&path, &pngs(SIZE)[0]).unwrap();
    let format = Format {
        name: "sidecars of maps",
        good: vec![b"{\"min\": -40, \"max\": 35.5}".to_vec()],
        words: JSON_WORDS,
    };
    fuzz(&format, |bytes| {
        fs::write(path.with_extension("json"), bytes).unwrap();
        read(&path, None);
    });
}
