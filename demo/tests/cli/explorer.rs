//! The explorer refuses on the terminal what it can, before it opens a window.

#[cfg(target_os = "linux")]
use crate::program::pangaea_within;
use crate::program::{assert_contains, assert_refused_in, stderr};
use std::fs;
use std::process::Command;
use tempfile::TempDir;

#[test]
fn the_explorer_refuses_files_before_it_opens_a_window() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("text.pangaea"), "no planet").unwrap();
    for (args, words) in [
        (&["--open", "missing.pangaea"][..], &["missing.pangaea"][..]),
        (&["--open", "text.pangaea"], &["no Pangaea planet"]),
        (
            &["--open", "missing.pangaea", "--frames", "1"],
            &["missing"],
        ),
        (&["--preset", "missing.planet.ron"], &["missing.planet.ron"]),
    ] {
        assert_refused_in(folder.path(), args, words);
    }
}

#[test]
fn the_explorer_refuses_places_where_no_picture_can_be() {
    let folder = TempDir::new().unwrap();
    fs::create_dir(folder.path().join("folder.png")).unwrap();
    for path in ["folder.png", "no/such.png"] {
        let args = ["--frames", "1", "--capture", path];
        assert_refused_in(folder.path(), &args, &[path]);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_display_the_explorer_points_to_the_commands() {
    let folder = TempDir::new().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .current_dir(folder.path())
        .env_remove("DISPLAY")
        .output()
        .unwrap();
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert_eq!(text.lines().count(), 1, "{text}");
    assert_contains(&text, &["DISPLAY", "pangaea --help"]);
}

#[cfg(target_os = "linux")]
#[test]
fn short_of_memory_the_explorer_says_so_in_one_line() {
    let folder = TempDir::new().unwrap();
    // From too little for its threads to enough for the next fault, that there is no display.
    for kibibytes in [145_000, 150_000, 155_000, 400_000] {
        let output = pangaea_within(&format!("v {kibibytes}"), folder.path(), &[]);
        let text = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{kibibytes}: {text}");
        assert_eq!(text.lines().count(), 1, "{kibibytes}: {text}");
        assert_contains(&text, &["error: "]);
    }
}
