//! Squares of the ground as files.

use crate::program::{
    assert_contains, assert_refused, assert_refused_in, names_in, pangaea, planet, read_json,
    stderr, succeed,
};
use std::fs;
use std::path::Path;

/// `export` of a square of 10 km, with more options.
fn export<'a>(planet: &'a str, more: &[&'a str]) -> Vec<&'a str> {
    [&["export", planet, "--region", "0,0,10"], more].concat()
}

#[test]
fn bad_regions_and_pixels_are_refused() {
    for region in [
        "", "1,2", "91,0,10", "0,361,10", "NaN,0,10", "0,0,inf", "0,0,0", "0,0,-5", "0,0,1e9",
        "a,b,c",
    ] {
        let args = ["export", "a.pangaea", "--out", "a.tif", "--region", region];
        assert_refused(&args, &["--region"]);
    }
    for pixels in ["0", "1", "-5", "NaN", "1e3", "20000"] {
        let args = export("a.pangaea", &["--out", "a.tif", "--pixels", pixels]);
        assert_refused(&args, &["--pixels", "16384"]);
    }
    let large_mesh = export("a.pangaea", &["--out", "a.glb", "--pixels", "9000"]);
    assert_refused(&large_mesh, &[".glb", "8192"]);
}

#[test]
fn options_that_are_missing_are_named() {
    assert_refused(&["export"], &["PLANET.pangaea"]);
    assert_refused(&export("a.pangaea", &[]), &["--out"]);
    let args = ["export", "a.pangaea", "--out", "a.tif"];
    assert_refused(&args, &["--region"]);
}

#[test]
fn files_without_a_known_format_are_refused() {
    for out in ["a.bmp", "a", ".tif", "a.jpg"] {
        let args = export("a.pangaea", &["--out", out]);
        assert_refused(&args, &[out, ".tif, .png, .r16, .raw, .exr or .glb"]);
    }
}

#[test]
fn planets_that_are_missing_or_damaged_are_refused() {
    let args = export("missing.pangaea", &["--out", "a.tif"]);
    assert_refused(&args, &["missing.pangaea"]);
    let folder = planet();
    fs::write(folder.path().join("bad.pangaea"), "no planet").unwrap();
    let words = ["bad.pangaea", "no Pangaea planet"];
    let args = export("bad.pangaea", &["--out", "a.tif"]);
    assert_refused_in(folder.path(), &args, &words);
}

#[test]
fn unwritable_places_are_refused() {
    let folder = planet();
    for out in [
        "no/such/a.tif",
        "planet.pangaea/a.png",
        "/proc/nowhere/a.glb",
    ] {
        let args = export("planet.pangaea", &["--out", out]);
        assert_refused_in(folder.path(), &args, &[out]);
    }
    // The sidecar of a PNG.
    fs::create_dir(folder.path().join("a.json")).unwrap();
    let args = export("planet.pangaea", &["--pixels", "8", "--out", "a.png"]);
    assert_refused_in(folder.path(), &args, &["a.json"]);
}

#[test]
fn a_sidecar_replaces_only_a_sidecar_of_ours() {
    let folder = planet();
    let path = folder.path().join("a.json");
    exported(folder.path(), "a.png");
    exported(folder.path(), "a.png");
    let theirs = r#"{"min": -40, "max": 30}"#;
    fs::write(&path, theirs).unwrap();
    let args = export("planet.pangaea", &["--pixels", "8", "--out", "a.png"]);
    assert_refused_in(
        folder.path(),
        &args,
        &["a.json", "does not say that Pangaea made it"],
    );
    assert_eq!(fs::read_to_string(&path).unwrap(), theirs);
}

#[cfg(unix)]
#[test]
fn a_link_stays_a_link_and_its_file_keeps_its_mode() {
    use std::os::unix::fs::{PermissionsExt, symlink};

    let folder = planet();
    let [link, file] = ["a.tif", "target"].map(|name| folder.path().join(name));
    symlink("target", &link).unwrap();
    exported(folder.path(), "a.tif");
    fs::set_permissions(&file, fs::Permissions::from_mode(0o600)).unwrap();
    exported(folder.path(), "a.tif");
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    let mode = fs::metadata(&file).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o600);
}

#[test]
fn squares_larger_than_the_planet_are_refused() {
    let folder = planet();
    let square = ["export", "planet.pangaea", "--region", "0,0,90000"];
    let file = ["--pixels", "16", "--out", "a.tif"];
    let args = [&square[..], &file].concat();
    assert_refused_in(folder.path(), &args, &["--region"]);
}

/// Exports a square of 500 km to a file, and returns its bytes.
fn exported(folder: &Path, out: &str) -> Vec<u8> {
    let square = ["export", "planet.pangaea", "--region=-12.5,-170,500"];
    let file = ["--pixels", "32", "--out", out];
    let printed = succeed(folder, &[&square[..], &file].concat());
    assert!(printed.is_empty(), "{printed}");
    fs::read(folder.join(out)).unwrap()
}

#[test]
fn squares_are_written_in_every_format() {
    let folder = planet();
    assert_eq!(&exported(folder.path(), "a.tif")[..4], b"II*\0");
    assert_eq!(&exported(folder.path(), "a.png")[..4], b"\x89PNG");
    assert_eq!(&exported(folder.path(), "a.glb")[..4], b"glTF");
    let names = ["a.glb", "a.json", "a.png", "a.tif", "planet.pangaea"];
    assert_eq!(names_in(folder.path()), names);
    let sidecar = read_json(&folder.path().join("a.json"));
    assert_eq!(sidecar["metres_per_pixel"], 15_625.0);
    assert_eq!(sidecar["lat"], -12.5);
    assert_eq!(sidecar["lon"], -170.0);
    assert!(sidecar["min_m"].as_f64().unwrap() <= sidecar["max_m"].as_f64().unwrap());
}

#[test]
fn options_that_do_not_go_together_are_refused_before_the_planet_is_read() {
    let tiles = |more: &[&'static str]| export("a.pangaea", more);
    for bad in ["0x1", "1x0", "2", "65x64", "-1x2"] {
        assert_refused(&tiles(&["--tiles", bad, "--out", "t.tif"]), &["--tiles"]);
    }
    let wide = ["--tiles", "9x1", "--pixels", "16384", "--out", "t.tif"];
    assert_refused(&tiles(&wide), &["--tiles", "65537"]);
    let size = ["--pixels", "64x32", "--out", "t.tif"];
    assert_refused(&tiles(&size), &["--pixels", "--box"]);
    for bad in ["5", "9,-9", "3,3", "NaN,1", "0,inf"] {
        assert_refused(&tiles(&["--range", bad, "--out", "t.png"]), &["--range"]);
    }
    let metres = ["--range", "0,5", "--out", "t.tif"];
    assert_refused(&tiles(&metres), &["range", ".tif"]);
}

#[test]
fn boxes_that_are_none_are_refused_before_the_planet_is_read() {
    let degrees =
        |degrees: &'static str, out| ["export", "a.pangaea", "--box", degrees, "--out", out];
    for bad in ["", "1,2,3", "-91,0,5,5", "0,0,5,361", "5,0,-5,9", "0,7,5,7"] {
        assert_refused(&degrees(bad, "a.tif"), &["--box"]);
    }
    assert_refused(&degrees("0,0,5,5", "a.glb"), &["box", "mesh"]);
    assert_refused(&degrees("-90,0,90,1", "a.tif"), &["--pixels", "16384"]);
}

/// The JSON of the manifest of tiles of 60 km, 9 vertices to a side.
fn exported_tiles(folder: &Path, out: &str) -> serde_json::Value {
    let square = ["export", "planet.pangaea", "--region=60,20,60"];
    let tiles = ["--pixels", "9", "--tiles", "2x1", "--out", out];
    succeed(folder, &[&square[..], &tiles].concat());
    read_json(&folder.join(out).with_extension("json"))
}

#[test]
fn tiles_are_written_with_a_manifest() {
    let folder = planet();
    let manifest = exported_tiles(folder.path(), "t.tif");
    assert_eq!(manifest["spacing_m"], 7500.0);
    assert_eq!(manifest["files"][1]["file"], "t_1_0.tif");
    assert_eq!(manifest["files"][1]["west_m"], 0.0);
    let manifest = exported_tiles(folder.path(), "u.r16");
    assert!(manifest["engines"]["unity"]["heightmap_resolution"] == 9);
    let greys = fs::read(folder.path().join("u_1_0.r16")).unwrap();
    assert_eq!(greys.len(), 2 * 9 * 9);
}

#[test]
fn tiles_of_an_older_block_are_named() {
    let folder = planet();
    let square = ["export", "planet.pangaea", "--region=60,20,60"];
    let tiles = |block| {
        let tiles = ["--pixels", "9", "--tiles", block, "--out", "t.png"];
        let output = pangaea(folder.path(), &[&square[..], &tiles].concat());
        assert!(output.status.success());
        stderr(&output)
    };
    fs::write(folder.path().join("t_7_7.png"), "a picture of the user's").unwrap();
    assert!(!tiles("2x2").contains("warning"));
    assert!(!tiles("2x2").contains("warning"));
    let said = tiles("3x1");
    assert!(
        said.contains("warning") && said.contains("t_0_1.png and 1 more"),
        "{said}"
    );
    // The list is that of the last block.
    assert!(!tiles("3x1").contains("warning"));
}

#[test]
fn a_range_makes_greys_of_two_squares_alike() {
    let folder = planet();
    for region in ["10,20,60", "60,20,60"] {
        let out = format!("{region}.png");
        let square = [
            "export",
            "planet.pangaea",
            "--region",
            region,
            "--pixels",
            "16",
        ];
        let greys = ["--range=-12000,12000", "--out", &out];
        succeed(folder.path(), &[&square[..], &greys].concat());
        let sidecar = read_json(&folder.path().join(format!("{region}.json")));
        assert_eq!(
            (&sidecar["min_m"], &sidecar["max_m"]),
            (&(-12e3).into(), &12e3.into())
        );
    }
}

#[test]
fn ground_beyond_the_range_is_said_to_be_cut_off() {
    let folder = planet();
    let square = [
        "export",
        "planet.pangaea",
        "--region=10,20,60",
        "--pixels",
        "16",
    ];
    let greys = ["--range=20000,20001", "--out", "a.png"];
    let output = pangaea(folder.path(), &[&square[..], &greys].concat());
    assert!(output.status.success());
    assert_contains(
        &stderr(&output),
        &["warning: --range 20000,20001", "cuts off"],
    );
}

#[test]
fn a_box_has_square_pixels_or_those_that_are_asked_for() {
    let folder = planet();
    let degrees = ["export", "planet.pangaea", "--box=-20,170,-10,-170"];
    for (pixels, step) in [("40", [0.5, 0.5]), ("40x10", [0.5, 1.0])] {
        let file = ["--pixels", pixels, "--out", "a.png"];
        succeed(folder.path(), &[&degrees[..], &file].concat());
        let sidecar = read_json(&folder.path().join("a.json"));
        assert_eq!(sidecar["degrees_per_pixel"], serde_json::json!(step));
        assert_eq!(sidecar["east"], 190.0);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn where_memory_ends_there_is_one_line() {
    let folder = planet();
    // Enough to begin with; the ground of a planet takes 300 MB.
    let script = format!(
        "ulimit -v 250000; exec {} export planet.pangaea --region=0,0,9 --out a.tif",
        env!("CARGO_BIN_EXE_pangaea")
    );
    let output = std::process::Command::new("sh")
        .args(["-c", &script])
        .env("RAYON_NUM_THREADS", "1")
        .current_dir(folder.path())
        .output()
        .unwrap();
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert_eq!(
        text.lines()
            .filter(|line| line.starts_with("error: "))
            .count(),
        1,
        "{text}"
    );
    assert!(!text.contains("backtrace"), "{text}");
    assert_eq!(names_in(folder.path()), ["planet.pangaea"]);
}

#[test]
fn the_same_square_again_has_the_same_bytes() {
    let folder = planet();
    let first = exported(folder.path(), "a.tif");
    assert!(first == exported(folder.path(), "a.tif"));
}
