//! The program as a user runs it, in a folder of its own.

use serde_json::Value;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::sync::OnceLock;
use tempfile::TempDir;

/// Runs the program with nothing on its standard input.
pub(super) fn pangaea(folder: &Path, args: &[&str]) -> Output {
    pangaea_with_input(folder, args, "")
}

/// Runs the program with `input` on its standard input.
pub(super) fn pangaea_with_input(folder: &Path, args: &[&str], input: &str) -> Output {
    let mut child = begun(folder, args, Stdio::piped());
    // A program that refuses its options does not read.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    child.wait_with_output().unwrap()
}

/// The program at work, its output held.
pub(super) fn begun(folder: &Path, args: &[&str], input: Stdio) -> Child {
    Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .args(args)
        .current_dir(folder)
        .stdin(input)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts")
}

/// Runs the program with a limit, as `ulimit` takes it: "v 400000" are so many KiB of addresses.
#[cfg(target_os = "linux")]
pub(super) fn pangaea_within(limit: &str, folder: &Path, args: &[&str]) -> Output {
    let limited = format!("ulimit -{limit} && exec \"$0\" \"$@\"");
    Command::new("sh")
        .args(["-c", &limited, env!("CARGO_BIN_EXE_pangaea")])
        .args(args)
        .current_dir(folder)
        .env_remove("DISPLAY")
        .stdin(Stdio::null())
        .output()
        .expect("the program starts")
}

/// Runs the program, asserts that it succeeds, and returns its standard output.
pub(super) fn succeed(folder: &Path, args: &[&str]) -> String {
    succeed_with_input(folder, args, "")
}

/// As [`succeed`], with `input` on the standard input.
pub(super) fn succeed_with_input(folder: &Path, args: &[&str], input: &str) -> String {
    let output = pangaea_with_input(folder, args, input);
    assert!(output.status.success(), "{args:?}: {}", stderr(&output));
    String::from_utf8(output.stdout).unwrap()
}

pub(super) fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// As [`assert_refused_in`], in an empty folder.
pub(super) fn assert_refused(args: &[&str], words: &[&str]) {
    let folder = TempDir::new().unwrap();
    assert_refused_in(folder.path(), args, words);
}

/// Asserts exit code 2, one line on stderr that contains all of `words`, and nothing written.
pub(super) fn assert_refused_in(folder: &Path, args: &[&str], words: &[&str]) {
    let before = names_in(folder);
    let output = pangaea(folder, args);
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{args:?}: {text}");
    assert!(text.starts_with("error: "), "{args:?}: {text}");
    assert_eq!(text.lines().count(), 1, "{args:?}: {text}");
    assert!(output.stdout.is_empty(), "{args:?}");
    assert_contains(&text, words);
    assert_eq!(names_in(folder), before, "{args:?} left files behind");
}

/// Asserts that a text contains all of `words`.
pub(super) fn assert_contains(text: &str, words: &[&str]) {
    for word in words {
        assert!(text.contains(word), "{text:?} does not name {word:?}");
    }
}

/// The names of all files and folders in a folder, sorted.
pub(super) fn names_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// `generate` for a planet of 500 samples at 30 My.
const SMALL: [&str; 7] = [
    "generate",
    "--samples",
    "500",
    "--plates",
    "12",
    "--until",
    "30",
];

/// All files of a planet of 500 samples at 30 My in `folder`/`name`.
pub(super) fn small_planet(folder: &Path, name: &str, more: &[&str]) {
    succeed(folder, &[&SMALL[..], &["--out", name], more].concat());
}

/// A folder with planet.pangaea in it: 500 samples at 30 My.
pub(super) fn planet() -> TempDir {
    static PLANET: OnceLock<Vec<u8>> = OnceLock::new();
    let bytes = PLANET.get_or_init(|| {
        let folder = TempDir::new().unwrap();
        small_planet(folder.path(), "a", &[]);
        fs::read(folder.path().join("a/planet.pangaea")).unwrap()
    });
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("planet.pangaea"), bytes).unwrap();
    folder
}

/// The statistics in a folder that `generate` wrote.
pub(super) fn stats(folder: &Path) -> Value {
    read_json(&folder.join("stats.json"))
}

pub(super) fn read_json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}
