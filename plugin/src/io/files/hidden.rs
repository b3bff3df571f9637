//! The hidden folder in which files grow, and those that dead runs left.
//!
//! It is gone when the writer is done, also on an error. As long as the writer lives, it holds a
//! lock on a file in it; a folder whose lock can be taken belongs to a run that was killed.

use super::lock::FolderLock;
use super::unfinished;
use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// The name of a hidden folder: this, six random letters or digits, the number of the process, for
/// people who look, and an ending. It is short, for a name that is as long as the system takes must
/// still be written.
const PREFIX: &str = ".pangaea-";
const RANDOM: usize = 6;
const ENDING: &str = ".part";

/// The file that is locked.
const LOCK: &str = "lock";

/// A hidden folder.
pub(super) struct HiddenFolder {
    folder: TempDir,
    /// Held as long as the folder is.
    _alive: File,
}

impl HiddenFolder {
    /// Makes a hidden folder in `folder`, from which those of dead runs are removed.
    pub(super) fn new(folder: &Path) -> io::Result<Self> {
        let lock = FolderLock::take(folder)?;
        // Unlocked, a folder that is being made could be taken for a dead one.
        if lock.is_some() {
            sweep(folder);
        }
        let mut builder = tempfile::Builder::new();
        let ending = format!(".{}{ENDING}", std::process::id());
        builder.prefix(PREFIX).rand_bytes(RANDOM).suffix(&ending);
        // The name of a folder that is not there says nothing to the user.
        let stage = builder.tempdir_in(folder).map_err(|error| error.kind())?;
        unfinished::begin(stage.path());
        let mut alive = File::create_new(stage.path().join(LOCK))?;
        // Where files cannot be locked, nobody can take this lock for that of a dead run.
        let _ = alive.try_lock();
        // A full disk is found out now.
        alive.write_all(&[0; 4096])?;
        Ok(Self {
            folder: stage,
            _alive: alive,
        })
    }

    /// The path of a file in it.
    pub(super) fn part(&self, number: usize) -> PathBuf {
        self.folder.path().join(number.to_string())
    }
}

impl Drop for HiddenFolder {
    fn drop(&mut self) {
        unfinished::end(self.folder.path());
    }
}

/// Removes hidden folders whose runs are dead. What cannot be removed stays.
fn sweep(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for entry in entries.flatten() {
        if is_stage_name(&entry.file_name()) && entry.file_type().is_ok_and(|kind| kind.is_dir()) {
            remove_dead(&entry.path());
        }
    }
}

fn is_stage_name(name: &OsStr) -> bool {
    let name = name.to_str().and_then(|name| name.strip_prefix(PREFIX));
    let parts = name.and_then(|name| name.strip_suffix(ENDING)?.split_once('.'));
    parts.is_some_and(|(random, process)| {
        random.len() == RANDOM
            && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
            && process.parse::<u32>().is_ok()
    })
}

fn remove_dead(stage: &Path) {
    let lock = OpenOptions::new()
        .read(true)
        .write(true)
        .open(stage.join(LOCK));
    let _ = match lock {
        Ok(lock) if lock.try_lock().is_ok() => fs::remove_dir_all(stage),
        // Killed before it had a lock, or while it was removed: the lock may go first.
        Err(error) if error.kind() == io::ErrorKind::NotFound => fs::remove_dir_all(stage),
        _ => Ok(()),
    };
}
