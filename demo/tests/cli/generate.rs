//! The files of a planet.

use crate::program::{names_in, small_planet, stats};
use serde_json::Value;
use std::fs;
use std::io::BufReader;
use std::path::Path;
use tempfile::TempDir;

const OVERLAYS: [&str; 21] = [
    "elevation_color",
    "plates",
    "crust_type",
    "ocean_age",
    "thickness",
    "orogeny_type",
    "orogeny_age",
    "fold_direction",
    "ridge_direction",
    "velocity",
    "slope",
    "laplacian",
    "vector_noise",
    "mesh",
    "temperature",
    "rain",
    "wetness",
    "drainage",
    "rivers",
    "basins",
    "lakes",
];

#[test]
fn generate_writes_the_same_bytes_on_any_number_of_threads() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "one", &["--threads", "1"]);
    small_planet(folder.path(), "two", &["--threads", "2"]);
    let (one, two) = (folder.path().join("one"), folder.path().join("two"));
    let mut names: Vec<String> = OVERLAYS.iter().map(|name| format!("{name}.png")).collect();
    names.extend(["elevation.png".into(), "planet.pangaea".into()]);
    for name in &names {
        let bytes = fs::read(one.join(name)).unwrap();
        assert!(!bytes.is_empty(), "{name}");
        assert!(bytes == fs::read(two.join(name)).unwrap(), "{name}");
    }
    names.push("stats.json".into());
    names.sort();
    assert_eq!(names_in(&one), names);
}

/// The pixels of a map of 2048 by 1024 in 16 bits of grey, as km.
fn read_elevation(path: &Path) -> Vec<f64> {
    let file = BufReader::new(fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (2048, 1024));
    assert_eq!(info.color_type, png::ColorType::Grayscale);
    assert_eq!(info.bit_depth, png::BitDepth::Sixteen);
    pixels
        .as_chunks::<2>()
        .0
        .iter()
        .map(|&bytes| f64::from(u16::from_be_bytes(bytes)) / 65535.0 * 24.0 - 12.0)
        .collect()
}

#[test]
fn elevation_is_16_bits_grey_of_2048_by_1024() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "a", &[]);
    let map = read_elevation(&folder.path().join("a/elevation.png"));
    let low = map.iter().copied().fold(f64::MAX, f64::min);
    let high = map.iter().copied().fold(f64::MIN, f64::max);
    let elevation = &stats(&folder.path().join("a"))["elevation_km"];
    assert!(low >= elevation["min"].as_f64().unwrap() - 1e-3);
    assert!(high <= elevation["max"].as_f64().unwrap() + 1e-3);
    assert!(low < -3.0 && high > 0.0, "{low} {high}");
}

/// The statistics of a planet of 500 samples at 30 My.
fn small_stats() -> Value {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "a", &["--seed", "3"]);
    stats(&folder.path().join("a"))
}

#[test]
fn stats_have_the_documented_form() {
    let stats = small_stats();
    let mut keys: Vec<&String> = stats.as_object().unwrap().keys().collect();
    keys.sort();
    let expected = [
        "continental_fraction",
        "digest",
        "elevation_km",
        "generator",
        "hydrology",
        "hypsometry",
        "land_fraction",
        "ledger",
        "ocean_age_my",
        "orogeny_fraction",
        "peak_rss_mb",
        "plates",
        "samples",
        "steps",
        "time_my",
        "timings_ms",
    ];
    assert_eq!(keys, expected);
    assert_eq!(stats["samples"], 500);
    assert_eq!(stats["steps"], 15);
    assert_eq!(stats["time_my"], 30.0);
    let digest = stats["digest"].as_str().unwrap();
    assert!(digest.chars().all(|c| c.is_ascii_hexdigit()), "{digest}");
}

#[test]
fn accounts_and_shares_are_numbers() {
    let stats = small_stats();
    for path in [
        "/ledger/unexplained_max",
        "/ledger/arc_growth",
        "/orogeny_fraction/andean",
        "/ocean_age_my/max",
    ] {
        assert!(stats.pointer(path).unwrap().is_number(), "{path}");
    }
}

#[test]
fn shares_are_shares() {
    let stats = small_stats();
    for share in ["land_fraction", "continental_fraction"] {
        let value = stats[share].as_f64().unwrap();
        assert!((0.0..=1.0).contains(&value), "{share}");
    }
    let hypsometry = stats["hypsometry"].as_array().unwrap();
    let shares: Vec<f64> = hypsometry.iter().filter_map(Value::as_f64).collect();
    assert_eq!(shares.len(), 88);
    assert!(shares.iter().all(|&share| share >= 0.0));
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9);
}

#[test]
fn timings_are_positive_or_none() {
    let timings = &small_stats()["timings_ms"];
    for timing in ["mesh", "step_mean", "step_max", "total", "floor"] {
        assert!(timings[timing].as_f64().unwrap() > 0.0, "{timing}");
    }
    for timing in ["resample_mean", "rift_mean"] {
        let value = &timings[timing];
        assert!(value.is_null() || value.is_number(), "{timing}: {value}");
    }
}
