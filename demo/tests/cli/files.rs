//! Files are written all or none: what is in the way, and what stays.

use crate::program::{assert_refused_in, begun, names_in, small_planet, stats, stderr, succeed};
use std::fs;
use std::process::Stdio;
use tempfile::TempDir;

/// `generate` for a planet that takes a minute; a refusal comes at once.
const LARGE: [&str; 4] = ["generate", "--samples", "2000000", "--out"];

#[test]
fn unwritable_places_are_refused_before_the_planet_grows() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("file"), "x").unwrap();
    for out in ["file", "file/sub", "/proc/nowhere", "/dev/null/x"] {
        assert_refused_in(folder.path(), &[&LARGE[..], &[out]].concat(), &[out]);
    }
    assert_eq!(fs::read_to_string(folder.path().join("file")).unwrap(), "x");
    let bench = ["bench", "--json", "no/such/folder.json"];
    assert_refused_in(folder.path(), &bench, &["no/such"]);
    assert_refused_in(folder.path(), &["bench", "--json", "."], &["."]);
}

/// Puts a folder where a command would write the file `name`, and asserts that it refuses.
fn assert_stopped_by(name: &str, args: &[&str]) {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out");
    fs::create_dir_all(out.join(name)).unwrap();
    assert_refused_in(folder.path(), args, &["cannot write", name, "folder"]);
    assert_eq!(names_in(&out), [name]);
}

#[test]
fn a_folder_in_the_way_of_one_file_stops_all_of_them_before_the_planet_grows() {
    let generate = [&LARGE[..], &["out"]].concat();
    for name in [
        "plates.png",
        "elevation_color.png",
        "planet.pangaea",
        "stats.json",
    ] {
        assert_stopped_by(name, &generate);
    }
    let views = ["views", "--samples", "2000000", "--out", "out"];
    assert_stopped_by("orbit-8-south.png", &views);
}

#[test]
fn a_file_that_pangaea_did_not_make_stops_all_of_them_before_the_planet_grows() {
    let generate = [&LARGE[..], &["out"]].concat();
    let views = ["views", "--samples", "2000000", "--out", "out"];
    for (name, args) in [
        ("rain.png", &generate[..]),
        ("stats.json", &generate),
        ("orbit-1.png", &views),
    ] {
        let folder = TempDir::new().unwrap();
        let file = folder.path().join("out").join(name);
        fs::create_dir(folder.path().join("out")).unwrap();
        fs::write(&file, "{}").unwrap();
        assert_refused_in(
            folder.path(),
            args,
            &[name, "does not say that Pangaea made it"],
        );
        assert_eq!(fs::read_to_string(&file).unwrap(), "{}");
    }
}

#[test]
fn two_runs_at_once_leave_one_planet() {
    let folder = TempDir::new().unwrap();
    let size = ["generate", "--samples", "500", "--plates", "12", "--until"];
    let runs = ["10", "20"].map(|until| {
        let args = [&size[..], &[until, "--out", "out"]].concat();
        begun(folder.path(), &args, Stdio::null())
    });
    for run in runs {
        let output = run.wait_with_output().unwrap();
        assert!(output.status.success(), "{}", stderr(&output));
    }
    let facts = succeed(folder.path(), &["info", "out/planet.pangaea"]);
    let digest = stats(&folder.path().join("out"))["digest"].to_string();
    assert!(facts.contains(digest.trim_matches('"')), "{facts} {digest}");
}

/// A command that fails at step 1.
const FAILING: &str = "[(step: 1, command: SetPlateMotion(plate: 999, pole: (0, 0), speed: 1))]";

#[test]
fn a_refused_command_removes_the_folders_that_it_made_and_no_other() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("a.scenario.ron"), FAILING).unwrap();
    fs::create_dir(folder.path().join("mine")).unwrap();
    let size = ["generate", "--samples", "500", "--plates", "10"];
    let play = ["--until", "20", "--scenario", "a.scenario.ron", "--out"];
    let too_long = format!("n1/n2/{}", "x".repeat(300));
    for out in ["n1/n2/n3", "n1/../n4/n5", "./n1/n2/", &too_long] {
        let args = [&size[..], &play, &[out]].concat();
        assert_refused_in(folder.path(), &args, &[]);
    }
    let args = [&size[..], &play, &["mine/n2/n3"]].concat();
    assert_refused_in(folder.path(), &args, &["999"]);
    assert!(names_in(&folder.path().join("mine")).is_empty());
}

#[test]
fn the_folder_may_exist_and_is_overwritten_whole() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("a");
    small_planet(folder.path(), "a", &["--seed", "1"]);
    let first = fs::read(out.join("planet.pangaea")).unwrap();
    fs::write(out.join("notes.txt"), "mine").unwrap();
    small_planet(folder.path(), "a", &["--seed", "2"]);
    assert_ne!(fs::read(out.join("planet.pangaea")).unwrap(), first);
    assert_eq!(fs::read_to_string(out.join("notes.txt")).unwrap(), "mine");
    assert!(names_in(&out).iter().all(|name| !name.starts_with('.')));
}
