//! Texts that people write: presets and scenarios in RON.

use super::IoError;
use ron::extensions::Extensions;
use serde::de::DeserializeOwned;
use std::fs::File;
use std::io::Read;
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
    options.from_str(text).map_err(|error| {
        // The parser quotes the text it met; a message stays on one line.
        let problem = error.code.to_string();
        TextError {
            line: error.span.start.line,
            problem: problem.split_whitespace().collect::<Vec<_>>().join(" "),
        }
    })
}

/// The content of a text file that is not too long.
pub(super) fn read_text(path: &Path) -> Result<String, IoError> {
    // One byte more than allowed tells a long file from a full one.
    let mut text = String::new();
    File::open(path)
        .and_then(|file| file.take(MAX_TEXT + 1).read_to_string(&mut text))
        .map_err(|source| IoError::read(path, source))?;
    if text.len() as u64 > MAX_TEXT {
        let too_long = TextError {
            line: 0,
            problem: format!("the file is longer than {MAX_TEXT} bytes"),
        };
        return Err(too_long.in_file(path));
    }
    Ok(text)
}
