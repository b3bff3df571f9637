use super::*;
use crate::climate::MapError;
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

/// Mean of a field over the vertices within a box of latitudes and longitudes.
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

/// WindBelts of 2.5 degrees are numbered from the equator.
const BELT_DEG: f64 = 2.5;

/// Mean rain of belt `k` north (`sign` 1) or south (-1) of the equator.
fn belt_rain(mesh: &SphereMesh, climate: &Climate, sign: f64, k: i32) -> f64 {
    let low = f64::from(k) * BELT_DEG;
    let range = if sign > 0.0 {
        (low, low + BELT_DEG)
    } else {
        (-low - BELT_DEG, -low)
    };
    mean(mesh, &climate.rain, range, ALL)
}

/// Holds the driest belt of both hemispheres to 15 to 30 degrees.
fn assert_dry_subtropics(mesh: &SphereMesh, climate: &Climate) {
    for sign in [1.0, -1.0] {
        let belt = |k: i32| belt_rain(mesh, climate, sign, k);
        let driest = (0..22)
            .min_by(|&a, &b| belt(a).total_cmp(&belt(b)))
            .unwrap();
        let latitude = BELT_DEG * f64::from(driest);
        assert!((6..12).contains(&driest), "driest at {latitude} degrees");
        assert!(belt(0) > 2.5 * belt(driest) && belt(18) > 1.3 * belt(driest));
    }
}

#[test]
fn dry_belts_of_the_sea_lie_between_15_and_30_degrees() {
    let (mesh, climate) = planet(|_, _| -4.0);
    assert_dry_subtropics(&mesh, &climate);
}

#[test]
fn dry_belts_of_continents_lie_between_15_and_30_degrees() {
    let (mesh, climate) = planet(|_, lon| {
        let is_land = lon.rem_euclid(120.0) < 50.0;
        if is_land { 0.3 } else { -4.0 }
    });
    assert_dry_subtropics(&mesh, &climate);
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
        let is_land = (-60.0..60.0).contains(&lon);
        if is_land { 0.2 } else { -4.0 }
    });
    // Westerlies bring rain from the west, trades from the east.
    let west = |lon: f64| mean(&mesh, &climate.rain, (42.0, 52.0), (lon, lon + 10.0));
    let [coast, middle] = [-55.0, 0.0].map(west);
    assert!(coast > 1.3 * middle, "{coast} {middle}");
    assert!(west(-25.0) > west(25.0));
    let trades = |lon: f64| mean(&mesh, &climate.rain, (16.0, 26.0), (lon, lon + 10.0));
    let [coast, inland] = [48.0, -40.0].map(trades);
    assert!(coast > 1.3 * inland, "{coast} {inland}");
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

/// A map with a value at the north pole.
fn with_pole(value: f32) -> Option<EquirectMap> {
    EquirectMap::from_fn(8, |lat, _| if lat > 60.0 { value } else { 0.5 }).ok()
}

/// A map of one value.
fn uniform(value: f32) -> Option<EquirectMap> {
    EquirectMap::from_fn(8, |_, _| value).ok()
}

#[test]
fn maps_of_impossible_climates_are_refused() {
    let kelvin = ClimateMaps {
        temperature: with_pole(288.0),
        ..ClimateMaps::default()
    };
    let negative = ClimateMaps {
        rain: with_pole(-1.0),
        ..ClimateMaps::default()
    };
    let beyond = ClimateMaps {
        wetness: with_pole(1.5),
        ..ClimateMaps::default()
    };
    for maps in [kelvin, negative, beyond] {
        let refused = maps.check();
        assert!(matches!(refused, Err(MapError::Range { pixel: 0, .. })));
    }
    let extreme = ClimateMaps {
        temperature: with_pole(-150.0),
        rain: with_pole(1e6),
        wetness: with_pole(1.0),
    };
    assert_eq!(extreme.check(), Ok(()));
    assert_eq!(ClimateMaps::default().check(), Ok(()));
}

#[test]
fn maps_replace_fields_and_the_others_follow() {
    let mesh = SphereMesh::fibonacci(2000).unwrap();
    let winds = Winds::new(&mesh);
    let maps = ClimateMaps {
        rain: uniform(700.0),
        temperature: uniform(12.0),
        wetness: None,
    };
    let climate = Climate::new(&mesh, &winds, &vec![0.1; 2000], &maps);
    assert!(climate.rain.iter().all(|r| (r - 700.0).abs() < 1e-3));
    let expected = wetness(700.0, potential_evaporation(12.0));
    assert!(climate.wetness.iter().all(|w| (w - expected).abs() < 1e-5));
}

#[test]
fn a_map_of_wetness_is_used_as_it_is() {
    let mesh = SphereMesh::fibonacci(500).unwrap();
    let maps = ClimateMaps {
        wetness: uniform(0.25),
        ..ClimateMaps::default()
    };
    let climate = Climate::new(&mesh, &Winds::new(&mesh), &[], &maps);
    assert!(climate.wetness.iter().all(|&w| w == 0.25));
}

/// Whether a vertex lies well within the north, or the south, of a map with voids in one of them.
fn is_clear_of_the_equator(mesh: &SphereMesh, i: usize) -> bool {
    mesh.point(i as u32).z.abs() > 0.1
}

/// A map of one value in the north, and voids in the south.
fn northern(value: f32) -> Option<EquirectMap> {
    EquirectMap::from_fn(64, |lat, _| if lat > 0.0 { value } else { f32::NAN }).ok()
}

/// The climates of a plain: its own, and with maps.
fn with_and_without(maps: &ClimateMaps) -> (SphereMesh, Climate, Climate) {
    let mesh = SphereMesh::fibonacci(3000).unwrap();
    let winds = Winds::new(&mesh);
    let plain = vec![0.3; mesh.len()];
    let own = Climate::new(&mesh, &winds, &plain, &ClimateMaps::default());
    let given = Climate::new(&mesh, &winds, &plain, maps);
    (mesh, own, given)
}

#[test]
fn voids_of_a_map_are_filled_from_the_planets_own_field() {
    let (mesh, own, given) = with_and_without(&ClimateMaps {
        rain: northern(700.0),
        wetness: northern(0.25),
        ..ClimateMaps::default()
    });
    for i in (0..mesh.len()).filter(|&i| is_clear_of_the_equator(&mesh, i)) {
        let (rain, wet) = if mesh.point(i as u32).z > 0.0 {
            (700.0, 0.25)
        } else {
            (own.rain[i], own.wetness[i])
        };
        assert_eq!((given.rain[i], given.wetness[i]), (rain, wet), "{i}");
    }
    assert_eq!(given.temperature, own.temperature);
}

#[test]
fn a_field_that_follows_from_a_map_with_voids_is_whole() {
    let (mesh, own, given) = with_and_without(&ClimateMaps {
        temperature: northern(-40.0),
        ..ClimateMaps::default()
    });
    for i in (0..mesh.len()).filter(|&i| is_clear_of_the_equator(&mesh, i)) {
        let is_north = mesh.point(i as u32).z > 0.0;
        let expected = if is_north { -40.0 } else { own.temperature[i] };
        assert_eq!(given.temperature[i], expected);
    }
    assert!(given.rain.iter().all(|rain| rain.is_finite()));
}
