//! SRTM's *.hgt: 1201 or 3601 rows of as many big-endian i16 in m, a degree wide; -32768 is a void.
//! The name says where the centre of the south west value is.

use super::error::DemError;
use super::tile::{Dem, degrees_to_metres};

const VOID: i16 = -32_768;

/// Bytes of a file with a value every three arc seconds, and every arc second.
const SRTM3_BYTES: usize = 2 * 1201 * 1201;
const SRTM1_BYTES: usize = 2 * 3601 * 3601;

/// Reads the content of a file of this name without extension.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Dem, DemError> {
    let (south, west) = corner(name).ok_or(DemError::HgtName)?;
    let side: u32 = match bytes.len() {
        SRTM3_BYTES => 1201,
        SRTM1_BYTES => 3601,
        other => return Err(DemError::HgtSize(other)),
    };
    let (pairs, _) = bytes.as_chunks();
    let values = pairs.iter().map(|&pair| height(pair)).collect();
    let step = 1.0 / f64::from(side - 1);
    let centre = (south + 0.5, west + 0.5);
    let pixel_m = degrees_to_metres([step, step], centre.0)?;
    Dem::new([side, side], values, pixel_m, Some(centre))
}

fn height(bytes: [u8; 2]) -> f32 {
    match i16::from_be_bytes(bytes) {
        VOID => f32::NAN,
        z => f32::from(z),
    }
}

/// Latitude and longitude of the south west corner in degrees.
fn corner(name: &str) -> Option<(f64, f64)> {
    let name = name.as_bytes();
    if name.len() != 7 {
        return None;
    }
    let lat = coordinate(&name[..3], b'N', b'S')?;
    let lon = coordinate(&name[3..], b'E', b'W')?;
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
        assert_eq!(corner("N44W072"), Some((44.0, -72.0)));
        assert_eq!(corner("s05e170"), Some((-5.0, 170.0)));
        for bad in [
            "", "N44W72", "N4aW072", "X44W072", "N44W072x", "N90E000", "N00E180", "N44é072",
        ] {
            assert_eq!(corner(bad), None, "{bad}");
        }
    }

    #[test]
    fn values_are_big_endian_metres_and_voids_are_filled() {
        let mut bytes = vec![0_u8; SRTM3_BYTES];
        bytes[..6].copy_from_slice(&[0x01, 0x02, 0x80, 0x00, 0xff, 0xfe]);
        let dem = read("N44W072", &bytes).unwrap();
        assert_eq!((dem.grid.width, dem.grid.height), (1201, 1201));
        assert_eq!((dem.grid.values[0], dem.grid.values[2]), (258.0, -2.0));
        assert_eq!(dem.voids, 1);
        assert!((dem.grid.values[1] - 256.0 / 5.0).abs() < 1e-4);
    }

    #[test]
    fn pixels_are_three_arc_seconds_about_the_middle_of_a_degree() {
        let dem = read("N44W072", &vec![0; SRTM3_BYTES]).unwrap();
        assert_eq!(dem.centre, Some((44.5, -71.5)));
        let [across, down] = dem.grid.pixel_m;
        assert!((down - 92.66).abs() < 0.01 && (across - 66.09).abs() < 0.01);
    }

    #[test]
    fn other_files_are_refused() {
        let bytes = vec![0; SRTM3_BYTES];
        let short = read("N44W072", &bytes[1..]);
        assert_eq!(short, Err(DemError::HgtSize(SRTM3_BYTES - 1)));
        assert_eq!(read("Matterhorn", &bytes), Err(DemError::HgtName));
        let voids = [0x80, 0x00].repeat(1201 * 1201);
        assert_eq!(read("N44W072", &voids), Err(DemError::OnlyVoids));
    }
}
