//! The numbers of an image: of a row of blocks, row by row of each block; or of strips, a row when it
//! is asked for.

use super::codec::BlockRows;
use super::layout::Layout;
use super::structure::{TiffFile, cut_short};
use crate::io::dem::error::{DemError, invalid};
use std::io::{Read, Seek};

/// Calls `use_row` with where a row of numbers begins in the image, and the numbers of a sample, for
/// all blocks of a row of blocks. Blocks that are left out hold `fill`.
pub(super) fn each_row<R: Read + Seek>(
    file: &TiffFile<R>,
    layout: &Layout,
    sample: usize,
    row_of_blocks: u32,
    fill: f64,
    mut use_row: impl FnMut(usize, &[f64]) -> Result<(), DemError>,
) -> Result<(), DemError> {
    let [across, _] = layout.blocks_a_side();
    for column in 0..across {
        let block = [column, row_of_blocks];
        let (places, count) = places(layout, block);
        let mut rows = RowSource::open(file, layout, sample, block, fill)?;
        let mut numbers = vec![fill; count];
        for place in places {
            rows.next(layout, sample, &mut numbers)?;
            use_row(place, &numbers)?;
        }
    }
    Ok(())
}

/// Where the rows of a block begin in the image, and how many numbers they have within it.
fn places(layout: &Layout, [column, row]: [u32; 2]) -> (impl Iterator<Item = usize>, usize) {
    let [width, height] = layout.size.map(|side| side as usize);
    let [x, y] = [0, 1].map(|axis| [column, row][axis] as usize * layout.block[axis] as usize);
    let last = height.min(y + layout.block[1] as usize);
    let places = (y..last).map(move |y| y * width + x);
    (places, (layout.block[0] as usize).min(width - x))
}

/// The rows of a block that are still to come.
enum RowSource<'a> {
    /// Of a block that is left out: all hold this number.
    Fill(f64),
    Block {
        rows: BlockRows<'a>,
        bytes: Vec<u8>,
        /// Has the file all bytes of it?
        is_whole: bool,
    },
}

impl<'a> RowSource<'a> {
    fn open<R: Read + Seek + 'a>(
        file: &TiffFile<R>,
        layout: &Layout,
        sample: usize,
        block: [u32; 2],
        fill: f64,
    ) -> Result<Self, DemError> {
        let Some((offset, length)) = layout.place(block, sample) else {
            return Ok(Self::Fill(fill));
        };
        // No block begins within the file's head.
        if offset < 8 {
            return Err(cut_short());
        }
        let part = file.part(offset, length);
        let is_whole = offset.saturating_add(length) <= file.length;
        let rows = layout.codec.rows(part, file.order, layout.sample_type);
        Ok(Self::Block {
            rows: rows.map_err(|error| in_block(error, layout, is_whole))?,
            bytes: vec![0; layout.row_bytes()],
            is_whole,
        })
    }

    fn next(
        &mut self,
        layout: &Layout,
        sample: usize,
        numbers: &mut [f64],
    ) -> Result<(), DemError> {
        match self {
            Self::Fill(fill) => numbers.fill(*fill),
            Self::Block {
                rows,
                bytes,
                is_whole,
            } => {
                let (stride, first) = layout.samples_in_block(sample);
                let read = rows.next(bytes, stride);
                read.map_err(|error| in_block(error, layout, *is_whole))?;
                let sample_type = layout.sample_type;
                sample_type.decode(bytes, stride, first, numbers);
            }
        }
        Ok(())
    }
}

/// The error of a block; of one that the file has whole it may be the count of its bytes that is
/// wrong.
fn in_block(error: DemError, layout: &Layout, is_whole: bool) -> DemError {
    let counts = layout.counts.name;
    match error {
        DemError::Invalid(_) if is_whole && error == cut_short() => invalid(format!(
            "a block is cut short, or its {counts} is too small"
        )),
        DemError::Invalid(problem) if is_whole => {
            invalid(format!("{problem}, or its {counts} is too small"))
        }
        error => error,
    }
}

/// The rows of an image whose blocks are as wide as it, from the first one on: however high a strip
/// is, a row of it is held.
#[derive(Default)]
pub(super) struct StripRows<'a> {
    strip: Option<RowSource<'a>>,
    /// The row that comes next.
    row: u32,
    numbers: Vec<f64>,
}

impl<'a> StripRows<'a> {
    /// The numbers of the next row. Strips that are left out hold `fill`.
    pub(super) fn next<R: Read + Seek + 'a>(
        &mut self,
        file: &TiffFile<R>,
        layout: &Layout,
        sample: usize,
        fill: f64,
    ) -> Result<&[f64], DemError> {
        let [strip, within] = [self.row / layout.block[1], self.row % layout.block[1]];
        let open = match self.strip.take() {
            Some(open) if within > 0 => open,
            _ => RowSource::open(file, layout, sample, [0, strip], fill)?,
        };
        self.numbers.resize(layout.size[0] as usize, fill);
        let open = self.strip.insert(open);
        open.next(layout, sample, &mut self.numbers)?;
        self.row += 1;
        Ok(&self.numbers)
    }
}
