//! Files that are there whole or not at all.

use super::IoError;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Writes a file whole or not at all: into a hidden file beside it, which is flushed to the disk
/// and then renamed. Devices and pipes are written directly.
///
/// # Errors
/// [`IoError::Write`]; the file is as it was before.
pub fn write_atomically(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), IoError> {
    // Folders are refused here, for a rename over an empty one may succeed.
    let target = target_of(path);
    let result = match fs::metadata(&target) {
        Ok(meta) if meta.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(meta) if !meta.is_file() => {
            File::create(&target).and_then(|file| fill(file, content, false))
        }
        _ => replace(&target, content),
    };
    result.map_err(|source| IoError::write(path, source))
}

/// Writes several files of given content, all or none: all of them under hidden names first.
///
/// # Errors
/// [`IoError::Write`]; the files are as they were before, but if a rename fails half way through.
pub fn write_all_atomically(files: &[(PathBuf, Vec<u8>)]) -> Result<(), IoError> {
    let paths: Vec<PathBuf> = files.iter().map(|(path, _)| path.clone()).collect();
    write_all_streamed(&paths, |k, out| out.write_all(&files[k].1))
}

/// Writes several files, all or none, one after the other as their content comes: `content` is told
/// the number of the file.
///
/// # Errors
/// As [`write_all_atomically`], and the errors of `content`.
pub fn write_all_streamed(
    paths: &[PathBuf],
    mut content: impl FnMut(usize, &mut dyn Write) -> io::Result<()>,
) -> Result<(), IoError> {
    if let Some(path) = paths.iter().find(|path| path.is_dir()) {
        return Err(IoError::write(path, io::ErrorKind::IsADirectory.into()));
    }
    // A device is written directly: there is nothing to rename.
    if let [path] = paths
        && is_device(path)
    {
        return write_atomically(path, |out| content(0, out));
    }
    let mut hidden = Vec::with_capacity(paths.len());
    let result = write_hidden(paths, content, &mut hidden).and_then(|()| reveal(paths, &hidden));
    if result.is_err() {
        for file in &hidden {
            // What cannot be removed was never written, or is renamed already.
            let _ = fs::remove_file(&file.part);
        }
    }
    result
}

/// A file under its hidden name.
struct HiddenFile {
    part: PathBuf,
    target: PathBuf,
}

/// Writes all files under hidden names, which `hidden` takes in even on an error.
fn write_hidden(
    paths: &[PathBuf],
    mut content: impl FnMut(usize, &mut dyn Write) -> io::Result<()>,
    hidden: &mut Vec<HiddenFile>,
) -> Result<(), IoError> {
    for (k, path) in paths.iter().enumerate() {
        let failed = |source| IoError::write(path, source);
        let target = target_of(path);
        let part = hidden_beside(&target).map_err(failed)?;
        // Before it is written, so that a half of it is removed, too.
        hidden.push(HiddenFile {
            part: part.clone(),
            target,
        });
        File::create(&part)
            .and_then(|file| fill(file, |out| content(k, out), true))
            .map_err(failed)?;
    }
    Ok(())
}

/// Gives all files their names.
fn reveal(paths: &[PathBuf], hidden: &[HiddenFile]) -> Result<(), IoError> {
    for (file, path) in hidden.iter().zip(paths) {
        fs::rename(&file.part, &file.target).map_err(|source| IoError::write(path, source))?;
    }
    Ok(())
}

/// The file that is replaced: a link stays a link.
fn target_of(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf())
}

fn is_device(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|meta| !meta.is_file() && !meta.is_dir())
}

/// The hidden name that a file has while it is written.
fn hidden_beside(target: &Path) -> io::Result<PathBuf> {
    let name = target.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    Ok(target.with_file_name(format!(
        ".{}.{}.part",
        name.to_string_lossy(),
        std::process::id()
    )))
}

/// Writes a hidden file and renames it.
fn replace(
    target: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let part = hidden_beside(target)?;
    let result = File::create(&part)
        .and_then(|file| fill(file, content, true))
        .and_then(|()| fs::rename(&part, target));
    if result.is_err() {
        // The error of the write is the one to report.
        let _ = fs::remove_file(&part);
    }
    result
}

/// Writes the content of a file, and flushes it to the disk if `sync` says so.
fn fill(
    file: File,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    sync: bool,
) -> io::Result<()> {
    let mut writer = BufWriter::new(file);
    content(&mut writer)?;
    // Dropping the writer would hide an error of its last bytes.
    let file = writer
        .into_inner()
        .map_err(io::IntoInnerError::into_error)?;
    if sync { file.sync_all() } else { Ok(()) }
}
