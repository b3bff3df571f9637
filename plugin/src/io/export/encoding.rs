//! One file at work: its points, and their heights band by band.

use super::error::as_io_error;
use super::scratch::HeightScratch;
use crate::query::{GroundError, MapGrid};
use core::ops::Range;
use std::io;

/// The source of one file.
pub(super) struct Encoding<'a> {
    /// The points of the file.
    pub(super) grid: MapGrid,
    /// The heights of the whole grid, of which `grid` may be a window.
    pub(super) heights: &'a HeightScratch,
    /// Whether the caller still wants the file.
    pub(super) go_on: &'a (dyn Fn() -> bool + Sync),
}

impl Encoding<'_> {
    /// Lets `take` have the heights of each band of rows, from the north.
    pub(super) fn for_each_band(
        &self,
        mut take: impl FnMut(&[f32]) -> io::Result<()>,
    ) -> io::Result<()> {
        self.for_each_rows(|rows| {
            let [first_column, first_row] = self.grid.first();
            let columns = first_column..first_column + self.grid.columns();
            let rows = first_row + rows.start..first_row + rows.end;
            take(&self.heights.read(columns, rows)?)
        })
    }

    /// Lets `take` have the rows of each band, for as long as the caller wants the file.
    pub(super) fn for_each_rows(
        &self,
        mut take: impl FnMut(Range<usize>) -> io::Result<()>,
    ) -> io::Result<()> {
        for rows in self.grid.bands() {
            if !(self.go_on)() {
                return Err(as_io_error(GroundError::Stopped));
            }
            take(rows)?;
        }
        Ok(())
    }
}
