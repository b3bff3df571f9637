//! Masks: an image of its own in the file that says which pixels are valid (GDAL's internal masks),
//! or a second sample that says how opaque a pixel is.

use super::layout::{self, Layout};
use super::rows::each_row;
use super::structure::{Directory, TiffFile, unsupported};
use super::tag;
use crate::io::dem::error::DemError;
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

/// Erases the values of pixels that the file's mask or the second sample declares invalid.
pub(super) fn erase<R: Read + Seek>(
    file: &mut TiffFile<R>,
    directory: &Directory,
    layout: &Layout,
    values: &mut [f32],
) -> Result<(), DemError> {
    if layout.samples > 1 {
        erase_by(file, layout, 1, values)?;
    }
    match find(file, directory, layout.size)? {
        Some(mask) => erase_by(file, &mask, 0, values),
        None => Ok(()),
    }
}

/// Erases values where a sample is 0.
fn erase_by<R: Read + Seek>(
    file: &mut TiffFile<R>,
    layout: &Layout,
    sample: usize,
    values: &mut [f32],
) -> Result<(), DemError> {
    each_row(file, layout, sample, 0.0, |place, numbers| {
        for (value, number) in values[place..].iter_mut().zip(numbers) {
            if *number == 0.0 {
                *value = f32::NAN;
            }
        }
    })
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
