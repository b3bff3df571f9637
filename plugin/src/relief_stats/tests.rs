use super::*;
use crate::io::load_dem;
use crate::math::{self, TAU};
use crate::query::HeightGrid;
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

/// Published figures of a tile: relief in 10 km (median, largest), slope (mean, 90th percentile),
/// hypsometric integral, exponent.
fn assert_published(name: &str, figures: [f64; 6]) {
    let [median, max, mean, p90, integral, exponent] = figures;
    let Some(tile) = real_tile(name) else { return };
    let found = ReliefStats::of(&tile).unwrap();
    close(found.relief10_median_m.unwrap(), median, 0.01);
    close(found.relief10_max_m.unwrap(), max, 0.01);
    close(found.slope_mean_deg, mean, 0.015);
    close(found.slope_p90_deg, p90, 0.01);
    close(found.hypsometric_integral.unwrap(), integral, 0.03);
    close(found.spectral_exponent.unwrap(), exponent, 0.02);
}

#[test]
fn real_tiles_have_their_published_figures() {
    let annapurna = [3221.0, 5554.0, 30.7, 47.2, 0.45, 3.49];
    assert_published("himalaya-annapurna.png", annapurna);
    let aconcagua = [2052.0, 3438.0, 26.2, 38.9, 0.44, 2.91];
    assert_published("andes-aconcagua.png", aconcagua);
    let new_hampshire = [651.0, 1560.0, 8.7, 18.0, 0.23, 3.21];
    assert_published("N44W072.hgt", new_hampshire);
}

/// The published row of this tile was made with pixels of 78.2 m, the size that they have at 44.5°
/// N; at 4.5° S they are 92.5 m wide. Relief and slopes are compared with that size, what does not
/// hang on it with the true one.
#[test]
fn a_plain_has_its_published_figures() {
    let Some(mut tile) = real_tile("S05W070.hgt") else {
        return;
    };
    let found = ReliefStats::of(&tile).unwrap();
    close(found.hypsometric_integral.unwrap(), 0.49, 0.03);
    close(found.spectral_exponent.unwrap(), 2.72, 0.07);
    tile.pixel_m = [78.2; 2];
    let found = ReliefStats::of(&tile).unwrap();
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
    assert_eq!([tile.width, tile.height], [1197, 643]);
    assert_eq!(tile.pixel_m, [30.0; 2]);
    let found = ReliefStats::of(&tile).unwrap();
    let [low, _, high] = found.elevation_m;
    // The canyon leaves the San Gabriel Mountains at 300 m; Mount Gleason above it is 1983 m high.
    assert!(low > 200.0 && (1900.0..2300.0).contains(&high), "{found:?}");
    assert!((15.0..30.0).contains(&found.slope_mean_deg), "{found:?}");
    assert!(found.spectral_exponent.is_some());
}

/// A tile of heights `z(x, y)` in m at x m east and y m south of its corner.
fn tile(width: usize, height: usize, pixel_m: [f64; 2], z: impl Fn(f64, f64) -> f64) -> HeightGrid {
    let mut values = Vec::with_capacity(width * height);
    for row in 0..height {
        let y = row as f64 * pixel_m[1];
        values.extend((0..width).map(|column| z(column as f64 * pixel_m[0], y) as f32));
    }
    HeightGrid {
        width,
        height,
        values,
        pixel_m,
    }
}

fn stats(
    width: usize,
    height: usize,
    pixel_m: [f64; 2],
    z: impl Fn(f64, f64) -> f64,
) -> ReliefStats {
    ReliefStats::of(&tile(width, height, pixel_m, z)).unwrap()
}

#[test]
fn a_plane_has_its_slope_and_the_relief_of_its_windows() {
    let found = stats(300, 250, [100.0, 80.0], |x, y| 0.3 * x - 0.4 * y);
    let slope = math::atan2(0.5, 1.0).to_degrees();
    assert!((found.slope_mean_deg - slope).abs() < 0.01);
    assert!((found.slope_p90_deg - slope).abs() < 0.02);
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
    let wave = |x, _| amplitude * math::sin(k * x);
    let found = stats(1200, 40, [10.0, 300.0], wave);
    let steepest = amplitude * k * math::cos(9.0_f64.to_radians());
    let p90 = math::atan2(steepest, 1.0).to_degrees();
    let error = found.slope_p90_deg - p90;
    assert!(error.abs() < 0.05, "{} {p90}", found.slope_p90_deg);
    close(found.relief10_median_m.unwrap(), 600.0, 1e-3);
}

#[test]
fn small_coarse_and_level_tiles_lack_figures() {
    for pixel in [50.0, 6000.0] {
        let found = stats(20, 20, [pixel; 2], |x, _| x);
        assert_eq!(found.relief10_median_m, None);
        assert_eq!(found.spectral_exponent, None);
    }
    let level = stats(200, 200, [100.0; 2], |_, _| 7.0);
    assert_eq!(level.hypsometric_integral, None);
    assert_eq!(level.spectral_exponent, None);
    assert_eq!(level.relief10_median_m, Some(0.0));
    assert_eq!(level.slope_p90_deg, 0.0);
}

#[test]
fn broken_tiles_have_no_figures() {
    let ramp = |width, pixel| tile(width, 20, [pixel; 2], |x, _| x);
    let mut broken = ramp(20, 50.0);
    broken.values[7] = f32::NAN;
    assert_eq!(ReliefStats::of(&broken), None);
    broken.values.pop();
    assert_eq!(ReliefStats::of(&broken), None);
    assert_eq!(ReliefStats::of(&ramp(2, 50.0)), None);
    assert_eq!(ReliefStats::of(&ramp(20, 0.0)), None);
}
