use super::*;
use crate::math;

fn planet(elevation: impl Fn(f64, f64) -> f32 + Sync) -> (SphereMesh, Climate) {
    let mesh = SphereMesh::from_points(crate::sphere::poisson_disk(3, 0.018)).unwrap();
    let z = parallel::map(mesh.len(), |i| {
        let (lat, lon) = math::lat_lon(mesh.point(i));
        elevation(lat, lon)
    });
    let climate = Climate::new(&mesh, &Winds::new(&mesh), &z, &ClimateMaps::default());
    (mesh, climate)
}

/// Mean rain of the vertices within a box of latitudes and longitudes.
fn mean(mesh: &SphereMesh, field: &[f32], lat: (f64, f64), lon: (f64, f64)) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for (p, &value) in mesh.points().iter().zip(field) {
        let (a, b) = math::lat_lon(*p);
        if a >= lat.0 && a < lat.1 && b >= lon.0 && b < lon.1 {
            (sum, count) = (sum + f64::from(value), count + 1.0);
        }
    }
    sum / count
}

const ALL: (f64, f64) = (-180.0, 180.0);

#[test]
fn rain_is_symmetric_without_relief() {
    for level in [-1.0, 0.2] {
        let (mesh, climate) = planet(|_, _| level);
        for k in 0..17 {
            let low = 5.0 * f64::from(k);
            let north = mean(&mesh, &climate.rain, (low, low + 5.0), ALL);
            let south = mean(&mesh, &climate.rain, (-low - 5.0, -low), ALL);
            assert!(
                (north - south).abs() < 0.03 * north + 3.0,
                "at {low}: {north} {south}"
            );
        }
    }
}

#[test]
fn dry_belts_lie_between_15_and_30_degrees() {
    // All sea, and continents in every belt.
    for land in [false, true] {
        let (mesh, climate) = planet(|_, lon| {
            if land && lon.rem_euclid(120.0) < 50.0 {
                0.3
            } else {
                -4.0
            }
        });
        for sign in [1.0, -1.0] {
            let belt = |k: i32| {
                let low = f64::from(k) * 2.5;
                let range = if sign > 0.0 {
                    (low, low + 2.5)
                } else {
                    (-low - 2.5, -low)
                };
                mean(&mesh, &climate.rain, range, ALL)
            };
            let driest = (0..22)
                .min_by(|&a, &b| belt(a).total_cmp(&belt(b)))
                .unwrap();
            assert!(
                (6..12).contains(&driest),
                "driest at {} degrees",
                2.5 * f64::from(driest)
            );
            assert!(belt(0) > 2.5 * belt(driest) && belt(18) > 1.3 * belt(driest));
        }
    }
}

#[test]
fn a_ridge_athwart_the_westerlies_has_a_wet_and_a_dry_side() {
    // A continent with a ridge 3 km high and 8 degrees wide, parallel to its western coast.
    let (mesh, climate) = planet(|lat, lon| {
        if !(0.0..60.0).contains(&lon) || lat.abs() > 70.0 {
            return -4.0;
        }
        0.2 + 2.8 * (1.0 - ((lon - 8.0) / 4.0).abs()).max(0.0) as f32
    });
    for lat in [(38.0, 55.0), (-55.0, -38.0)] {
        let windward = mean(&mesh, &climate.rain, lat, (4.0, 8.0));
        let lee = mean(&mesh, &climate.rain, lat, (9.0, 13.0));
        assert!(windward > 2.0 * lee, "{windward} {lee}");
    }
}

#[test]
fn rain_falls_off_with_the_distance_to_the_sea_along_the_wind() {
    let (mesh, climate) = planet(|_, lon| {
        if (-60.0..60.0).contains(&lon) {
            0.2
        } else {
            -4.0
        }
    });
    let at = |lon: f64| mean(&mesh, &climate.rain, (42.0, 52.0), (lon, lon + 10.0));
    assert!(
        at(-55.0) > 1.3 * at(0.0) && at(-25.0) > at(25.0),
        "{} {} {}",
        at(-55.0),
        at(0.0),
        at(45.0)
    );
    let trades = |lon: f64| mean(&mesh, &climate.rain, (16.0, 26.0), (lon, lon + 10.0));
    assert!(
        trades(48.0) > 1.3 * trades(-40.0),
        "{} {}",
        trades(48.0),
        trades(-40.0)
    );
}

#[test]
fn everything_is_finite_smooth_and_the_same_again() {
    let rough = |lat: f64, lon: f64| (3.0 * (math::sin(lat * 0.3) * math::cos(lon * 0.2))) as f32;
    let (mesh, climate) = planet(rough);
    assert_eq!(climate, planet(rough).1);
    for i in 0..mesh.len() {
        assert!(
            (0.0..15_000.0).contains(&climate.rain[i]),
            "{}",
            climate.rain[i]
        );
        assert!((-80.0..40.0).contains(&climate.temperature[i]));
        assert!((0.0..=1.0).contains(&climate.wetness[i]));
        assert!(climate.runoff[i] >= 0.0 && climate.runoff[i] <= climate.rain[i]);
    }
}

#[test]
fn maps_of_no_climate_are_refused() {
    let map =
        |value: f32| EquirectMap::from_fn(8, |lat, _| if lat > 60.0 { value } else { 0.5 }).ok();
    let [temperature, rain, wetness] = [288.0, -1.0, 1.5].map(map);
    for maps in [
        ClimateMaps {
            temperature,
            ..ClimateMaps::default()
        },
        ClimateMaps {
            rain,
            ..ClimateMaps::default()
        },
        ClimateMaps {
            wetness,
            ..ClimateMaps::default()
        },
    ] {
        assert!(matches!(
            maps.check(),
            Err(MapError::Range { pixel: 0, .. })
        ));
    }
    let [temperature, rain, wetness] = [-150.0, 1e6, 1.0].map(map);
    assert_eq!(
        ClimateMaps {
            temperature,
            rain,
            wetness
        }
        .check(),
        Ok(())
    );
    assert_eq!(ClimateMaps::default().check(), Ok(()));
}

#[test]
fn maps_replace_fields_and_the_others_follow() {
    let mesh = SphereMesh::fibonacci(2000).unwrap();
    let winds = Winds::new(&mesh);
    let map = |value: f32| EquirectMap::from_fn(8, |_, _| value).ok();
    let maps = ClimateMaps {
        rain: map(700.0),
        temperature: map(12.0),
        wetness: None,
    };
    let climate = Climate::new(&mesh, &winds, &vec![0.1; 2000], &maps);
    assert!(climate.rain.iter().all(|r| (r - 700.0).abs() < 1e-3));
    let expected = wetness::wetness(700.0, wetness::evaporation(12.0));
    assert!(climate.wetness.iter().all(|w| (w - expected).abs() < 1e-5));
    let wet = ClimateMaps {
        wetness: map(0.25),
        ..ClimateMaps::default()
    };
    assert!(
        Climate::new(&mesh, &winds, &[], &wet)
            .wetness
            .iter()
            .all(|&w| w == 0.25)
    );
}
