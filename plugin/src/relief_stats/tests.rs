use super::*;
use crate::crust::Orogeny;
use crate::io::load_dem;
use crate::math::{self, PI, TAU};
use crate::query::{Ground, GroundError, checked};
use crate::random::{Purpose, Stream};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use std::path::PathBuf;

/// The folder of real tiles: `$PANGAEA_DATA/dem`, else `shared/data/dem` beside the repository.
fn real_tile(name: &str) -> Option<HeightGrid> {
    let data = std::env::var_os("PANGAEA_DATA").map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data")),
        PathBuf::from,
    );
    let path = data.join("dem").join(name);
    if !path.exists() {
        eprintln!("skipped: {} is missing", path.display());
        return None;
    }
    Some(load_dem(&path).unwrap().grid)
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found / expected - 1.0).abs() < tolerance,
        "{found} is not {expected}"
    );
}

/// Published figures of four tiles: relief in 10 km (median, largest), slope (mean, 90th
/// percentile), hypsometric integral, exponent.
#[test]
fn real_tiles_have_their_published_figures() {
    for (name, [median, max, mean, p90, integral, exponent]) in [
        (
            "himalaya-annapurna.png",
            [3221.0, 5554.0, 30.7, 47.2, 0.45, 3.49],
        ),
        (
            "andes-aconcagua.png",
            [2052.0, 3438.0, 26.2, 38.9, 0.44, 2.91],
        ),
        ("N44W072.hgt", [651.0, 1560.0, 8.7, 18.0, 0.23, 3.21]),
    ] {
        let Some(tile) = real_tile(name) else {
            continue;
        };
        let found = relief(&tile).unwrap();
        close(found.relief10_median_m.unwrap(), median, 0.01);
        close(found.relief10_max_m.unwrap(), max, 0.01);
        close(found.slope_mean_deg, mean, 0.015);
        close(found.slope_p90_deg, p90, 0.01);
        close(found.hypsometric_integral.unwrap(), integral, 0.03);
        close(found.spectral_exponent.unwrap(), exponent, 0.02);
    }
}

/// The published row of this tile was made with pixels of 78.2 m, the size that they have at 44.5°
/// N; at 4.5° S they are 92.5 m wide. Relief and slopes are compared with that size, what does not
/// hang on it with the true one.
#[test]
fn a_plain_has_its_published_figures() {
    let Some(mut tile) = real_tile("S05W070.hgt") else {
        return;
    };
    let found = relief(&tile).unwrap();
    close(found.hypsometric_integral.unwrap(), 0.49, 0.03);
    close(found.spectral_exponent.unwrap(), 2.72, 0.07);
    tile.pixel_m = [78.2; 2];
    let found = relief(&tile).unwrap();
    close(found.relief10_median_m.unwrap(), 75.0, 0.01);
    close(found.relief10_max_m.unwrap(), 114.0, 0.01);
    close(found.slope_mean_deg, 2.5, 0.02);
    close(found.slope_p90_deg, 4.9, 0.02);
}

#[test]
fn a_real_geotiff_is_read() {
    let Some(tile) = real_tile("bigtujunga.tif") else {
        return;
    };
    assert_eq!(
        (tile.width, tile.height, tile.pixel_m),
        (1197, 643, [30.0; 2])
    );
    let found = relief(&tile).unwrap();
    // The canyon leaves the San Gabriel Mountains at 300 m; Mount Gleason above it is 1983 m high.
    assert!(
        found.elevation_m[0] > 200.0 && (1900.0..2300.0).contains(&found.elevation_m[2]),
        "{found:?}"
    );
    assert!(
        (15.0..30.0).contains(&found.slope_mean_deg) && found.spectral_exponent.is_some(),
        "{found:?}"
    );
}

fn tile(width: usize, height: usize, pixel_m: [f64; 2], z: impl Fn(f64, f64) -> f64) -> HeightGrid {
    let at = |i: usize| {
        z(
            (i % width) as f64 * pixel_m[0],
            (i / width) as f64 * pixel_m[1],
        ) as f32
    };
    HeightGrid {
        width,
        height,
        values: (0..width * height).map(at).collect(),
        pixel_m,
    }
}

#[test]
fn a_plane_has_its_slope_and_the_relief_of_its_windows() {
    let found = relief(&tile(300, 250, [100.0, 80.0], |x, y| 0.3 * x - 0.4 * y)).unwrap();
    let slope = math::atan2(0.5, 1.0).to_degrees();
    assert!(
        (found.slope_mean_deg - slope).abs() < 0.01 && (found.slope_p90_deg - slope).abs() < 0.02
    );
    // 99 steps of 100 m across, 124 of 80 m down.
    let range = 0.3 * 9900.0 + 0.4 * 9920.0;
    assert!((found.relief10_median_m.unwrap() - range).abs() < 0.1);
    assert!((found.relief10_max_m.unwrap() - range).abs() < 0.1);
    assert!((found.hypsometric_integral.unwrap() - 0.5).abs() < 1e-4);
}

#[test]
fn waves_have_the_slopes_of_their_derivative() {
    // Height A sin(kx): the slope is A k |cos|, whose 90th percentile is that of |cos|: cos 9°.
    let (amplitude, k) = (300.0, TAU / 6000.0);
    let found = relief(&tile(1200, 40, [10.0, 300.0], |x, _| {
        amplitude * math::sin(k * x)
    }))
    .unwrap();
    let p90 = math::atan2(amplitude * k * math::cos(9.0_f64.to_radians()), 1.0).to_degrees();
    assert!(
        (found.slope_p90_deg - p90).abs() < 0.05,
        "{} {p90}",
        found.slope_p90_deg
    );
    close(found.relief10_median_m.unwrap(), 600.0, 1e-3);
}

/// A surface of many random waves whose power falls as k^-β: amplitudes k^(-β/2) over a density of
/// waves that grows with k, as in the plane. Waves are drawn in the logarithm of k, so each stands
/// for k² waves of the plane.
fn fractal(beta: f64, pixel_m: [f64; 2], seed: u64) -> HeightGrid {
    let stream = Stream::new(seed, Purpose::ReliefSites, 0);
    let waves: Vec<[f64; 4]> = (0..600)
        .map(|i| {
            let wavelength = math::exp(stream.range(4 * i, math::ln(500.0), math::ln(60_000.0)));
            let (sin, cos) = math::sin_cos(TAU * stream.unit(4 * i + 1));
            let amplitude = math::pow(wavelength, 0.5 * beta - 1.0);
            [
                cos * TAU / wavelength,
                sin * TAU / wavelength,
                TAU * stream.unit(4 * i + 2),
                amplitude,
            ]
        })
        .collect();
    // sin(a + b) = sin a cos b + cos a sin b: a table for each axis.
    let table = |n: usize, pixel: f64, k: usize| -> Vec<Vec<(f64, f64)>> {
        let at = |i: usize| {
            waves
                .iter()
                .map(move |wave| math::sin_cos(wave[k] * i as f64 * pixel))
                .collect()
        };
        (0..n).map(at).collect()
    };
    let (width, height) = (500, 400);
    let (columns, rows) = (table(width, pixel_m[0], 0), table(height, pixel_m[1], 1));
    let phases: Vec<(f64, f64)> = waves.iter().map(|wave| math::sin_cos(wave[2])).collect();
    let mut values = Vec::with_capacity(width * height);
    for row in &rows {
        let shifted = row
            .iter()
            .zip(&phases)
            .zip(&waves)
            .map(|((&(s, c), &(ps, pc)), wave)| {
                (wave[3] * (s * pc + c * ps), wave[3] * (c * pc - s * ps))
            });
        let shifted: Vec<(f64, f64)> = shifted.collect();
        for column in &columns {
            values.push(
                column
                    .iter()
                    .zip(&shifted)
                    .map(|(&(s, c), &(rs, rc))| s * rc + c * rs)
                    .sum::<f64>() as f32,
            );
        }
    }
    HeightGrid {
        width,
        height,
        values,
        pixel_m,
    }
}

#[test]
fn surfaces_of_known_exponent_have_it() {
    for (beta, pixel) in [
        (2.0, [120.0, 150.0]),
        (3.0, [150.0, 120.0]),
        (4.0, [120.0; 2]),
    ] {
        let found = [1, 2, 3].map(|seed| spectral_exponent(&fractal(beta, pixel, seed)).unwrap());
        let mean = found.iter().sum::<f64>() / 3.0;
        assert!((mean - beta).abs() < 0.25, "{beta}: {found:?}");
    }
}

#[test]
fn what_has_no_figure_has_none() {
    let small = relief(&tile(20, 20, [50.0; 2], |x, _| x)).unwrap();
    assert_eq!(
        (small.relief10_median_m, small.spectral_exponent),
        (None, None)
    );
    let level = relief(&tile(200, 200, [100.0; 2], |_, _| 7.0)).unwrap();
    assert_eq!(
        (level.hypsometric_integral, level.relief10_median_m),
        (None, Some(0.0))
    );
    assert_eq!((level.spectral_exponent, level.slope_p90_deg), (None, 0.0));
    let mut broken = tile(20, 20, [50.0; 2], |x, _| x);
    broken.values[7] = f32::NAN;
    assert_eq!(relief(&broken), None);
    broken.values.pop();
    assert_eq!(relief(&broken), None);
    assert_eq!(relief(&tile(2, 20, [50.0; 2], |x, _| x)), None);
    assert_eq!(relief(&tile(20, 20, [0.0; 2], |x, _| x)), None);
    let coarse = relief(&tile(20, 20, [6000.0; 2], |x, _| x)).unwrap();
    assert_eq!(
        (coarse.relief10_median_m, coarse.spectral_exponent),
        (None, None)
    );
}

#[test]
fn medians_are_middles() {
    assert_eq!(
        (
            median(vec![3.0, 1.0, 2.0]),
            median(vec![4.0, 1.0, 2.0, 3.0])
        ),
        (Some(2.0), Some(2.5))
    );
    assert_eq!(median(Vec::new()), None);
}

/// A planet with a young belt in the north, an old one at the equator and a plain in the south.
fn belts(mesh: &SphereMesh) -> (Vec<f32>, Vec<Orogeny>, Vec<f32>) {
    let of = |i: usize| match mesh.point(i as u32).z {
        z if z > 0.5 => (4.0, Orogeny::Himalayan, 10.0),
        z if z > 0.3 => (2.0, Orogeny::Andean, 5.0),
        z if z > -0.3 => (0.6, Orogeny::Andean, 300.0),
        z if z > -0.8 => (0.1, Orogeny::None, 0.0),
        _ => (-4.0, Orogeny::None, 0.0),
    };
    let all: Vec<_> = (0..mesh.len()).map(of).collect();
    (
        all.iter().map(|s| s.0).collect(),
        all.iter().map(|s| s.1).collect(),
        all.iter().map(|s| s.2).collect(),
    )
}

#[test]
fn sites_belong_to_their_class_and_hang_on_the_seed_alone() {
    let mesh = SphereMesh::fibonacci(5000).unwrap();
    let (elevation, orogeny, orogeny_age) = belts(&mesh);
    let input = |seed| SiteInput {
        mesh: &mesh,
        elevation: &elevation,
        orogeny: &orogeny,
        orogeny_age: &orogeny_age,
        seed,
    };
    for class in CLASSES {
        let drawn = sites(&input(3), class);
        assert_eq!(drawn.len(), SITES, "{class:?}");
        for &site in &drawn {
            for i in mesh.ring(site).iter().chain([&site]).map(|&i| i as usize) {
                assert!(
                    class.holds(elevation[i], orogeny[i], orogeny_age[i]),
                    "{class:?}"
                );
            }
        }
        let mut unique = drawn.clone();
        unique.sort_unstable();
        unique.dedup();
        assert_eq!(unique.len(), SITES);
        assert_eq!(sites(&input(3), class), drawn);
        assert_ne!(sites(&input(4), class), drawn);
    }
    let nothing = vec![Orogeny::None; mesh.len()];
    let sea = vec![-1.0; mesh.len()];
    let none = SiteInput {
        elevation: &sea,
        orogeny: &nothing,
        ..input(1)
    };
    assert!(CLASSES.iter().all(|&class| sites(&none, class).is_empty()));
}

/// Ridges of 1000 m, 5 km apart, along the meridians.
struct Ridges;

impl Ground for Ridges {
    fn radius_m(&self) -> f64 {
        6_370_000.0
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let (_, lon) = math::lat_lon(checked(direction, level)?);
        let across = lon.to_radians() * self.radius_m();
        Ok((1000.0 + 500.0 * math::sin(2.0 * PI * across / 5000.0)) as f32)
    }
}

#[test]
fn tiles_around_sites_are_measured_on_the_ground() {
    let mesh = SphereMesh::fibonacci(5000).unwrap();
    let equator: Vec<u32> = (0..5000)
        .filter(|&i| mesh.point(i).z.abs() < 0.01)
        .take(2)
        .collect();
    let mut seen = 0;
    let found = class_relief(&Ridges, &mesh, &equator, || seen += 1).unwrap();
    assert_eq!((found.len(), seen), (2, 2));
    let [relief10, p90, exponent] = medians(&found);
    close(relief10.unwrap(), 1000.0, 0.001);
    close(
        p90.unwrap(),
        math::atan2(500.0 * 2.0 * PI / 5000.0, 1.0).to_degrees(),
        0.02,
    );
    assert!(exponent.is_some());
    assert_eq!(medians(&[]), [None; 3]);
}
