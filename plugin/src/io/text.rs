//! Texts that people write: presets and scenarios in RON, sidecars in JSON.
//!
//! Editors begin some with a byte order mark, and write some as UTF-16: the mark is passed over,
//! and UTF-16 is read where a mark tells of it. Lines may end as on any system.

use super::IoError;
use super::limited::read_at_most;
use ron::extensions::Extensions;
use serde::de::DeserializeOwned;
use std::borrow::Cow;
use std::path::Path;
use thiserror::Error;

/// Longest preset or scenario in bytes.
const MAX_TEXT: u64 = 8 << 20;

/// Why a text is refused, and in which line.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("line {line}: {problem}")]
pub struct TextError {
    /// Line from 1; 0 if the problem is in no line in particular.
    pub line: usize,
    /// The reason.
    pub problem: String,
}

impl TextError {
    /// The error of the file that holds the text.
    pub(super) fn in_file(self, path: &Path) -> IoError {
        IoError::Text {
            path: path.to_path_buf(),
            line: self.line,
            problem: self.problem,
        }
    }
}

/// Reads RON in which `Some(..)` may be left out.
pub(super) fn parse<T: DeserializeOwned>(text: &str) -> Result<T, TextError> {
    let options = ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
    options.from_str(without_mark(text)).map_err(|error| {
        // The parser quotes the text it met; a message stays on one line.
        let problem = error.code.to_string();
        TextError {
            line: error.span.start.line,
            problem: problem.split_whitespace().collect::<Vec<_>>().join(" "),
        }
    })
}

/// Reads JSON, whose error is one line.
#[cfg(feature = "dem")]
pub(super) fn parse_json<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, String> {
    let text = decode(bytes).map_err(|error| error.problem)?;
    serde_json::from_str(without_mark(&text)).map_err(|error| error.to_string())
}

/// The text without the byte order mark that it may begin with.
fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// The text in UTF-8, or in UTF-16 behind a byte order mark.
///
/// # Errors
/// [`TextError`] for bytes that are neither.
pub(super) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, TextError> {
    let text = match bytes {
        [0xff, 0xfe, units @ ..] => utf16(units, u16::from_le_bytes).map(Cow::Owned),
        [0xfe, 0xff, units @ ..] => utf16(units, u16::from_be_bytes).map(Cow::Owned),
        _ => str::from_utf8(bytes).ok().map(Cow::Borrowed),
    };
    text.ok_or_else(|| TextError {
        line: 0,
        problem: "the file is no text in UTF-8, nor in UTF-16 with a byte order mark".into(),
    })
}

/// The text of units of UTF-16.
fn utf16(units: &[u8], unit: fn([u8; 2]) -> u16) -> Option<String> {
    let (units, rest) = units.as_chunks();
    let text = char::decode_utf16(units.iter().map(|&bytes| unit(bytes)));
    text.collect::<Result<_, _>>()
        .ok()
        .filter(|_| rest.is_empty())
}

fn too_long() -> TextError {
    TextError {
        line: 0,
        problem: format!("the file is longer than {MAX_TEXT} bytes"),
    }
}

/// The content of a text file that is not too long.
pub(super) fn read_text(path: &Path) -> Result<String, IoError> {
    let bytes = read_at_most(path, MAX_TEXT)?.ok_or_else(|| too_long().in_file(path))?;
    let text = decode(&bytes).map_err(|error| error.in_file(path))?;
    Ok(text.into_owned())
}

#[cfg(test)]
#[path = "text_tests.rs"]
mod tests;
