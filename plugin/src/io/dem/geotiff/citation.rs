//! Esri's systems, as text in a citation: `ESRI PE String = PROJCS[...]`. Its programs and GDAL write
//! so what the keys have no codes for.

use super::keys::{self, Key, KeyDirectory};
use super::system::GEOGRAPHIC;
use super::wkt::{self, SystemOfText};
use crate::io::dem::error::DemError;

/// The words before the text.
const PREFIX: &str = "ESRI PE String = ";

/// The end of a text among those of all keys.
const END: char = '|';

/// Keys that hold such a text.
const CITATIONS: [Key; 2] = [keys::PROJECTED_CITATION, keys::CITATION];

/// The system of a file whose keys leave its projection to a citation.
pub(super) fn system(keys: &KeyDirectory) -> Result<Option<SystemOfText>, DemError> {
    let of_keys = [keys::PROJECTED_SYSTEM, keys::PROJECTION_METHOD];
    let is_geographic = keys.code(keys::MODEL_TYPE) == Some(GEOGRAPHIC);
    if is_geographic || of_keys.iter().any(|key| keys.definition(*key).is_some()) {
        return Ok(None);
    }
    let texts = CITATIONS.iter().filter_map(|key| keys.text(*key));
    match texts.into_iter().find(|text| text.contains(PREFIX)) {
        Some(text) => wkt::system(after_prefix(&text)).map(Some),
        None => Ok(None),
    }
}

fn after_prefix(citation: &str) -> &str {
    let text = citation.split_once(PREFIX).map_or("", |(_, text)| text);
    text.split(END).next().unwrap_or_default()
}
