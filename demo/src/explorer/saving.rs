//! Files that are to be written of the planet, one after the other, on another thread.

use super::background::Background;
use super::discard::PlanetRevision;
use bevy_pangaea::io;
use bevy_pangaea::prelude::*;
use std::path::{Path, PathBuf};

/// The part of a planet that a file is to hold.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum SaveContent {
    /// All of it.
    Planet,
    /// Its commands.
    Scenario,
}

/// A file that the user asks for.
pub struct SaveRequest {
    /// The file.
    pub path: PathBuf,
    content: SaveContent,
}

impl SaveRequest {
    /// A file with that part of the planet.
    pub fn new(path: &Path, content: SaveContent) -> Self {
        let path = path.to_path_buf();
        Self { path, content }
    }

    /// Writes the file. Returns the note that says so.
    fn write(&self, state: &PlanetState) -> Result<String, String> {
        match self.content {
            SaveContent::Planet => io::save(state, &self.path),
            SaveContent::Scenario => io::save_scenario(state, &self.path),
        }
        .map_err(|error| error.to_string())?;
        Ok(format!("saved {}", self.path.display()))
    }
}

/// A save under way: the revision that it holds, and the note when it is written.
struct Saving {
    revision: Option<PlanetRevision>,
    work: Background<String>,
}

/// A save that is done.
pub struct SaveOutcome {
    /// The revision that is safe with it, if it holds the whole planet.
    pub revision: Option<PlanetRevision>,
    /// The note, or the error.
    pub result: Result<String, String>,
}

/// The files that are still to be written, and the one that is being written.
#[derive(Default)]
pub struct SaveQueue {
    requests: Vec<SaveRequest>,
    saving: Option<Saving>,
}

impl SaveQueue {
    /// Asks for a file, in place of an earlier wish of its kind that still waits.
    pub fn ask(&mut self, request: SaveRequest) {
        self.requests.retain(|old| old.content != request.content);
        self.requests.push(request);
    }

    /// Whether a file is being written, or waits for it.
    pub fn is_busy(&self) -> bool {
        self.saving.is_some() || !self.requests.is_empty()
    }

    /// Whether a file waits and none is being written.
    pub fn is_ready(&self) -> bool {
        self.saving.is_none() && !self.requests.is_empty()
    }

    /// Begins to write the next file, of a planet that has come to `revision`; without a state it
    /// cannot be written, and is forgotten.
    pub fn begin(&mut self, state: Option<PlanetState>, revision: Option<PlanetRevision>) {
        if !self.is_ready() {
            return;
        }
        let request = self.requests.remove(0);
        // Commands alone are not the planet: it may not go without a question.
        let is_whole = request.content == SaveContent::Planet;
        let work = Background::start(move || match &state {
            Some(state) => request.write(state),
            None => Err("the planet cannot be saved now".into()),
        });
        self.saving = Some(Saving {
            revision: revision.filter(|_| is_whole),
            work,
        });
    }

    /// The outcome of the file that was being written, once, as soon as it is there.
    pub fn take(&mut self) -> Option<SaveOutcome> {
        let saving = self.saving.as_mut()?;
        let result = saving.work.take()?;
        let revision = saving.revision;
        self.saving = None;
        Some(SaveOutcome { revision, result })
    }
}
