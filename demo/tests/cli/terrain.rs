//! Planets of maps alone: terrain files, and maps of the elevation.

use crate::program::{
    assert_contains, assert_refused_in, names_in, pangaea, succeed, succeed_with_input,
};
use bevy_pangaea::math;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Degrees from the middle of the continent, 0° N 0° E, to its coast.
const COAST: f64 = 40.0;

/// The top of its mountain.
const MOUNTAIN: (f64, f64) = (10.0, -20.0);

/// Degrees between two places.
fn degrees_between([a, b]: [(f64, f64); 2]) -> f64 {
    let [a, b] = [a, b].map(|(lat, lon)| math::direction(lat, lon));
    math::angle_between(a, b).to_degrees()
}

/// Elevation in m: a round continent, a plain of 1 km within 30° of its middle, from where it falls
/// to the sea and on to a floor of 4 km, and a mountain of 4 km.
fn island(lat: f64, lon: f64) -> f64 {
    let inland = COAST - degrees_between([(lat, lon), (0.0, 0.0)]);
    let plain = (100.0 * inland).clamp(-4000.0, 1000.0);
    let away = degrees_between([(lat, lon), MOUNTAIN]);
    plain + (3000.0 * (1.0 - away / 5.0)).max(0.0)
}

/// Writes a map of 256 x 128 greys of 16 bits between two values.
fn write_map(path: &Path, [min, max]: [f64; 2], value: impl Fn(f64, f64) -> f64) {
    let step = 180.0 / 128.0;
    let greys = (0..256 * 128).flat_map(|i| {
        let (x, y) = (f64::from(i % 256), f64::from(i / 256));
        let value = value(90.0 - (y + 0.5) * step, (x + 0.5) * step - 180.0);
        let grey = (value - min) / (max - min) * 65_535.0;
        (grey.round() as u16).to_be_bytes()
    });
    let mut encoder = png::Encoder::new(fs::File::create(path).unwrap(), 256, 128);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Sixteen);
    let data: Vec<u8> = greys.collect();
    encoder
        .write_header()
        .unwrap()
        .write_image_data(&data)
        .unwrap();
    let sidecar = format!("{{\"min\": {min}, \"max\": {max}}}");
    fs::write(path.with_extension("json"), sidecar).unwrap();
}

/// A folder with a/island.terrain.ron and the map that it names, a/maps/island.png.
fn island_files() -> TempDir {
    let folder = TempDir::new().unwrap();
    let maps = folder.path().join("a/maps");
    fs::create_dir_all(&maps).unwrap();
    write_map(&maps.join("island.png"), [-5000.0, 5000.0], island);
    let text = "(\n    elevation: \"maps/island.png\",\n    seed: 5,\n)\n";
    fs::write(folder.path().join("a/island.terrain.ron"), text).unwrap();
    folder
}

/// An answer of `query`.
struct Answer {
    height_m: f64,
    is_sea: bool,
}

/// The ground of a planet at points.
fn ask(folder: &Path, planet: &str, level: &str, points: &[(f64, f64)]) -> Vec<Answer> {
    let input: String = points
        .iter()
        .map(|(lat, lon)| format!("{lat},{lon}\n"))
        .collect();
    let text = succeed_with_input(folder, &["query", planet, "--level", level], &input);
    let answers: Vec<Answer> = text.lines().skip(1).map(answer).collect();
    assert_eq!(answers.len(), points.len());
    answers
}

fn answer(line: &str) -> Answer {
    let fields: Vec<&str> = line.split(',').collect();
    Answer {
        height_m: fields[2].parse().unwrap(),
        is_sea: fields[7] == "sea_floor",
    }
}

/// Points of a grid around a place, so many degrees to either side of it.
fn points_around((lat, lon): (f64, f64), reach: f64) -> Vec<(f64, f64)> {
    (0..21 * 21)
        .map(|i| [i % 21, i / 21].map(|k| reach * (f64::from(k) / 10.0 - 1.0)))
        .map(|[north, east]| (lat + north, lon + east))
        .collect()
}

fn mean(answers: &[Answer]) -> f64 {
    answers.iter().map(|answer| answer.height_m).sum::<f64>() / answers.len() as f64
}

#[test]
fn a_kilometre_of_the_map_is_a_kilometre_of_ground() {
    let folder = island_files();
    // In the middle of the plain. Valleys are cut and crests stand in it, but not for nothing is
    // its mean that of the map: within 30 % at a level whose edges are 200 m.
    let plain = points_around((-5.0, 15.0), 5.0);
    let ground = ask(folder.path(), "a/island.terrain.ron", "8", &plain);
    let height = mean(&ground);
    assert!((700.0..1300.0).contains(&height), "{height} m");
    let floor = points_around((0.0, 150.0), 5.0);
    let height = mean(&ask(folder.path(), "a/island.terrain.ron", "8", &floor));
    assert!((-4600.0..-3400.0).contains(&height), "{height} m");
}

#[test]
fn the_mountain_is_where_the_map_says() {
    let folder = island_files();
    let (lat, lon) = MOUNTAIN;
    let mountain = highest(folder.path(), MOUNTAIN);
    assert!((3000.0..7000.0).contains(&mountain), "{mountain} m");
    for elsewhere in [(-lat, lon), (lat, -lon), (-lat, -lon), (0.0, 0.0)] {
        let height = highest(folder.path(), elsewhere);
        assert!(height < 2200.0, "{height} m at {elsewhere:?}");
    }
}

/// The highest ground in m around a place of the island's planet.
fn highest(folder: &Path, about: (f64, f64)) -> f64 {
    let points = points_around(about, 1.5);
    let ground = ask(folder, "a/island.terrain.ron", "6", &points);
    ground.iter().map(|at| at.height_m).fold(f64::MIN, f64::max)
}

#[test]
fn the_share_of_land_is_that_of_the_map() {
    let folder = island_files();
    // Points of a Fibonacci spiral stand for equal areas.
    let points: Vec<(f64, f64)> = (0..3000)
        .map(|i| {
            let sine = (2.0 * f64::from(i) + 1.0) / 3000.0 - 1.0;
            let turn = f64::from(i) * 0.618_033_988_749_895;
            (math::asin(sine).to_degrees(), 360.0 * turn.fract() - 180.0)
        })
        .collect();
    let ground = ask(folder.path(), "a/island.terrain.ron", "6", &points);
    let land = ground.iter().filter(|at| !at.is_sea).count() as f64 / 3000.0;
    // The share of a cap.
    let share = 0.5 * (1.0 - math::cos(COAST.to_radians()));
    assert!((land - share).abs() < 0.015, "{land} {share}");
}

/// The 16-bit greys of a picture, and its width.
fn greys(path: &Path) -> (Vec<u16>, u32) {
    let file = std::io::BufReader::new(fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!(info.bit_depth, png::BitDepth::Sixteen);
    let pairs = bytes.chunks_exact(2);
    let greys = pairs.map(|pair| u16::from_be_bytes([pair[0], pair[1]]));
    (greys.collect(), info.width)
}

#[test]
fn maps_of_a_planet_of_maps_show_them_again() {
    let folder = island_files();
    let options = [
        "--size",
        "128",
        "--overlay",
        "elevation,drainage,rivers,rain",
    ];
    let args = [
        &["maps", "a/island.terrain.ron", "--out", "m"],
        &options[..],
    ]
    .concat();
    succeed(folder.path(), &args);
    let maps = folder.path().join("m");
    let names = ["drainage", "elevation", "elevation_color", "rain", "rivers"];
    assert_eq!(names_in(&maps), names.map(|name| format!("{name}.png")));
    let (greys, width) = greys(&maps.join("elevation.png"));
    for (i, grey) in (0_u32..).zip(greys) {
        let (x, y) = (f64::from(i % width), f64::from(i / width));
        let step = 360.0 / f64::from(width);
        let (lat, lon) = (90.0 - (y + 0.5) * step, (x + 0.5) * step - 180.0);
        let metres = f64::from(grey) / 65_535.0 * 24_000.0 - 12_000.0;
        // The foot and the top of the mountain are blunted by a pixel of either map.
        let error = (metres - island(lat, lon)).abs();
        assert!(error < 450.0, "{metres} m at {lat}, {lon}");
    }
}

#[test]
fn all_commands_about_the_ground_take_a_terrain_file() {
    let folder = island_files();
    let planet = "a/island.terrain.ron";
    let tile = ["export", planet, "--region", "10,-20,300", "--pixels", "16"];
    succeed(folder.path(), &[&tile[..], &["--out", "tile.tif"]].concat());
    assert!(folder.path().join("tile.tif").is_file());
    let relief = succeed(folder.path(), &["relief", planet, "--sites", "1"]);
    assert_contains(&relief, &["plains"]);
    let facts = succeed(folder.path(), &["info", planet]);
    let words = [
        "terrain file",
        "elevation, 256 x 128 pixels",
        "6370 km",
        "plates       1",
    ];
    assert_contains(&facts, &words);
}

#[test]
fn a_map_of_the_elevation_is_a_planet_too() {
    let folder = island_files();
    let text = "(elevation: \"island.png\")";
    fs::write(folder.path().join("a/maps/same.terrain.ron"), text).unwrap();
    let alone = heights(folder.path(), "a/maps/island.png");
    assert_eq!(alone, heights(folder.path(), "a/maps/same.terrain.ron"));
    // Another seed has other rivers.
    assert_ne!(alone, heights(folder.path(), "a/island.terrain.ron"));
}

/// Heights in m of places about the island.
fn heights(folder: &Path, planet: &str) -> Vec<f64> {
    let points = points_around((5.0, -10.0), 12.0);
    let ground = ask(folder, planet, "5", &points);
    ground.iter().map(|at| at.height_m).collect()
}

#[test]
fn maps_that_are_missing_or_absurd_are_refused_in_one_line() {
    let folder = island_files();
    write_map(&folder.path().join("km.png"), [-5.0, 5.0], |_, _| 1.0);
    for (name, text, words) in [
        ("none", "(elevation: \"none.tif\")", &["none.tif"][..]),
        ("empty", "()", &["empty.terrain.ron", "elevation"]),
        (
            "km",
            "(elevation: \"km.png\")",
            &["km.png", "unit: kilometres"],
        ),
        (
            "radius",
            "(elevation: \"a/maps/island.png\", radius: 0)",
            &["radius.terrain.ron", "radius"],
        ),
    ] {
        let file = format!("{name}.terrain.ron");
        fs::write(folder.path().join(&file), text).unwrap();
        assert_refused_in(folder.path(), &["query", &file, "--at", "0,0"], words);
        assert_refused_in(folder.path(), &["maps", &file, "--out", "m"], words);
        assert_refused_in(folder.path(), &["info", &file], words);
        assert_refused_in(folder.path(), &["--open", &file], words);
        let tile = ["export", &file, "--region", "0,0,10", "--out", "a.tif"];
        assert_refused_in(folder.path(), &tile, words);
    }
}

#[test]
fn the_example_of_the_assets_is_a_planet() {
    let assets = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/terrain");
    let output = pangaea(&assets, &["query", "islands.terrain.ron", "--at", "20,-60"]);
    assert!(output.status.success());
}
