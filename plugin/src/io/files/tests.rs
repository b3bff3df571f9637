//! Files are written whole or not at all, and replace what they may.

use super::*;
use std::fs::{self, File};
use std::path::PathBuf;
use std::sync::Barrier;
use tempfile::TempDir;

fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}

fn put(path: &Path, text: &str) -> Result<(), IoError> {
    write_atomically(path, |out| out.write_all(text.as_bytes()))
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(path).unwrap()
}

/// The names of everything in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_trial_leaves_nothing() {
    let folder = folder();
    let path = folder.path().join("a");
    check_outputs(&[Output::named(&path)]).unwrap();
    assert!(names(folder.path()).is_empty());
    fs::write(&path, "old").unwrap();
    check_outputs(&[Output::named(&path)]).unwrap();
    assert_eq!((read(&path), names(folder.path()).len()), ("old".into(), 1));
}

#[test]
fn places_where_no_file_can_be_are_refused() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    fs::write(at("file"), "x").unwrap();
    fs::create_dir(at("sub")).unwrap();
    let long = "x".repeat(300);
    for (path, word) in [
        (at("sub"), "folder"),
        (at("sub/"), "folder"),
        (at("no/a"), "folder"),
        (at("new/"), "names no file"),
        (at("sub/.."), "folder"),
        (PathBuf::new(), "names no file"),
        (at("file/a"), "irectory"),
        (at(&long), "too long"),
    ] {
        let error = check_outputs(&[Output::named(&path)]).unwrap_err();
        let text = error.to_string();
        assert!(text.contains(word), "{}: {text}", path.display());
        assert_eq!(put(&path, "").unwrap_err().to_string(), text);
    }
    assert_eq!(names(folder.path()), ["file", "sub"]);
}

#[test]
fn the_longest_names_are_written() {
    let folder = folder();
    let path = folder.path().join("x".repeat(255));
    put(&path, "1").unwrap();
    put(&path, "2").unwrap();
    assert_eq!(read(&path), "2");
    assert_eq!(names(folder.path()).len(), 1);
}

#[test]
fn an_error_in_one_content_changes_no_file() {
    let folder = folder();
    let outputs = ["a", "b"].map(|name| Output::named(folder.path().join(name)));
    fs::write(outputs[0].path(), "old").unwrap();
    let failed = write_all(&outputs, |k, out| match k {
        0 => out.write_all(b"new"),
        _ => Err(io::ErrorKind::StorageFull.into()),
    });
    assert!(failed.unwrap_err().to_string().contains("/b: "));
    assert_eq!(read(outputs[0].path()), "old");
    assert_eq!(names(folder.path()), ["a"]);
}

#[test]
fn names_given_before_one_that_cannot_be_are_told() {
    let folder = folder();
    let outputs = ["a", "b", "c"].map(|name| Output::named(folder.path().join(name)));
    let failed = write_all(&outputs, |k, out| {
        // Somebody makes a folder of that name meanwhile.
        if k == 2 {
            fs::create_dir(outputs[1].path())?;
        }
        out.write_all(b"new")
    });
    let text = failed.unwrap_err().to_string();
    assert!(text.ends_with("; 1 of 3 files are new"), "{text}");
    assert_eq!(names(folder.path()), ["a", "b"]);
}

#[test]
fn sets_that_are_written_at_once_do_not_mix() {
    const WRITERS: usize = 8;
    const FILES: usize = 12;
    let folder = folder();
    let outputs: Vec<Output> = (0..FILES)
        .map(|k| Output::named(folder.path().join(format!("{k}"))))
        .collect();
    let (outputs, start) = (&outputs, &Barrier::new(WRITERS));
    for _round in 0..10 {
        std::thread::scope(|scope| {
            for writer in 0..WRITERS {
                scope.spawn(move || {
                    start.wait();
                    write_all(outputs, |_, out| write!(out, "{writer}")).unwrap();
                });
            }
        });
        let first = read(outputs[0].path());
        for output in outputs {
            assert_eq!(read(output.path()), first);
        }
    }
    assert_eq!(names(folder.path()).len(), FILES);
}

#[test]
fn hidden_folders_of_dead_runs_go_and_no_others() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    for name in [
        ".pangaea-Dead01.7.part",
        ".pangaea-Alive1.7.part",
        ".pangaea-notes.part",
        ".other-Dead01",
    ] {
        fs::create_dir(at(name)).unwrap();
        fs::write(at(name).join("lock"), "").unwrap();
        fs::write(at(name).join("0"), "half").unwrap();
    }
    for name in [".pangaea-Unborn.7.part", ".pangaea-Undone.7.part"] {
        fs::create_dir(at(name)).unwrap();
    }
    // Killed while it was removed, the lock first.
    fs::write(at(".pangaea-Undone.7.part/0"), "half").unwrap();
    let alive = File::open(at(".pangaea-Alive1.7.part/lock")).unwrap();
    alive.lock().unwrap();
    put(&at("a"), "").unwrap();
    let kept = [
        ".other-Dead01",
        ".pangaea-Alive1.7.part",
        ".pangaea-notes.part",
        "a",
    ];
    assert_eq!(names(folder.path()), kept);
    assert_eq!(names(&at(".pangaea-Alive1.7.part")), ["0", "lock"]);
}

#[test]
fn a_file_beside_replaces_only_ours() {
    const OURS: [&[u8]; 7] = [
        b"",
        b"PANGAEA\x1a\x03\0\0\0",
        b"\x89PNG\r\n\x1a\n....IHDR....tEXtSoftware\0Pangaea",
        b"II*\0\x08\0\0\0....Pangaea\0",
        b"\x76\x2f\x31\x01....software\0string\0\x07\0\0\0Pangaea",
        b"glTF....{\"asset\":{\"generator\":\"Pangaea\"}}",
        b"{\n  \"generator\": \"Pangaea\",\n  \"min_m\": 0\n}",
    ];
    const THEIRS: [&[u8]; 5] = [
        b"{\"min\": -40, \"max\": 30}",
        b"{\"planet\": \"Pangaea\"}",
        b"\x89PNG\r\n\x1a\n....tEXtSoftware\0GIMP",
        b"II*\0\x08\0\0\0....GDAL\0",
        b"Pangaea\0Software\0Pangaea",
    ];
    let folder = folder();
    let path = folder.path().join("tile.json");
    let outputs = [Output::beside(&path)];
    let write = || write_all(&outputs, |_, out| out.write_all(b"new"));
    for ours in OURS {
        fs::write(&path, ours).unwrap();
        write().unwrap();
        assert_eq!(read(&path), "new");
    }
    for theirs in THEIRS {
        fs::write(&path, theirs).unwrap();
        let text = write().unwrap_err().to_string();
        assert!(text.contains("tile.json: there is a file"), "{text}");
        assert_eq!(fs::read(&path).unwrap(), theirs);
    }
    put(&path, "named").unwrap();
}

#[test]
fn the_mark_is_found_at_the_end_of_a_large_file() {
    let folder = folder();
    let path = folder.path().join("a.tif");
    let pixels = vec![7; 200_000];
    fs::write(&path, [b"II*\0", &pixels[..], b"Pangaea\0"].concat()).unwrap();
    assert!(is_marked(&path).unwrap());
    fs::write(&path, [b"II*\0", &pixels[..]].concat()).unwrap();
    assert!(!is_marked(&path).unwrap());
}

#[test]
fn a_file_without_room_for_a_mark_is_ours_where_a_list_of_ours_names_it() {
    let folder = folder();
    let [raw, list] = ["t_0_1.r16", "t.json"].map(|name| folder.path().join(name));
    fs::write(&raw, "raw").unwrap();
    let output = Output::listed(&raw, &list);
    let check = || check_outputs(core::slice::from_ref(&output));
    assert!(check().is_err());
    fs::write(&list, r#"{"files": ["t_0_1.r16"]}"#).unwrap();
    assert!(check().is_err());
    fs::write(
        &list,
        r#"{"generator": "Pangaea", "files": ["xt_0_1.r16"]}"#,
    )
    .unwrap();
    assert!(check().is_err());
    fs::write(&list, r#"{"generator": "Pangaea", "files": ["t_0_1.r16"]}"#).unwrap();
    check().unwrap();
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};

    fn mode(path: &Path) -> u32 {
        fs::metadata(path).unwrap().mode() & 0o7777
    }

    #[test]
    fn a_file_keeps_its_mode_and_a_new_one_has_the_usual() {
        let folder = folder();
        let [path, usual] = ["a", "usual"].map(|name| folder.path().join(name));
        fs::write(&usual, "").unwrap();
        put(&path, "new").unwrap();
        assert_eq!(mode(&path), mode(&usual));
        for kept in [0o600, 0o640, 0o664, 0o755, 0o444, 0o400] {
            fs::set_permissions(&path, fs::Permissions::from_mode(kept)).unwrap();
            put(&path, "newer").unwrap();
            assert_eq!((mode(&path), read(&path)), (kept, "newer".into()));
        }
    }

    #[test]
    fn links_stay_links_also_those_to_nothing() {
        let folder = folder();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("sub")).unwrap();
        symlink("sub/file", at("link")).unwrap();
        symlink("link", at("chain")).unwrap();
        for text in ["first", "second"] {
            put(&at("chain"), text).unwrap();
            assert_eq!(read(at("sub/file")), text);
        }
        for link in ["link", "chain"] {
            assert!(fs::symlink_metadata(at(link)).unwrap().is_symlink());
        }
        symlink("no/file", at("astray")).unwrap();
        let error = check_outputs(&[Output::named(at("astray"))]).unwrap_err();
        assert!(error.to_string().contains("its folder does not exist"));
        symlink("circle", at("circle")).unwrap();
        assert!(check_outputs(&[Output::named(at("circle"))]).is_err());
    }

    #[test]
    fn of_hard_links_the_named_one_parts() {
        let folder = folder();
        let [path, other] = ["a", "b"].map(|name| folder.path().join(name));
        fs::write(&path, "old").unwrap();
        fs::hard_link(&path, &other).unwrap();
        put(&path, "new").unwrap();
        assert_eq!((read(&path), read(&other)), ("new".into(), "old".into()));
    }

    #[test]
    fn a_writer_waits_for_another_in_the_folder() {
        let folder = folder();
        let path = folder.path().join("a");
        let other = File::open(folder.path()).unwrap();
        other.lock().unwrap();
        let writer = std::thread::spawn({
            let path = path.clone();
            move || put(&path, "new")
        });
        std::thread::sleep(core::time::Duration::from_millis(50));
        assert!(!path.exists());
        other.unlock().unwrap();
        writer.join().unwrap().unwrap();
        assert_eq!(read(&path), "new");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn devices_are_written_and_stay() {
        put(Path::new("/dev/null"), "gone").unwrap();
        let error = put(Path::new("/dev/full"), "too much").unwrap_err();
        assert!(error.to_string().contains("/dev/full: "), "{error}");
        assert!(!fs::metadata("/dev/full").unwrap().is_file());
    }
}
