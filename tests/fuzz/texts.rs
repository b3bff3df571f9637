//! Presets, scenarios and terrain files.

use super::{Trial, tiny};
use bevy_pangaea::io::load_planet;
use bevy_pangaea::io::preset::parse_recipe;
use bevy_pangaea::io::scenario::parse_scenario;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::fuzz::{Format, fuzz};
use std::fs;

/// Numbers and signs that a parser of RON meets.
const WORDS: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    ",",
    ":",
    "Some(",
    "None",
    "NaN",
    "inf",
    "-inf",
    "-1",
    "1e308",
    "1e-308",
    "18446744073709551616",
    "0x7f",
    "\"",
    "'",
    "r#\"",
    "/*",
    "*/",
    "//",
    "\\u{10ffff}",
    "é",
    "\0",
    "\u{feff}",
    "#![enable(implicit_some)]",
    "true",
    "()",
];

/// Largest planet that is grown to see whether its recipe works.
const SAMPLES: u32 = 300;

fn format<'a>(name: &'a str, good: &[&str]) -> Format<'a> {
    Format {
        name,
        good: good.iter().map(|text| text.as_bytes().to_vec()).collect(),
        words: WORDS,
    }
}

/// Asserts that an error is one line.
fn assert_one_line(error: &impl ToString) {
    let text = error.to_string();
    assert!(!text.is_empty() && !text.contains('\n'), "{text}");
}

#[test]
fn damaged_presets_are_refused_or_make_planets() {
    let good = [
        "(seed: 7, samples: 100, plate_count: 5, land: 0.4, radius: 6370)",
        "(samples: 150, plates: [(centroid: (10, -60), pole: (55, 20), speed: 40),
          (centroid: (-20, 120))], continents: [(center: (10, -60), radius: 2500)],
          params: (erosion: 0.05, processes: (noise: false), ocean_floor: Paper))",
    ];
    let mut trial = Trial::new();
    fuzz(&format("presets", &good), |bytes| {
        match parse_recipe(&String::from_utf8_lossy(bytes)) {
            Err(error) => assert_one_line(&error),
            Ok(recipe) if recipe.samples <= SAMPLES => {
                trial.lives_on(PlanetState::new(&recipe).expect("a recipe that was accepted"));
            }
            Ok(recipe) => recipe.validate().expect("a recipe that was accepted"),
        }
    });
}

#[test]
fn damaged_scenarios_are_refused_or_play() {
    let good = [
        "[(step: 0, command: SetPlateMotion(plate: 3, pole: (60, -30), speed: 80)),
          (step: 0, command: RiftPlate(plate: 1, line: [(0, 10), (20, 14)]))]",
        "[(step: 0, command: PaintCrust(target: Disc(center: (10, 20), radius: 800), brush: Raise(2))),
          (step: 0, command: SetParam(name: \"erosion\", value: 0.1)),
          (step: 0, command: SetProcess(name: \"drift\", on: false)),
          (step: 3, command: Resample)]",
        "[(step: 0, command: RiftPlate(plate: 2, fragments: 3)),
          (step: 0, command: SetPlateCrust(plate: 1, kind: Continental)),
          (step: 0, command: PaintCrust(target: Everywhere, brush: Kind(Oceanic)))]",
    ];
    let start = tiny(3);
    let mut trial = Trial::new();
    fuzz(&format("scenarios", &good), |bytes| {
        match parse_scenario(&String::from_utf8_lossy(bytes)) {
            Err(error) => assert_one_line(&error),
            Ok(scenario) => {
                let mut state = start.clone();
                state.pending = scenario;
                trial.lives_on(state);
            }
        }
    });
}

/// The maps are not there: a file that is understood is refused for that, and no planet is made.
#[test]
fn damaged_terrain_files_are_refused() {
    let good = [
        "(elevation: \"none.tif\", unit: kilometres, radius: 3000, seed: 9)",
        "(elevation: \"none.png\", age: \"a.png\", plateaus: \"p.png\", hills: \"b.png\",
          temperature: \"t.tif\", rain: \"r.tif\", wetness: \"w.png\")",
    ];
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.terrain.ron");
    fuzz(&format("terrain files", &good), |bytes| {
        fs::write(&path, bytes).unwrap();
        let error = load_planet(&path).err().expect("none of its maps is there");
        assert_one_line(&error);
    });
}
