//! A file to write, and what it may replace.

use super::checksum::hash_of;
use super::mark::{contains, is_marked};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A file to write, and what it may replace.
///
/// One that the user named replaces whatever file there is. One whose name follows from another, a
/// sidecar or a file in a folder, replaces only what Pangaea made: files say so in the field of
/// their format for it, `Software` in PNG and TIFF, `generator` in glTF and JSON.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Output {
    path: PathBuf,
    replaces: Replaceable,
    /// The hash of the older file as it was written, where it is known.
    older_hash: Option<String>,
}

/// Which older file may be replaced.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Replaceable {
    Any,
    /// One with the mark.
    Marked,
    /// One that this file names, which has the mark.
    ListedIn(PathBuf),
    /// One with the mark that tells of this file, or of none.
    TellingOf(String),
}

impl Output {
    fn new(path: impl Into<PathBuf>, replaces: Replaceable) -> Self {
        Self {
            path: path.into(),
            replaces,
            older_hash: None,
        }
    }

    /// A file that the user named.
    pub fn named(path: impl Into<PathBuf>) -> Self {
        Self::new(path, Replaceable::Any)
    }

    /// A file whose name follows from another.
    pub fn beside(path: impl Into<PathBuf>) -> Self {
        Self::new(path, Replaceable::Marked)
    }

    /// A file whose name follows from another, of a format that has no room for a mark: it replaces
    /// one that `list` names, a text of ours beside it.
    pub fn listed(path: impl Into<PathBuf>, list: impl Into<PathBuf>) -> Self {
        Self::new(path, Replaceable::ListedIn(list.into()))
    }

    /// A text that tells of another file, `name` beside it: it replaces one of ours that tells of
    /// the same, so that what another file is decoded by stays.
    pub fn telling_of(path: impl Into<PathBuf>, name: String) -> Self {
        Self::new(path, Replaceable::TellingOf(name))
    }

    /// The same, if the older file has still the BLAKE3 hash, in hexadecimal digits, with which it
    /// was written: programs that edit a file keep its mark. Without a hash any content will do.
    #[must_use]
    pub fn unchanged(self, older_hash: Option<String>) -> Self {
        Self { older_hash, ..self }
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Refuses to replace an older file that Pangaea did not make.
    pub(super) fn check_older(&self) -> io::Result<()> {
        let is_ours = match &self.replaces {
            Replaceable::Any => true,
            Replaceable::Marked => is_marked(&self.path)?,
            Replaceable::ListedIn(list) => self.is_listed_in(list)?,
            Replaceable::TellingOf(name) => {
                self.check_told(name)?;
                is_marked(&self.path)?
            }
        };
        if is_ours {
            return self.check_unchanged();
        }
        let problem = "there is a file of this name that does not say that Pangaea made it (early \
                       versions left that out); move it, or choose another --out";
        Err(io::Error::new(io::ErrorKind::AlreadyExists, problem))
    }

    /// Refuses to replace a file that somebody has changed.
    fn check_unchanged(&self) -> io::Result<()> {
        let Some(written) = &self.older_hash else {
            return Ok(());
        };
        if hash_of(&self.path)? == *written {
            return Ok(());
        }
        let problem = "it was changed since Pangaea wrote it; move it, or choose another --out";
        Err(io::Error::new(io::ErrorKind::AlreadyExists, problem))
    }

    /// Refuses to replace a text that tells of another file than `name`.
    fn check_told(&self, name: &str) -> io::Result<()> {
        let text = fs::read(&self.path)?;
        let tells = contains(&text, b"\"file\": ");
        if !tells || contains(&text, format!("\"{name}\"").as_bytes()) {
            return Ok(());
        }
        let problem = "it tells of a file in another format; choose another --out";
        Err(io::Error::new(io::ErrorKind::AlreadyExists, problem))
    }

    fn is_listed_in(&self, list: &Path) -> io::Result<bool> {
        let name = self.path.file_name().unwrap_or_default();
        let quoted = format!("\"{}\"", name.to_string_lossy());
        Ok(list.is_file() && is_marked(list)? && contains(&fs::read(list)?, quoted.as_bytes()))
    }
}
