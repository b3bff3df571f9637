//! Relief statistics of a planet, beside those of real tiles.

#[cfg(target_os = "linux")]
use crate::program::pangaea_within;
use crate::program::{
    assert_contains, assert_refused, assert_refused_in, pangaea, planet, read_json, stderr, succeed,
};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The figures of a planet beside those of a folder of tiles.
const BESIDE_TILES: [&str; 8] = [
    "relief",
    "planet.pangaea",
    "--sites",
    "1",
    "--json",
    "r.json",
    "--dem",
    "tiles",
];

const CLASSES: [&str; 4] = ["young_himalayan", "young_andean", "old_belts", "plains"];

#[test]
fn bad_options_and_planets_are_refused() {
    assert_refused(&["relief"], &["PLANET.pangaea"]);
    assert_refused(&["relief", "missing.pangaea"], &["missing.pangaea"]);
    let args = ["relief", "a.pangaea", "--sites", "0"];
    assert_refused(&args, &["1 to 20"]);
    let folder = planet();
    let args = ["relief", "planet.pangaea", "--json", "no/such/a.json"];
    assert_refused_in(folder.path(), &args, &["no/such/a.json"]);
    fs::write(folder.path().join("bad.pangaea"), "no planet").unwrap();
    let words = ["bad.pangaea", "no Pangaea planet"];
    assert_refused_in(folder.path(), &["relief", "bad.pangaea"], &words);
}

/// The folder of real tiles: `$PANGAEA_DATA/dem`, else `shared/data/dem` beside the repository.
fn real_tiles() -> Option<PathBuf> {
    let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data");
    let data = std::env::var_os("PANGAEA_DATA").unwrap_or_else(|| beside.into());
    let folder = PathBuf::from(data).join("dem");
    if !folder.is_dir() {
        eprintln!("skipped: {} is missing", folder.display());
        return None;
    }
    Some(folder)
}

/// The figures that `relief` writes for planet.pangaea.
fn relief(folder: &Path, more: &[&str]) -> Value {
    let sites = ["relief", "planet.pangaea", "--sites", "1"];
    let args = [&sites[..], &["--json", "r.json"], more].concat();
    let text = succeed(folder, &args);
    assert_contains(&text, &CLASSES);
    assert_contains(&text, &["relief in 10 km", "coherence", "geomorphons, %"]);
    read_json(&folder.join("r.json"))
}

/// Asserts that every class has its figures, or no sites.
fn assert_has_classes(figures: &Value) {
    for class in CLASSES {
        let figures = &figures[class];
        let sites = figures["sites"].as_u64().unwrap();
        assert!(sites <= 1);
        for key in ["relief10_median_m", "slope_p90_deg"] {
            assert!(figures[key].is_number() || sites == 0, "{class} {key}");
        }
        for key in [
            "coherence_median",
            "coherence_p90",
            "slope_area_exponent",
            "pits_percent",
        ] {
            assert!(figures.get(key).is_some(), "{class} {key}");
        }
        // A site may be too rough or too flat to have one.
        assert!(figures.get("spectral_exponent").is_some(), "{class}");
    }
}

#[test]
fn relief_has_figures_of_classes() {
    let folder = planet();
    let figures = relief(folder.path(), &[]);
    assert_has_classes(&figures);
    assert!(figures["tiles"].as_object().unwrap().is_empty());
}

#[test]
fn relief_has_figures_of_real_tiles() {
    let Some(real) = real_tiles() else { return };
    let folder = planet();
    let figures = relief(folder.path(), &["--dem", real.to_str().unwrap()]);
    assert_has_classes(&figures);
    let tiles = &figures["tiles"];
    let annapurna = &tiles["himalaya-annapurna"]["relief10_median_m"];
    let ratio = annapurna.as_f64().unwrap() / 3221.0;
    assert!((ratio - 1.0).abs() < 0.05, "{annapurna}");
    assert_eq!(tiles["N44W072"]["sites"], 1);
    let nearest = &figures["nearest_tile"]["himalaya-annapurna"];
    assert_eq!(nearest, "andes-aconcagua");
    let shares = &figures["geomorphons"]["himalaya-annapurna"];
    assert_eq!(shares.as_object().unwrap().len(), 10);
    assert_eq!(tiles.as_object().unwrap().len(), 5);
}

#[test]
fn bad_tiles_are_named() {
    let folder = planet();
    let tiles = folder.path().join("tiles");
    fs::create_dir(&tiles).unwrap();
    let measure = ["relief", "planet.pangaea", "--json", "r.json", "--dem"];
    let args = [&measure[..], &["tiles"]].concat();
    assert_refused_in(folder.path(), &args, &["tiles", ".hgt"]);
    for (name, words) in [
        ("N44W072.hgt", &["N44W072.hgt", "1201"][..]),
        ("b.tif", &["b.tif"]),
        ("c.png", &["c.png", "c.json"]),
        ("._N44W072.hgt", &["._N44W072.hgt", "hidden"]),
    ] {
        let path = tiles.join(name);
        fs::write(&path, "nonsense").unwrap();
        assert_refused_in(folder.path(), &args, words);
        fs::remove_file(path).unwrap();
    }
    let args = [&measure[..], &["nowhere"]].concat();
    assert_refused_in(folder.path(), &args, &["nowhere"]);
}

/// A tile of 1201 x 1201 heights in m.
fn hgt(height: impl Fn(usize) -> i16) -> Vec<u8> {
    (0..1201 * 1201)
        .flat_map(|i| height(i).to_be_bytes())
        .collect()
}

/// Heights of ridges across each other.
fn hills(i: usize) -> i16 {
    let slope = |k: usize, period: usize| (k % period).abs_diff(period / 2) as i16;
    500 + slope(i % 1201, 400) + slope(i / 1201, 300)
}

#[test]
fn bad_tiles_beside_good_ones_are_passed_over() {
    let folder = planet();
    let tiles = folder.path().join("tiles");
    fs::create_dir(&tiles).unwrap();
    let good = hgt(hills);
    for (name, content) in [
        ("N44W072.SRTMGL1.HGT", &good[..]),
        ("N44W071 (1).hgt", &good),
        ("N00E006.hgt", &hgt(|_| i16::MIN)),
        ("N01E006.hgt", &good[..1_000_000]),
        ("._N44W072.hgt", b"Mac OS X"),
        (".DS_Store", b"Bud1"),
        ("preview.png", b"no sidecar"),
        ("preview.png.aux.xml", b"<PAMDataset/>"),
    ] {
        fs::write(tiles.join(name), content).unwrap();
    }
    let output = pangaea(folder.path(), &BESIDE_TILES);
    let said = stderr(&output);
    assert!(output.status.success(), "{said}");
    let warnings: Vec<&str> = said.lines().collect();
    assert_eq!(warnings.len(), 4, "{said}");
    for (warning, words) in warnings.iter().zip([
        ["._N44W072.hgt", "hidden"],
        ["N00E006.hgt", "only voids"],
        ["N01E006.hgt", "1000000 bytes"],
        ["preview.png", "preview.json"],
    ]) {
        assert_contains(warning, &["warning", "passed over"]);
        assert_contains(warning, &words);
    }
    let figures = read_json(&folder.path().join("r.json"));
    let measured: Vec<&String> = figures["tiles"].as_object().unwrap().keys().collect();
    assert_eq!(measured, ["N44W071 (1)", "N44W072.SRTMGL1"]);
}

#[test]
fn what_looks_like_a_tile_and_is_none_is_named() {
    let folder = planet();
    let tiles = folder.path().join("tiles");
    fs::create_dir_all(tiles.join("N02E006.hgt")).unwrap();
    for name in [
        "N03E006.zip",
        "N04E006.hgt.part",
        "a.ASC",
        "notes.txt",
        "a.md5",
    ] {
        fs::write(tiles.join(name), "x").unwrap();
    }
    let args = ["relief", "planet.pangaea", "--dem", "tiles"];
    assert_refused_in(folder.path(), &args, &["N02E006.hgt", "no file", "3 more"]);
    fs::write(tiles.join("N44W072.hgt"), hgt(hills)).unwrap();
    let output = pangaea(folder.path(), &BESIDE_TILES);
    let said = stderr(&output);
    assert!(output.status.success(), "{said}");
    let named = ["N02E006.hgt", "N03E006.zip", "N04E006.hgt.part", "a.ASC"];
    assert_eq!(said.lines().count(), named.len(), "{said}");
    for (warning, name) in said.lines().zip(named) {
        assert_contains(warning, &["warning", name, "passed over"]);
    }
}

#[test]
fn a_folder_without_a_good_tile_is_refused_in_one_line() {
    let folder = planet();
    let tiles = folder.path().join("tiles");
    fs::create_dir(&tiles).unwrap();
    fs::write(tiles.join("N00E006.hgt"), hgt(|_| i16::MIN)).unwrap();
    fs::write(tiles.join("b.tif"), "nonsense").unwrap();
    let args = ["relief", "planet.pangaea", "--dem", "tiles"];
    let words = ["tiles", "N00E006.hgt", "only voids", "1 more"];
    assert_refused_in(folder.path(), &args, &words);
}

/// A GeoTIFF of `side` x `side` heights of one byte, 300 m and below: pixels of 10 m, in strips of
/// 1000 rows that are all alike.
fn wide_raster(side: u32) -> Vec<u8> {
    const ROWS: u32 = 1000;
    let row: Vec<u8> = (0..side).map(|x| (x / 100 % 200) as u8).collect();
    let mut packed = ZlibEncoder::new(Vec::new(), Compression::fast());
    for _ in 0..ROWS {
        packed.write_all(&row).unwrap();
    }
    let strip = packed.finish().unwrap();
    let count = side / ROWS;
    let mut values = Vec::new();
    // Behind the head, the strip and twelve entries.
    let start = 8 + strip.len() as u32 + 2 + 12 * 12 + 4;
    let mut place = |bytes: Vec<u8>| {
        let at = start + values.len() as u32;
        values.extend(bytes);
        at
    };
    let offsets = place(8_u32.to_le_bytes().repeat(count as usize));
    let lengths = place((strip.len() as u32).to_le_bytes().repeat(count as usize));
    let scale = place([10.0_f64, 10.0, 0.0].map(f64::to_le_bytes).concat());
    let tie = place(
        [0.0_f64, 0.0, 0.0, 4e5, 5e6, 0.0]
            .map(f64::to_le_bytes)
            .concat(),
    );
    let keys = [1_u16, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, 9001];
    let keys = place(keys.map(u16::to_le_bytes).concat());
    // Tag, type, number of values, value or its place.
    let entries = [
        [256, 4, 1, side],
        [257, 4, 1, side],
        [258, 3, 1, 8],
        [259, 3, 1, 8],
        [262, 3, 1, 1],
        [273, 4, count, offsets],
        [277, 3, 1, 1],
        [278, 4, 1, ROWS],
        [279, 4, count, lengths],
        [33_550, 12, 3, scale],
        [33_922, 12, 6, tie],
        [34_735, 3, 12, keys],
    ];
    let mut file = b"II\x2a\0".to_vec();
    file.extend((8 + strip.len() as u32).to_le_bytes());
    file.extend(strip);
    file.extend((entries.len() as u16).to_le_bytes());
    for [tag, kind, count, value] in entries {
        file.extend([tag as u16, kind as u16].map(u16::to_le_bytes).concat());
        file.extend([count, value].map(u32::to_le_bytes).concat());
    }
    file.extend([0; 4]);
    file.extend(values);
    file
}

/// Memory that a model may take, threads included, in KiB.
#[cfg(target_os = "linux")]
const LITTLE_MEMORY: &str = "v 1300000";

#[cfg(target_os = "linux")]
#[test]
fn a_raster_of_many_pixels_takes_little_memory() {
    let folder = planet();
    let tiles = folder.path().join("tiles");
    fs::create_dir(&tiles).unwrap();
    // Whole it has 3.6 GB of heights.
    fs::write(tiles.join("wide.tif"), wide_raster(30_000)).unwrap();
    let output = pangaea_within(LITTLE_MEMORY, folder.path(), &BESIDE_TILES);
    let said = stderr(&output);
    assert!(output.status.success(), "{said}");
    assert_contains(
        &said,
        &[
            "warning",
            "wide.tif",
            "30000 x 30000 pixels",
            "3750 x 3750 means",
        ],
    );
    let figures = read_json(&folder.path().join("r.json"));
    // Steps of 1 m and cliffs of 199 m every 200 km: all windows of 10 km have a range of 10 m.
    let range = figures["tiles"]["wide"]["relief10_median_m"]
        .as_f64()
        .unwrap();
    assert!((range - 10.0).abs() < 0.6, "{range}");
}
