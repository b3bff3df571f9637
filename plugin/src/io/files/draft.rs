//! Files while they grow.

use super::hidden::HiddenFolder;
use super::lock::FolderLock;
use super::output::Output;
use super::place::{adopt, check_owner, copy_into};
use super::target::Target;
use super::unfinished;
use crate::io::IoError;
use std::collections::{BTreeMap, BTreeSet};
use std::env;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Files that get their names together.
#[derive(Default)]
pub(super) struct OutputSet {
    drafts: Vec<OutputDraft>,
    /// Hidden folders, each with the folder that it is in.
    stages: Vec<(PathBuf, HiddenFolder)>,
    /// The files that the drafts will be.
    taken: BTreeSet<PathBuf>,
}

/// A file while it grows.
struct OutputDraft {
    /// As the user wrote it.
    path: PathBuf,
    target: Target,
    /// Where its content grows.
    part: PathBuf,
    /// Whether that is beside the target, so that a rename can bring it there.
    is_beside: bool,
}

impl OutputSet {
    /// Empty drafts of all files.
    pub(super) fn of(outputs: &[Output]) -> Result<Self, IoError> {
        let mut drafts = Self::default();
        for output in outputs {
            drafts
                .add(output)
                .map_err(|source| IoError::write(output.path(), source))?;
        }
        Ok(drafts)
    }

    fn add(&mut self, output: &Output) -> io::Result<()> {
        let target = Target::of(output.path())?;
        if target.older.is_some() && !target.is_device() {
            output.check_older()?;
        }
        if !target.is_device() && !self.taken.insert(target.real()) {
            let problem = "it is to hold two things: choose another name for one of them";
            return Err(io::Error::new(ErrorKind::AlreadyExists, problem));
        }
        let (stage, is_beside) = self.stage_for(&target)?;
        let part = self.stages[stage].1.part(self.drafts.len());
        let file = File::create_new(&part)?;
        if let Some(older) = target.older.as_ref().filter(|older| !older.is_writable) {
            check_owner(&file, &older.meta)?;
        }
        self.drafts.push(OutputDraft {
            path: output.path().to_path_buf(),
            target,
            part,
            is_beside,
        });
        Ok(())
    }

    /// The number of a hidden folder for a file, and whether it is beside the file.
    fn stage_for(&mut self, target: &Target) -> io::Result<(usize, bool)> {
        if !target.is_device() {
            match self.stage_in(target.folder()) {
                Ok(stage) => return Ok((stage, true)),
                // In a closed folder a file can be written as it is, once its content is complete.
                Err(error) if !target.is_writable() => return Err(error),
                Err(_) => {}
            }
        }
        let stage = self.stage_in(&env::temp_dir()).map_err(temporary)?;
        Ok((stage, false))
    }

    fn stage_in(&mut self, folder: &Path) -> io::Result<usize> {
        let known = self.stages.iter().position(|(at, _)| at == folder);
        if let Some(stage) = known {
            return Ok(stage);
        }
        self.stages
            .push((folder.to_path_buf(), HiddenFolder::new(folder)?));
        Ok(self.stages.len() - 1)
    }

    /// Writes the content of the `k`-th file and flushes it to the disk.
    pub(super) fn fill(
        &self,
        k: usize,
        content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), IoError> {
        let draft = &self.drafts[k];
        draft
            .fill(content)
            .map_err(|source| IoError::write(&draft.path, source))
    }

    /// Gives all files their names.
    pub(super) fn commit(self) -> Result<(), IoError> {
        let (devices, files): (Vec<_>, Vec<_>) =
            (self.drafts.iter()).partition(|draft| draft.target.is_device());
        // First, for a pipe may wait for its reader as long as it likes: no folder is locked yet, and
        // the program can be ended.
        for draft in devices {
            let placed = draft.place();
            placed.map_err(|source| IoError::write(&draft.path, source))?;
        }
        let locks = self.lock_folders()?;
        let mut unfinished = unfinished::hold();
        for (done, draft) in files.iter().enumerate() {
            let total = files.len();
            draft.place().map_err(|source| match done {
                0 => IoError::write(&draft.path, source),
                _ => IoError::half(&draft.path, source, [done, total]),
            })?;
        }
        unfinished.are_named = true;
        drop(unfinished);
        locks.iter().for_each(FolderLock::sync);
        Ok(())
    }

    /// Locks every folder once, in the order of their paths, so that two runs never wait for each
    /// other.
    fn lock_folders(&self) -> Result<Vec<FolderLock>, IoError> {
        let mut folders = BTreeMap::new();
        for draft in self.drafts.iter().filter(|draft| !draft.target.is_device()) {
            let folder = draft.target.folder();
            let real = fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
            folders.entry(real).or_insert(&draft.path);
        }
        let mut locks = Vec::new();
        for (folder, path) in folders {
            let lock = FolderLock::take(&folder).map_err(|source| IoError::write(path, source))?;
            locks.extend(lock);
        }
        Ok(locks)
    }
}

/// The error of the folder of temporary files, which the user does not know by the file's name.
pub(in crate::io) fn temporary(error: io::Error) -> io::Error {
    let folder = env::temp_dir();
    let problem = format!(
        "no temporary file in {} (TMPDIR): {error}",
        folder.display()
    );
    io::Error::new(error.kind(), problem)
}

impl OutputDraft {
    fn fill(&self, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let mut writer = BufWriter::new(OpenOptions::new().write(true).open(&self.part)?);
        content(&mut writer)?;
        // Dropping the writer would hide an error of its last bytes.
        let file = writer
            .into_inner()
            .map_err(io::IntoInnerError::into_error)?;
        if let Some(older) = self.target.older.as_ref().filter(|_| self.is_beside) {
            adopt(&file, &older.meta)?;
        }
        file.sync_all()
    }

    /// Brings the content to where it belongs.
    fn place(&self) -> io::Result<()> {
        if self.is_beside {
            match fs::rename(&self.part, &self.target.path) {
                // A mounted file keeps its place, and so does another user's file in a folder like
                // /tmp.
                Err(error) if self.target.is_writable() && is_about_the_name(error.kind()) => {}
                renamed => return renamed,
            }
        }
        copy_into(&self.part, &self.target)
    }
}

/// Whether a file may take content that cannot take its name.
fn is_about_the_name(problem: ErrorKind) -> bool {
    matches!(
        problem,
        ErrorKind::ResourceBusy | ErrorKind::PermissionDenied | ErrorKind::CrossesDevices
    )
}
