//! The hidden folders that a program has, for one that must end in the middle of its work.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Hidden folders, and whether files of this program got their names.
#[derive(Default)]
pub(super) struct UnfinishedFiles {
    folders: Vec<PathBuf>,
    pub(super) are_named: bool,
}

static UNFINISHED: Mutex<UnfinishedFiles> = Mutex::new(UnfinishedFiles {
    folders: Vec::new(),
    are_named: false,
});

/// Keeps the program from being ended by [`abandon_outputs`] while files get their names.
pub(super) fn hold() -> MutexGuard<'static, UnfinishedFiles> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Notes a hidden folder.
pub(super) fn begin(folder: &Path) {
    hold().folders.push(folder.to_path_buf());
}

/// Forgets a hidden folder that is done with.
pub(super) fn end(folder: &Path) {
    hold().folders.retain(|other| other != folder);
}

/// Removes whatever files are growing, for a program that is about to end without its destructors,
/// and says whether nothing was written: `false` if files have got their names already.
///
/// Files that are getting their names just now are waited for. No file gets its name after that.
pub fn abandon_outputs() -> bool {
    let unfinished = hold();
    if unfinished.are_named {
        return false;
    }
    for folder in &unfinished.folders {
        let _ = fs::remove_dir_all(folder);
    }
    // The program ends, and till then nothing is to begin.
    core::mem::forget(unfinished);
    true
}
