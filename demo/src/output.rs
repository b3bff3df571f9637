//! Files that a command writes, all of them or not one, and text on stdout.

use crate::error::CliError;
use crate::inputs::Inputs;
use crate::interrupt;
use bevy_pangaea::io::{Output, abandon_outputs, check_outputs, write_all, write_atomically};
use serde::Serialize;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Folders that were made for files that are not there yet, the innermost first.
static MADE: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn made_folders() -> MutexGuard<'static, Vec<PathBuf>> {
    MADE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes what is unfinished, and says whether nothing was written.
pub fn abandon() -> bool {
    let is_nothing_written = abandon_outputs();
    if is_nothing_written {
        for folder in made_folders().iter() {
            let _ = fs::remove_dir(folder);
        }
    }
    is_nothing_written
}

/// Files for one folder, kept in memory until all are there.
pub struct Files {
    folder: PathBuf,
    /// Folders that were made for the files, the innermost first.
    made: Vec<PathBuf>,
    files: Vec<(Output, Vec<u8>)>,
}

impl Files {
    /// Makes the folder where it is missing, and tries whether files of these names can be written
    /// to it, and the one that the user `named` to be written with them. Older files of these names
    /// must be ours.
    ///
    /// # Errors
    /// If one of them cannot be written, or is among `inputs`.
    pub fn new(
        folder: &Path,
        names: impl IntoIterator<Item = impl AsRef<str>>,
        named: Option<&Path>,
        inputs: &Inputs,
    ) -> Result<Self, CliError> {
        // From here on an early return removes the folders that were made.
        let files = Self {
            folder: folder.to_path_buf(),
            made: missing_folders(folder),
            files: Vec::new(),
        };
        made_folders().extend(files.made.iter().cloned());
        files.make_folder()?;
        let outputs = names.into_iter().map(|name| files.output(name.as_ref()));
        let outputs: Vec<Output> = outputs.chain(named.map(Output::named)).collect();
        for output in &outputs {
            inputs.check(output.path())?;
        }
        check_outputs(&outputs)?;
        Ok(files)
    }

    fn make_folder(&self) -> Result<(), CliError> {
        fs::create_dir_all(&self.folder).map_err(|error| {
            let folder = self.folder.display();
            CliError::unwritten(&error, format!("cannot write to {folder}: {error}"))
        })
    }

    /// The names in the folder are ours to choose, what they name may not be.
    fn output(&self, name: &str) -> Output {
        Output::beside(self.folder.join(name))
    }

    /// Adds a file.
    pub fn add(&mut self, name: &str, content: Vec<u8>) {
        self.files.push((self.output(name), content));
    }

    /// Number of files that were added.
    pub fn count(&self) -> usize {
        self.files.len()
    }

    /// Adds a file that the user named, wherever it is: it is written with the others, or not at
    /// all.
    pub fn add_named(&mut self, path: &Path, content: Vec<u8>) {
        self.files.push((Output::named(path), content));
    }

    /// Writes all files, or not one, and returns their paths in the order in which they were added.
    ///
    /// # Errors
    /// If one cannot be written; no file is changed then.
    pub fn write(mut self) -> Result<Vec<PathBuf>, CliError> {
        // Another run, which had made the folder, may have failed and removed it.
        self.make_folder()?;
        let (outputs, contents): (Vec<_>, Vec<_>) = self.files.drain(..).unzip();
        write_all(&outputs, |k, out| out.write_all(&contents[k]))?;
        self.made.clear();
        Ok(outputs.iter().map(|file| file.path().into()).collect())
    }
}

impl Drop for Files {
    /// Folders that were made for files that never came go again, unless someone else uses them by
    /// now.
    fn drop(&mut self) {
        for folder in &self.made {
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Says how many files were written to a folder.
pub fn say_written(files: &[PathBuf], folder: &Path) {
    say(&format!("{} files in {}", files.len(), folder.display()));
}

/// Warns of older files that stay beside those that were written, for `reason`. They stay: nothing
/// that the user has is removed unasked.
pub fn warn_of_older(reason: &str, files: &[PathBuf]) {
    let Some((first, others)) = files.split_first() else {
        return;
    };
    let first = first.display();
    let more = match others.len() {
        0 => String::new(),
        count => format!(" and {count} more"),
    };
    say(&format!("warning: {reason}: {first}{more}"));
}

/// The folders of a path that do not exist, the innermost first.
fn missing_folders(folder: &Path) -> Vec<PathBuf> {
    folder
        .ancestors()
        .take_while(|folder| !folder.as_os_str().is_empty() && !folder.exists())
        .map(Path::to_path_buf)
        .collect()
}

/// Refuses a path at which no file can be written, before minutes are spent on its content, and one
/// of the files that the command reads.
///
/// # Errors
/// If it cannot be written, or is to be read.
pub fn check_file(path: &Path, inputs: &Inputs) -> Result<(), CliError> {
    inputs.check(path)?;
    Ok(check_outputs(&[Output::named(path)])?)
}

/// Writes one file, whole or not at all.
///
/// # Errors
/// If it cannot be written.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), CliError> {
    // From here on an interrupt waits until nothing hidden is left.
    interrupt::watch();
    Ok(write_atomically(path, |out| out.write_all(content))?)
}

/// A value as the text of a JSON file.
///
/// # Errors
/// If it has no form in JSON.
pub fn json(value: &impl Serialize) -> Result<Vec<u8>, CliError> {
    let mut json =
        serde_json::to_vec_pretty(value).map_err(|error| CliError::Failed(error.to_string()))?;
    json.push(b'\n');
    Ok(json)
}

/// Prints to stdout. A reader that has gone away is no error.
///
/// # Errors
/// If stdout cannot take the text, as on a full disk.
pub fn print(text: &str) -> Result<(), CliError> {
    print_to(&mut io::stdout().lock(), text).map(drop)
}

/// Prints to `out`, and says whether somebody still reads it.
///
/// # Errors
/// If it cannot take the text.
pub fn print_to(out: &mut impl Write, text: &str) -> Result<bool, CliError> {
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(CliError::unwritten(
            &error,
            format!("cannot write to stdout: {error}"),
        )),
    }
}

/// Whether somebody still reads stdout, as far as the system says: of a pipe whose other end was
/// closed it does.
#[cfg(unix)]
pub fn has_reader() -> bool {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};

    let out = io::stdout();
    let mut ends = [PollFd::new(&out, PollFlags::empty())];
    let is_known = poll(&mut ends, Some(&Timespec::default())).is_ok();
    let is_closed = ends[0]
        .revents()
        .intersects(PollFlags::ERR | PollFlags::HUP);
    !(is_known && is_closed)
}

/// The next line that is printed will tell.
#[cfg(not(unix))]
pub fn has_reader() -> bool {
    true
}

/// Says something on stderr; whether anyone hears it does not matter.
pub fn say(text: &str) {
    let _ = writeln!(io::stderr(), "{text}");
}
