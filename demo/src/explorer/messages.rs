//! The log of events, notes and errors; the latest notes and errors stand over the globe, too.

use bevy::prelude::*;
use std::collections::VecDeque;
use std::time::{Duration, Instant};

/// Entries that are kept at most.
const LOG_CAPACITY: usize = 200;
/// How long a message stands over the globe.
const STRIP_TIME: Duration = Duration::from_secs(7);

/// How a message is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// The planet did something.
    Event,
    /// The explorer did what was asked.
    Note,
    /// Something could not be done.
    Error,
}

/// A line of the log.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Geological time in My, `None` where the entry does not concern the planet.
    pub time: Option<f64>,
    /// How it is meant.
    pub tone: Tone,
    /// One line.
    pub text: String,
    /// How often it came in a row.
    pub times: u32,
    at: Instant,
}

/// The log, newest first.
#[derive(Resource, Default)]
pub struct MessageLog(VecDeque<Entry>);

impl MessageLog {
    /// All entries, newest first.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.0.iter()
    }

    /// The entries that stand over the globe now, newest first; events only go into the log.
    pub fn strip(&self) -> impl Iterator<Item = &Entry> {
        self.0
            .iter()
            .filter(|e| e.tone != Tone::Event && e.at.elapsed() < STRIP_TIME)
            .take(3)
    }

    /// Says that something was done.
    pub fn note(&mut self, text: impl Into<String>) {
        self.push(None, Tone::Note, text.into());
    }

    /// Says that something could not be done; also on the terminal.
    pub fn error(&mut self, text: impl Into<String>) {
        let text = text.into();
        warn!("{text}");
        self.push(None, Tone::Error, text);
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Adds an entry, or counts the newest once more if it says the same.
    pub fn push(&mut self, time: Option<f64>, tone: Tone, text: String) {
        if let Some(last) = self.0.front_mut()
            && last.text == text
            && last.tone == tone
        {
            last.times += 1;
            last.time = time;
            last.at = Instant::now();
            return;
        }
        self.0.push_front(Entry {
            time,
            tone,
            text,
            times: 1,
            at: Instant::now(),
        });
        self.0.truncate(LOG_CAPACITY);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn repeated_messages_are_counted_and_the_log_is_bounded() {
        let mut messages = MessageLog::default();
        messages.note("saved");
        messages.note("saved");
        assert_eq!(messages.entries().map(|e| e.times).collect::<Vec<_>>(), [2]);
        for i in 0..500 {
            messages.note(format!("{i}"));
        }
        assert_eq!(messages.entries().count(), LOG_CAPACITY);
        assert_eq!(messages.strip().count(), 3);
    }
}
