//! Signals end a command and leave nothing; a full disk is an error.

#[cfg(target_os = "linux")]
use crate::program::pangaea_within;
use crate::program::{begun, names_in, pangaea, planet, stderr};
use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// Sends a signal to a program, which says so after what it has to say anyway.
fn assert_ended_by(signal: &str, code: i32, mut child: Child, before: &str) {
    let kill = format!("kill -{signal} {}", child.id());
    let sent = Command::new("sh").args(["-c", &kill]).status().unwrap();
    if !sent.success() {
        let _ = child.kill();
    }
    let output = child.wait_with_output().unwrap();
    let text = stderr(&output);
    let expected = format!("{before}error: interrupted; nothing is written\n");
    assert_eq!(output.status.code(), Some(code), "{signal}: {text}");
    assert_eq!(text, expected);
}

/// Signals by which batch systems tell that they will kill, and their codes where numbers of
/// signals are Linux's.
#[cfg(target_os = "linux")]
const WARNINGS: [(&str, i32); 3] = [("USR1", 138), ("USR2", 140), ("XCPU", 152)];
#[cfg(not(target_os = "linux"))]
const WARNINGS: [(&str, i32); 0] = [];

/// Signals of timers, of input, of failing power, and real-time ones, by numbers.
#[cfg(target_os = "linux")]
const OTHERS: [(&str, i32); 9] = [
    ("14", 142),
    ("26", 154),
    ("27", 155),
    ("29", 157),
    ("30", 158),
    ("16", 144),
    ("34", 162),
    ("40", 168),
    ("64", 192),
];
#[cfg(not(target_os = "linux"))]
const OTHERS: [(&str, i32); 0] = [];

#[test]
fn signals_end_a_command_and_leave_nothing() {
    let size = ["generate", "--samples", "5000", "--until", "10000"];
    let args = [&size[..], &["--out", "a/b/c"]].concat();
    let usual = [("INT", 130), ("TERM", 143), ("HUP", 129), ("QUIT", 131)];
    for (signal, code) in usual.into_iter().chain(WARNINGS).chain(OTHERS) {
        let folder = TempDir::new().unwrap();
        let child = begun(folder.path(), &args, Stdio::null());
        // It listens before it makes the folders.
        let deadline = Instant::now() + Duration::from_secs(60);
        while !folder.path().join("a/b/c").exists() && Instant::now() < deadline {
            std::thread::sleep(Duration::from_millis(5));
        }
        assert_ended_by(signal, code, child, "");
        assert!(names_in(folder.path()).is_empty(), "{signal}");
    }
}

/// The mesh of so many samples takes longer than a command is given to end by itself.
const LONG: [&str; 5] = ["generate", "--samples", "1000000", "--out", "a/b"];

#[test]
fn a_signal_in_work_that_does_not_look_for_it_leaves_nothing() {
    let folder = TempDir::new().unwrap();
    let child = begun(folder.path(), &LONG, Stdio::null());
    let deadline = Instant::now() + Duration::from_secs(60);
    while !folder.path().join("a/b").exists() && Instant::now() < deadline {
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_ended_by("TERM", 143, child, "");
    assert!(names_in(folder.path()).is_empty());
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_beyond_the_limit_is_an_error_and_leaves_nothing() {
    let folder = planet();
    let square = ["export", "planet.pangaea", "--region", "0,0,100"];
    let file = ["--pixels", "512", "--level", "0", "--out", "a.tif"];
    let output = pangaea_within("f 512", folder.path(), &[&square[..], &file].concat());
    let text = stderr(&output);
    assert!(text.contains("error: cannot write"), "{text}");
    assert_eq!(output.status.code(), Some(1), "no signal ended it");
    assert_eq!(names_in(folder.path()), ["planet.pangaea"]);
}

#[cfg(target_os = "linux")]
#[test]
fn the_end_of_memory_is_one_line_and_leaves_nothing() {
    let folder = TempDir::new().unwrap();
    let output = pangaea_within("v 400000", folder.path(), &LONG);
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.starts_with("error: memory is full"), "{text}");
    assert_eq!(text.lines().count(), 1, "{text}");
    assert!(names_in(folder.path()).is_empty());
}

#[test]
fn an_interrupt_ends_an_export_between_its_rows() {
    let folder = planet();
    let square = ["export", "planet.pangaea", "--region", "0,0,100"];
    let file = ["--pixels", "8192", "--out", "a.png"];
    let args = [&square[..], &file].concat();
    let mut child = begun(folder.path(), &args, Stdio::null());
    // It names the level when it begins with the heights; they take minutes.
    let mut said = [0; 5];
    let errors = child.stderr.as_mut().unwrap();
    errors.read_exact(&mut said).unwrap();
    assert_eq!(&said, b"level");
    assert_ended_by("INT", 130, child, " 13, 12.207 m to a pixel\n");
    assert_eq!(names_in(folder.path()), ["planet.pangaea"]);
}

/// Waits until a file grows in a hidden folder of `temp`.
#[cfg(unix)]
fn wait_for_a_part(temp: &Path) {
    let deadline = Instant::now() + Duration::from_secs(60);
    let is_growing = || {
        let hidden = names_in(temp);
        let part = hidden.first().map(|name| temp.join(name).join("0"));
        part.is_some_and(|part| fs::metadata(part).is_ok_and(|facts| facts.len() > 0))
    };
    while !is_growing() && Instant::now() < deadline {
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[cfg(unix)]
#[test]
fn a_signal_while_a_pipe_has_no_reader_leaves_nothing() {
    let folder = planet();
    let temp = TempDir::new().unwrap();
    let mut make = Command::new("mkfifo");
    let made = make.arg(folder.path().join("pipe")).status().unwrap();
    assert!(made.success());
    let child = Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .args(["info", "planet.pangaea", "--scenario-out", "pipe"])
        .current_dir(folder.path())
        .env("TMPDIR", temp.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // What is written grows beside other temporary files, and then waits for its reader.
    wait_for_a_part(temp.path());
    std::thread::sleep(Duration::from_millis(100));
    assert_ended_by("TERM", 143, child, "");
    assert!(names_in(temp.path()).is_empty());
}

#[cfg(unix)]
#[test]
fn a_missing_folder_of_temporary_files_is_named() {
    let folder = planet();
    let mut make = Command::new("mkfifo");
    assert!(
        make.arg(folder.path().join("pipe"))
            .status()
            .unwrap()
            .success()
    );
    for args in [
        &["info", "planet.pangaea", "--scenario-out", "pipe"][..],
        &["info", "planet.pangaea", "--scenario-out", "/dev/null"],
    ] {
        let output = Command::new(env!("CARGO_BIN_EXE_pangaea"))
            .args(args)
            .current_dir(folder.path())
            .env("TMPDIR", "/no/such/folder")
            .output()
            .unwrap();
        let text = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains("/no/such/folder (TMPDIR)"), "{text}");
        assert_eq!(text.lines().count(), 1, "{text}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_and_not_a_panic() {
    let folder = TempDir::new().unwrap();
    let args = ["bench", "--samples", "300", "--json", "/dev/full"];
    let output = pangaea(folder.path(), &args);
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains("error: cannot write /dev/full"), "{text}");
    assert!(!text.contains("panick"), "{text}");
    assert!(Path::new("/dev/full").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_stdout_is_an_error() {
    let full = fs::OpenOptions::new().write(true).open("/dev/full");
    let output = Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .arg("--help")
        .stdout(full.unwrap())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", stderr(&output));
}
