//! Values are read, and refused with their limits.

use super::*;

/// Asserts that each of the texts is refused.
fn assert_refused<T>(read: impl Fn(&str) -> Result<T, String>, texts: &[&str]) {
    for text in texts {
        assert!(read(text).is_err(), "{text}");
    }
}

#[test]
fn whole_numbers_have_limits() {
    assert_eq!(samples("60000"), Ok(60_000));
    let wrong = ["", "0", "-5", "NaN", "inf", "1e3", "99", "2000001"];
    assert_refused(samples, &wrong);
    assert_refused(samples, &["1000000000000", "99999999999999999999999"]);
    assert_eq!(
        (level("0"), level("17"), level("18").is_err()),
        (Ok(0), Ok(17), true)
    );
}

#[test]
fn numbers_have_limits() {
    assert_eq!(land("0.3"), Ok(0.3));
    assert_refused(land, &["", "NaN", "nan", "inf", "-inf", "infinity", "x"]);
    assert_refused(land, &["-0.1", "0.91", "1e300"]);
}

#[test]
fn cameras_are_read() {
    let expected = CameraSpec {
        lat: -33.0,
        lon: -70.5,
        altitude_m: 2e6,
        heading: 90.0,
        pitch: -10.0,
    };
    assert_eq!(camera("-33,-70.5,2000000,90,-10"), Ok(expected));
    assert_eq!(camera("0, 0, 1000").unwrap().pitch, -90.0);
    assert_refused(camera, &["", "1,2", "1,2,3,4", "91,0,10", "0,NaN,10"]);
    assert_refused(camera, &["0,0,0", "0,0,-5", "0,0,inf", "0,0,1e10"]);
    assert_refused(camera, &["0,0,9,0,91", "0,0,9,361,0"]);
    assert!(camera("0,0,9,0,91").unwrap_err().contains("the pitch"));
}

#[test]
fn places_and_regions_are_read() {
    let middle = PlaceSpec {
        lat: -33.0,
        lon: -70.5,
    };
    let size_km = 12.0;
    assert_eq!(place(" -33, -70.5"), Ok(middle));
    assert_eq!(region("-33,-70.5,12"), Ok(RegionSpec { middle, size_km }));
    assert_refused(place, &["", "1", "1,2,3", "91,0", "0,361"]);
    assert_refused(place, &["NaN,0", "0,inf", "a,b", "1;2"]);
    assert_refused(region, &["", "1,2", "1,2,0", "1,2,-5", "1,2,NaN"]);
    assert_refused(region, &["1,2,1e9", "1,2,3,4", "-91,2,3"]);
}

#[test]
fn pixels_and_tiles_are_read() {
    assert_eq!(pixels("257"), Ok(PixelsSpec::Side(257)));
    assert_eq!(pixels("2048x1"), Ok(PixelsSpec::Size([2048, 1])));
    assert_refused(
        pixels,
        &["", "1", "16385", "0x5", "5x0", "5x", "5x20000", "5x5x5"],
    );
    assert_eq!(tiles("2x1"), Ok(TilesSpec([2, 1])));
    assert_eq!(tiles("64X64"), Ok(TilesSpec([64, 64])));
    assert_refused(tiles, &["", "2", "0x1", "1x0", "-1x2", "65x64", "2x1x1"]);
    assert_refused(tiles, &["5000x1", "18446744073709551615x2"]);
}

#[test]
fn ranges_and_boxes_are_read() {
    assert_eq!(
        height_range("-12000,9000.5"),
        Ok(RangeSpec([-12_000.0, 9000.5]))
    );
    assert_refused(
        height_range,
        &["", "5", "1,2,3", "9,-9", "3,3", "NaN,1", "0,inf"],
    );
    let fiji = BoxSpec([-20.0, 170.0, -10.0, 190.0]);
    assert_eq!(degree_box("-20,170,-10,-170"), Ok(fiji));
    assert_eq!(degree_box("-20, 170, -10, 190"), Ok(fiji));
    let planet = BoxSpec([-90.0, -180.0, 90.0, 180.0]);
    assert_eq!(degree_box("-90,-180,90,180"), Ok(planet));
    assert_refused(
        degree_box,
        &["", "1,2,3", "-91,0,5,5", "0,0,91,5", "0,0,5,361"],
    );
    assert_refused(degree_box, &["5,0,-5,9", "5,0,5,9", "0,7,5,7", "NaN,0,1,1"]);
}

#[test]
fn sizes_lists_and_names_are_read() {
    assert_eq!(size("1280x720"), Ok((1280, 720)));
    assert_refused(size, &["", "0x0", "1280", "1280x", "-1x5"]);
    assert_refused(size, &["100000x100000", "16x15", "NaNx5"]);
    assert_eq!(sample_counts("100,2000"), Ok(SampleCounts(vec![100, 2000])));
    assert_refused(sample_counts, &["100,,200", "", "99"]);
    assert!(overlay("nonsense").unwrap_err().contains("ocean_age"));
}
