//! `export`, `relief` and `query` as a user types them: exit codes, messages, files.

use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// Runs the program in `folder` with `input` on its standard input.
fn pangaea(folder: &Path, args: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .args(args)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // A program that refuses its options does not read.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// A folder with planet.pangaea in it: 500 samples at 30 My.
fn planet() -> TempDir {
    let folder = TempDir::new().unwrap();
    let args = [
        "generate",
        "--samples",
        "500",
        "--plates",
        "12",
        "--until",
        "30",
        "--out",
        ".",
    ];
    let output = pangaea(folder.path(), &args, "");
    assert!(output.status.success(), "{}", stderr(&output));
    for entry in fs::read_dir(folder.path()).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().unwrap() != "pangaea" {
            fs::remove_file(path).unwrap();
        }
    }
    folder
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Asserts exit code 2, one line on stderr that contains all of `words`, and nothing written.
fn refused(folder: &Path, args: &[&str], input: &str, words: &[&str]) {
    let before = names(folder);
    let output = pangaea(folder, args, input);
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {text}");
    assert!(
        text.starts_with("error: ") && text.lines().count() == 1,
        "{args:?}: {text}"
    );
    assert!(output.stdout.is_empty(), "{args:?}");
    for word in words {
        assert!(
            text.contains(word),
            "{args:?}: {text:?} does not name {word:?}"
        );
    }
    assert_eq!(names(folder), before, "{args:?} left files behind");
}

#[test]
fn bad_options_are_refused_by_name() {
    let folder = TempDir::new().unwrap();
    let refused = |args: &[&str], words: &[&str]| refused(folder.path(), args, "", words);
    for region in [
        "", "1,2", "91,0,10", "0,361,10", "NaN,0,10", "0,0,inf", "0,0,0", "0,0,-5", "0,0,1e9",
        "a,b,c",
    ] {
        refused(
            &["export", "a.pangaea", "--out", "a.tif", "--region", region],
            &["--region"],
        );
    }
    for pixels in ["0", "1", "-5", "NaN", "1e3", "20000"] {
        let args = [
            "export",
            "a.pangaea",
            "--out",
            "a.tif",
            "--region",
            "0,0,10",
            "--pixels",
            pixels,
        ];
        refused(&args, &["--pixels", "16384"]);
    }
    refused(&["export", "a.pangaea", "--region", "0,0,10"], &["--out"]);
    refused(&["export", "a.pangaea", "--out", "a.tif"], &["--region"]);
    for out in ["a.bmp", "a", ".tif", "a.jpg"] {
        refused(
            &["export", "a.pangaea", "--region", "0,0,10", "--out", out],
            &[out, ".tif, .png or .glb"],
        );
    }
    let mesh = [
        "export",
        "a.pangaea",
        "--region",
        "0,0,10",
        "--out",
        "a.glb",
        "--pixels",
        "9000",
    ];
    refused(&mesh, &[".glb", "8192"]);
    for at in [
        "", "1", "1,2,3", "91,0", "-90.5,0", "0,400", "NaN,0", "0,inf",
    ] {
        refused(&["query", "a.pangaea", "--at", at], &["--at"]);
    }
    for level in ["18", "-1", "NaN", "1.5", "999999999999999999999"] {
        refused(
            &["query", "a.pangaea", "--at", "0,0", "--level", level],
            &["--level", "17"],
        );
    }
    for command in ["export", "relief", "query"] {
        refused(&[command], &["PLANET.pangaea"]);
    }
    refused(
        &["query", "missing.pangaea", "--at", "0,0"],
        &["missing.pangaea"],
    );
    refused(&["relief", "missing.pangaea"], &["missing.pangaea"]);
    refused(&["relief", "a.pangaea", "--sites", "0"], &["1 to 20"]);
    refused(
        &[
            "export",
            "missing.pangaea",
            "--region",
            "0,0,10",
            "--out",
            "a.tif",
        ],
        &["missing.pangaea"],
    );
}

#[test]
fn unwritable_places_and_squares_larger_than_the_planet_are_refused() {
    let folder = planet();
    let refused = |args: &[&str], words: &[&str]| refused(folder.path(), args, "", words);
    for out in [
        "no/such/a.tif",
        "planet.pangaea/a.png",
        "/proc/nowhere/a.glb",
    ] {
        refused(
            &[
                "export",
                "planet.pangaea",
                "--region",
                "0,0,10",
                "--out",
                out,
            ],
            &[out],
        );
    }
    refused(
        &["relief", "planet.pangaea", "--json", "no/such/a.json"],
        &["no/such/a.json"],
    );
    let large = [
        "export",
        "planet.pangaea",
        "--region",
        "0,0,90000",
        "--pixels",
        "16",
        "--out",
        "a.tif",
    ];
    refused(&large, &["--region"]);
    fs::write(folder.path().join("bad.pangaea"), "no planet").unwrap();
    for args in [
        &["query", "bad.pangaea", "--at", "0,0"][..],
        &["relief", "bad.pangaea"],
        &[
            "export",
            "bad.pangaea",
            "--region",
            "0,0,10",
            "--out",
            "a.tif",
        ],
    ] {
        refused(args, &["bad.pangaea", "no Pangaea planet"]);
    }
    fs::create_dir(folder.path().join("a.json")).unwrap();
    refused(
        &[
            "export",
            "planet.pangaea",
            "--region",
            "0,0,10",
            "--pixels",
            "8",
            "--out",
            "a.png",
        ],
        &["a.json"],
    );
}

#[test]
fn squares_are_written_in_every_format() {
    let folder = planet();
    let export = |out: &str| {
        let args = [
            "export",
            "planet.pangaea",
            "--region=-12.5,-170,500",
            "--pixels",
            "32",
            "--out",
            out,
        ];
        let output = pangaea(folder.path(), &args, "");
        assert!(
            output.status.success() && output.stdout.is_empty(),
            "{}",
            stderr(&output)
        );
        fs::read(folder.path().join(out)).unwrap()
    };
    assert_eq!(&export("a.tif")[..4], b"II*\0");
    assert_eq!(&export("a.png")[..4], b"\x89PNG");
    assert_eq!(&export("a.glb")[..4], b"glTF");
    let sidecar: Value =
        serde_json::from_slice(&fs::read(folder.path().join("a.json")).unwrap()).unwrap();
    assert_eq!(sidecar["metres_per_pixel"], 15_625.0);
    assert_eq!(
        (&sidecar["lat"], &sidecar["lon"]),
        (&Value::from(-12.5), &Value::from(-170.0))
    );
    assert!(sidecar["min_m"].as_f64().unwrap() <= sidecar["max_m"].as_f64().unwrap());
    assert_eq!(
        names(folder.path()),
        ["a.glb", "a.json", "a.png", "a.tif", "planet.pangaea"]
    );
    // The same again gives the same bytes.
    let first = fs::read(folder.path().join("a.tif")).unwrap();
    assert_eq!(export("a.tif"), first);
}

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

#[test]
fn maps_replace_fields_of_the_climate() {
    let folder = planet();
    grey_map(&folder.path().join("t.png"), 0);
    fs::write(folder.path().join("t.json"), r#"{"min": -60, "max": 60}"#).unwrap();
    let points: Vec<String> = (0..400)
        .map(|i| format!("{},{}", 60 - i % 120, 3 * (i % 117) - 170))
        .collect();
    let snow = |more: &[&str]| {
        let args = [&["query", "planet.pangaea", "--level", "6"], more].concat();
        let output = pangaea(folder.path(), &args, &points.join("\n"));
        assert!(output.status.success(), "{}", stderr(&output));
        let text = stdout(&output);
        let dry = text
            .lines()
            .filter(|line| !line.ends_with("sea_floor"))
            .count();
        (
            text.lines()
                .filter(|line| line.ends_with("snow") || line.ends_with("ice"))
                .count(),
            dry,
        )
    };
    let (mild, (frozen, land)) = (snow(&[]).0, snow(&["--temperature", "t.png"]));
    assert!(
        mild < frozen && frozen * 2 > land,
        "{mild} and {frozen} of {land} points are frozen"
    );
}

#[test]
fn maps_that_are_no_climate_are_refused_before_anything_grows() {
    let folder = planet();
    let write = |name: &str, grey| grey_map(&folder.path().join(name), grey);
    write("dry.png", 10);
    write("hot.png", 255);
    fs::write(folder.path().join("hot.json"), r#"{"min": 0, "max": 3000}"#).unwrap();
    fs::write(folder.path().join("bad.tif"), "nonsense").unwrap();
    let cases: [(&[&str], &[&str]); 5] = [
        (&["--rain", "missing.tif"], &["missing.tif"]),
        (&["--rain", "bad.tif"], &["bad.tif", "no TIFF"]),
        (&["--rain", "dry.png"], &["dry.png", "dry.json"]),
        (
            &["--temperature", "hot.png"],
            &["hot.png", "3000", "-150 to 150 °C"],
        ),
        (&["--wetness", "dry.jpg"], &["dry.jpg", ".tif"]),
    ];
    let commands: [&[&str]; 4] = [
        &["generate", "--samples", "2000000", "--out", "out"],
        &[
            "export",
            "planet.pangaea",
            "--region",
            "0,0,10",
            "--out",
            "a.tif",
        ],
        &["relief", "planet.pangaea", "--json", "r.json"],
        &["query", "planet.pangaea", "--at", "0,0"],
    ];
    for command in commands {
        for (maps, words) in cases {
            refused(folder.path(), &[command, maps].concat(), "", words);
        }
    }
}

const HEADER: &str = "lat,lon,height_m,water_m,normal_x,normal_y,normal_z,surface";

#[test]
fn points_are_answered_in_the_order_of_the_input() {
    let folder = planet();
    let ask = |args: &[&str], input: &str| {
        let output = pangaea(
            folder.path(),
            &[&["query", "planet.pangaea"], args].concat(),
            input,
        );
        assert!(output.status.success(), "{}", stderr(&output));
        stdout(&output)
    };
    let lines: Vec<String> = (0..200)
        .map(|i| format!("{},{}", 80 - i % 160, 3 * i - 300))
        .collect();
    let text = ask(&[], &lines.join("\n"));
    let rows: Vec<&str> = text.lines().collect();
    assert_eq!((rows[0], rows.len()), (HEADER, 201));
    for (row, line) in rows[1..].iter().zip(&lines) {
        assert!(row.starts_with(&format!("{line},")), "{row} {line}");
        let fields: Vec<&str> = row.split(',').collect();
        let number = |k: usize| fields[k].parse::<f64>().unwrap();
        assert!(
            fields.len() == 8
                && (-12_000.0..12_000.0).contains(&number(2))
                && number(3) >= number(2) - 1e-9
        );
        assert!(((4..7).map(|k| number(k) * number(k)).sum::<f64>() - 1.0).abs() < 1e-4);
        assert!(
            !fields[7].is_empty()
                && fields[7]
                    .chars()
                    .all(|c| c.is_ascii_lowercase() || c == '_')
        );
    }
    let one = ask(&["--at", "-33,-70"], "");
    assert_eq!(one, ask(&["--at=-33,-70"], "ignored"));
    assert_eq!(one, ask(&["--level", "17"], "-33,-70\n"));
    assert_eq!(ask(&[], ""), format!("{HEADER}\n"));
}

#[test]
fn the_first_bad_line_of_the_input_is_named() {
    let folder = planet();
    for (input, words) in [
        ("1,2\n3\n", &["line 2", "LAT,LON"][..]),
        ("1,2\n91,0\n", &["line 2", "latitude"]),
        ("nan,0\n", &["line 1", "latitude"]),
        ("0,1e9\n", &["line 1", "longitude"]),
        ("0,0,0\n", &["line 1"]),
        ("Manaus\n", &["line 1"]),
    ] {
        refused(folder.path(), &["query", "planet.pangaea"], input, words);
    }
}

/// The folder of real tiles: `$PANGAEA_DATA/dem`, else `shared/data/dem` beside the repository.
fn real_tiles() -> Option<PathBuf> {
    let data = std::env::var_os("PANGAEA_DATA").map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/data")),
        PathBuf::from,
    );
    let folder = data.join("dem");
    if !folder.is_dir() {
        eprintln!("skipped: {} is missing", folder.display());
        return None;
    }
    Some(folder)
}

/// The figures that `relief` writes for planet.pangaea.
fn relief(folder: &Path, more: &[&str]) -> Value {
    let args = [
        &[
            "relief",
            "planet.pangaea",
            "--sites",
            "1",
            "--json",
            "r.json",
        ],
        more,
    ]
    .concat();
    let output = pangaea(folder, &args, "");
    assert!(output.status.success(), "{}", stderr(&output));
    let text = stdout(&output);
    for word in [
        "young_himalayan",
        "young_andean",
        "old_belts",
        "plains",
        "relief in 10 km",
    ] {
        assert!(text.contains(word), "{text}");
    }
    serde_json::from_slice(&fs::read(folder.join("r.json")).unwrap()).unwrap()
}

#[test]
fn relief_has_figures_of_classes_and_of_real_tiles() {
    let folder = planet();
    let real = real_tiles();
    let dem = real.as_ref().map(|path| ["--dem", path.to_str().unwrap()]);
    let json = relief(folder.path(), dem.as_ref().map_or(&[], |dem| &dem[..]));
    for class in ["young_himalayan", "young_andean", "old_belts", "plains"] {
        let figures = json[class].as_object().unwrap();
        assert!(figures["sites"].as_u64().unwrap() <= 1);
        for key in ["relief10_median_m", "slope_p90_deg", "spectral_exponent"] {
            assert!(
                figures[key].is_number() || figures["sites"] == 0 || key == "spectral_exponent",
                "{class} {key}"
            );
        }
    }
    let tiles = json["tiles"].as_object().unwrap();
    if real.is_some() {
        let relief10 = tiles["himalaya-annapurna"]["relief10_median_m"]
            .as_f64()
            .unwrap();
        assert!((relief10 / 3221.0 - 1.0).abs() < 0.05, "{relief10}");
        assert_eq!(
            (tiles.len(), &tiles["N44W072"]["sites"]),
            (5, &Value::from(1))
        );
    } else {
        assert!(tiles.is_empty());
    }
}

#[test]
fn bad_tiles_are_named() {
    let folder = planet();
    let tiles = folder.path().join("tiles");
    fs::create_dir(&tiles).unwrap();
    let args = [
        "relief",
        "planet.pangaea",
        "--dem",
        "tiles",
        "--json",
        "r.json",
    ];
    refused(folder.path(), &args, "", &["tiles", ".hgt"]);
    for (name, words) in [
        ("N44W072.hgt", &["N44W072.hgt", "1201"][..]),
        ("b.tif", &["b.tif"]),
        ("c.png", &["c.json"]),
    ] {
        let path = tiles.join(name);
        fs::write(&path, "nonsense").unwrap();
        refused(folder.path(), &args, "", words);
        fs::remove_file(path).unwrap();
    }
    refused(
        folder.path(),
        &["relief", "planet.pangaea", "--dem", "nowhere"],
        "",
        &["nowhere"],
    );
}
