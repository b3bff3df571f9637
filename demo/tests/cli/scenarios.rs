//! Commands of a planet, written as a scenario and played again.

use crate::program::{assert_refused_in, small_planet, stats, succeed};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Commands in no order, one of them after the last of the 15 steps.
const SCENARIO: &str = "[
    (step: 15, command: SetParam(name: \"erosion\", value: 0.3)),
    (step: 4, command: PaintCrust(target: Disc(center: (10, 20), radius: 900), brush: Raise(0.7))),
    (step: 0, command: SetPlateMotion(plate: 3, pole: (60.1, -30), speed: 80.7)),
    (step: 4, command: RiftPlate(plate: 5)),
]";

fn digest(folder: &Path, name: &str) -> Value {
    stats(&folder.join(name))["digest"].clone()
}

#[test]
fn a_written_scenario_gives_the_same_planet() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("a.scenario.ron"), SCENARIO).unwrap();
    let play = ["--scenario", "a.scenario.ron"];
    let written = ["--scenario-out", "b.scenario.ron"];
    small_planet(folder.path(), "a", &[play, written].concat());
    small_planet(folder.path(), "b", &["--scenario", "b.scenario.ron"]);
    assert_eq!(digest(folder.path(), "a"), digest(folder.path(), "b"));
    small_planet(folder.path(), "plain", &[]);
    assert_ne!(digest(folder.path(), "a"), digest(folder.path(), "plain"));
    // The save knows them, too.
    let info = [
        "info",
        "a/planet.pangaea",
        "--scenario-out",
        "c.scenario.ron",
    ];
    succeed(folder.path(), &info);
    let [grown, saved] = ["b", "c"]
        .map(|name| fs::read_to_string(folder.path().join(format!("{name}.scenario.ron"))));
    let grown = grown.unwrap();
    assert_eq!(grown, saved.unwrap());
    assert_eq!(grown.matches("(step: ").count(), 4, "{grown}");
}

#[test]
fn places_without_a_scenario_file_are_refused_before_the_planet_grows() {
    let folder = TempDir::new().unwrap();
    for place in ["no/such/a.scenario.ron", "."] {
        let size = ["generate", "--samples", "2000000", "--out", "out"];
        let args = [&size[..], &["--scenario-out", place]].concat();
        assert_refused_in(folder.path(), &args, &[place]);
    }
}
