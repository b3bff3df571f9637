//! Heights of a grid by bands of rows: memory does not grow with the grid.

use super::error::GroundError;
use super::ground::Ground;
use super::map_grid::MapGrid;
use crate::parallel;
use crate::room::try_reserve;
use bevy::math::DVec3;
use core::ops::Range;
use core::sync::atomic::{AtomicUsize, Ordering};
use rayon::prelude::*;

/// Points of a band: enough for all threads, few enough for a megabyte.
const BAND_POINTS: usize = 1 << 18;

impl MapGrid {
    /// The rows of each band, from the north.
    pub fn bands(&self) -> impl Iterator<Item = Range<usize>> + use<> {
        let rows = self.rows();
        let height = (BAND_POINTS / self.columns().max(1)).clamp(1, rows.max(1));
        (0..rows.div_ceil(height)).map(move |k| k * height..((k + 1) * height).min(rows))
    }

    /// Asks for the heights in m of all points, band by band from the north, each on all threads,
    /// and gives each band to `take`. The bits are those of single questions.
    ///
    /// `go_on` is told the number of points that are known before each batch, from any thread, and
    /// says whether to go on.
    ///
    /// ```
    /// use bevy_pangaea::query::{DegreeBox, GroundError, PlanetGround, Rules};
    /// use pangaea_shaders::amplify::synthetic::control_mesh;
    ///
    /// let ground = PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default())?;
    /// let planet = DegreeBox::new([-90.0, -180.0, 90.0, 180.0], 6_370_000.0, [64, 32])?;
    /// let mut highest = f32::MIN;
    /// planet.grid().heights_by_bands(&ground, |_| true, |band| {
    ///     highest = band.iter().fold(highest, |high, &z| high.max(z));
    ///     Ok::<(), GroundError>(())
    /// })?;
    /// assert!(highest > -12_000.0);
    /// # Ok::<(), GroundError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Ground::height`]: the error of the first batch that has one; [`GroundError::Stopped`];
    /// [`GroundError::Memory`]; and those of `take`.
    pub fn heights_by_bands<E: From<GroundError>>(
        &self,
        ground: &(impl Ground + ?Sized),
        go_on: impl Fn(usize) -> bool + Sync,
        mut take: impl FnMut(&[f32]) -> Result<(), E>,
    ) -> Result<(), E> {
        let known = AtomicUsize::new(0);
        let mut band = Vec::new();
        for rows in self.bands() {
            let count = rows.len() * self.columns();
            try_reserve(&mut band, count).map_err(|_| GroundError::Memory)?;
            band.resize(count, 0.0);
            self.fill(ground, rows.start, &mut band, &known, &go_on)?;
            take(&band)?;
            band.clear();
        }
        Ok(())
    }

    /// Heights from a row on, in batches on all threads.
    fn fill(
        &self,
        ground: &(impl Ground + ?Sized),
        first_row: usize,
        heights: &mut [f32],
        known: &AtomicUsize,
        go_on: &(impl Fn(usize) -> bool + Sync),
    ) -> Result<(), GroundError> {
        let first = first_row * self.columns();
        let batches = heights.par_chunks_mut(parallel::CHUNK).enumerate();
        let results = batches.map(|(batch, heights)| {
            if !go_on(known.load(Ordering::Relaxed)) {
                return Err(GroundError::Stopped);
            }
            let directions = self.directions(first + batch * parallel::CHUNK, heights.len());
            ground.heights(&directions, self.level, heights)?;
            known.fetch_add(heights.len(), Ordering::Relaxed);
            Ok(())
        });
        // Collected first: which of several errors is told must not depend on the threads.
        let results: Vec<Result<(), GroundError>> = results.collect();
        results.into_iter().collect()
    }

    /// Unit vectors of so many points from the `first` on, row by row.
    fn directions(&self, first: usize, count: usize) -> Vec<DVec3> {
        (first..first + count)
            .map(|i| self.direction(i % self.columns(), i / self.columns()))
            .collect()
    }
}
