//! Files that are there whole or not at all.
//!
//! ```text
//! mark     what says that Pangaea made a file
//! checksum what a file was when it was written
//! output   a file to write, and what it may replace
//! target   where the content of a file goes: links, devices, files in the way
//! lock     one writer at a time in a folder
//! unfinished    the hidden folders of a program that must end in the middle
//! hidden   the hidden folder in which files grow, and those that dead runs left
//! place    what a file keeps when it is replaced
//! draft    files while they grow, and how they get their names
//! ```
//!
//! Content goes into a hidden folder `.pangaea-XXXXXX.PID.part` beside the file, is flushed to the
//! disk and renamed. A link stays a link: the file that it names is replaced, or made. A file keeps
//! its mode and, where the system permits it, its owner and group. Of several hard links the one
//! that was named parts from the others. Where a name cannot be taken from its file, as with one
//! that is mounted into a container, the complete content is copied into it; devices and pipes
//! likewise.
//!
//! Files of one call get their names while their folder is locked: two runs that write into one
//! folder do so one after the other. A run that was killed leaves its hidden folder; the next one
//! that writes beside it removes it.

mod mark;

mod checksum;

mod output;

mod target;

mod lock;

mod unfinished;

mod hidden;

mod place;

mod draft;

#[cfg(feature = "export")]
pub(super) use checksum::write_hashed;
#[cfg(feature = "export")]
pub(super) use draft::temporary;
pub use mark::{MarkedJson, is_marked};
pub use output::Output;
#[cfg(feature = "export")]
pub(super) use target::folder_of;
pub use unfinished::abandon_outputs;

use super::IoError;
use draft::OutputSet;
use std::io::{self, Write};
use std::path::Path;

/// Writes a file whole or not at all.
///
/// # Errors
/// [`IoError::Write`]; the file is as it was before.
pub fn write_atomically(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), IoError> {
    let mut content = Some(content);
    write_all(&[Output::named(path)], |_, out| match content.take() {
        Some(content) => content(out),
        None => Ok(()),
    })
}

/// Writes several files, all or none, one after the other: `content` is told the number of the file
/// in `outputs`.
///
/// ```
/// use bevy_pangaea::io::{Output, write_all};
///
/// # let folder = tempfile::tempdir()?;
/// let outputs = ["a.txt", "b.txt"].map(|name| Output::named(folder.path().join(name)));
/// write_all(&outputs, |k, out| writeln!(out, "file {k}"))?;
/// assert_eq!(std::fs::read_to_string(outputs[1].path())?, "file 1\n");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::Write`]; the files are as they were before. [`IoError::Half`] if a name cannot be
/// given when others have been.
pub fn write_all(
    outputs: &[Output],
    mut content: impl FnMut(usize, &mut dyn Write) -> io::Result<()>,
) -> Result<(), IoError> {
    let drafts = OutputSet::of(outputs)?;
    for k in 0..outputs.len() {
        drafts.fill(k, |out| content(k, out))?;
    }
    drafts.commit()
}

/// Tries whether files can be written, before minutes are spent on their content. Nothing is left
/// of the trial.
///
/// Files that dead runs left in their folders are removed.
///
/// # Errors
/// [`IoError::Write`] names the first that cannot be written, or that must not be replaced.
pub fn check_outputs(outputs: &[Output]) -> Result<(), IoError> {
    OutputSet::of(outputs).map(drop)
}

#[cfg(test)]
mod tests;
