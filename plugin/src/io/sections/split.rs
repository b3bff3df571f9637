//! A file cut into its sections.

use crate::io::SaveError;
use crate::io::codec::{Decoder, invalid};

/// Four letters that name a section.
pub(in crate::io) type SectionTag = [u8; 4];

/// The contents of the sections that this program knows.
pub(in crate::io) struct FileSections<'a>(Vec<(SectionTag, Option<&'a [u8]>)>);

impl<'a> FileSections<'a> {
    /// Cuts `bytes`; `known` are the tags that this program knows. A section that it does not know
    /// is passed over where its tag begins with a small letter, and refused where it begins with a
    /// capital: without it the planet would be another one.
    pub(super) fn split(
        bytes: &'a [u8],
        known: impl Iterator<Item = SectionTag>,
    ) -> Result<Self, SaveError> {
        let mut sections = Self(known.map(|tag| (tag, None)).collect());
        let mut read = Decoder(bytes);
        while !read.0.is_empty() {
            let tag = read.tag()?;
            let length = usize::try_from(read.u64()?).map_err(|_| SaveError::Truncated)?;
            sections.put(tag, read.take(length)?)?;
        }
        Ok(sections)
    }

    fn put(&mut self, tag: SectionTag, content: &'a [u8]) -> Result<(), SaveError> {
        match self.0.iter_mut().find(|(known, _)| *known == tag) {
            Some((_, Some(_))) => Err(invalid(format!("it has two sections {}", shown(tag)))),
            Some((_, place)) => {
                *place = Some(content);
                Ok(())
            }
            None if tag[0].is_ascii_lowercase() => Ok(()),
            None => Err(SaveError::unknown("section", &shown(tag))),
        }
    }

    /// The content of a section that a file may have.
    pub(super) fn get(&self, tag: SectionTag) -> Option<&'a [u8]> {
        let section = self.0.iter().find(|(known, _)| *known == tag);
        section.and_then(|(_, content)| *content)
    }

    /// The content of a section that every file must have.
    pub(super) fn require(&self, tag: SectionTag) -> Result<&'a [u8], SaveError> {
        self.get(tag)
            .ok_or_else(|| invalid(format!("its section {} is missing", shown(tag))))
    }
}

/// A tag in a message.
fn shown(tag: SectionTag) -> String {
    tag.escape_ascii().to_string()
}
