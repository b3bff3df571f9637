//! The facts of a save, and the measurements of a machine.

use crate::program::{
    assert_contains, assert_refused_in, planet, read_json, small_planet, stats, succeed,
};
use serde_json::Value;
use std::fs;
use tempfile::TempDir;

#[test]
fn info_tells_the_facts() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "a", &[]);
    let text = succeed(folder.path(), &["info", "a/planet.pangaea"]);
    let stats = stats(&folder.path().join("a"));
    let digest = stats["digest"].as_str().unwrap();
    assert_contains(&text, &["500", "30 My in 15 steps", digest]);
}

#[test]
fn damaged_files_are_refused() {
    let folder = planet();
    let whole = fs::read(folder.path().join("planet.pangaea")).unwrap();
    let mut flipped = whole.clone();
    flipped[whole.len() / 3] ^= 16;
    let mut newer = whole.clone();
    newer[8] = 9;
    for (bytes, words) in [
        (&whole[..whole.len() / 2], &["damaged"][..]),
        (&[], &["no Pangaea planet"]),
        (b"PNG or whatever", &["no Pangaea planet"]),
        (&flipped, &["checksum"]),
        (&newer, &["version 9", "newer"]),
    ] {
        fs::write(folder.path().join("b.pangaea"), bytes).unwrap();
        let words = [&["b.pangaea"], words].concat();
        assert_refused_in(folder.path(), &["info", "b.pangaea"], &words);
        let render = ["render", "b.pangaea", "--out", "c.png"];
        assert_refused_in(folder.path(), &render, &words);
    }
}

#[test]
fn files_that_are_missing_and_folders_are_refused() {
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("a")).unwrap();
    let missing = ["info", "missing.pangaea"];
    assert_refused_in(folder.path(), &missing, &["missing.pangaea"]);
    assert_refused_in(folder.path(), &["info", "a"], &["a"]);
}

/// The timings that every row of a bench has.
const TIMINGS: [&str; 7] = [
    "mesh",
    "step_mean",
    "step_max",
    "resample_mean",
    "rift_mean",
    "total",
    "floor",
];

#[test]
fn bench_prints_a_table_and_writes_its_timings() {
    let folder = TempDir::new().unwrap();
    let args = ["bench", "--samples", "400,800", "--json", "b.json"];
    let text = succeed(folder.path(), &args);
    assert_contains(&text, &["400", "800", "step mean", "resample", "rift"]);
    assert_contains(&text, &["floor", "subduction", "peak MB"]);
    let json = read_json(&folder.path().join("b.json"));
    let rows = json.as_array().unwrap();
    let samples: Vec<&Value> = rows.iter().map(|row| &row["samples"]).collect();
    assert_eq!(samples, [400, 800]);
    rows.iter().for_each(assert_timings);
}

fn assert_timings(row: &Value) {
    for timing in TIMINGS {
        let ms = row["timings_ms"][timing].as_f64();
        assert!(ms.is_some_and(|ms| ms > 0.0), "{timing}");
    }
}
