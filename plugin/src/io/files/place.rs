//! A replaced file keeps its mode, its owner and group; or all but its content.

use super::target::Target;
use std::fs::{File, Metadata, OpenOptions};
use std::io;
use std::path::Path;

/// Gives a new file the mode of the one that it replaces and, where that is permitted, its owner and
/// group.
#[cfg(unix)]
pub(super) fn adopt(file: &File, older: &Metadata) -> io::Result<()> {
    use std::fs::Permissions;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};

    // Only the superuser may give a file away.
    let _ = fchown(file, Some(older.uid()), None);
    let mut mode = older.mode() & 0o777;
    if fchown(file, None, Some(older.gid())).is_err() {
        // It is another group that has the file now: it may do no more than everybody.
        mode = (mode & 0o707) | (mode & ((mode & 0o007) << 3));
    }
    if file.metadata()?.mode() & 0o777 == mode {
        return Ok(());
    }
    file.set_permissions(Permissions::from_mode(mode))
}

/// Modes are those of the folder.
#[cfg(not(unix))]
pub(super) fn adopt(_file: &File, _older: &Metadata) -> io::Result<()> {
    Ok(())
}

/// Refuses to replace another user's file without the permission to write it: what would be there
/// afterwards is not theirs.
#[cfg(unix)]
pub(super) fn check_owner(new: &File, older: &Metadata) -> io::Result<()> {
    use std::os::unix::fs::MetadataExt;

    if new.metadata()?.uid() == older.uid() {
        return Ok(());
    }
    Err(io::ErrorKind::PermissionDenied.into())
}

/// A read-only file stays as it is.
#[cfg(not(unix))]
pub(super) fn check_owner(_new: &File, _older: &Metadata) -> io::Result<()> {
    Err(io::ErrorKind::PermissionDenied.into())
}

/// Replaces the content of a file, or writes to a device.
pub(super) fn copy_into(part: &Path, target: &Target) -> io::Result<()> {
    let mut to = OpenOptions::new()
        .write(true)
        .truncate(true)
        .open(&target.path)?;
    io::copy(&mut File::open(part)?, &mut to)?;
    if target.is_device() {
        return Ok(());
    }
    to.sync_all()
}
