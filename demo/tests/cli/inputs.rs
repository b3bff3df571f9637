//! What a command reads is not what it writes: the planet, maps, tiles and texts, and the files beside
//! them; nor are two of its files one.

use crate::program::{assert_refused_in, planet, succeed};
use std::fs;
use tempfile::TempDir;

/// `generate` for a planet that takes a minute; a refusal comes at once.
const LARGE: [&str; 4] = ["generate", "--samples", "2000000", "--out"];

#[test]
fn a_file_that_a_command_reads_is_not_written_over() {
    let folder = planet();
    let before = fs::read(folder.path().join("planet.pangaea")).unwrap();
    for args in [
        &["info", "planet.pangaea", "--scenario-out", "planet.pangaea"][..],
        &[
            "info",
            "planet.pangaea",
            "--scenario-out",
            "./planet.pangaea",
        ],
        &["relief", "planet.pangaea", "--json", "planet.pangaea"],
    ] {
        assert_refused_in(folder.path(), args, &["planet.pangaea", "reads it"]);
    }
    let after = fs::read(folder.path().join("planet.pangaea")).unwrap();
    assert_eq!(after, before);
    fs::write(folder.path().join("earth.tif"), "II").unwrap();
    let args = [
        "export",
        "earth.tif",
        "--region",
        "0,0,10",
        "--out",
        "earth.tif",
    ];
    assert_refused_in(folder.path(), &args, &["earth.tif", "reads it"]);
}

/// A folder with planet.pangaea in it, and other files by their names.
fn folder_with(files: &[(&str, &[u8])]) -> TempDir {
    let folder = planet();
    for (name, content) in files {
        fs::write(folder.path().join(name), content).unwrap();
    }
    folder
}

/// Asserts that commands refuse to write over `name`, which they read, before they begin.
fn assert_kept(folder: &TempDir, name: &str, commands: &[&[&str]]) {
    let path = folder.path().join(name);
    let before = fs::read(&path).unwrap();
    for args in commands {
        assert_refused_in(folder.path(), args, &["cannot write", "reads it"]);
        assert_eq!(fs::read(&path).unwrap(), before, "{args:?}");
    }
}

#[test]
fn recipes_and_scenarios_are_not_written_over() {
    let folder = folder_with(&[("a.ron", b"[]"), ("b.ron", b"(seed: 4)")]);
    #[cfg(unix)]
    std::os::unix::fs::symlink("a.ron", folder.path().join("link")).unwrap();
    let size = "2000000";
    let played = ["generate", "--samples", size, "--scenario", "a.ron"];
    let named = ["generate", "--samples", size, "--preset", "b.ron"];
    let drawn = ["render", "--samples", size, "--scenario", "a.ron", "--out"];
    let mut outs = vec!["a.ron", "./a.ron", "no/../a.ron"];
    if cfg!(unix) {
        outs.push("link");
    }
    fs::create_dir(folder.path().join("no")).unwrap();
    for out in outs {
        let played = [&played[..], &["--scenario-out", out]].concat();
        assert_kept(&folder, "a.ron", &[&played, &[&drawn[..], &[out]].concat()]);
    }
    let named = [&named[..], &["--scenario-out", "b.ron"]].concat();
    assert_kept(&folder, "b.ron", &[&named]);
}

#[test]
fn what_belongs_to_a_map_by_its_name_is_not_written_over() {
    let terrain = br#"(elevation: "m.png")"#;
    let sidecar = br#"{"min": 0, "max": 1, "generator": "Pangaea"}"#;
    let folder = folder_with(&[
        ("m.png", b"x"),
        ("m.json", sidecar),
        ("m.pgw", b"1"),
        ("a.terrain.ron", terrain),
    ]);
    fs::create_dir(folder.path().join("tiles")).unwrap();
    fs::write(folder.path().join("tiles/t.hgt"), "x").unwrap();
    for name in ["m.png", "m.json", "m.pgw"] {
        let out = ["--scenario-out", name];
        let info = [&["info", "a.terrain.ron"][..], &out].concat();
        let relief = [
            "relief",
            "planet.pangaea",
            "--rain",
            "m.png",
            "--json",
            name,
        ];
        assert_kept(&folder, name, &[&info, &relief]);
    }
    let relief = ["relief", "planet.pangaea", "--dem", "tiles"];
    let onto = [&relief[..], &["--json", "tiles/t.hgt"]].concat();
    assert_kept(&folder, "tiles/t.hgt", &[&onto]);
    // The sidecar of a picture that is laid upon the ground, and that of the picture to be written.
    let export = [
        "export",
        "planet.pangaea",
        "--region",
        "0,0,10",
        "--out",
        "m.raw",
    ];
    let field = [&export[..], &["--height-field", "m.png"]].concat();
    assert_kept(&folder, "m.json", &[&field]);
}

#[test]
fn maps_that_are_drawn_again_into_their_own_folder_stay() {
    let folder = planet();
    succeed(
        folder.path(),
        &["maps", "planet.pangaea", "--size", "16", "--out", "maps"],
    );
    let maps = ["maps", "maps/elevation.png", "--out", "maps"];
    assert_kept(&folder, "maps/elevation.png", &[&maps]);
    fs::copy(
        folder.path().join("maps/elevation.png"),
        folder.path().join("maps/rain.png"),
    )
    .unwrap();
    let generate = [
        "generate",
        "--samples",
        "2000000",
        "--rain",
        "maps/rain.png",
    ];
    fs::write(
        folder.path().join("maps/rain.json"),
        r#"{"min": 0, "max": 2000}"#,
    )
    .unwrap();
    let generate = [&generate[..], &["--out", "maps"]].concat();
    assert_kept(&folder, "maps/rain.png", &[&generate]);
}

#[test]
fn one_file_does_not_hold_two_things() {
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("out")).unwrap();
    let generate = [&LARGE[..], &["out", "--scenario-out"]].concat();
    for name in ["out/planet.pangaea", "out/../out/stats.json"] {
        let args = [&generate[..], &[name]].concat();
        assert_refused_in(folder.path(), &args, &[name, "two things"]);
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("out/rain.png", folder.path().join("link")).unwrap();
        let args = [&generate[..], &["link"]].concat();
        assert_refused_in(folder.path(), &args, &["link", "two things"]);
    }
}
