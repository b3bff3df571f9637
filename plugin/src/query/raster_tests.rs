use super::*;
use crate::math;
use crate::query::checked;
use core::sync::atomic::{AtomicUsize, Ordering};

/// Heights of 10 m per degree of a coordinate.
enum Degrees {
    OfLatitude,
    OfLongitude,
}

impl Ground for Degrees {
    fn radius_m(&self) -> f64 {
        RADIUS_M
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let (lat, lon) = math::lat_lon(checked(direction, level)?);
        Ok(10.0
            * match self {
                Self::OfLatitude => lat as f32,
                Self::OfLongitude => lon as f32,
            })
    }
}

const RADIUS_M: f64 = 6_370_000.0;

fn square(lat: f64, lon: f64, side_m: f64, pixels: usize) -> MapSquare {
    let about = AzimuthalEquidistant::new(lat, lon, RADIUS_M).unwrap();
    MapSquare::new(about, side_m, pixels).unwrap()
}

#[test]
fn north_is_up_and_values_are_those_of_pixel_centres() {
    let degree = RADIUS_M * math::PI / 180.0;
    let square = square(30.0, 40.0, 8.0 * degree, 8);
    let lat = square.heights(&Degrees::OfLatitude, 5).unwrap();
    assert_eq!([lat.width, lat.height, lat.values.len()], [8, 8, 64]);
    // The middle column is half a pixel off the meridian; latitudes differ by a few hundredths
    // of a degree there.
    for y in 0..8 {
        let expected = 33.5 - y as f32;
        assert!((lat.row(y)[4] / 10.0 - expected).abs() < 0.02, "{y}");
    }
    let lon = square.heights(&Degrees::OfLongitude, 5).unwrap();
    assert!(lon.row(3).windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(lat.range().unwrap()[1], lat.row(0)[4].max(lat.row(0)[3]));
}

#[test]
fn whoever_asks_hears_how_far_it_is_and_may_stop() {
    let (square, ground) = (square(30.0, 40.0, 1e6, 100), Degrees::OfLongitude);
    let heard = AtomicUsize::new(0);
    let listen = |pixels| heard.fetch_max(pixels, Ordering::Relaxed) <= 10_000;
    let grid = square.heights_while(&ground, 5, listen).unwrap();
    assert_eq!(Ok(grid), square.heights(&ground, 5));
    // The last batch begins when others are known; two threads may begin it together.
    assert!((1..10_000).contains(&heard.into_inner()));
    let stopped = square.heights_while(&ground, 5, |pixels| pixels < 4000);
    assert_eq!(stopped, Err(GroundError::Stopped));
}

#[test]
fn levels_follow_pixels() {
    assert_eq!(square(0.0, 0.0, 60_004.8, 648).level(), 10);
    let fine = square(0.0, 0.0, 64.0, 128);
    assert_eq!(fine.level(), 17);
    assert_eq!(fine.at_level(9).unwrap().level(), 9);
    assert_eq!(fine.at_level(18), Err(GroundError::Level(18)));
}

#[test]
fn bad_squares_and_levels_are_refused() {
    let map = AzimuthalEquidistant::new(0.0, 0.0, 50_000.0).unwrap();
    for side in [0.0, -1.0, f64::NAN, f64::INFINITY, 300_000.0] {
        let refused = MapSquare::new(map, side, 16);
        assert!(matches!(refused, Err(GroundError::Length { .. })), "{side}");
    }
    for pixels in [0, 1, 20_000, usize::MAX] {
        let refused = MapSquare::new(map, 1000.0, pixels);
        assert!(matches!(refused, Err(GroundError::Count { .. })));
    }
    let refused = square(0.0, 0.0, 1e5, 9).heights(&Degrees::OfLatitude, 18);
    assert_eq!(refused, Err(GroundError::Level(18)));
}
