//! The numbers of an image: of a row of blocks, row by row of each block.

use super::layout::Layout;
use super::structure::{TiffFile, cut_short};
use crate::io::dem::error::DemError;
use std::io::{Read, Seek};

/// Calls `use_row` with where a row of numbers begins in the image, and the numbers of a sample, for
/// all blocks of a row of blocks. Blocks that are left out hold `fill`.
pub(super) fn each_row<R: Read + Seek>(
    file: &mut TiffFile<R>,
    layout: &Layout,
    sample: usize,
    row_of_blocks: u32,
    fill: f64,
    mut use_row: impl FnMut(usize, &[f64]),
) -> Result<(), DemError> {
    let [across, _] = layout.blocks_a_side();
    for column in 0..across {
        let block = [column, row_of_blocks];
        match layout.place(block, sample) {
            Some(bytes) => read_block(file, layout, sample, block, bytes, &mut use_row)?,
            None => fill_block(layout, block, fill, &mut use_row),
        }
    }
    Ok(())
}

/// Where the rows of a block begin in the image, and how many numbers they have within it.
fn rows(layout: &Layout, [column, row]: [u32; 2]) -> (impl Iterator<Item = usize>, usize) {
    let [width, height] = layout.size.map(|side| side as usize);
    let [x, y] = [0, 1].map(|axis| [column, row][axis] as usize * layout.block[axis] as usize);
    let last = height.min(y + layout.block[1] as usize);
    let places = (y..last).map(move |y| y * width + x);
    (places, (layout.block[0] as usize).min(width - x))
}

fn fill_block(
    layout: &Layout,
    block: [u32; 2],
    fill: f64,
    use_row: &mut impl FnMut(usize, &[f64]),
) {
    let (places, count) = rows(layout, block);
    let numbers = vec![fill; count];
    places.for_each(|place| use_row(place, &numbers));
}

fn read_block<R: Read + Seek>(
    file: &mut TiffFile<R>,
    layout: &Layout,
    sample: usize,
    block: [u32; 2],
    (offset, length): (u64, u64),
    use_row: &mut impl FnMut(usize, &[f64]),
) -> Result<(), DemError> {
    // No block begins within the file's head.
    if offset < 8 {
        return Err(cut_short());
    }
    let order = file.order;
    let part = file.part(offset, length)?;
    let mut source = layout.codec.rows(part, order, layout.sample_type)?;
    let (places, count) = rows(layout, block);
    let mut bytes = vec![0; layout.row_bytes()];
    let mut numbers = vec![0.0; count];
    let (stride, first) = layout.samples_in_block(sample);
    for place in places {
        source.next(&mut bytes, stride)?;
        layout
            .sample_type
            .decode(&bytes, stride, first, &mut numbers);
        use_row(place, &numbers);
    }
    Ok(())
}
