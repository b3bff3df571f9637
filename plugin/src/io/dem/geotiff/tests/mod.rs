//! Files that are written here byte by byte, and the numbers that GDAL reads from them.

mod beside;
mod blocks;
mod codes;
mod counts;
mod places;
mod systems;
mod texts;
mod writer;

use super::*;
use crate::io::dem::error::DemError;
use std::io::Cursor;
use writer::{Image, PLAIN, Values, tiff};

/// The tags of an image of one band: size, bits to a sample, their format, compression, rows of a
/// strip.
fn fields(size: [u16; 2], bits: u16, format: u16, compression: u16) -> Vec<(u16, Values)> {
    let numbers = [
        (256, size[0]),
        (257, size[1]),
        (258, bits),
        (259, compression),
        (262, 1),
        (277, 1),
        (278, size[1]),
        (339, format),
    ];
    numbers.map(|(tag, n)| (tag, Values::Short(vec![n]))).into()
}

/// Replaces or adds tags.
fn with<const N: usize>(
    mut fields: Vec<(u16, Values)>,
    tags: [(u16, Values); N],
) -> Vec<(u16, Values)> {
    for (tag, values) in tags {
        fields.retain(|(other, _)| *other != tag);
        fields.push((tag, values));
    }
    fields
}

fn short(n: u16) -> Values {
    Values::Short(vec![n])
}

/// A file of one image in one block.
fn plain(fields: Vec<(u16, Values)>, block: Vec<u8>) -> Vec<u8> {
    let blocks = vec![block];
    tiff(PLAIN, vec![Image { fields, blocks }])
}

/// The values of a file, NaN for voids.
fn values(bytes: &[u8]) -> Result<Vec<f32>, DemError> {
    let open = RasterFile::open(Cursor::new(bytes), SideFiles::default(), |_, _| {
        Ok::<(), DemError>(())
    });
    let mut raster = open?;
    let [width, height] = raster.size().map(|side| side as usize);
    let mut values = vec![f32::NAN; width * height];
    raster.for_each_row([1.0, 0.0], |place, row| {
        values[place..place + row.len()].copy_from_slice(row);
    })?;
    let [is_mirrored, is_south_up] = raster.is_turned();
    let mut rows: Vec<Vec<f32>> = values.chunks(width).map(<[f32]>::to_vec).collect();
    if is_mirrored {
        rows.iter_mut().for_each(|row| row.reverse());
    }
    if is_south_up {
        rows.reverse();
    }
    Ok(rows.concat())
}

/// Why a file is refused.
fn refusal(bytes: &[u8]) -> String {
    values(bytes).unwrap_err().to_string()
}
