//! How an image lies in its file: blocks of rows (strips) or of columns and rows (tiles), the
//! samples of a pixel together or in planes, and what a sample is.

use super::codec::Codec;
use super::sample::SampleType;
use super::structure::{Directory, TiffFile, refused, unsupported};
use super::tag::{self, Tag};
use crate::io::dem::error::DemError;
use core::ops::Range;
use std::io::{Read, Seek};

/// The layout of an image.
pub(super) struct Layout {
    /// Columns and rows of the image.
    pub(super) size: [u32; 2],
    /// Columns and rows of a block; strips are as wide as the image.
    pub(super) block: [u32; 2],
    /// Samples of a pixel.
    pub(super) samples: usize,
    /// Do samples lie in planes of their own?
    pub(super) is_planar: bool,
    pub(super) sample_type: SampleType,
    pub(super) codec: Codec,
    /// The tag of the lengths of blocks.
    pub(super) counts: Tag,
    /// Offset and length of every block; length 0 for one that is left out.
    blocks: Vec<(u64, u64)>,
}

/// Most pixels to the side of a tile: the largest image that is read, in one.
const MAX_TILE: u32 = 1 << 17;

/// A band, and how opaque it is.
const MAX_SAMPLES: u64 = 2;

/// Columns and rows of the image of a directory.
pub(super) fn size<R: Read + Seek>(
    file: &TiffFile<R>,
    directory: &Directory,
) -> Result<[u32; 2], DemError> {
    Ok([
        side(file, directory, tag::IMAGE_WIDTH, u32::MAX)?,
        side(file, directory, tag::IMAGE_LENGTH, u32::MAX)?,
    ])
}

/// A length in pixels, from 1 to `most`.
fn side<R: Read + Seek>(
    file: &TiffFile<R>,
    directory: &Directory,
    tag: Tag,
    most: u32,
) -> Result<u32, DemError> {
    let side = file.number_or(directory, tag, 0)?;
    let is_sound = (1..=u64::from(most)).contains(&side);
    is_sound.then_some(side as u32).ok_or_else(|| refused(tag))
}

impl Layout {
    /// The layout of the image of a directory.
    pub(super) fn read<R: Read + Seek>(
        file: &TiffFile<R>,
        directory: &Directory,
    ) -> Result<Self, DemError> {
        let size = size(file, directory)?;
        let fill_order = file.number_or(directory, tag::FILL_ORDER, 1)?;
        if fill_order != 1 {
            return Err(unsupported(tag::FILL_ORDER, fill_order));
        }
        let samples = file.number_or(directory, tag::SAMPLES_PER_PIXEL, 1)?;
        if !(1..=MAX_SAMPLES).contains(&samples) {
            return Err(unsupported(tag::SAMPLES_PER_PIXEL, samples));
        }
        let planar = file.number_or(directory, tag::PLANAR_CONFIGURATION, 1)?;
        let sample_type = SampleType::read(file, directory)?;
        let mut layout = Self {
            size,
            block: block(file, directory, size)?,
            samples: samples as usize,
            is_planar: planar == 2,
            sample_type,
            codec: Codec::read(file, directory, sample_type)?,
            counts: match directory.has(tag::TILE_OFFSETS) {
                true => tag::TILE_BYTE_COUNTS,
                false => tag::STRIP_BYTE_COUNTS,
            },
            blocks: Vec::new(),
        };
        layout.blocks = layout.find_blocks(file, directory)?;
        Ok(layout)
    }

    /// Offset and length of every block.
    fn find_blocks<R: Read + Seek>(
        &self,
        file: &TiffFile<R>,
        directory: &Directory,
    ) -> Result<Vec<(u64, u64)>, DemError> {
        let where_ = match directory.has(tag::TILE_OFFSETS) {
            true => tag::TILE_OFFSETS,
            false => tag::STRIP_OFFSETS,
        };
        let [across, down] = self.blocks_a_side().map(u64::from);
        let planes = if self.is_planar { self.samples } else { 1 };
        let wanted = across.saturating_mul(down).saturating_mul(planes as u64);
        let offsets = file.numbers(directory, where_)?;
        let counts = file.numbers(directory, self.counts)?;
        if (offsets.len() as u64) < wanted {
            return Err(refused(where_));
        }
        let counts = counts.into_iter().map(Some).chain(core::iter::repeat(None));
        let places = offsets.into_iter().take(wanted as usize).zip(counts);
        places
            .map(|(offset, count)| Ok((offset, self.length(offset, count)?)))
            .collect()
    }

    /// Bytes of the block at an offset by its count, if it has one; 0 for one that is left out, which
    /// has neither.
    fn length(&self, offset: u64, count: Option<u64>) -> Result<u64, DemError> {
        match count {
            Some(0) if offset == 0 => Ok(0),
            // GDAL does not ask what a count says that it can compute.
            _ if self.codec.is_plain() => Ok(self.row_bytes() as u64 * u64::from(self.block[1])),
            None | Some(0) => Err(refused(self.counts)),
            Some(count) => Ok(count),
        }
    }

    /// The rows of blocks that hold some rows of pixels.
    pub(super) fn rows_of_blocks(&self, rows: Range<u32>) -> Range<u32> {
        rows.start / self.block[1]..rows.end.div_ceil(self.block[1])
    }

    /// The rows of pixels in some rows of blocks.
    pub(super) fn rows_in(&self, blocks: Range<u32>) -> Range<u32> {
        let start = |block: u32| block.saturating_mul(self.block[1]).min(self.size[1]);
        start(blocks.start)..start(blocks.end)
    }

    /// Are blocks as wide as the image?
    pub(super) fn is_of_strips(&self) -> bool {
        self.blocks_a_side()[0] == 1
    }

    /// Blocks to a row of blocks, and rows of blocks.
    pub(super) fn blocks_a_side(&self) -> [u32; 2] {
        [0, 1].map(|axis| self.size[axis].div_ceil(self.block[axis]))
    }

    /// Offset and length of the block at a column and row of blocks that holds a sample; `None` if
    /// it is left out.
    pub(super) fn place(&self, [column, row]: [u32; 2], sample: usize) -> Option<(u64, u64)> {
        let [across, down] = self.blocks_a_side().map(|side| side as usize);
        let plane = if self.is_planar { sample } else { 0 };
        let number = (plane * down + row as usize) * across + column as usize;
        self.blocks
            .get(number)
            .copied()
            .filter(|(_, length)| *length > 0)
    }

    /// Samples of a pixel within a block that holds a sample, and which of them it is.
    pub(super) fn samples_in_block(&self, sample: usize) -> (usize, usize) {
        if self.is_planar {
            (1, 0)
        } else {
            (self.samples, sample)
        }
    }

    /// Bytes of a row of a block.
    pub(super) fn row_bytes(&self) -> usize {
        let samples = self.block[0] as usize * self.samples_in_block(0).0;
        let bits = samples * self.sample_type.bits as usize;
        bits.div_ceil(8)
    }
}

/// Columns and rows of a block.
fn block<R: Read + Seek>(
    file: &TiffFile<R>,
    directory: &Directory,
    [width, height]: [u32; 2],
) -> Result<[u32; 2], DemError> {
    if !directory.has(tag::TILE_OFFSETS) {
        let rows = file.number_or(directory, tag::ROWS_PER_STRIP, u64::from(height))?;
        let rows = rows.min(u64::from(height)) as u32;
        return match rows {
            0 => Err(refused(tag::ROWS_PER_STRIP)),
            rows => Ok([width, rows]),
        };
    }
    Ok([
        side(file, directory, tag::TILE_WIDTH, MAX_TILE)?,
        side(file, directory, tag::TILE_LENGTH, MAX_TILE)?,
    ])
}
