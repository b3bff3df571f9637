//! The heights of an export on the disk while it is written.
//!
//! Heights are dear and a planet has more than memory: each is computed once, band by band, and
//! kept in a file without a name, which is gone with the program however it ends. Every format
//! reads its rows from there, knowing the range of all.

use super::error::{ExportError, as_io_error, cannot_encode};
use crate::io::IoError;
use crate::io::files::{folder_of, temporary};
use crate::query::{Ground, GroundError, MapGrid};
use crate::room::try_reserve;
use core::ops::Range;
use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// The heights of a whole grid, in a file without a name.
pub(super) struct HeightScratch {
    file: File,
    columns: usize,
    /// Lowest and highest.
    pub(super) range: [f32; 2],
}

impl HeightScratch {
    /// Asks for the heights of a grid, and keeps them on the disk that `path` is to be on.
    pub(super) fn record(
        ground: &(impl Ground + ?Sized),
        grid: &MapGrid,
        path: &Path,
        go_on: impl Fn(usize) -> bool + Sync,
    ) -> Result<Self, ExportError> {
        let failed = |source| ExportError::Io(IoError::write(path, source));
        let mut out = BufWriter::new(nameless_beside(path).map_err(failed)?);
        let mut range = [f32::INFINITY, f32::NEG_INFINITY];
        grid.heights_by_bands(ground, go_on, |band| {
            range = range_with(range, band)?;
            write_floats(&mut out, band).map_err(failed)
        })?;
        Ok(Self {
            file: out
                .into_inner()
                .map_err(|error| failed(error.into_error()))?,
            columns: grid.columns(),
            range,
        })
    }

    /// The heights at `columns` and `rows` of the grid, row by row.
    pub(super) fn read(&self, columns: Range<usize>, rows: Range<usize>) -> io::Result<Vec<f32>> {
        let width = columns.len();
        let mut values = Vec::new();
        try_reserve(&mut values, width * rows.len())
            .map_err(|_| as_io_error(GroundError::Memory))?;
        let mut bytes = vec![0; 4 * width];
        for row in rows {
            let at = 4 * (row * self.columns + columns.start) as u64;
            (&self.file).seek(SeekFrom::Start(at))?;
            (&self.file).read_exact(&mut bytes)?;
            values.extend(bytes.as_chunks().0.iter().map(|&b| f32::from_ne_bytes(b)));
        }
        Ok(values)
    }
}

/// A file without a name on the disk that `path` is to be on; where its folder takes none, as with
/// devices, on the disk of temporary files.
fn nameless_beside(path: &Path) -> io::Result<File> {
    tempfile::tempfile_in(folder_of(path)).or_else(|_| tempfile::tempfile().map_err(temporary))
}

/// A range, widened to the heights of a band; refuses infinite heights and NaN.
fn range_with(range: [f32; 2], band: &[f32]) -> Result<[f32; 2], ExportError> {
    if !band.iter().all(|z| z.is_finite()) {
        return Err(cannot_encode(
            "the ground has a height that is not a number",
        ));
    }
    let widen = |[low, high]: [f32; 2], &z: &f32| [low.min(z), high.max(z)];
    Ok(band.iter().fold(range, widen))
}

/// Floats in the machine's order.
pub(super) fn write_floats(out: &mut dyn Write, floats: &[f32]) -> io::Result<()> {
    let bytes: Vec<u8> = floats.iter().flat_map(|z| z.to_ne_bytes()).collect();
    out.write_all(&bytes)
}
