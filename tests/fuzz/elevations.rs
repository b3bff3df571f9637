//! Elevation models of real ground.

use super::pictures::{JSON_WORDS, PNG_WORDS, Place, TIFF_WORDS, geotiffs, mended, pngs};
use bevy_pangaea::io::load_dem;
use pangaea_tests::fuzz::{Format, fuzz};
use std::fs;
use std::path::Path;

const SIZE: [u32; 2] = [9, 7];

const SIDECARS: [&str; 2] = [
    "{\"metres_per_pixel\": 30, \"min_m\": -12.5, \"max_m\": 4000, \"lat\": 46, \"lon\": 7}",
    "{\"metres_per_pixel\": 90.5, \"metres_per_unit\": 0.1}",
];

/// Loads a tile; one that is accepted has a height at every pixel, and pixels have a size.
pub(super) fn read(path: &Path) {
    match load_dem(path) {
        Ok(tile) => {
            let grid = &tile.grid;
            assert_eq!(grid.values.len(), grid.width * grid.height);
            assert!(grid.values.iter().all(|z| z.abs() <= 1e6));
            assert!(
                grid.pixel_m
                    .iter()
                    .all(|side| side.is_finite() && *side > 0.0)
            );
        }
        Err(error) => assert!(!error.to_string().contains('\n'), "{error}"),
    }
}

#[test]
fn damaged_geotiffs_are_refused_or_have_heights() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tile.tif");
    let degrees = Place {
        pixel: 0.001,
        corner: [7.0, 46.0],
        is_geographic: true,
    };
    let metres = Place {
        pixel: 30.0,
        corner: [4e5, 5e6],
        is_geographic: false,
    };
    let format = Format {
        name: "GeoTIFF tiles",
        good: [geotiffs(SIZE, degrees), geotiffs(SIZE, metres)].concat(),
        words: TIFF_WORDS,
    };
    fuzz(&format, |bytes| {
        fs::write(&path, bytes).unwrap();
        read(&path);
    });
}

#[test]
fn damaged_grey_tiles_are_refused_or_have_heights() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tile.png");
    fs::write(path.with_extension("json"), SIDECARS[0]).unwrap();
    let format = Format {
        name: "grey tiles",
        good: pngs(SIZE),
        words: PNG_WORDS,
    };
    fuzz(&format, |bytes| {
        fs::write(&path, mended(bytes)).unwrap();
        read(&path);
    });
}

#[test]
fn damaged_sidecars_of_tiles_are_refused_or_scale_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("tile.png");
    fs::write(&path, &pngs(SIZE)[0]).unwrap();
    let format = Format {
        name: "sidecars of tiles",
        good: SIDECARS.map(|text| text.as_bytes().to_vec()).to_vec(),
        words: JSON_WORDS,
    };
    fuzz(&format, |bytes| {
        fs::write(path.with_extension("json"), bytes).unwrap();
        read(&path);
    });
}

/// Values to a row, and rows, of the smaller of SRTM's tiles.
const SRTM_SIDE: usize = 1201;

/// Names are damaged. One in five hundred is a good one instead, of a whole tile with the damaged
/// name in its heights.
#[test]
fn damaged_hgt_tiles_and_names_are_refused_or_have_heights() {
    const WHOLE: usize = 500;
    let folder = tempfile::tempdir().unwrap();
    let format = Format {
        name: "HGT tiles",
        good: ["N44W072", "s05e170", "N00E000", "S90W180"]
            .map(|name| name.as_bytes().to_vec())
            .to_vec(),
        words: &["N", "S", "E", "W", "90", "180", "-1", "é", "."],
    };
    let mut count = 0;
    fuzz(&format, |bytes| {
        count += 1;
        let (name, content) = if count % WHOLE == 0 {
            ("N44W072".into(), tile(bytes))
        } else {
            (file_name(bytes), bytes.to_vec())
        };
        let path = folder.path().join(format!("{name}.hgt"));
        if fs::write(&path, content).is_ok() {
            read(&path);
            fs::remove_file(&path).unwrap();
        }
    });
}

/// A text that a file can be named by, without line breaks, which messages would repeat.
fn file_name(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes);
    let is_bad = |c: char| c == '/' || c.is_control();
    text.replace(is_bad, "_")
}

/// A tile that repeats `bytes`, with voids in rows between.
pub(super) fn tile(bytes: &[u8]) -> Vec<u8> {
    let row: Vec<u8> = bytes
        .iter()
        .copied()
        .chain([1])
        .cycle()
        .take(2 * SRTM_SIDE)
        .collect();
    let void = [0x80, 0].repeat(SRTM_SIDE);
    let rows = (0..SRTM_SIDE).flat_map(|y| {
        if y % 3 == 0 {
            void.clone()
        } else {
            row.clone()
        }
    });
    rows.collect()
}
