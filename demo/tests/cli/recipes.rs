//! Presets and scenarios are checked before a planet grows, and commands while it does.

use crate::program::{
    assert_contains, assert_refused_in, names_in, pangaea, stats, stderr, succeed,
};
use std::fs;
use tempfile::TempDir;

const PRESET: [&str; 3] = ["generate", "--preset", "a.planet.ron"];

#[test]
fn presets_are_checked_line_by_line() {
    let folder = TempDir::new().unwrap();
    let huge = "(\n  seed: 1,\n  samples: 1000000000000,\n)";
    let negative = "(\n  samples: 500,\n  params: (\n    erosion: -1,\n  ),\n)";
    let crowded = "(\n  samples: 500,\n  plate_count: 100000,\n)";
    for (text, words) in [
        (huge, &["line 3"][..]),
        ("(\n  sampels: 500,\n)", &["line 2", "sampels"]),
        ("(\n  land: NaN,\n)", &["line 2", "land", "0.9"]),
        (negative, &["line 4", "erosion"]),
        (crowded, &["100000"]),
        ("nonsense", &["line 1"]),
        ("", &["line 1"]),
    ] {
        fs::write(folder.path().join("a.planet.ron"), text).unwrap();
        let words = [&["a.planet.ron"], words].concat();
        assert_refused_in(folder.path(), &PRESET, &words);
    }
}

#[test]
fn presets_that_are_no_text_are_refused() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("a.planet.ron"), [0xff, 0xfe, 0x00]).unwrap();
    assert_refused_in(folder.path(), &PRESET, &["a.planet.ron"]);
    assert_refused_in(folder.path(), &["generate", "--preset", "."], &["."]);
}

#[test]
fn a_preset_may_begin_with_a_byte_order_mark() {
    let folder = TempDir::new().unwrap();
    let text = "(\r\n  seed: 9,\r\n  samples: 500,\r\n  plate_count: 12,\r\n)\r\n";
    let utf16: Vec<u16> = format!("\u{feff}{text}").encode_utf16().collect();
    for (name, bytes) in [
        ("plain", text.as_bytes().to_vec()),
        ("marked", format!("\u{feff}{text}").into_bytes()),
        (
            "utf16",
            utf16.into_iter().flat_map(u16::to_le_bytes).collect(),
        ),
    ] {
        fs::write(folder.path().join("a.planet.ron"), bytes).unwrap();
        succeed(
            folder.path(),
            &[&PRESET[..], &["--until", "2", "--out", name]].concat(),
        );
    }
    let digest = |name: &str| stats(&folder.path().join(name))["digest"].clone();
    assert_eq!(digest("plain"), digest("marked"));
    assert_eq!(digest("plain"), digest("utf16"));
}

/// The lines that are said while the planet of a preset is generated.
fn said_of(preset: &str) -> String {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("a.planet.ron"), preset).unwrap();
    let args = [&PRESET[..], &["--until", "2", "--out", "o"]].concat();
    let output = pangaea(folder.path(), &args);
    assert!(output.status.success(), "{}", stderr(&output));
    stderr(&output)
}

#[test]
fn whatever_a_planet_will_lack_is_said_at_the_start() {
    let start = "samples: 500, plate_count: 12";
    let island = "(center: (10, 20), radius: 200)";
    for (preset, words) in [
        (
            format!("({start}, continents: [{island}, {island}])"),
            ["warning: 2 of 2 continents", "1802 km"],
        ),
        (
            format!("({start}, land: 0.01)"),
            ["warning: a share of land of 0.01", "500 samples"],
        ),
        (
            format!("({start}, radius: 12000)"),
            ["warning: there is no ground", "10000 km"],
        ),
    ] {
        assert_contains(&said_of(&preset), &words);
    }
    assert!(!said_of(&format!("({start})")).contains("warning"));
}

/// `generate` for a planet of 500 samples, with a scenario.
const PLAY: [&str; 7] = [
    "generate",
    "--samples",
    "500",
    "--plates",
    "10",
    "--scenario",
    "a.scenario.ron",
];

/// A folder with a scenario in it.
fn with_scenario(text: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("a.scenario.ron"), text).unwrap();
    folder
}

#[test]
fn commands_that_the_planet_refuses_end_the_growth() {
    let north = "SetPlateMotion(plate: 0, pole: (91, 0), speed: 1)";
    let missing = "SetPlateMotion(plate: 999, pole: (0, 0), speed: 1)";
    for (command, word) in [
        ("SetParam(name: \"upift\", value: 1)", "upift"),
        (north, "latitude"),
        (missing, "999"),
    ] {
        let folder = with_scenario(&format!("[(step: 1, command: {command})]"));
        let args = [&PLAY[..], &["--until", "20"]].concat();
        assert_refused_in(folder.path(), &args, &["step 1", word]);
    }
}

#[test]
fn a_scenario_changes_the_planet() {
    let raise = "PaintCrust(target: Everywhere, brush: Raise(0.5))";
    let folder = with_scenario(&format!("[(step: 2, command: {raise})]"));
    let until = ["--until", "20", "--out"];
    succeed(folder.path(), &[&PLAY[..], &until, &["played"]].concat());
    succeed(folder.path(), &[&PLAY[..5], &until, &["plain"]].concat());
    let digest = |name: &str| stats(&folder.path().join(name))["digest"].clone();
    assert_ne!(digest("played"), digest("plain"));
}

/// Grows a planet and asserts its number of steps and its time in My.
fn assert_ends(folder: &TempDir, args: &[&str], until: &str, (steps, time_my): (u64, f64)) {
    let out = ["--until", until, "--out", "a"];
    succeed(folder.path(), &[args, &out].concat());
    let stats = stats(&folder.path().join("a"));
    assert_eq!(stats["steps"], steps, "{until}");
    assert_eq!(stats["time_my"], time_my, "{until}");
}

#[test]
fn a_planet_grows_until_the_time_even_where_a_scenario_changes_the_step() {
    let step_of_4 = "[(step: 1, command: SetParam(name: \"time_step\", value: 4))]";
    let folder = with_scenario(step_of_4);
    assert_ends(&folder, &PLAY, "30", (8, 30.0));
    assert_ends(&folder, &PLAY, "31", (9, 34.0));
    assert_ends(&folder, &PLAY[..5], "0.1", (1, 2.0));
}

#[test]
fn commands_after_the_end_are_refused_before_the_planet_grows() {
    let step_of_4 = "SetParam(name: \"time_step\", value: 4)";
    for (first, late, steps) in [
        ("Resample", 16, "15 steps"),
        ("Resample", 1000, "15 steps"),
        (step_of_4, 9, "8 steps"),
    ] {
        let text = format!("[(step: 1, command: {first}), (step: {late}, command: Resample)]");
        let folder = with_scenario(&text);
        let late = format!("step {late}");
        let place = ["a.scenario.ron", "command 2", &late];
        let words = [&place[..], &["after the end", steps]].concat();
        for command in ["generate", "render", "views"] {
            let size = [command, "--samples", "2000000", "--until", "30"];
            let play = ["--scenario", "a.scenario.ron", "--out", "out"];
            assert_refused_in(folder.path(), &[&size[..], &play].concat(), &words);
        }
        assert_eq!(names_in(folder.path()), ["a.scenario.ron"]);
    }
}
