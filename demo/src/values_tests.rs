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
fn sizes_lists_and_names_are_read() {
    assert_eq!(size("1280x720"), Ok((1280, 720)));
    assert_refused(size, &["", "0x0", "1280", "1280x", "-1x5"]);
    assert_refused(size, &["100000x100000", "16x15", "NaNx5"]);
    assert_eq!(sample_counts("100,2000"), Ok(SampleCounts(vec![100, 2000])));
    assert_refused(sample_counts, &["100,,200", "", "99"]);
    assert!(overlay("nonsense").unwrap_err().contains("ocean_age"));
}
