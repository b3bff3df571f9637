//! Maps of a planet file: those that `generate` draws, in any size.

use crate::program::{assert_refused_in, names_in, pangaea, planet, small_planet, stderr, succeed};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Width and height of a picture.
fn size(path: &Path) -> (u32, u32) {
    let file = std::io::BufReader::new(fs::File::open(path).unwrap());
    let reader = png::Decoder::new(file).read_info().unwrap();
    (reader.info().width, reader.info().height)
}

#[test]
fn maps_of_a_save_are_those_that_generate_drew() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "a", &[]);
    succeed(folder.path(), &["maps", "a/planet.pangaea", "--out", "m"]);
    let maps = names_in(&folder.path().join("m"));
    let mut drawn = names_in(&folder.path().join("a"));
    drawn.retain(|name| name.ends_with(".png"));
    assert_eq!(maps, drawn);
    for name in maps {
        let [saved, grown] = ["m", "a"].map(|from| fs::read(folder.path().join(from).join(&name)));
        assert!(saved.unwrap() == grown.unwrap(), "{name}");
    }
}

#[test]
fn the_maps_that_are_asked_for_are_drawn_in_the_size_that_is_asked_for() {
    let folder = planet();
    let size_and_overlays = ["--size", "64", "--overlay", "rain,plates,rain"];
    let args = [
        &["maps", "planet.pangaea", "--out", "m"],
        &size_and_overlays[..],
    ]
    .concat();
    succeed(folder.path(), &args);
    let maps = folder.path().join("m");
    assert_eq!(names_in(&maps), ["elevation.png", "plates.png", "rain.png"]);
    for name in names_in(&maps) {
        assert_eq!(size(&maps.join(&name)), (64, 32), "{name}");
    }
}

#[test]
fn maps_are_refused_before_anything_is_drawn() {
    let folder = planet();
    fs::write(folder.path().join("file"), "x").unwrap();
    let maps = ["maps", "planet.pangaea", "--out", "file"];
    assert_refused_in(folder.path(), &maps, &["file"]);
    let missing = ["maps", "missing.pangaea", "--out", "m"];
    assert_refused_in(folder.path(), &missing, &["missing.pangaea"]);
}

#[test]
fn maps_that_stay_of_another_planet_are_named() {
    let folder = planet();
    small_planet(folder.path(), "other", &["--seed", "9"]);
    let maps = |planet: &str, overlays: &str| {
        let size = ["--size", "64", "--out", "m", "--overlay", overlays];
        stderr(&pangaea(
            folder.path(),
            &[&["maps", planet], &size[..]].concat(),
        ))
    };
    fs::create_dir(folder.path().join("m")).unwrap();
    fs::write(folder.path().join("m/slope.png"), "mine").unwrap();
    assert!(!maps("planet.pangaea", "rain,plates,rivers").contains("warning"));
    // Those of the same planet belong together.
    assert!(!maps("planet.pangaea", "wetness").contains("warning"));
    let text = maps("other/planet.pangaea", "rain,plates");
    let is_named = |word: &str| text.contains(word);
    assert!(
        is_named("warning: older maps stay") && is_named(".png and 1 more"),
        "{text}"
    );
    let names = ["elevation", "plates", "rain", "rivers", "slope", "wetness"];
    let names = names.map(|name| format!("{name}.png"));
    assert_eq!(names_in(&folder.path().join("m")), names);
}
