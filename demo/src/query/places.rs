//! Places on the lines of the standard input, read on a thread of their own.

use crate::error::CliError;
use crate::values::{PlaceSpec, place};
use std::io::{self, BufRead};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::thread;
use std::time::Duration;

/// Longest line of the input in bytes.
const MAX_LINE_BYTES: u64 = 1000;

/// Places that are read ahead.
const READ_AHEAD: usize = 8192;

/// Places on their way.
pub(super) struct PlaceQueue {
    receiver: Receiver<Result<PlaceSpec, CliError>>,
    /// A place or an error that was received and is not taken yet.
    next: Option<Result<PlaceSpec, CliError>>,
}

impl From<PlaceSpec> for PlaceQueue {
    /// One place, which is there already.
    fn from(place: PlaceSpec) -> Self {
        let (_, receiver) = sync_channel(0);
        let next = Some(Ok(place));
        Self { receiver, next }
    }
}

impl PlaceQueue {
    /// Starts to read the lines of an input, up to the first wrong one.
    pub(super) fn read<R: BufRead>(open: impl FnOnce() -> R + Send + 'static) -> Self {
        let (sender, receiver) = sync_channel(READ_AHEAD);
        let thread = thread::Builder::new().name("input".into());
        let started = thread.spawn(move || send_places(open(), &sender));
        let next = started.err().map(|error| {
            let problem = format!("no thread can be started: {error}");
            Err(CliError::Failed(problem))
        });
        Self { receiver, next }
    }

    /// Waits for a place, and says whether there may be more.
    ///
    /// # Errors
    /// If the next line is refused, once all before it are taken.
    pub(super) fn wait(&mut self, longest: Duration) -> Result<bool, CliError> {
        if self.next.is_none() {
            match self.receiver.recv_timeout(longest) {
                Ok(next) => self.next = Some(next),
                Err(RecvTimeoutError::Timeout) => return Ok(true),
                Err(RecvTimeoutError::Disconnected) => return Ok(false),
            }
        }
        match self.next.take() {
            Some(Err(error)) => Err(error),
            next => {
                self.next = next;
                Ok(true)
            }
        }
    }

    /// Takes places that have come, at most so many.
    pub(super) fn arrived(&mut self, most: usize) -> Vec<PlaceSpec> {
        let mut places = Vec::new();
        while places.len() < most {
            match self.next.take().or_else(|| self.receiver.try_recv().ok()) {
                Some(Ok(place)) => places.push(place),
                other => {
                    self.next = other;
                    break;
                }
            }
        }
        places
    }
}

fn send_places(input: impl BufRead, sender: &SyncSender<Result<PlaceSpec, CliError>>) {
    for place in places_in(input) {
        let is_last = place.is_err();
        if sender.send(place).is_err() || is_last {
            break;
        }
    }
}

/// The places on the lines "lat,lon" of an input; empty lines are passed over. A wrong line is an
/// error that tells its number.
pub fn places_in(mut input: impl BufRead) -> impl Iterator<Item = Result<PlaceSpec, CliError>> {
    let lines = (1_u64..).map_while(move |number| numbered_line(&mut input, number).transpose());
    lines.filter_map(Result::transpose)
}

/// The place in the next line, if it is not empty; `None` at the end of the input.
fn numbered_line(
    input: &mut impl BufRead,
    number: u64,
) -> Result<Option<Option<PlaceSpec>>, CliError> {
    let Some(line) = read_line(input)? else {
        return Ok(None);
    };
    place_in(&line)
        .map(Some)
        .map_err(|problem| CliError::input(format!("line {number} of the input: {problem}")))
}

/// The next line with what ends it, at most one byte longer than [`MAX_LINE_BYTES`]; `None` at the
/// end of the input.
fn read_line(input: &mut impl BufRead) -> Result<Option<Vec<u8>>, CliError> {
    let mut line = Vec::new();
    let read = io::Read::take(input, MAX_LINE_BYTES + 1)
        .read_until(b'\n', &mut line)
        .map_err(|error| CliError::input(format!("cannot read the standard input: {error}")))?;
    Ok((read > 0).then_some(line))
}

/// The place in a line of the input, `None` in an empty one.
fn place_in(line: &[u8]) -> Result<Option<PlaceSpec>, String> {
    if line.len() as u64 > MAX_LINE_BYTES {
        return Err("it is too long".into());
    }
    if line.starts_with(b"\xff\xfe") || line.starts_with(b"\xfe\xff") {
        return Err("it is in UTF-16, and only UTF-8 is read".into());
    }
    let text = str::from_utf8(line).map_err(|_| "it is no text")?;
    // Spreadsheets begin their files with a byte order mark.
    let text = text.trim_start_matches('\u{feff}').trim();
    if text.is_empty() {
        return Ok(None);
    }
    place(text)
        .map(Some)
        .map_err(|problem| format!("`{text}`: {problem}"))
}
