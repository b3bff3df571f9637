//! Squares of the ground as files.

use crate::program::{assert_refused, assert_refused_in, names_in, planet, read_json, succeed};
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
        assert_refused(&args, &[out, ".tif, .png or .glb"]);
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
    assert_refused_in(folder.path(), &args, &["a.json", "Pangaea did not make"]);
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
fn the_same_square_again_has_the_same_bytes() {
    let folder = planet();
    let first = exported(folder.path(), "a.tif");
    assert!(first == exported(folder.path(), "a.tif"));
}
