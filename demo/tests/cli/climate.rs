//! Maps of a user that replace fields of the climate.

use crate::program::{
    assert_contains, assert_refused_in, pangaea, pangaea_with_input, planet, small_planet, stderr,
    succeed, succeed_with_input,
};
use std::fs;
use std::path::Path;
use std::process::Output;
use tempfile::TempDir;

/// A map of 8-bit grey, twice as wide as high.
fn grey_map(path: &Path, grey: u8) {
    let mut encoder = png::Encoder::new(fs::File::create(path).unwrap(), 16, 8);
    encoder.set_color(png::ColorType::Grayscale);
    encoder
        .write_header()
        .unwrap()
        .write_image_data(&[grey; 128])
        .unwrap();
}

/// So many points of the planet, a line each.
fn points(count: i32) -> String {
    (0..count)
        .map(|i| format!("{},{}\n", 60 - i % 120, 3 * (i % 117) - 170))
        .collect()
}

/// How many of 400 points are frozen, and how many are land.
fn frozen_and_land(folder: &Path, maps: &[&str]) -> (usize, usize) {
    let args = [&["query", "planet.pangaea", "--level", "6"], maps].concat();
    let text = succeed_with_input(folder, &args, &points(400));
    let frozen = |line: &&str| line.ends_with("snow") || line.ends_with("ice");
    let land = |line: &&str| !line.ends_with("sea_floor");
    (
        text.lines().filter(frozen).count(),
        text.lines().filter(land).count(),
    )
}

#[test]
fn maps_replace_fields_of_the_climate() {
    let folder = planet();
    grey_map(&folder.path().join("t.png"), 0);
    fs::write(folder.path().join("t.json"), r#"{"min": -60, "max": 60}"#).unwrap();
    let (mild, _) = frozen_and_land(folder.path(), &[]);
    let (frozen, land) = frozen_and_land(folder.path(), &["--temperature", "t.png"]);
    assert!(mild < frozen, "{mild} {frozen}");
    assert!(frozen * 2 > land, "{frozen} of {land} points are frozen");
}

/// A map of grey 0, transparent but for the rows of the north.
fn northern_map(path: &Path) {
    let mut encoder = png::Encoder::new(fs::File::create(path).unwrap(), 16, 8);
    encoder.set_color(png::ColorType::GrayscaleAlpha);
    let data: Vec<u8> = (0..128)
        .flat_map(|i| [0, if i < 64 { 255 } else { 0 }])
        .collect();
    encoder
        .write_header()
        .unwrap()
        .write_image_data(&data)
        .unwrap();
}

#[test]
fn voids_of_a_map_keep_the_planets_own_climate() {
    let folder = planet();
    northern_map(&folder.path().join("t.png"));
    fs::write(folder.path().join("t.json"), r#"{"min": -60, "max": 60}"#).unwrap();
    let map = ["--temperature", "t.png"];
    for place in ["-40,10", "-30,-100", "-20,140"] {
        let [given, own] = [&map[..], &[]].map(|maps| surface(&query(&folder, place, maps)));
        assert_eq!(given, own, "{place}");
    }
    let said = stderr(&query(&folder, "40,10", &map));
    assert_eq!(said.lines().count(), 1, "{said}");
    assert_contains(&said, &["t.png", "64 voids of 128", "planet's own"]);
}

/// Asks for the ground at a place.
fn query(folder: &TempDir, place: &str, maps: &[&str]) -> Output {
    let args = ["query", "planet.pangaea", "--level", "6", "--at", place];
    pangaea(folder.path(), &[&args, maps].concat())
}

/// The surface in the last column of an answer.
fn surface(answer: &Output) -> String {
    let text = String::from_utf8_lossy(&answer.stdout);
    text.trim().rsplit(',').next().unwrap().into()
}

/// A folder with two maps of rain, and a planet that was grown with the first.
fn dry_planet() -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, grey) in [("dry", 10), ("wet", 250)] {
        grey_map(&folder.path().join(format!("{name}.png")), grey);
        let scale = folder.path().join(format!("{name}.json"));
        fs::write(scale, r#"{"min": 0, "max": 4000}"#).unwrap();
    }
    small_planet(folder.path(), "a", &["--rain", "dry.png"]);
    folder
}

/// Heights and kinds of the ground at 300 points, and what is said on stderr.
fn ground(folder: &Path, maps: &[&str]) -> (String, String) {
    let args = [&["query", "a/planet.pangaea", "--level", "8"], maps].concat();
    let output = pangaea_with_input(folder, &args, &points(300));
    assert!(output.status.success(), "{}", stderr(&output));
    let said = stderr(&output);
    (String::from_utf8(output.stdout).unwrap(), said)
}

#[test]
fn a_save_keeps_the_maps_that_it_was_grown_with() {
    let folder = dry_planet();
    let (kept, said) = ground(folder.path(), &[]);
    assert_eq!(said, "");
    let (repeated, said) = ground(folder.path(), &["--rain", "dry.png"]);
    assert!(kept == repeated, "the ground is another one");
    assert_eq!(said, "");
    let (other, said) = ground(folder.path(), &["--rain", "wet.png"]);
    assert!(kept != other, "the map that is given counts");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert_contains(&said, &["--rain", "replaces"]);
}

#[test]
fn info_shows_the_maps_of_a_save() {
    let folder = dry_planet();
    let text = succeed(folder.path(), &["info", "a/planet.pangaea"]);
    let maps: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with("map "))
        .collect();
    assert_eq!(maps.len(), 1, "{text}");
    assert_contains(
        maps[0],
        &["rain, 16 x 8 pixels", "0 of them void", "BLAKE3"],
    );
    let text = succeed(planet().path(), &["info", "planet.pangaea"]);
    assert!(!text.lines().any(|line| line.starts_with("map ")), "{text}");
}

/// Asserts that a command refuses each map that is no climate.
fn assert_checks_maps(command: &[&str]) {
    let folder = planet();
    grey_map(&folder.path().join("dry.png"), 10);
    grey_map(&folder.path().join("hot.png"), 255);
    fs::write(folder.path().join("hot.json"), r#"{"min": 0, "max": 3000}"#).unwrap();
    fs::write(folder.path().join("bad.tif"), "nonsense").unwrap();
    let hot = ["hot.png", "3000", "-150 to 150 °C"];
    for (map, words) in [
        (["--rain", "missing.tif"], &["missing.tif"][..]),
        (["--rain", "bad.tif"], &["bad.tif", "no TIFF"]),
        (["--rain", "dry.png"], &["dry.png", "dry.json"]),
        (["--temperature", "hot.png"], &hot),
        (["--wetness", "dry.jpg"], &["dry.jpg", ".tif"]),
    ] {
        let args = [command, &map].concat();
        assert_refused_in(folder.path(), &args, words);
    }
}

#[test]
fn maps_that_are_no_climate_are_refused_before_anything_grows() {
    assert_checks_maps(&["generate", "--samples", "2000000", "--out", "out"]);
    let square = ["export", "planet.pangaea", "--region", "0,0,10"];
    assert_checks_maps(&[&square[..], &["--out", "a.tif"]].concat());
    assert_checks_maps(&["maps", "planet.pangaea", "--out", "m"]);
    assert_checks_maps(&["render", "planet.pangaea", "--out", "a.png"]);
    assert_checks_maps(&["relief", "planet.pangaea", "--json", "r.json"]);
    assert_checks_maps(&["query", "planet.pangaea", "--at", "0,0"]);
}
