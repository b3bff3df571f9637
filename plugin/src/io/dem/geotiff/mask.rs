//! Masks: an image of its own in the file that says which pixels are valid (GDAL's internal masks),
//! in a file of its own (NAME.EXT.msk), or a second sample that says how opaque a pixel is.

use super::layout::{self, Layout};
use super::rows::each_row;
use super::structure::{Directory, TiffFile, unsupported};
use super::tag;
use crate::io::dem::error::{DemError, invalid};
use crate::room::try_reserve;
use std::io::{Read, Seek};

/// Bits of NewSubfileType: an image of less resolution, and a mask.
const REDUCED: u64 = 1;
const MASK: u64 = 4;

/// Directories among which a mask is looked for: far more than a file has overviews.
const MOST_DIRECTORIES: usize = 256;

/// The layout of the mask of an image of that size, if there is one.
fn find<R: Read + Seek>(
    file: &mut TiffFile<R>,
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
        let mut file = TiffFile::open(source)?;
        let directory = file.directory(file.first)?;
        let layout = Layout::read(&mut file, &directory)?;
        Ok(Self { file, layout })
    }
}

/// The pixels that are invalid, a bit each; none where all are valid.
#[derive(Default)]
pub(super) struct InvalidPixels(Vec<u64>);

impl InvalidPixels {
    /// Reads the masks of an image: its second sample, the one in its file, the one beside it.
    pub(super) fn read<R: Read + Seek, M: Read + Seek>(
        file: &mut TiffFile<R>,
        directory: &Directory,
        layout: &Layout,
        beside: Option<&mut MaskFile<M>>,
    ) -> Result<Self, DemError> {
        let mut all = Self::default();
        if layout.samples > 1 {
            all.add(file, layout, 1)?;
        }
        if let Some(mask) = find(file, directory, layout.size)? {
            all.add(file, &mask, 0)?;
        }
        if let Some(mask) = beside {
            if mask.layout.size != layout.size {
                return Err(invalid("the mask beside it (.msk) has another size"));
            }
            all.add(&mut mask.file, &mask.layout, 0)?;
        }
        Ok(all)
    }

    /// Adds the pixels at which a sample is 0.
    fn add<R: Read + Seek>(
        &mut self,
        file: &mut TiffFile<R>,
        layout: &Layout,
        sample: usize,
    ) -> Result<(), DemError> {
        let words = layout.pixels().div_ceil(64);
        if self.0.is_empty() {
            let room = try_reserve(&mut self.0, words);
            room.map_err(|_| DemError::Memory(8 * words as u64))?;
            self.0.resize(words, 0);
        }
        each_row(file, layout, sample, 0.0, |place, numbers| {
            for (pixel, _) in (place..).zip(numbers).filter(|(_, number)| **number == 0.0) {
                self.0[pixel / 64] |= 1 << (pixel % 64);
            }
        })
    }

    /// Is a pixel invalid?
    pub(super) fn has(&self, pixel: usize) -> bool {
        let word = self.0.get(pixel / 64);
        word.is_some_and(|word| word >> (pixel % 64) & 1 == 1)
    }
}

/// Refuses images of several bands: one band may have a second sample that says how opaque it is.
pub(super) fn check_samples<R: Read + Seek>(
    file: &mut TiffFile<R>,
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
