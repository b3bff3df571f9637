//! SRTM's *.hgt: 1201 or 3601 rows of as many big-endian i16 in m, a degree wide; -32768 is a void.
//! The name says where the centre of the south west value is.

use super::{Dem, DemError, degrees_to_metres, filled};

const VOID: i16 = -32_768;

/// Reads the content of a file of this name without extension.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<Dem, DemError> {
    let (south, west) = corner(name).ok_or(DemError::HgtName)?;
    let side: u32 = match bytes.len() {
        2_884_802 => 1201,
        25_934_402 => 3601,
        other => return Err(DemError::HgtSize(other)),
    };
    let value = |pair: &[u8]| match i16::from_be_bytes([pair[0], pair[1]]) {
        VOID => f32::NAN,
        z => f32::from(z),
    };
    let values = bytes.chunks_exact(2).map(value).collect();
    let step = 1.0 / f64::from(side - 1);
    let pixel = degrees_to_metres([step, step], south + 0.5)?;
    filled(side, side, values, pixel, Some((south + 0.5, west + 0.5)))
}

/// Latitude and longitude of the south west corner in degrees.
fn corner(name: &str) -> Option<(f64, f64)> {
    let name = name.as_bytes();
    if name.len() != 7 || !name[1..3].iter().chain(&name[4..7]).all(u8::is_ascii_digit) {
        return None;
    }
    let number = |digits: &[u8]| {
        digits
            .iter()
            .fold(0.0, |n, digit| 10.0 * n + f64::from(digit - b'0'))
    };
    let signed = |letter: u8, plus: u8, minus: u8, value: f64| match letter.to_ascii_uppercase() {
        l if l == plus => Some(value),
        l if l == minus => Some(-value),
        _ => None,
    };
    let lat = signed(name[0], b'N', b'S', number(&name[1..3]))?;
    let lon = signed(name[3], b'E', b'W', number(&name[4..7]))?;
    ((-90.0..90.0).contains(&lat) && (-180.0..180.0).contains(&lon)).then_some((lat, lon))
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
        let mut bytes = vec![0_u8; 2_884_802];
        bytes[..6].copy_from_slice(&[0x01, 0x02, 0x80, 0x00, 0xff, 0xfe]);
        let dem = read("N44W072", &bytes).unwrap();
        assert_eq!(
            (dem.grid.width, dem.grid.height, dem.voids),
            (1201, 1201, 1)
        );
        assert_eq!((dem.grid.values[0], dem.grid.values[2]), (258.0, -2.0));
        assert!((dem.grid.values[1] - 256.0 / 5.0).abs() < 1e-4);
        assert_eq!(dem.centre, Some((44.5, -71.5)));
        // Three arc seconds.
        assert!(
            (dem.grid.pixel_m[1] - 92.66).abs() < 0.01
                && (dem.grid.pixel_m[0] - 66.09).abs() < 0.01
        );
        assert_eq!(
            read("N44W072", &bytes[1..]),
            Err(DemError::HgtSize(2_884_801))
        );
        assert_eq!(read("Matterhorn", &bytes), Err(DemError::HgtName));
        let void = [0x80, 0x00].repeat(1201 * 1201);
        assert_eq!(read("N44W072", &void), Err(DemError::OnlyVoids));
    }
}
