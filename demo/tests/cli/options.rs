//! Options: numbers with limits, names, help.

use crate::program::{assert_contains, assert_refused, pangaea};
use tempfile::TempDir;

#[test]
fn bad_numbers_are_refused_by_option_and_limits() {
    let numbers = ["-1", "NaN", "inf", "-inf", "1e300", "", "x"];
    let seeds = ["18446744073709551616", "1.5"];
    for (option, limits, also) in [
        ("--samples", ["100", "2000000"], ["0", "1000000000000"]),
        ("--plates", ["2", "1000"], ["0", "100000"]),
        ("--land", ["0", "0.9"], ["1", "-0.1"]),
        ("--until", ["0.1", "10000"], ["0", "1e9"]),
        ("--threads", ["1", "1024"], ["0", "1000000"]),
        ("--seed", ["0", "18446744073709551615"], seeds),
    ] {
        let words = [option, limits[0], limits[1]];
        for value in numbers.into_iter().chain(also) {
            assert_refused(&["generate", option, value], &words);
        }
    }
}

#[test]
fn more_plates_than_samples_can_carry_are_refused() {
    let args = ["generate", "--samples", "100", "--plates", "50"];
    assert_refused(&args, &["50 plates", "500"]);
}

#[test]
fn bad_cameras_are_refused() {
    for camera in [
        "",
        "1,2",
        "91,0,1000",
        "0,0,0",
        "0,NaN,5",
        "0,0,inf",
        "1,2,3,4",
        "0,0,1e12",
        "0,0,5,0,100",
    ] {
        let args = ["render", "--camera", camera, "--out", "a.png"];
        assert_refused(&args, &["--camera"]);
    }
}

#[test]
fn bad_sizes_and_overlays_are_refused() {
    for size in ["0x0", "10x10", "-5x100", "100000x100000", "720", "NaNx3"] {
        let args = ["render", "--size", size, "--out", "a.png"];
        assert_refused(&args, &["--size", "16", "8192"]);
    }
    let args = ["render", "--overlay", "rainbow", "--out", "a.png"];
    assert_refused(&args, &["--overlay", "ocean_age"]);
    let args = [
        "maps",
        "a.pangaea",
        "--overlay",
        "plates,rainbow",
        "--out",
        "m",
    ];
    assert_refused(&args, &["--overlay", "ocean_age"]);
    for size in ["0", "15", "17", "8194", "1e3", "-64"] {
        let args = ["maps", "a.pangaea", "--size", size, "--out", "m"];
        assert_refused(&args, &["--size", "even", "8192"]);
    }
}

#[test]
fn options_that_are_missing_or_exclude_each_other_are_refused() {
    assert_refused(&["render"], &["--out"]);
    assert_refused(&["info"], &["FILE"]);
    let args = ["render", "a.pangaea", "--seed", "1", "--out", "a.png"];
    assert_refused(&args, &["--seed"]);
    let args = ["render", "nowhere.pangaea", "--out", "a.png"];
    assert_refused(&args, &["nowhere.pangaea"]);
}

#[test]
fn unknown_names_are_refused() {
    assert_refused(&["explode"], &["explode"]);
    assert_refused(&["generate", "--sampels", "5"], &["--sampels"]);
    assert_refused(&["bench", "--samples", "60000,99"], &["--samples", "100"]);
    assert_refused(&["bench", "--samples", "0"], &["--samples"]);
}

/// Asserts that the program prints all of `words` to stdout, and nothing to stderr.
fn assert_prints(args: &[&str], words: &[&str]) {
    let folder = TempDir::new().unwrap();
    let output = pangaea(folder.path(), args);
    assert!(output.status.success(), "{args:?}");
    assert!(output.stderr.is_empty(), "{args:?}");
    assert_contains(&String::from_utf8_lossy(&output.stdout), words);
}

#[test]
fn help_and_version_go_to_stdout() {
    assert_prints(&["--version"], &["pangaea 0."]);
    assert_prints(
        &["--help"],
        &["generate", "maps", "render", "views", "bench"],
    );
    assert_prints(&["--help"], &["info", "export", "relief", "query"]);
    let words = ["--samples", "60000", "--until", "250", "pangaea-out"];
    assert_prints(&["generate", "--help"], &words);
    let words = ["LAT,LON,ALTITUDE_M[,HEADING,PITCH]", "1280x720"];
    assert_prints(&["render", "--help"], &words);
}
