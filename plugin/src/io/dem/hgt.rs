//! SRTM's *.hgt: rows of big-endian i16 in m, a degree wide and high; -32768 is a void. The name
//! says where the centre of the south west value is.

use super::error::{DemError, invalid};
use super::geotiff::PamFile;
use super::shrink::ShrunkRaster;
use super::tile::{Dem, degrees_to_metres};
use std::io::Read;

const VOID: i16 = -32_768;

/// Values to a row, and rows: one every three arc seconds, every second, every half second; from 50
/// degrees north on some files have one every two seconds along a row and every second down.
const SIZES: [[u32; 2]; 4] = [[1201, 1201], [1801, 3601], [3601, 3601], [7201, 7201]];

/// Reads a file of this name and of so many bytes.
pub(super) fn read(name: &str, length: u64, mut source: impl Read) -> Result<Dem, DemError> {
    let (south, west) = corner(name).ok_or(DemError::HgtName)?;
    let bytes = |size: &[u32; 2]| 2 * u64::from(size[0]) * u64::from(size[1]);
    let size = SIZES.into_iter().find(|size| bytes(size) == length);
    let size = size.ok_or(DemError::HgtSize(length))?;
    let mut raster = ShrunkRaster::new(size, [false; 2])?;
    let mut row = vec![0; 2 * size[0] as usize];
    for y in 0..size[1] as usize {
        source.read_exact(&mut row).map_err(unread)?;
        let (pairs, _) = row.as_chunks();
        let heights: Vec<f32> = pairs.iter().map(|&pair| height(pair)).collect();
        raster.add(y * heights.len(), &heights);
    }
    // An archive checks its sum at the end.
    if source.read(&mut [0]).map_err(unread)? > 0 {
        return Err(DemError::HgtSize(length + 1));
    }
    let steps = size.map(|side| 1.0 / f64::from(side - 1));
    let centre = (south + 0.5, west + 0.5);
    let pixel_m = degrees_to_metres(steps, centre.0)?;
    raster.finish(pixel_m, Some(centre))
}

/// Is there a corner in a name?
pub(super) fn is_name(name: &str) -> bool {
    corner(name).is_some()
}

fn unread(error: std::io::Error) -> DemError {
    invalid(format!("the file cannot be read: {error}"))
}

/// Refuses a side file that names another void.
pub(super) fn check_void(pam: &PamFile) -> Result<(), DemError> {
    match pam.void() {
        Some(void) if void != f64::from(VOID) => Err(invalid(format!(
            "the void {void} of its .aux.xml is not that of .hgt files, {VOID}"
        ))),
        _ => Ok(()),
    }
}

fn height(bytes: [u8; 2]) -> f32 {
    match i16::from_be_bytes(bytes) {
        VOID => f32::NAN,
        z => f32::from(z),
    }
}

/// Letters and digits of a corner.
const CORNER_LEN: usize = 7;

/// Latitude and longitude of the south west corner in degrees: the first corner that stands in a
/// name, at its beginning or behind a sign. Archives put their own names before and behind,
/// browsers and file managers the number of a copy.
fn corner(name: &str) -> Option<(f64, f64)> {
    let name = name.as_bytes();
    let begins = |at: usize| at == 0 || !name[at - 1].is_ascii_alphanumeric();
    let ends = |at: usize| !name.get(at).is_some_and(u8::is_ascii_digit);
    (0..name.len())
        .filter(|&at| begins(at) && ends(at + CORNER_LEN))
        .find_map(|at| corner_of(name.get(at..at + CORNER_LEN)?))
}

/// The corner that seven letters and digits mean.
fn corner_of(text: &[u8]) -> Option<(f64, f64)> {
    let lat = coordinate(&text[..3], b'N', b'S')?;
    let lon = coordinate(&text[3..], b'E', b'W')?;
    ((-90.0..90.0).contains(&lat) && (-180.0..180.0).contains(&lon)).then_some((lat, lon))
}

/// A letter for the sign, in either case, and digits.
fn coordinate(text: &[u8], plus: u8, minus: u8) -> Option<f64> {
    let (&letter, digits) = text.split_first()?;
    if !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    let value = (digits.iter()).fold(0.0, |n, digit| 10.0 * n + f64::from(digit - b'0'));
    match letter.to_ascii_uppercase() {
        l if l == plus => Some(value),
        l if l == minus => Some(-value),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_corners() {
        assert_eq!(corner("N44W072.hgt"), Some((44.0, -72.0)));
        assert_eq!(corner("s05e170.HGT"), Some((-5.0, 170.0)));
        for bad in [
            "", "N44W72", "N4aW072", "X44W072", "N44W0723", "aN44W072", "N90E000", "N00E180",
            "N44é072", "é",
        ] {
            assert_eq!(corner(bad), None, "{bad}");
        }
    }

    #[test]
    fn archives_browsers_and_file_managers_may_add_to_names() {
        for name in [
            "N44W072.SRTMGL1.hgt",
            "N44W072.SRTMGL1.2.hgt",
            "N44W072 (1).hgt",
            "N44W072.hgt (1)",
            "N44W072.hgt.1",
            "N44W072_1.hgt",
            "N44W072 - Copy.hgt",
            "Copy of N44W072.hgt",
            "n44w072v3.hgt",
            "NASADEM_HGT_n44w072.hgt",
            "USGS_N44W072_dem.hgt",
        ] {
            assert_eq!(corner(name), Some((44.0, -72.0)), "{name}");
        }
    }

    /// A file of so many values, all 0 but for the first three: 258 m, a void, -2 m.
    fn file(size: usize) -> Vec<u8> {
        let mut bytes = vec![0_u8; 2 * size];
        bytes[..6].copy_from_slice(&[0x01, 0x02, 0x80, 0x00, 0xff, 0xfe]);
        bytes
    }

    fn read(name: &str, bytes: &[u8]) -> Result<Dem, DemError> {
        super::read(name, bytes.len() as u64, bytes)
    }

    #[test]
    fn values_are_big_endian_metres_and_voids_are_filled() {
        let dem = read("N44W072", &file(1201 * 1201)).unwrap();
        assert_eq!((dem.grid.width, dem.grid.height), (1201, 1201));
        assert_eq!((dem.grid.values[0], dem.grid.values[2]), (258.0, -2.0));
        assert_eq!(dem.voids, 1);
        assert!((dem.grid.values[1] - 256.0 / 5.0).abs() < 1e-4);
    }

    #[test]
    fn every_size_spans_a_degree_both_ways() {
        // A second of arc is 30.887 m down, and half of that across at 60 degrees north.
        for (columns, rows, seconds) in [
            (1201, 1201, [3.0, 3.0]),
            (1801, 3601, [2.0, 1.0]),
            (3601, 3601, [1.0, 1.0]),
            (7201, 7201, [0.5, 0.5]),
        ] {
            let dem = read("N59E010", &file(columns * rows)).unwrap();
            assert_eq!(dem.pixels, [columns, rows]);
            assert_eq!(dem.is_shrunk(), columns == 7201);
            let share = dem.grid.width as f64 / columns as f64;
            let [across, down] = dem.grid.pixel_m.map(|side| side * share);
            let cosine = 0.507_538_4; // of 59.5 degrees
            assert!((down - seconds[1] * 30.887_3).abs() < 1e-3, "{down}");
            assert!(
                (across - seconds[0] * 30.887_3 * cosine).abs() < 1e-3,
                "{across}"
            );
            assert_eq!(dem.centre, Some((59.5, 10.5)));
        }
    }

    #[test]
    fn other_files_are_refused() {
        let bytes = file(1201 * 1201);
        let short = read("N44W072", &bytes[1..]);
        assert_eq!(short, Err(DemError::HgtSize(bytes.len() as u64 - 1)));
        assert_eq!(read("Matterhorn", &bytes), Err(DemError::HgtName));
        let voids = [0x80, 0x00].repeat(1201 * 1201);
        assert_eq!(read("N44W072", &voids), Err(DemError::OnlyVoids));
    }
}
