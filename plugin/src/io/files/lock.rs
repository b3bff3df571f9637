//! One writer at a time in a folder: an advisory lock on the folder itself, which leaves no file.

use std::fs::{File, TryLockError};
use std::io::{self, ErrorKind};
use std::path::Path;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Longest wait for another writer; it holds the lock while it renames, or copies a mounted file.
const LONGEST_WAIT: Duration = Duration::from_secs(60);

/// Pause between two tries.
const PAUSE: Duration = Duration::from_millis(5);

/// The lock of a folder, until it is dropped or the program ends.
pub(super) struct FolderLock(File);

impl FolderLock {
    /// Waits for the lock. `None` where folders cannot be locked: on Windows, on some network
    /// drives, and without the permission to list them.
    ///
    /// # Errors
    /// If another program keeps the lock for a minute.
    pub(super) fn take(folder: &Path) -> io::Result<Option<Self>> {
        let Ok(handle) = File::open(folder) else {
            return Ok(None);
        };
        let deadline = Instant::now() + LONGEST_WAIT;
        loop {
            match handle.try_lock() {
                Ok(()) => return Ok(Some(Self(handle))),
                Err(TryLockError::Error(_)) => return Ok(None),
                Err(TryLockError::WouldBlock) if Instant::now() < deadline => sleep(PAUSE),
                Err(TryLockError::WouldBlock) => {
                    let problem = "another program keeps its folder locked";
                    return Err(io::Error::new(ErrorKind::TimedOut, problem));
                }
            }
        }
    }

    /// Flushes the names in the folder to the disk, where that can be asked for.
    pub(super) fn sync(&self) {
        let _ = self.0.sync_all();
    }
}
