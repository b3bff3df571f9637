//! The headless commands as a user types them: exit codes, messages, and what is in the files.

use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

#[path = "cli/files.rs"]
mod files;

fn pangaea(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .args(args)
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .expect("the program starts")
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Asserts exit code 2, one line on stderr that contains all of `words`, and nothing written.
fn refused(args: &[&str], words: &[&str]) {
    let folder = TempDir::new().unwrap();
    refused_in(folder.path(), args, words);
    let left = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(left, 0, "{args:?} left files behind");
}

fn refused_in(folder: &Path, args: &[&str], words: &[&str]) {
    let output = pangaea(folder, args);
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {text}");
    assert!(text.starts_with("error: "), "{args:?}: {text}");
    assert_eq!(text.lines().count(), 1, "{args:?}: {text}");
    assert!(output.stdout.is_empty(), "{args:?}");
    for word in words {
        assert!(
            text.contains(word),
            "{args:?}: {text:?} does not name {word:?}"
        );
    }
}

/// A planet of 500 samples in `folder`/`name`.
fn small_planet(folder: &Path, name: &str, more: &[&str]) {
    let mut args = vec![
        "generate",
        "--samples",
        "500",
        "--plates",
        "12",
        "--until",
        "30",
        "--out",
        name,
    ];
    args.extend(more);
    let output = pangaea(folder, &args);
    assert!(output.status.success(), "{}", stderr(&output));
}

/// The names of all there is in a folder, sorted.
fn names_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn bad_numbers_are_refused_by_option_and_limits() {
    let numbers = ["-1", "NaN", "inf", "-inf", "1e300", "", "x"];
    for (option, limits, also) in [
        ("--samples", ["100", "2000000"], ["0", "1000000000000"]),
        ("--plates", ["2", "1000"], ["0", "100000"]),
        ("--land", ["0", "0.9"], ["1", "-0.1"]),
        ("--until", ["0.1", "10000"], ["0", "1e9"]),
        ("--threads", ["1", "1024"], ["0", "1000000"]),
        (
            "--seed",
            ["0", "18446744073709551615"],
            ["18446744073709551616", "1.5"],
        ),
    ] {
        for value in numbers.into_iter().chain(also) {
            refused(
                &["generate", option, value],
                &[option, limits[0], limits[1]],
            );
        }
    }
    refused(
        &["generate", "--samples", "100", "--plates", "50"],
        &["50 plates", "500"],
    );
}

#[test]
fn bad_views_are_refused() {
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
        refused(
            &["render", "--camera", camera, "--out", "a.png"],
            &["--camera"],
        );
    }
    for size in ["0x0", "10x10", "-5x100", "100000x100000", "720", "NaNx3"] {
        refused(
            &["render", "--size", size, "--out", "a.png"],
            &["--size", "16", "8192"],
        );
    }
    refused(
        &["render", "--overlay", "rainbow", "--out", "a.png"],
        &["--overlay", "ocean_age"],
    );
    refused(&["render"], &["--out"]);
    refused(
        &["render", "a.pangaea", "--seed", "1", "--out", "a.png"],
        &["--seed"],
    );
    refused(
        &["render", "nowhere.pangaea", "--out", "a.png"],
        &["nowhere.pangaea"],
    );
}

#[test]
fn unknown_names_are_refused() {
    refused(&["explode"], &["explode"]);
    refused(&["generate", "--sampels", "5"], &["--sampels"]);
    refused(&["bench", "--samples", "60000,99"], &["--samples", "100"]);
    refused(&["bench", "--samples", "0"], &["--samples"]);
    refused(&["info"], &["FILE"]);
}

#[test]
fn help_and_version_go_to_stdout() {
    let folder = TempDir::new().unwrap();
    for (args, words) in [
        (&["--version"][..], &["pangaea 0."][..]),
        (
            &["--help"],
            &[
                "generate", "render", "views", "bench", "info", "export", "relief", "query",
            ],
        ),
        (
            &["generate", "--help"],
            &["--samples", "60000", "--until", "250", "pangaea-out"],
        ),
        (
            &["render", "--help"],
            &["LAT,LON,ALTITUDE_M[,HEADING,PITCH]", "1280x720"],
        ),
    ] {
        let output = pangaea(folder.path(), args);
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(
            output.status.success() && output.stderr.is_empty(),
            "{args:?}"
        );
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
    }
}

#[test]
fn presets_are_checked_line_by_line() {
    let folder = TempDir::new().unwrap();
    let preset = folder.path().join("a.planet.ron");
    for (text, words) in [
        (
            "(\n  seed: 1,\n  samples: 1000000000000,\n)",
            &["line 3"][..],
        ),
        ("(\n  sampels: 500,\n)", &["line 2", "sampels"]),
        ("(\n  land: NaN,\n)", &["line 2", "land", "0.9"]),
        (
            "(\n  samples: 500,\n  params: (\n    erosion: -1,\n  ),\n)",
            &["line 4", "erosion"],
        ),
        ("(\n  samples: 500,\n  plate_count: 100000,\n)", &["100000"]),
        ("nonsense", &["line 1"]),
        ("", &["line 1"]),
    ] {
        fs::write(&preset, text).unwrap();
        let mut all = vec!["a.planet.ron"];
        all.extend(words);
        refused_in(
            folder.path(),
            &["generate", "--preset", "a.planet.ron"],
            &all,
        );
    }
    fs::write(&preset, [0xff, 0xfe, 0x00]).unwrap();
    refused_in(
        folder.path(),
        &["generate", "--preset", "a.planet.ron"],
        &["a.planet.ron"],
    );
    refused_in(folder.path(), &["generate", "--preset", "."], &["."]);
    assert!(!folder.path().join("pangaea-out").exists());
}

#[test]
fn scenarios_are_checked_before_and_while_they_play() {
    let folder = TempDir::new().unwrap();
    let scenario = folder.path().join("a.scenario.ron");
    let play = [
        "generate",
        "--samples",
        "500",
        "--plates",
        "10",
        "--until",
        "20",
        "--scenario",
        "a.scenario.ron",
    ];
    for (command, words) in [
        (
            "SetParam(name: \"upift\", value: 1)",
            &["step 1", "upift"][..],
        ),
        (
            "SetPlateMotion(plate: 0, pole: (91, 0), speed: 1)",
            &["step 1", "latitude"],
        ),
        (
            "SetPlateMotion(plate: 999, pole: (0, 0), speed: 1)",
            &["step 1", "999"],
        ),
    ] {
        fs::write(&scenario, format!("[(step: 1, command: {command})]")).unwrap();
        refused_in(folder.path(), &play, words);
    }
    assert!(!folder.path().join("pangaea-out").exists());
    fs::write(
        &scenario,
        "[(step: 2, command: PaintCrust(target: Everywhere, brush: Raise(0.5)))]",
    )
    .unwrap();
    assert!(pangaea(folder.path(), &play).status.success());
    let plain = [&play[..7], &["--out", "plain"]].concat();
    assert!(pangaea(folder.path(), &plain).status.success());
    let digest = |name: &str| stats(&folder.path().join(name))["digest"].clone();
    assert_ne!(digest("pangaea-out"), digest("plain"));
}

#[test]
fn a_planet_grows_until_the_time_even_where_a_scenario_changes_the_step() {
    let folder = TempDir::new().unwrap();
    let step_of_4 = "[(step: 1, command: SetParam(name: \"time_step\", value: 4))]";
    fs::write(folder.path().join("a.scenario.ron"), step_of_4).unwrap();
    for (until, steps, time) in [("30", 8, 30.0), ("31", 9, 34.0), ("0.1", 1, 2.0)] {
        let more: &[&str] = if steps > 1 {
            &["--scenario", "a.scenario.ron"]
        } else {
            &[]
        };
        let args = [
            "generate",
            "--samples",
            "500",
            "--plates",
            "10",
            "--until",
            until,
            "--out",
            "a",
        ];
        let output = pangaea(folder.path(), &[&args[..], more].concat());
        assert!(output.status.success(), "{}", stderr(&output));
        let stats = stats(&folder.path().join("a"));
        assert_eq!(
            (&stats["steps"], &stats["time_my"]),
            (&Value::from(steps), &Value::from(time)),
            "{until}"
        );
    }
}

#[test]
fn commands_after_the_end_are_refused_before_the_planet_grows() {
    let folder = TempDir::new().unwrap();
    let scenario = folder.path().join("a.scenario.ron");
    for (first, late, steps) in [
        ("Resample", 15, "15 steps"),
        ("Resample", 1000, "15 steps"),
        ("SetParam(name: \"time_step\", value: 4)", 8, "8 steps"),
    ] {
        let text = format!("[(step: 1, command: {first}), (step: {late}, command: Resample)]");
        fs::write(&scenario, text).unwrap();
        let play = [
            "--samples",
            "2000000",
            "--until",
            "30",
            "--scenario",
            "a.scenario.ron",
            "--out",
            "out",
        ];
        let words = [
            "a.scenario.ron",
            "command 2",
            &format!("step {late}"),
            "after the end",
            steps,
        ];
        for command in ["generate", "render", "views"] {
            refused_in(folder.path(), &[&[command], &play[..]].concat(), &words);
        }
    }
    assert_eq!(names_in(folder.path()), ["a.scenario.ron"]);
}

fn stats(folder: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join("stats.json")).unwrap()).unwrap()
}

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
        let (a, b) = (
            fs::read(one.join(name)).unwrap(),
            fs::read(two.join(name)).unwrap(),
        );
        assert!(!a.is_empty() && a == b, "{name}");
    }
    names.push("stats.json".into());
    names.sort();
    assert_eq!(names_in(&one), names);
}

#[test]
fn elevation_is_16_bits_grey_of_2048_by_1024() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "a", &[]);
    let file = fs::File::open(folder.path().join("a/elevation.png")).unwrap();
    let mut reader = png::Decoder::new(std::io::BufReader::new(file))
        .read_info()
        .unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    assert_eq!((info.width, info.height), (2048, 1024));
    assert_eq!(
        (info.color_type, info.bit_depth),
        (png::ColorType::Grayscale, png::BitDepth::Sixteen)
    );
    let km =
        |bytes: &[u8]| f64::from(u16::from_be_bytes([bytes[0], bytes[1]])) / 65535.0 * 24.0 - 12.0;
    let (low, high) = pixels
        .chunks(2)
        .map(km)
        .fold((f64::MAX, f64::MIN), |(low, high), z| {
            (low.min(z), high.max(z))
        });
    let elevation = &stats(&folder.path().join("a"))["elevation_km"];
    assert!(low >= elevation["min"].as_f64().unwrap() - 1e-3);
    assert!(high <= elevation["max"].as_f64().unwrap() + 1e-3);
    assert!(low < -3.0 && high > 0.0, "{low} {high}");
}

#[test]
fn stats_have_the_documented_form() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "a", &["--seed", "3"]);
    let stats = stats(&folder.path().join("a"));
    let keys: Vec<&str> = stats
        .as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect();
    let mut expected = vec![
        "digest",
        "samples",
        "plates",
        "steps",
        "time_my",
        "land_fraction",
        "continental_fraction",
        "elevation_km",
        "ocean_age_my",
        "hypsometry",
        "orogeny_fraction",
        "ledger",
        "hydrology",
        "timings_ms",
        "peak_rss_mb",
    ];
    expected.sort();
    let mut sorted = keys.clone();
    sorted.sort();
    assert_eq!(sorted, expected);
    assert_eq!(stats["samples"], 500);
    assert_eq!(stats["steps"], 15);
    assert_eq!(stats["time_my"], 30.0);
    assert!(
        stats["digest"]
            .as_str()
            .unwrap()
            .chars()
            .all(|c| c.is_ascii_hexdigit())
    );
    let shares: Vec<f64> = stats["hypsometry"]
        .as_array()
        .unwrap()
        .iter()
        .map(|share| share.as_f64().unwrap())
        .collect();
    assert_eq!(shares.len(), 88);
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9 && shares.iter().all(|&s| s >= 0.0));
    for share in ["land_fraction", "continental_fraction"] {
        assert!(
            (0.0..=1.0).contains(&stats[share].as_f64().unwrap()),
            "{share}"
        );
    }
    for timing in ["mesh", "step_mean", "step_max", "total", "floor"] {
        assert!(
            stats["timings_ms"][timing].as_f64().unwrap() > 0.0,
            "{timing}"
        );
    }
    for timing in ["resample_mean", "rift_mean"] {
        let value = &stats["timings_ms"][timing];
        assert!(value.is_null() || value.is_number(), "{timing}: {value}");
    }
    assert!(
        stats["ledger"]["unexplained_max"].is_number() && stats["ledger"]["arc_growth"].is_number()
    );
    assert!(
        stats["orogeny_fraction"]["andean"].is_number() && stats["ocean_age_my"]["max"].is_number()
    );
}

#[test]
fn info_tells_the_facts_and_refuses_damaged_files() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "a", &[]);
    let file = folder.path().join("a/planet.pangaea");
    let output = pangaea(folder.path(), &["info", "a/planet.pangaea"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let digest = stats(&folder.path().join("a"))["digest"]
        .as_str()
        .unwrap()
        .to_string();
    for word in ["500", "30 My in 15 steps", &digest] {
        assert!(text.contains(word), "{word}: {text}");
    }
    let whole = fs::read(&file).unwrap();
    let damaged = folder.path().join("b.pangaea");
    let check = |bytes: &[u8], words: &[&str]| {
        fs::write(&damaged, bytes).unwrap();
        let mut all = vec!["b.pangaea"];
        all.extend(words);
        refused_in(folder.path(), &["info", "b.pangaea"], &all);
        refused_in(
            folder.path(),
            &["render", "b.pangaea", "--out", "c.png"],
            &all,
        );
    };
    check(&whole[..whole.len() / 2], &["damaged"]);
    check(&[], &["no Pangaea planet"]);
    check(b"PNG or whatever", &["no Pangaea planet"]);
    let mut flipped = whole.clone();
    flipped[whole.len() / 3] ^= 16;
    check(&flipped, &["checksum"]);
    let mut newer = whole.clone();
    newer[8] = 9;
    check(&newer, &["version 9", "newer"]);
    refused_in(
        folder.path(),
        &["info", "missing.pangaea"],
        &["missing.pangaea"],
    );
    refused_in(folder.path(), &["info", "a"], &["a"]);
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_display_the_explorer_points_to_the_commands() {
    let folder = TempDir::new().unwrap();
    let program = env!("CARGO_BIN_EXE_pangaea");
    let output = Command::new(program)
        .current_dir(folder.path())
        .env_remove("DISPLAY")
        .output()
        .unwrap();
    let text = stderr(&output);
    assert_eq!(
        (output.status.code(), text.lines().count()),
        (Some(1), 1),
        "{text}"
    );
    assert!(
        text.contains("DISPLAY") && text.contains("pangaea --help"),
        "{text}"
    );
}

#[test]
fn bench_prints_a_table_and_writes_its_timings() {
    let folder = TempDir::new().unwrap();
    let output = pangaea(
        folder.path(),
        &["bench", "--samples", "400,800", "--json", "b.json"],
    );
    assert!(output.status.success(), "{}", stderr(&output));
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    for word in [
        "400",
        "800",
        "step mean",
        "resample",
        "rift",
        "floor",
        "subduction",
        "peak MB",
    ] {
        assert!(text.contains(word), "{word}: {text}");
    }
    let json: Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("b.json")).unwrap()).unwrap();
    let rows = json.as_array().unwrap();
    assert_eq!((rows.len(), &rows[1]["samples"]), (2, &Value::from(800)));
    for timing in [
        "mesh",
        "step_mean",
        "step_max",
        "resample_mean",
        "rift_mean",
        "total",
        "floor",
    ] {
        assert!(
            rows.iter().all(|row| row["timings_ms"][timing]
                .as_f64()
                .is_some_and(|ms| ms > 0.0)),
            "{timing}"
        );
    }
}
