//! A program that is killed while it writes: every file is the old one or the new one, whole, and the
//! next run removes what is hidden.
//!
//! A few kills in a usual run, a hundred with `PANGAEA_SOAK=1`.

#![cfg(unix)]

use pangaea_tests::soak;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use tempfile::TempDir;

/// The file whose content is another in each run.
const FIGURES: &str = "stats.json";

/// Names and contents of the files of one run.
type Files = BTreeMap<String, Vec<u8>>;

/// Starts to write a planet into a folder.
fn generate(folder: &Path, seed: &str) -> Child {
    Command::new(env!("CARGO_BIN_EXE_pangaea"))
        .args([
            "generate",
            "--samples",
            "20000",
            "--until",
            "2",
            "--seed",
            seed,
            "--out",
        ])
        .arg(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts")
}

/// The files of a folder but hidden ones.
fn files_in(folder: &Path) -> Files {
    let entries = fs::read_dir(folder).expect("the folder is there");
    entries
        .map(|entry| entry.expect("a readable folder"))
        .map(|entry| {
            (
                entry.file_name().to_string_lossy().into_owned(),
                entry.path(),
            )
        })
        .filter(|(name, _)| !name.starts_with('.'))
        .map(|(name, path)| (name, fs::read(path).expect("a readable file")))
        .collect()
}

/// The hidden names in a folder.
fn hidden_in(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    entries
        .map(|entry| entry.expect("a readable folder").file_name())
        .map(|name| name.to_string_lossy().into_owned())
        .filter(|name| name.starts_with('.'))
        .collect()
}

/// Whether a file grows in a hidden folder; those of the trial before the work are empty.
fn is_written_to(folder: &Path) -> bool {
    let length = |name: &String| fs::metadata(folder.join(name).join("0")).map(|meta| meta.len());
    hidden_in(folder)
        .iter()
        .any(|name| length(name).is_ok_and(|length| length > 0))
}

/// The files of a whole run.
fn whole(seed: &str) -> Files {
    let folder = TempDir::new().unwrap();
    let mut run = generate(folder.path(), seed);
    assert!(run.wait().unwrap().success());
    files_in(folder.path())
}

/// Kills a run some time after it has begun to write. Returns whether it was in time.
fn kill_while_writing(mut run: Child, folder: &Path, delay: Duration) -> bool {
    let is_running = |run: &mut Child| run.try_wait().unwrap().is_none();
    while is_running(&mut run) && !is_written_to(folder) {
        std::thread::sleep(Duration::from_micros(100));
    }
    std::thread::sleep(delay);
    let was_running = is_running(&mut run);
    run.kill().unwrap();
    run.wait().unwrap();
    was_running
}

/// Asserts that every file is one of `old` or of `new`.
fn assert_whole(found: &Files, old: &Files, new: &Files, kill: u64) {
    for name in old.keys() {
        assert!(found.contains_key(name), "{name} is gone after kill {kill}");
    }
    for (name, content) in found {
        if name == FIGURES {
            let figures: Result<serde_json::Value, _> = serde_json::from_slice(content);
            assert!(figures.is_ok(), "{name} is damaged after kill {kill}");
            continue;
        }
        let is_one_of = |files: &Files| files.get(name) == Some(content);
        assert!(
            is_one_of(old) || is_one_of(new),
            "{name} is damaged after kill {kill}"
        );
    }
}

#[test]
fn killed_while_it_writes_the_program_leaves_whole_files() {
    let (first, second) = (whole("1"), whole("2"));
    let (nothing, mut in_time) = (Files::new(), 0);
    let kills = soak::count(3, 100);
    for kill in 0..kills {
        let folder = TempDir::new().unwrap();
        // Every other run finds an older planet in its folder.
        let old = if kill % 2 == 0 { &first } else { &nothing };
        for (name, content) in old {
            fs::write(folder.path().join(name), content).unwrap();
        }
        let run = generate(folder.path(), "2");
        let delay = Duration::from_micros(kill * 7919 % 40_000);
        in_time += u64::from(kill_while_writing(run, folder.path(), delay));
        assert_whole(&files_in(folder.path()), old, &second, kill);
        let mut next = generate(folder.path(), "1");
        assert!(next.wait().unwrap().success());
        let left = hidden_in(folder.path());
        assert!(left.is_empty(), "{left:?} after kill {kill}");
    }
    assert!(
        2 * in_time > kills,
        "only {in_time} of {kills} kills came in time"
    );
}
