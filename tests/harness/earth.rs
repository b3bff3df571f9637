//! Earth's relief, where it is present: averaged ETOPO at 20 minutes.

use bevy_pangaea::climate::EquirectMap;
use flate2::read::GzDecoder;
use std::fs::File;
use std::io::Read;
use std::path::PathBuf;

/// Rows and columns of the file: cell centres, latitude from -89.83, longitude from 20.17, one
/// column twice.
const SIZE: (usize, usize) = (540, 1081);

/// Elevation of the Earth in km; `None`, and a line on stderr, where the file is missing. The
/// folder is `PANGAEA_DATA`, or `../shared/data` beside the workspace.
pub fn earth() -> Option<EquirectMap> {
    let beside = || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../shared/data");
    let folder = std::env::var_os("PANGAEA_DATA").map_or_else(beside, PathBuf::from);
    let path = folder.join("earth/etopo20data.gz");
    let Ok(file) = File::open(&path) else {
        eprintln!("skipped: {} is missing", path.display());
        return None;
    };
    let metres = numbers(file);
    assert_eq!(metres.len(), SIZE.0 * SIZE.1);
    let height_km = |lat, lon| metres[pixel(lat, lon)] / 1000.0;
    Some(EquirectMap::from_fn(SIZE.0 as u32, height_km).expect("540 rows"))
}

/// All numbers of a gzipped text.
fn numbers(file: File) -> Vec<f32> {
    let mut text = String::new();
    let read = GzDecoder::new(file).read_to_string(&mut text);
    read.expect("the relief is gzipped text");
    let words = text.split_ascii_whitespace();
    words.map(|word| word.parse().expect("a number")).collect()
}

/// Place in the file of a point at the middle of a pixel.
fn pixel(lat: f64, lon: f64) -> usize {
    let row = ((lat + 90.0) * 3.0 - 0.5).round() as usize;
    let column = ((lon - 20.0).rem_euclid(360.0) * 3.0 - 0.5).round() as usize;
    row.min(SIZE.0 - 1) * SIZE.1 + column.min(SIZE.1 - 1)
}
