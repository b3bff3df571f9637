//! Where the content of a file goes: links, devices, files in the way.

use std::fs::{self, Metadata, OpenOptions};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Links followed one after the other; as many as Linux follows.
const MOST_LINKS: usize = 40;

/// The file that is replaced or made.
pub(super) struct Target {
    /// Not a link.
    pub(super) path: PathBuf,
    /// The file that is there already.
    pub(super) older: Option<OlderFile>,
}

/// A file, or a device, that is there already.
pub(super) struct OlderFile {
    pub(super) meta: Metadata,
    /// Whether it can be written as it is; a device is not tried.
    pub(super) is_writable: bool,
}

impl Target {
    /// The target of a path: links are followed, also to a file that is not there yet.
    ///
    /// # Errors
    /// If no file can be there.
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        let meta = match fs::metadata(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Self::new(path),
            meta => meta?,
        };
        if meta.is_dir() {
            return Err(io::Error::new(ErrorKind::IsADirectory, "it is a folder"));
        }
        // What the link of a pipe says is no path.
        let is_file = meta.is_file();
        let path = if is_file { followed(path) } else { path.into() };
        let is_writable = !is_file || is_writable(&path)?;
        let older = Some(OlderFile { meta, is_writable });
        Ok(Self { path, older })
    }

    /// A file that is still to be made.
    fn new(path: &Path) -> io::Result<Self> {
        let path = followed(path);
        // Of a name with a separator at its end the system makes a folder.
        let is_name = !path.as_os_str().as_encoded_bytes().ends_with(b"/");
        if !is_name || path.file_name().is_none() {
            return Err(io::Error::new(ErrorKind::InvalidInput, "it names no file"));
        }
        if !folder_of(&path).is_dir() {
            let problem = "its folder does not exist";
            return Err(io::Error::new(ErrorKind::NotFound, problem));
        }
        Ok(Self { path, older: None })
    }

    /// Whether it is a device or a pipe.
    pub(super) fn is_device(&self) -> bool {
        self.older
            .as_ref()
            .is_some_and(|older| !older.meta.is_file())
    }

    /// Whether it can be written without a rename.
    pub(super) fn is_writable(&self) -> bool {
        self.older.as_ref().is_some_and(|older| older.is_writable)
    }

    /// The path by which the system knows it, by whatever links and names it was given; in a folder
    /// that hides its place, as it was given.
    pub(super) fn real(&self) -> PathBuf {
        let whole = fs::canonicalize(&self.path).ok();
        let known = whole.or_else(|| self.real_in_folder());
        known.unwrap_or(self.path.clone())
    }

    /// The same for a file that does not exist yet: only its folder's links are followed.
    fn real_in_folder(&self) -> Option<PathBuf> {
        let folder = fs::canonicalize(self.folder()).ok()?;
        Some(folder.join(self.path.file_name()?))
    }

    /// The folder that it is in.
    pub(super) fn folder(&self) -> &Path {
        folder_of(&self.path)
    }
}

/// The folder that a path is in; that of the program for a mere name.
pub(in crate::io) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// The path that links lead to.
fn followed(path: &Path) -> PathBuf {
    let mut path = path.to_path_buf();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&path) else {
            break;
        };
        path = folder_of(&path).join(next);
    }
    path
}

/// Whether a file can be opened to write.
///
/// # Errors
/// If a rename could not replace it either: on a read-only file system, or if it is immutable.
fn is_writable(path: &Path) -> io::Result<bool> {
    /// EPERM, on every Unix: not for lack of a permission, but for what the file is.
    const NOT_PERMITTED: i32 = 1;
    match OpenOptions::new().write(true).open(path) {
        Ok(_) => Ok(true),
        Err(error) if cfg!(unix) && error.raw_os_error() == Some(NOT_PERMITTED) => Err(error),
        // Without the permission a rename replaces it, as `mv` does; a program that runs, too.
        Err(error) => match error.kind() {
            ErrorKind::PermissionDenied | ErrorKind::ExecutableFileBusy => Ok(false),
            _ => Err(error),
        },
    }
}
