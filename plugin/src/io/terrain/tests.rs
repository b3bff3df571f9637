use super::*;
use crate::io::png::grey_png;
use crate::math::direction;
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// Writes a map of 64 x 32 greys, by latitude and longitude, whose black and white have these
/// values.
fn map(folder: &TempDir, name: &str, ends: [f64; 2], grey: impl Fn(f64, f64) -> u16) {
    let step = 180.0 / 32.0;
    let greys = (0..64 * 32).map(|i| {
        let (x, y) = (f64::from(i % 64), f64::from(i / 64));
        grey(90.0 - (y + 0.5) * step, (x + 0.5) * step - 180.0)
    });
    let path = folder.path().join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(&path, grey_png(64, greys).unwrap()).unwrap();
    let [min, max] = ends;
    let sidecar = format!("{{\"min\": {min}, \"max\": {max}}}");
    fs::write(path.with_extension("json"), sidecar).unwrap();
}

/// Land in the east: white there, black elsewhere.
fn east(_: f64, lon: f64) -> u16 {
    if lon > 0.0 { u16::MAX } else { 0 }
}

/// Writes a terrain file.
fn terrain_file(folder: &TempDir, text: &str) -> PathBuf {
    let path = folder.path().join("a.terrain.ron");
    fs::write(&path, text).unwrap();
    path
}

/// The planet of a terrain file with this text.
fn planet(folder: &TempDir, text: &str) -> PlanetState {
    load_planet(&terrain_file(folder, text)).unwrap()
}

/// Elevation in km in the middle of the east and of the west.
fn heights(planet: &PlanetState) -> [f32; 2] {
    [90.0, -90.0].map(|lon| {
        let sample = planet.lattice.0.nearest(direction(0.0, lon));
        planet.crust.elevation[sample as usize]
    })
}

#[test]
fn names_tell_files_apart() {
    for (name, kind) in [
        ("a/EARTH.Terrain.RON", PlanetFileKind::Terrain),
        ("a/earth.tif", PlanetFileKind::Elevation),
        ("EARTH.TIFF", PlanetFileKind::Elevation),
        ("earth.png", PlanetFileKind::Elevation),
        ("earth.pangaea", PlanetFileKind::Save),
        ("earth.planet.ron", PlanetFileKind::Save),
        ("earth", PlanetFileKind::Save),
    ] {
        assert_eq!(PlanetFileKind::of(Path::new(name)), kind, "{name}");
    }
}

#[test]
fn elevations_are_metres_unless_the_file_says_otherwise() {
    let folder = TempDir::new().unwrap();
    map(&folder, "maps/m.png", [-3000.0, 1000.0], east);
    map(&folder, "maps/km.png", [-3.0, 1.0], east);
    let metres = planet(&folder, r#"(elevation: "maps/m.png")"#);
    let text = r#"(elevation: "maps/km.png", unit: kilometres)"#;
    let kilometres = planet(&folder, text);
    let alone = load_planet(&folder.path().join("maps/m.png")).unwrap();
    for planet in [metres, kilometres, alone] {
        assert_eq!(heights(&planet), [1.0, -3.0]);
        assert_eq!((planet.planet.radius, planet.planet.seed), (6370.0, 0));
    }
}

#[test]
fn a_picture_without_a_sidecar_is_12_km_deep_and_high() {
    let folder = TempDir::new().unwrap();
    map(&folder, "m.png", [0.0, 1.0], |_, lon| {
        if lon > 0.0 { 36_864 } else { 16_384 }
    });
    fs::remove_file(folder.path().join("m.json")).unwrap();
    let [land, sea] = heights(&planet(&folder, r#"(elevation: "m.png")"#));
    // 36,864 of 65,535 is 1.5 km, 16,384 is -6 km.
    assert!((land - 1.5).abs() < 1e-3 && (sea + 6.0).abs() < 1e-3);
}

#[test]
fn every_field_arrives() {
    let folder = TempDir::new().unwrap();
    map(&folder, "m.png", [-3000.0, 1000.0], east);
    map(&folder, "share.png", [0.0, 1.0], east);
    map(&folder, "high.png", [10.0, 20.0], east);
    let state = planet(
        &folder,
        r#"(elevation: "m.png", radius: 3000, seed: 9, age: "high.png", plateaus: "share.png",
            hills: "share.png", temperature: "high.png", rain: "high.png", wetness: "share.png")"#,
    );
    assert_eq!((state.planet.radius, state.planet.seed), (3000.0, 9));
    let terrain = state.terrain.as_ref().unwrap();
    let names: Vec<&str> = terrain.iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["elevation", "age", "plateaus", "hills"]);
    let at = |map: &crate::climate::EquirectMap| map.at(direction(0.0, 90.0));
    let values: Vec<_> = terrain.iter().map(|(_, map)| at(map)).collect();
    assert_eq!(values, [Some(1.0), Some(20.0), Some(1.0), Some(1.0)]);
    let climate: Vec<_> = state.climate.iter().map(|(_, map)| at(map)).collect();
    assert_eq!(climate, [Some(20.0), Some(20.0), Some(1.0)]);
}

/// Asserts that a terrain file is refused in one line with these words.
fn assert_refused(folder: &TempDir, text: &str, words: &[&str]) {
    let problem = load_planet(&terrain_file(folder, text)).err().unwrap();
    let problem = problem.to_string();
    assert_eq!(problem.lines().count(), 1, "{problem}");
    for word in words {
        assert!(problem.contains(word), "{problem} does not name {word}");
    }
}

#[test]
fn bad_files_are_refused_by_name_and_line() {
    let folder = TempDir::new().unwrap();
    map(&folder, "m.png", [-3000.0, 1000.0], east);
    for (text, words) in [
        ("(radius: 3000)", &["a.terrain.ron", "elevation"][..]),
        ("(\nelevation: \"m.png\",\nsead: 3)", &["line 3", "sead"]),
        (r#"(elevation: "m.png", unit: feet)"#, &["feet"]),
        (r#"(elevation: "m.png", radius: -1)"#, &["ron", "radius"]),
        (r#"(elevation: "m.png", radius: NaN)"#, &["ron", "radius"]),
        (r#"(elevation: "none.tif")"#, &["none.tif"]),
        (r#"(elevation: "m.png", rain: "none.tif")"#, &["none.tif"]),
    ] {
        assert_refused(&folder, text, words);
    }
}

#[test]
fn maps_that_no_planet_is_made_of_are_named() {
    let folder = TempDir::new().unwrap();
    map(&folder, "m.png", [-3000.0, 1000.0], east);
    map(&folder, "km.png", [-3.0, 1.0], east);
    map(&folder, "feet.png", [-36_000.0, 29_000.0], east);
    for (text, words) in [
        (r#"(elevation: "km.png")"#, ["km.png", "unit: kilometres"]),
        (
            r#"(elevation: "feet.png")"#,
            ["feet.png", "-15000 to 15000 m"],
        ),
        (
            r#"(elevation: "m.png", unit: kilometres)"#,
            ["m.png", "look like metres"],
        ),
        (
            r#"(elevation: "m.png", hills: "feet.png")"#,
            ["feet.png", "hills"],
        ),
        (r#"(elevation: "m.png", age: "km.png")"#, ["km.png", "age"]),
        (
            r#"(elevation: "m.png", rain: "feet.png")"#,
            ["feet.png", "rain"],
        ),
    ] {
        assert_refused(&folder, text, &words);
    }
}

#[test]
fn voids_of_maps_of_the_climate_are_noted() {
    let folder = TempDir::new().unwrap();
    map(&folder, "m.png", [-3000.0, 1000.0], east);
    // Wetness of 1, two pixels of which are transparent.
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 4, 2);
    encoder.set_color(png::ColorType::GrayscaleAlpha);
    let mut writer = encoder.write_header().unwrap();
    let pixels = [[255, 0].repeat(2), [255, 255].repeat(6)].concat();
    writer.write_image_data(&pixels).unwrap();
    drop(writer);
    fs::write(folder.path().join("w.png"), bytes).unwrap();
    let text = r#"(elevation: "m.png", wetness: "w.png")"#;
    let loaded = load_planet_with_notes(&terrain_file(&folder, text)).unwrap();
    let [note] = loaded.notes.as_slice() else {
        panic!("{:?}", loaded.notes)
    };
    assert!(
        note.contains("w.png") && note.contains("2 voids of 8"),
        "{note}"
    );
}

#[test]
fn voids_of_the_elevation_are_refused() {
    let folder = TempDir::new().unwrap();
    let pixels = [128_u8, 255].repeat(32 * 16);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 32, 16);
    encoder.set_color(png::ColorType::GrayscaleAlpha);
    let holes: Vec<u8> = [128, 0]
        .into_iter()
        .chain(pixels.into_iter().skip(2))
        .collect();
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&holes).unwrap();
    drop(writer);
    fs::write(folder.path().join("m.png"), bytes).unwrap();
    let words = ["m.png", "has no value at pixel 0"];
    assert_refused(&folder, r#"(elevation: "m.png")"#, &words);
}
