//! Files are written all or none: what is in the way, who interrupts, what stays.

use super::*;
use std::io::Read;
use std::process::Child;
use std::time::{Duration, Instant};

#[test]
fn the_explorer_refuses_files_before_it_opens_a_window() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("text.pangaea"), "no planet").unwrap();
    fs::create_dir(folder.path().join("folder.png")).unwrap();
    for (args, words) in [
        (&["--open", "missing.pangaea"][..], &["missing.pangaea"][..]),
        (
            &["--open", "text.pangaea"],
            &["text.pangaea", "no Pangaea planet"],
        ),
        (
            &["--open", "missing.pangaea", "--frames", "1"],
            &["missing.pangaea"],
        ),
        (&["--preset", "missing.planet.ron"], &["missing.planet.ron"]),
        (
            &["--frames", "1", "--capture", "folder.png"],
            &["folder.png"],
        ),
        (
            &["--frames", "1", "--capture", "no/such.png"],
            &["no/such.png"],
        ),
    ] {
        refused_in(folder.path(), args, words);
    }
}

#[test]
fn unwritable_places_are_refused_before_the_planet_grows() {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("file"), "x").unwrap();
    // Two million samples would take a minute; the refusal comes at once.
    for out in ["file", "file/sub", "/proc/nowhere", "/dev/null/x"] {
        let args = ["generate", "--samples", "2000000", "--out", out];
        refused_in(folder.path(), &args, &[out]);
    }
    assert_eq!(fs::read_to_string(folder.path().join("file")).unwrap(), "x");
    refused_in(
        folder.path(),
        &["bench", "--json", "no/such/folder.json"],
        &["no/such"],
    );
    refused_in(folder.path(), &["bench", "--json", "."], &["."]);
}

#[test]
fn a_folder_in_the_way_of_one_file_stops_all_of_them_before_the_planet_grows() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out");
    for name in [
        "plates.png",
        "elevation_color.png",
        "planet.pangaea",
        "stats.json",
    ] {
        fs::create_dir_all(out.join(name)).unwrap();
        let args = ["generate", "--samples", "2000000", "--out", "out"];
        refused_in(folder.path(), &args, &["cannot write", name, "folder"]);
        assert_eq!(names_in(&out), [name]);
        fs::remove_dir(out.join(name)).unwrap();
    }
    fs::create_dir_all(out.join("orbit-8-south.png")).unwrap();
    let args = ["views", "--samples", "2000000", "--out", "out"];
    refused_in(
        folder.path(),
        &args,
        &["cannot write", "orbit-8-south.png", "folder"],
    );
    assert_eq!(names_in(&out), ["orbit-8-south.png"]);
}

#[test]
fn a_refused_command_removes_the_folders_that_it_made_and_no_other() {
    let folder = TempDir::new().unwrap();
    fs::write(
        folder.path().join("a.scenario.ron"),
        "[(step: 1, command: SetPlateMotion(plate: 999, pole: (0, 0), speed: 1))]",
    )
    .unwrap();
    let play = [
        "generate",
        "--samples",
        "500",
        "--plates",
        "10",
        "--until",
        "20",
        "--scenario",
        "a.scenario.ron",
    ];
    let too_long = format!("n1/n2/{}", "x".repeat(300));
    for out in ["n1/n2/n3", "n1/../n4/n5", "./n1/n2/", &too_long] {
        refused_in(folder.path(), &[&play[..], &["--out", out]].concat(), &[]);
        assert_eq!(names_in(folder.path()), ["a.scenario.ron"], "{out}");
    }
    fs::create_dir(folder.path().join("mine")).unwrap();
    refused_in(
        folder.path(),
        &[&play[..], &["--out", "mine/n2/n3"]].concat(),
        &["999"],
    );
    assert!(names_in(&folder.path().join("mine")).is_empty());
}

/// The program at work in a folder, its output held.
#[cfg(unix)]
fn begun(folder: &Path, args: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .args(args)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

#[cfg(unix)]
#[test]
fn an_interrupt_ends_a_command_and_leaves_nothing() {
    let folder = TempDir::new().unwrap();
    let args = [
        "generate",
        "--samples",
        "5000",
        "--until",
        "10000",
        "--out",
        "out",
    ];
    let child = begun(folder.path(), &args);
    // It listens before it makes the folder.
    let patience = Instant::now() + Duration::from_secs(60);
    while !folder.path().join("out").exists() && Instant::now() < patience {
        std::thread::sleep(Duration::from_millis(5));
    }
    assert_interrupted(child, "");
    assert!(names_in(folder.path()).is_empty());
}

#[cfg(unix)]
#[test]
fn an_interrupt_ends_an_export_between_its_rows() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "one", &[]);
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    let square = [
        "one/planet.pangaea",
        "--region",
        "0,0,100",
        "--pixels",
        "8192",
    ];
    let mut child = begun(
        folder.path(),
        &[&["export"], &square[..], &["--out", "out/a.png"]].concat(),
    );
    // It names the level when it begins with the heights; they take minutes.
    let mut said = [0; 5];
    child
        .stderr
        .as_mut()
        .unwrap()
        .read_exact(&mut said)
        .unwrap();
    assert_eq!(&said, b"level");
    assert_interrupted(child, " 13, 12.207 m to a pixel\n");
    assert!(names_in(&out).is_empty());
}

/// Interrupts a program, which says so after what it has to say anyway.
#[cfg(unix)]
fn assert_interrupted(mut child: Child, before: &str) {
    let kill = format!("kill -INT {}", child.id());
    let sent = Command::new("sh").args(["-c", &kill]).status().unwrap();
    if !sent.success() {
        let _ = child.kill();
    }
    let output = child.wait_with_output().unwrap();
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(130), "{text}");
    assert_eq!(
        text,
        format!("{before}error: interrupted; nothing is written\n")
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error_and_not_a_panic() {
    let folder = TempDir::new().unwrap();
    let output = pangaea(
        folder.path(),
        &["bench", "--samples", "300", "--json", "/dev/full"],
    );
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(
        text.contains("error: cannot write /dev/full") && !text.contains("panick"),
        "{text}"
    );
    assert!(Path::new("/dev/full").exists());
    let full = fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .arg("--help")
        .stdout(full)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
}

#[test]
fn the_folder_may_exist_and_is_overwritten_whole() {
    let folder = TempDir::new().unwrap();
    small_planet(folder.path(), "a", &["--seed", "1"]);
    let first = fs::read(folder.path().join("a/planet.pangaea")).unwrap();
    fs::write(folder.path().join("a/notes.txt"), "mine").unwrap();
    small_planet(folder.path(), "a", &["--seed", "2"]);
    assert_ne!(
        fs::read(folder.path().join("a/planet.pangaea")).unwrap(),
        first
    );
    assert_eq!(
        fs::read_to_string(folder.path().join("a/notes.txt")).unwrap(),
        "mine"
    );
    let hidden = fs::read_dir(folder.path().join("a")).unwrap();
    assert!(
        !hidden
            .flatten()
            .any(|entry| entry.file_name().to_string_lossy().starts_with('.'))
    );
}
