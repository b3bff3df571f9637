use super::*;

/// The value at a latitude and a longitude in degrees.
fn value(map: &EquirectMap, lat: f64, lon: f64) -> f32 {
    map.at(math::direction(lat, lon)).unwrap()
}

#[test]
fn pixels_are_found_at_their_centres_and_join_around_the_date_line() {
    let map = EquirectMap::from_fn(18, |lat, lon| (lat + 1000.0 * lon.abs()) as f32).unwrap();
    assert_eq!(value(&map, 45.0, 15.0), 45.0 + 15_000.0);
    assert_eq!(value(&map, 50.0, 15.0), 50.0 + 15_000.0);
    assert!((value(&map, 5.0, 180.0) - (5.0 + 175_000.0)).abs() < 0.1);
    assert!((value(&map, 90.0, 0.0) - value(&map, 89.0, 0.0)).abs() < 1e-3);
}

/// A map of 8 x 4 pixels of 45 degrees that counts its columns, with voids in the third one.
fn columns_with_voids() -> EquirectMap {
    let values = (0..32).map(|i| match i % 8 {
        2 => f32::NAN,
        x => x as f32,
    });
    EquirectMap::new(8, 4, values.collect()).unwrap()
}

#[test]
fn voids_reach_as_far_as_their_pixels() {
    let map = columns_with_voids();
    assert_eq!(map.voids(), 4);
    // The third column reaches from 90 to 45 degrees west.
    for (lon, expected) in [
        (-157.5, Some(0.0)),
        (-135.0, Some(0.5)),
        (-112.5, Some(1.0)),
        (-91.0, Some(1.0)),
        (-89.0, None),
        (-67.5, None),
        (-46.0, None),
        (-44.0, Some(3.0)),
        (-22.5, Some(3.0)),
        (0.0, Some(3.5)),
    ] {
        let found = map.at(math::direction(10.0, lon));
        let near = |(a, b): (f32, f32)| (a - b).abs() < 1e-5;
        let agree = found.zip(expected).map_or(found == expected, near);
        assert!(agree, "at {lon}: {found:?}, not {expected:?}");
    }
}

#[test]
fn corners_that_are_voids_leave_their_weight_to_the_others() {
    let nan = f32::NAN;
    // Weights of three corners: 9, 3 and 3 sixteenths.
    let three = between([[4.0, 8.0], [16.0, nan]], 0.25, 0.25);
    assert_eq!(three, Some((9.0 * 4.0 + 3.0 * 8.0 + 3.0 * 16.0) / 15.0));
    assert_eq!(between([[nan, 8.0], [16.0, 1.0]], 0.25, 0.25), None);
    assert_eq!(between([[nan, nan], [nan, 7.0]], 0.9, 0.9), Some(7.0));
    assert_eq!(between([[5.0, nan], [nan, nan]], 0.0, 0.0), Some(5.0));
}

#[test]
fn maps_come_back_from_files_and_broken_files_are_refused() {
    let map = EquirectMap::from_fn(2, |lat, lon| (lat + lon) as f32).unwrap();
    let text = ron::to_string(&map).unwrap();
    assert_eq!(ron::from_str(&text), Ok(map));
    let torn = text.replace("width:4", "width:6");
    assert!(ron::from_str::<EquirectMap>(&torn).is_err());
    // A void is a void again, and equals itself.
    let voids = columns_with_voids();
    let text = ron::to_string(&voids).unwrap();
    assert_eq!(ron::from_str(&text), Ok(voids));
}

#[test]
fn broken_maps_are_refused() {
    assert_eq!(EquirectMap::new(0, 0, vec![]), Err(MapError::Size(0, 0)));
    assert_eq!(
        EquirectMap::new(3, 2, vec![0.0; 6]),
        Err(MapError::Shape(3, 2))
    );
    assert_eq!(
        EquirectMap::new(2, 1, vec![0.0]),
        Err(MapError::Count {
            given: 1,
            wanted: 2
        })
    );
    for infinite in [f32::INFINITY, f32::NEG_INFINITY] {
        let map = EquirectMap::new(2, 1, vec![f32::NAN, infinite]);
        assert_eq!(map, Err(MapError::Infinite(1)));
    }
    let only_voids = EquirectMap::new(2, 1, vec![f32::NAN; 2]);
    assert_eq!(only_voids, Err(MapError::OnlyVoids));
    for height in [0, 1 << 20] {
        assert!(EquirectMap::from_fn(height, |_, _| 0.0).is_err());
    }
}
