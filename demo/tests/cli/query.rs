//! Points of the ground.

use crate::program::{
    assert_contains, assert_refused, assert_refused_in, pangaea_with_input, planet, stderr,
    succeed_with_input,
};
use std::fs;
use std::path::Path;

const HEADER: &str = "lat,lon,height_m,water_m,normal_x,normal_y,normal_z,surface";

#[test]
fn bad_options_are_refused_by_name() {
    for at in [
        "", "1", "1,2,3", "91,0", "-90.5,0", "0,400", "NaN,0", "0,inf",
    ] {
        assert_refused(&["query", "a.pangaea", "--at", at], &["--at"]);
    }
    for level in ["18", "-1", "NaN", "1.5", "999999999999999999999"] {
        let args = ["query", "a.pangaea", "--at", "0,0", "--level", level];
        assert_refused(&args, &["--level", "17"]);
    }
    assert_refused(&["query"], &["PLANET.pangaea"]);
}

#[test]
fn planets_that_are_missing_or_damaged_are_refused() {
    let args = ["query", "missing.pangaea", "--at", "0,0"];
    assert_refused(&args, &["missing.pangaea"]);
    let folder = planet();
    fs::write(folder.path().join("bad.pangaea"), "no planet").unwrap();
    let args = ["query", "bad.pangaea", "--at", "0,0"];
    let words = ["bad.pangaea", "no Pangaea planet"];
    assert_refused_in(folder.path(), &args, &words);
}

fn ask(folder: &Path, args: &[&str], input: &str) -> String {
    let args = [&["query", "planet.pangaea"], args].concat();
    succeed_with_input(folder, &args, input)
}

/// Asserts that a line answers the point `point`, with numbers that make sense.
fn assert_answers(line: &str, point: &str) {
    let fields: Vec<&str> = line.split(',').collect();
    assert_eq!(fields[..2].join(","), point);
    let numbers: Vec<f64> = fields[2..7].iter().map(|n| n.parse().unwrap()).collect();
    let [height, water, normal @ ..] = &numbers[..] else {
        panic!("{line}")
    };
    assert!((-12_000.0..12_000.0).contains(height), "{line}");
    assert!(*water >= height - 1e-9, "{line}");
    let length: f64 = normal.iter().map(|n| n * n).sum();
    assert!((length - 1.0).abs() < 1e-4, "{line}");
    let [surface] = fields[7..] else {
        panic!("{line}")
    };
    assert!(!surface.is_empty(), "{line}");
    assert!(surface.chars().all(|c| c.is_ascii_lowercase() || c == '_'));
}

#[test]
fn points_are_answered_in_the_order_of_the_input() {
    let folder = planet();
    let points: Vec<String> = (0..200)
        .map(|i| format!("{},{}", 80 - i % 160, 3 * i - 300))
        .collect();
    let text = ask(folder.path(), &[], &points.join("\n"));
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!((lines[0], lines.len()), (HEADER, 201));
    for (line, point) in lines[1..].iter().zip(&points) {
        assert_answers(line, point);
    }
}

#[test]
fn a_point_has_one_answer_however_it_is_asked_for() {
    let folder = planet();
    let one = ask(folder.path(), &["--at", "-33,-70"], "");
    assert_eq!(one, ask(folder.path(), &["--at=-33,-70"], "ignored"));
    assert_eq!(one, ask(folder.path(), &["--level", "17"], "-33,-70\n"));
    assert_eq!(ask(folder.path(), &[], ""), format!("{HEADER}\n"));
}

#[test]
fn lines_before_a_bad_one_are_answered_and_it_is_named() {
    let folder = planet();
    for (input, answers, words) in [
        ("1,2\n3\n", 1, &["line 2", "LAT,LON"][..]),
        ("1,2\n91,0\n", 1, &["line 2", "latitude"]),
        ("nan,0\n", 0, &["line 1", "latitude"]),
        ("0,1e9\n", 0, &["line 1", "longitude"]),
        ("0,0,0\n", 0, &["line 1"]),
        ("Manaus\n", 0, &["line 1"]),
    ] {
        let output = pangaea_with_input(folder.path(), &["query", "planet.pangaea"], input);
        let text = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert_eq!(text.lines().count(), 1, "{text}");
        assert_contains(&text, words);
        let printed = String::from_utf8(output.stdout).unwrap();
        assert_eq!(printed.lines().skip(1).count(), answers, "{input}");
    }
}
