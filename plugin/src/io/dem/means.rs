//! Means of the values that fall into each of many cells, while values come in any order.

use super::error::DemError;
use crate::room::try_reserve;

/// Cells, and what has come into them.
pub(in crate::io) struct CellMeans {
    /// Sums of the values; where none gets more than one, the value, or NaN.
    sums: Vec<f32>,
    /// How many values have come into each cell; empty where none gets more than one.
    counts: Vec<u32>,
}

impl CellMeans {
    /// So many cells; `is_single` says that none gets more than one value.
    ///
    /// # Errors
    /// [`DemError::Memory`].
    pub(in crate::io) fn new(cells: usize, is_single: bool) -> Result<Self, DemError> {
        let counted = if is_single { 0 } else { cells };
        let no_room = |_| DemError::Memory(4 * (cells + counted) as u64);
        let mut means = Self {
            sums: Vec::new(),
            counts: Vec::new(),
        };
        try_reserve(&mut means.sums, cells).map_err(no_room)?;
        let empty = if is_single { f32::NAN } else { 0.0 };
        means.sums.resize(cells, empty);
        try_reserve(&mut means.counts, counted).map_err(no_room)?;
        means.counts.resize(counted, 0);
        Ok(means)
    }

    /// Takes a value into a cell, unless it is NaN.
    pub(in crate::io) fn add(&mut self, cell: usize, value: f32) {
        if value.is_nan() {
            return;
        }
        match self.counts.get_mut(cell) {
            None => self.sums[cell] = value,
            Some(count) => {
                *count += 1;
                self.sums[cell] += value;
            }
        }
    }

    /// The mean of every cell, NaN where no value has come.
    pub(in crate::io) fn finish(self) -> Vec<f32> {
        let mut means = self.sums;
        for (sum, count) in means.iter_mut().zip(&self.counts) {
            *sum /= *count as f32;
        }
        means
    }
}
