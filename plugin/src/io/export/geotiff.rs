//! GeoTIFF (OGC 19-008r4): one band of f32 in m, uncompressed, in strips.
//!
//! The directory comes first and the strips follow in order, so the file is written in one go.

use super::encoding::Encoding;
use super::geo_keys::GeoKeys;
use super::scratch::write_floats;
use crate::query::MapGrid;
use core::ops::Range;
use std::io::{self, Cursor, Seek, Write};
use tiff::TiffResult;
use tiff::encoder::{DirectoryEncoder, Rational, TiffEncoder, TiffKind};
use tiff::tags::Tag;

/// Bytes of a strip, about.
const STRIP_BYTES: usize = 1 << 18;

/// The file of a grid.
pub(super) fn write(source: &Encoding, out: &mut dyn Write) -> io::Result<()> {
    let head = head(&source.grid).map_err(io::Error::other)?;
    out.write_all(&head)?;
    source.for_each_band(|band| write_floats(out, band))
}

/// All that comes before the strips.
fn head(grid: &MapGrid) -> TiffResult<Vec<u8>> {
    // The length of the head does not depend on where it says that the strips are.
    let length = head_before(grid, 0)?.len();
    head_before(grid, length)
}

/// The head of a file whose strips begin at byte `first`.
fn head_before(grid: &MapGrid, first: usize) -> TiffResult<Vec<u8>> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes)?;
    let mut directory = encoder.image_directory()?;
    write_image(&mut directory, grid)?;
    write_strips(&mut directory, grid, first)?;
    write_place(&mut directory, grid)?;
    directory.finish()?;
    Ok(bytes.into_inner())
}

/// One band of 32-bit floats, zero is black; no unit of length for paper.
fn write_image<W: Write + Seek, K: TiffKind>(
    tags: &mut DirectoryEncoder<'_, W, K>,
    grid: &MapGrid,
) -> TiffResult<()> {
    tags.write_tag(Tag::ImageWidth, grid.columns() as u32)?;
    tags.write_tag(Tag::ImageLength, grid.rows() as u32)?;
    tags.write_tag(Tag::BitsPerSample, 32_u16)?;
    tags.write_tag(Tag::Compression, 1_u16)?;
    tags.write_tag(Tag::PhotometricInterpretation, 1_u16)?;
    tags.write_tag(Tag::SamplesPerPixel, 1_u16)?;
    tags.write_tag(Tag::SampleFormat, 3_u16)?;
    tags.write_tag(Tag::XResolution, Rational { n: 1, d: 1 })?;
    tags.write_tag(Tag::YResolution, Rational { n: 1, d: 1 })?;
    tags.write_tag(Tag::ResolutionUnit, 1_u16)?;
    tags.write_tag(Tag::Software, "Pangaea")
}

/// Where the strips are.
fn write_strips<W: Write + Seek, K: TiffKind>(
    tags: &mut DirectoryEncoder<'_, W, K>,
    grid: &MapGrid,
    first: usize,
) -> TiffResult<()> {
    let row = 4 * grid.columns();
    let height = (STRIP_BYTES / row).clamp(1, grid.rows());
    let strips = strips(grid.rows(), height);
    let offsets: Vec<u32> = strips
        .iter()
        .map(|rows| (first + rows.start * row) as u32)
        .collect();
    let counts: Vec<u32> = strips
        .iter()
        .map(|rows| (rows.len() * row) as u32)
        .collect();
    tags.write_tag(Tag::RowsPerStrip, height as u32)?;
    tags.write_tag(Tag::StripOffsets, &offsets[..])?;
    tags.write_tag(Tag::StripByteCounts, &counts[..])
}

/// The rows of each strip.
fn strips(rows: usize, height: usize) -> Vec<Range<usize>> {
    let strip = |k: usize| k * height..((k + 1) * height).min(rows);
    (0..rows.div_ceil(height)).map(strip).collect()
}

/// Where the grid is on the planet.
fn write_place<W: Write + Seek, K: TiffKind>(
    tags: &mut DirectoryEncoder<'_, W, K>,
    grid: &MapGrid,
) -> TiffResult<()> {
    let step = grid.step();
    let scale = [step.x, step.y, 0.0];
    // Raster point (0, 0) is the first vertex, or the corner of the first pixel.
    let corner = grid.north_west();
    let tie = [0.0, 0.0, 0.0, corner.x, corner.y, 0.0];
    let keys = GeoKeys::new(grid);
    tags.write_tag(Tag::ModelPixelScaleTag, &scale[..])?;
    tags.write_tag(Tag::ModelTiepointTag, &tie[..])?;
    tags.write_tag(Tag::GeoKeyDirectoryTag, &keys.directory[..])?;
    tags.write_tag(Tag::GeoDoubleParamsTag, &keys.doubles[..])?;
    tags.write_tag(Tag::GeoAsciiParamsTag, keys.text.as_str())
}
