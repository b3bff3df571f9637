//! The mark that says that Pangaea made a file: the standard field of its format.
//!
//! ```text
//! *.pangaea   the magic
//! PNG         tEXt chunk `Software` (PNG specification, keywords)
//! TIFF        tag 305, Software
//! OpenEXR     attribute `software`
//! glTF, JSON  "generator"
//! ```

use serde::Serialize;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

/// How a file of a format begins, and the mark of ours in it.
const MARKS: [(&[u8], &[u8]); 6] = [
    (b"PANGAEA\x1a", b"PANGAEA\x1a"),
    (b"\x89PNG", b"Software\0Pangaea"),
    (b"II", b"Pangaea\0"),
    (b"\x76\x2f\x31\x01", b"software\0string\0\x07\0\0\0Pangaea"),
    (b"glTF", b"\"generator\":\"Pangaea\""),
    (b"{", b"\"generator\": \"Pangaea\""),
];

/// Bytes at either end of a file in which its mark is looked for.
const END_BYTES: u64 = 1 << 16;

/// A JSON object with the mark. Fields of `content` follow it.
///
/// ```
/// use bevy_pangaea::io::MarkedJson;
/// use std::collections::BTreeMap;
///
/// let text = serde_json::to_string(&MarkedJson::new(BTreeMap::from([("min", 3)])))?;
/// assert_eq!(text, r#"{"generator":"Pangaea","min":3}"#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, Serialize)]
pub struct MarkedJson<T> {
    generator: &'static str,
    #[serde(flatten)]
    content: T,
}

impl<T: Serialize> MarkedJson<T> {
    /// An object or a map with the mark.
    pub fn new(content: T) -> Self {
        Self {
            generator: "Pangaea",
            content,
        }
    }
}

/// Whether a file says that Pangaea made it; an empty one may be anybody's.
///
/// JSON is recognised as it is written with indentation.
///
/// # Errors
/// If the file cannot be read.
pub fn is_marked(path: &Path) -> io::Result<bool> {
    let mut file = File::open(path)?;
    let length = file.metadata()?.len();
    let mut ends = Vec::new();
    (&file).take(END_BYTES).read_to_end(&mut ends)?;
    if length > END_BYTES {
        // TIFF may have its tags at the end.
        file.seek(SeekFrom::Start(END_BYTES.max(length - END_BYTES)))?;
        file.take(END_BYTES).read_to_end(&mut ends)?;
    }
    let is_ours = |(start, mark): (&[u8], &[u8])| ends.starts_with(start) && contains(&ends, mark);
    Ok(length == 0 || MARKS.into_iter().any(is_ours))
}

/// Whether bytes occur in others.
pub(super) fn contains(bytes: &[u8], searched: &[u8]) -> bool {
    bytes
        .windows(searched.len())
        .any(|window| window == searched)
}
