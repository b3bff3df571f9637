//! A writer of TIFFs as they come, by the letter of TIFF 6.0: any tags, in both byte orders, as
//! BigTIFF, with several images.

/// The values of a tag.
pub(super) enum Values {
    Short(Vec<u16>),
    Long(Vec<u64>),
    Double(Vec<f64>),
    Text(&'static str),
}

/// An image: its tags, and blocks of samples. The tags of its blocks' places are added.
pub(super) struct Image {
    pub(super) fields: Vec<(u16, Values)>,
    pub(super) blocks: Vec<Vec<u8>>,
}

/// How numbers are written.
#[derive(Clone, Copy)]
pub(super) struct Style {
    pub(super) is_big_endian: bool,
    pub(super) is_big_tiff: bool,
}

pub(super) const PLAIN: Style = Style {
    is_big_endian: false,
    is_big_tiff: false,
};

impl Style {
    /// A number of `size` bytes.
    fn number(self, value: u64, size: usize) -> Vec<u8> {
        let mut bytes = value.to_le_bytes()[..size].to_vec();
        if self.is_big_endian {
            bytes.reverse();
        }
        bytes
    }

    /// Bytes of an offset.
    fn wide(self) -> usize {
        if self.is_big_tiff { 8 } else { 4 }
    }

    /// Bytes of numbers, one after the other.
    fn numbers(self, numbers: impl Iterator<Item = u64>, size: usize) -> Vec<u8> {
        numbers.flat_map(|n| self.number(n, size)).collect()
    }

    /// Type, count and bytes of values.
    fn values(self, values: &Values) -> (u64, u64, Vec<u8>) {
        match values {
            Values::Short(all) => {
                let numbers = all.iter().map(|&n| u64::from(n));
                (3, all.len() as u64, self.numbers(numbers, 2))
            }
            Values::Long(all) => {
                let numbers = all.iter().copied();
                (4, all.len() as u64, self.numbers(numbers, 4))
            }
            Values::Double(all) => {
                let numbers = all.iter().map(|z| z.to_bits());
                (12, all.len() as u64, self.numbers(numbers, 8))
            }
            Values::Text(text) => {
                let bytes = [text.as_bytes(), b"\0"].concat();
                (2, bytes.len() as u64, bytes)
            }
        }
    }
}

/// The file of some images.
pub(super) fn tiff(style: Style, images: Vec<Image>) -> Vec<u8> {
    let mut bytes = if style.is_big_endian { b"MM" } else { b"II" }.to_vec();
    bytes.extend(style.number(if style.is_big_tiff { 43 } else { 42 }, 2));
    if style.is_big_tiff {
        bytes.extend(style.number(8, 4 - 2));
        bytes.extend(style.number(0, 2));
    }
    // Where the offset of the next directory stands.
    let mut link = bytes.len();
    bytes.resize(link + style.wide(), 0);
    for image in images {
        link = append(style, image, &mut bytes, link);
    }
    bytes
}

/// Appends an image, to which `link` is made to point; returns the place of its own link.
fn append(style: Style, image: Image, bytes: &mut Vec<u8>, link: usize) -> usize {
    let mut fields = image.fields;
    let is_tiled = fields.iter().any(|(tag, _)| *tag == 322);
    let [offsets, counts] = if is_tiled { [324, 325] } else { [273, 279] };
    let places = blocks(&image.blocks, bytes);
    fields.push((offsets, Values::Long(places)));
    let sizes = image.blocks.iter().map(|block| block.len() as u64);
    fields.push((counts, Values::Long(sizes.collect())));
    fields.sort_by_key(|(tag, _)| *tag);
    let entries: Vec<u8> = fields
        .iter()
        .flat_map(|(tag, values)| entry(style, *tag, values, bytes))
        .collect();
    let place = style.number(bytes.len() as u64, style.wide());
    bytes[link..link + style.wide()].copy_from_slice(&place);
    bytes.extend(style.number(fields.len() as u64, if style.is_big_tiff { 8 } else { 2 }));
    bytes.extend(entries);
    let next = bytes.len();
    bytes.resize(next + style.wide(), 0);
    next
}

/// Appends blocks; returns their places, 0 for those that are left out.
fn blocks(blocks: &[Vec<u8>], bytes: &mut Vec<u8>) -> Vec<u64> {
    let mut places = Vec::new();
    for block in blocks {
        places.push(if block.is_empty() {
            0
        } else {
            bytes.len() as u64
        });
        bytes.extend(block);
    }
    places
}

/// The entry of a tag; values that do not fit into it are appended to `bytes`.
fn entry(style: Style, tag: u16, values: &Values, bytes: &mut Vec<u8>) -> Vec<u8> {
    let (kind, count, mut value) = style.values(values);
    if value.len() > style.wide() {
        let place = style.number(bytes.len() as u64, style.wide());
        bytes.extend(value);
        value = place;
    }
    value.resize(style.wide(), 0);
    let parts = [
        style.number(u64::from(tag), 2),
        style.number(kind, 2),
        style.number(count, style.wide()),
        value,
    ];
    parts.concat()
}
