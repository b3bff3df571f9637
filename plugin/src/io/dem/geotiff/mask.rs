//! Masks: an image of its own in the file that says which pixels are valid (GDAL's internal masks),
//! in a file of its own (NAME.EXT.msk), or a second sample that says how opaque a pixel is.

use super::layout::{self, Layout};
use super::rows::{StripRows, each_row};
use super::structure::{Directory, TiffFile, unsupported};
use super::tag;
use crate::io::dem::error::{DemError, invalid};
use crate::room::try_reserve;
use core::ops::Range;
use std::io::{Read, Seek};

/// Bits of NewSubfileType: an image of less resolution, and a mask.
const REDUCED: u64 = 1;
const MASK: u64 = 4;

/// Directories among which a mask is looked for: far more than a file has overviews.
const MOST_DIRECTORIES: usize = 256;

/// The layout of the mask of an image of that size, if there is one.
fn find<R: Read + Seek>(
    file: &TiffFile<R>,
    first: &Directory,
    size: [u32; 2],
) -> Result<Option<Layout>, DemError> {
    let mut next = first.next;
    for _ in 0..MOST_DIRECTORIES {
        if next == 0 {
            break;
        }
        let directory = file.directory(next)?;
        let kind = file.number_or(&directory, tag::NEW_SUBFILE_TYPE, 0)?;
        if kind & MASK != 0 && kind & REDUCED == 0 && layout::size(file, &directory)? == size {
            return Layout::read(file, &directory).map(Some);
        }
        next = directory.next;
    }
    Ok(None)
}

/// A mask in a file of its own.
pub(in crate::io) struct MaskFile<R> {
    file: TiffFile<R>,
    layout: Layout,
}

impl<R: Read + Seek> MaskFile<R> {
    /// Opens a file of a mask; nothing of it is read yet.
    pub(in crate::io) fn open(source: R) -> Result<Self, DemError> {
        let file = TiffFile::open(source)?;
        let directory = file.directory(file.first)?;
        let layout = Layout::read(&file, &directory)?;
        Ok(Self { file, layout })
    }
}

/// The pixels of some rows that are invalid, by all masks that an image has: its second sample, the
/// one in its file, the one beside it. Rows are asked for in their order.
pub(super) struct InvalidPixels<'a, R, M> {
    image: (&'a TiffFile<R>, &'a Layout),
    own: Option<Layout>,
    beside: Option<&'a MaskFile<M>>,
    bands: [MaskBand<'a>; 3],
}

impl<'a, R: Read + Seek, M: Read + Seek> InvalidPixels<'a, R, M> {
    /// Finds the masks of an image; nothing of them is read yet.
    pub(super) fn find(
        file: &'a TiffFile<R>,
        directory: &Directory,
        layout: &'a Layout,
        beside: Option<&'a MaskFile<M>>,
    ) -> Result<Self, DemError> {
        if beside.is_some_and(|mask| mask.layout.size != layout.size) {
            return Err(invalid("the mask beside it (.msk) has another size"));
        }
        Ok(Self {
            image: (file, layout),
            own: find(file, directory, layout.size)?,
            beside,
            bands: Default::default(),
        })
    }

    /// Reads the masks of some rows of an image.
    pub(super) fn load(&mut self, rows: Range<u32>) -> Result<(), DemError> {
        let [opacity, own, beside] = &mut self.bands;
        let (file, layout) = self.image;
        if layout.samples > 1 {
            opacity.load(file, layout, 1, rows.clone())?;
        }
        if let Some(mask) = &self.own {
            own.load(file, mask, 0, rows.clone())?;
        }
        if let Some(mask) = self.beside {
            beside.load(&mask.file, &mask.layout, 0, rows)?;
        }
        Ok(())
    }

    /// Is a pixel of these rows invalid?
    pub(super) fn has(&self, pixel: usize) -> bool {
        self.bands.iter().any(|band| band.has(pixel))
    }
}

/// Some rows of a mask: those that are wanted, or, of tiles, those of whole ones.
#[derive(Default)]
struct MaskBand<'a> {
    rows: Range<u32>,
    /// Its first pixel.
    first: usize,
    /// A bit for each pixel, set if that is invalid.
    bits: Vec<u64>,
    strips: StripRows<'a>,
}

impl<'a> MaskBand<'a> {
    /// Reads some rows, unless they are here already. Invalid is a sample of 0.
    fn load<R: Read + Seek + 'a>(
        &mut self,
        file: &TiffFile<R>,
        layout: &Layout,
        sample: usize,
        wanted: Range<u32>,
    ) -> Result<(), DemError> {
        if self.rows.start <= wanted.start && wanted.end <= self.rows.end {
            return Ok(());
        }
        let blocks = layout.rows_of_blocks(wanted.clone());
        self.rows = match layout.is_of_strips() {
            true => wanted,
            false => layout.rows_in(blocks.clone()),
        };
        let width = layout.size[0] as usize;
        self.first = self.rows.start as usize * width;
        self.clear(self.rows.len() * width)?;
        if layout.is_of_strips() {
            for row in 0..self.rows.len() {
                let numbers = self.strips.next(file, layout, sample, 0.0)?;
                mark(&mut self.bits, row * width, numbers);
            }
            return Ok(());
        }
        for row in blocks {
            each_row(file, layout, sample, row, 0.0, |place, numbers| {
                mark(&mut self.bits, place - self.first, numbers);
                Ok(())
            })?;
        }
        Ok(())
    }

    /// Makes room for so many valid pixels.
    fn clear(&mut self, pixels: usize) -> Result<(), DemError> {
        let words = pixels.div_ceil(64);
        self.bits.clear();
        let room = try_reserve(&mut self.bits, words);
        room.map_err(|_| DemError::Memory(8 * words as u64))?;
        self.bits.resize(words, 0);
        Ok(())
    }

    fn has(&self, pixel: usize) -> bool {
        let place = pixel.wrapping_sub(self.first);
        let word = self.bits.get(place / 64);
        word.is_some_and(|word| word >> (place % 64) & 1 == 1)
    }
}

/// Notes the zeros among numbers of pixels, the first of which has this place among bits.
fn mark(bits: &mut [u64], place: usize, numbers: &[f64]) {
    for (pixel, _) in (place..).zip(numbers).filter(|(_, number)| **number == 0.0) {
        bits[pixel / 64] |= 1 << (pixel % 64);
    }
}

/// Refuses images of several bands: one band may have a second sample that says how opaque it is.
pub(super) fn check_samples<R: Read + Seek>(
    file: &TiffFile<R>,
    directory: &Directory,
) -> Result<(), DemError> {
    let samples = file.number_or(directory, tag::SAMPLES_PER_PIXEL, 1)?;
    let extra = file.numbers(directory, tag::EXTRA_SAMPLES)?;
    match (samples, extra.as_slice()) {
        // Associated and unassociated alpha.
        (0..=1, _) | (2, [1 | 2]) => Ok(()),
        _ => Err(unsupported(
            tag::SAMPLES_PER_PIXEL,
            format!("{samples}, several bands,"),
        )),
    }
}
