//! The structure of a TIFF (TIFF 6.0, section 2; BigTIFF): a byte order, a chain of directories, and
//! the values of their tags.
//!
//! Nothing is read before it is asked for, and no more room is made than the file has bytes. The
//! decoder of the crate `tiff` is not used: it holds a megabyte of values to a tag, which 100,000
//! strips exceed, and refuses blocks that GDAL leaves out.

use super::tag::Tag;
use crate::io::dem::error::{DemError, invalid};
use core::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::rc::Rc;

/// A TIFF that is read from `R`.
pub(super) struct TiffFile<R> {
    source: Rc<RefCell<R>>,
    /// Bytes of the file.
    pub(super) length: u64,
    pub(super) order: ByteOrder,
    /// Bytes of an offset: 4, or 8 in a BigTIFF.
    offset_size: u64,
    /// Where the first directory is.
    pub(super) first: u64,
}

/// Which byte of a number comes first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ByteOrder {
    /// The least.
    Little,
    /// The greatest.
    Big,
}

impl ByteOrder {
    /// The number that up to eight bytes are.
    fn number(self, bytes: &[u8]) -> u64 {
        let push = |n: u64, digit: &u8| n << 8 | u64::from(*digit);
        match self {
            Self::Little => bytes.iter().rev().fold(0, push),
            Self::Big => bytes.iter().fold(0, push),
        }
    }
}

/// The tags of an image.
pub(super) struct Directory {
    fields: BTreeMap<u16, Field>,
    /// Where the next directory is; 0 after the last.
    pub(super) next: u64,
}

/// Where the values of a tag are.
#[derive(Clone, Copy)]
struct Field {
    kind: u16,
    count: u64,
    place: u64,
}

/// Types of values that texts have, and numbers with a fraction.
const ASCII: u16 = 2;
const FLOAT: u16 = 11;
const DOUBLE: u16 = 12;

/// Bytes of a whole number of a type: BYTE, SHORT, LONG, IFD, LONG8, IFD8.
fn whole_size(kind: u16) -> Option<usize> {
    match kind {
        1 => Some(1),
        3 => Some(2),
        4 | 13 => Some(4),
        16 | 18 => Some(8),
        _ => None,
    }
}

/// Bytes of a value of a type; `None` for types that no tag here has.
fn size(kind: u16) -> Option<u64> {
    match kind {
        ASCII => Some(1),
        FLOAT => Some(4),
        DOUBLE => Some(8),
        _ => whole_size(kind).map(|size| size as u64),
    }
}

impl Directory {
    /// Does it have this tag?
    pub(super) fn has(&self, tag: Tag) -> bool {
        self.fields.contains_key(&tag.number)
    }
}

impl<R: Read + Seek> TiffFile<R> {
    /// Opens a file.
    pub(super) fn open(mut source: R) -> Result<Self, DemError> {
        let length = source.seek(SeekFrom::End(0)).map_err(unread)?;
        let mut file = Self {
            source: Rc::new(RefCell::new(source)),
            length,
            order: ByteOrder::Little,
            offset_size: 4,
            first: 0,
        };
        let head = file.bytes(0, 4)?;
        file.order = match &head[..2] {
            b"II" => ByteOrder::Little,
            b"MM" => ByteOrder::Big,
            _ => return Err(no_tiff()),
        };
        match file.order.number(&head[2..]) {
            42 => file.first = file.number(4, 4)?,
            43 if file.number(4, 2)? == 8 => {
                file.offset_size = 8;
                file.first = file.number(8, 8)?;
            }
            _ => return Err(no_tiff()),
        }
        Ok(file)
    }

    /// The directory at `place`.
    pub(super) fn directory(&self, place: u64) -> Result<Directory, DemError> {
        // Bytes of the number of tags, and of a tag.
        let (counter, step) = if self.offset_size == 8 {
            (8, 20)
        } else {
            (2, 12)
        };
        let count = self.number(place, counter)?;
        let start = place.saturating_add(counter);
        let bytes = self.bytes(start, count.saturating_mul(step))?;
        let mut fields = BTreeMap::new();
        for (i, entry) in (0..).zip(bytes.chunks_exact(step as usize)) {
            let number = self.order.number(&entry[..2]) as u16;
            if let Some(field) = self.field(entry, start + i * step) {
                fields.entry(number).or_insert(field);
            }
        }
        let end = start + count * step;
        // A last directory may end with the file.
        let next = self.number(end, self.offset_size).unwrap_or(0);
        Ok(Directory { fields, next })
    }

    /// The field that an entry at `place` of the file describes, if its type is known.
    fn field(&self, entry: &[u8], place: u64) -> Option<Field> {
        let kind = self.order.number(&entry[2..4]) as u16;
        let (count, offset) = entry[4..].split_at(self.offset_size as usize);
        let count = self.order.number(count);
        let is_inside = count.saturating_mul(size(kind)?) <= self.offset_size;
        let place = if is_inside {
            place + 4 + self.offset_size
        } else {
            self.order.number(offset)
        };
        Some(Field { kind, count, place })
    }

    /// All values of a tag of whole numbers; none without the tag.
    pub(super) fn numbers(&self, of: &Directory, tag: Tag) -> Result<Vec<u64>, DemError> {
        let Some(field) = of.fields.get(&tag.number) else {
            return Ok(Vec::new());
        };
        let size = whole_size(field.kind).ok_or_else(|| refused(tag))?;
        let bytes = self.values(field)?;
        Ok(bytes
            .chunks_exact(size)
            .map(|value| self.order.number(value))
            .collect())
    }

    /// The first value of a tag of whole numbers, or what it is without the tag.
    pub(super) fn number_or(
        &self,
        of: &Directory,
        tag: Tag,
        default: u64,
    ) -> Result<u64, DemError> {
        Ok(*self.numbers(of, tag)?.first().unwrap_or(&default))
    }

    /// All values of a tag of floating-point numbers; none without the tag.
    pub(super) fn reals(&self, of: &Directory, tag: Tag) -> Result<Vec<f64>, DemError> {
        let Some(field) = of.fields.get(&tag.number) else {
            return Ok(Vec::new());
        };
        let bytes = self.values(field)?;
        let single = |value| f64::from(f32::from_bits(self.order.number(value) as u32));
        let double = |value| f64::from_bits(self.order.number(value));
        match field.kind {
            FLOAT => Ok(bytes.chunks_exact(4).map(single).collect()),
            DOUBLE => Ok(bytes.chunks_exact(8).map(double).collect()),
            _ => Err(refused(tag)),
        }
    }

    /// The text of a tag up to its end.
    pub(super) fn text(&self, of: &Directory, tag: Tag) -> Result<Option<String>, DemError> {
        let Some(field) = of.fields.get(&tag.number) else {
            return Ok(None);
        };
        if field.kind != ASCII {
            return Err(refused(tag));
        }
        let bytes = self.values(field)?;
        let text = bytes.split(|&byte| byte == 0).next().unwrap_or_default();
        Ok(Some(String::from_utf8_lossy(text).into_owned()))
    }

    fn values(&self, field: &Field) -> Result<Vec<u8>, DemError> {
        let size = size(field.kind).unwrap_or(1);
        self.bytes(field.place, field.count.saturating_mul(size))
    }

    fn number(&self, place: u64, size: u64) -> Result<u64, DemError> {
        let bytes = self.bytes(place, size)?;
        Ok(self.order.number(&bytes))
    }

    /// So many bytes of the file.
    pub(super) fn bytes(&self, place: u64, count: u64) -> Result<Vec<u8>, DemError> {
        // Refused before room is made for what the file only promises.
        if place.saturating_add(count) > self.length {
            return Err(cut_short());
        }
        let mut bytes = vec![0; count as usize];
        self.unbuffered(place, count)
            .read_exact(&mut bytes)
            .map_err(unread)?;
        Ok(bytes)
    }

    /// A reader of a part of the file, which knows its place whatever others read meanwhile.
    pub(super) fn part(&self, place: u64, count: u64) -> BufReader<FilePart<R>> {
        BufReader::new(self.unbuffered(place, count))
    }

    fn unbuffered(&self, place: u64, count: u64) -> FilePart<R> {
        FilePart {
            source: self.source.clone(),
            place,
            end: place.saturating_add(count),
        }
    }
}

/// A part of a file.
pub(super) struct FilePart<R> {
    source: Rc<RefCell<R>>,
    place: u64,
    end: u64,
}

impl<R: Read + Seek> Read for FilePart<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let most = (self.end - self.place).min(buffer.len() as u64) as usize;
        let mut source = self.source.borrow_mut();
        source.seek(SeekFrom::Start(self.place))?;
        let count = source.read(&mut buffer[..most])?;
        self.place += count as u64;
        Ok(count)
    }
}

fn no_tiff() -> DemError {
    invalid("the file is no TIFF")
}

/// The error of a file that ends too early.
pub(super) fn cut_short() -> DemError {
    invalid("the file is cut short, or no TIFF")
}

fn unread(error: io::Error) -> DemError {
    invalid(format!("the file cannot be read: {error}"))
}

/// The error of a tag whose values make no sense.
pub(super) fn refused(tag: Tag) -> DemError {
    invalid(format!("the tag {} makes no sense", tag.name))
}

/// The error of a value of a tag that is not read.
pub(super) fn unsupported(tag: Tag, value: impl core::fmt::Display) -> DemError {
    invalid(format!("{} {value} is not read", tag.name))
}
