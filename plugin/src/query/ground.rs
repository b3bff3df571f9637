//! The questions that every reader of a ground asks.

use super::check::{check_count, checked};
use super::error::GroundError;
use super::sample::{NormalStencil, Sample};
use super::surface::ClimateSample;
use bevy::math::DVec3;
use rayon::prelude::*;

/// Points of a batch of samples that a thread asks for in a row: neighbours share work.
const SAMPLES_PER_RUN: usize = 64;

/// The ground of a planet. Every method may be called from many threads at once.
///
/// A ground needs a radius and heights; all other answers follow from them, and a ground that knows
/// better gives its own.
///
/// ```
/// use bevy::math::DVec3;
/// use bevy_pangaea::query::{Ground, GroundError, GroundSurface, checked};
///
/// /// A ball of 1000 km under 50 m of water.
/// struct Ocean;
///
/// impl Ground for Ocean {
///     fn radius_m(&self) -> f64 {
///         1e6
///     }
///
///     fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
///         checked(direction, level).map(|_| -50.0)
///     }
/// }
///
/// let sample = Ocean.sample(DVec3::new(1.0, 2.0, 3.0), 12)?;
/// assert_eq!((sample.height_m, sample.water_m), (-50.0, 0.0));
/// assert_eq!(sample.surface, GroundSurface::SeaFloor);
/// # Ok::<(), GroundError>(())
/// ```
pub trait Ground: Sync {
    /// Radius of the sea level in m.
    fn radius_m(&self) -> f64;

    /// Height of the ground above sea level in m, at a direction of any length and a level up to
    /// [`LEVELS`](super::LEVELS).
    ///
    /// # Errors
    /// [`GroundError::NotADirection`], [`GroundError::Level`].
    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError>;

    /// Heights at many directions, faster where the ground can share work between neighbours.
    ///
    /// # Errors
    /// As [`height`](Self::height), for the first refused direction; [`GroundError::Count`] if
    /// `heights` is not as long as `directions`.
    fn heights(
        &self,
        directions: &[DVec3],
        level: u8,
        heights: &mut [f32],
    ) -> Result<(), GroundError> {
        check_same_length(directions, heights)?;
        for (direction, height) in directions.iter().zip(heights) {
            *height = self.height(*direction, level)?;
        }
        Ok(())
    }

    /// Level of the water surface in m; the height of the ground where it is dry. Without a better
    /// answer there is a sea at level 0 and no other water.
    ///
    /// # Errors
    /// As [`height`](Self::height).
    fn water(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        Ok(self.height(direction, level)?.max(0.0))
    }

    /// Warmth and wetness at a direction, for a ground that is `height_m` above the sea. Without a
    /// better answer it is that of the latitude.
    ///
    /// # Errors
    /// As [`height`](Self::height).
    fn climate(&self, direction: DVec3, height_m: f32) -> Result<ClimateSample, GroundError> {
        let unit = checked(direction, 0)?;
        Ok(ClimateSample::of_latitude(unit.z, height_m))
    }

    /// Unit normal of the ground in the planet's axes: of the surface through the four points that
    /// lie one edge of the level to the east, west, north and south.
    ///
    /// # Errors
    /// As [`height`](Self::height); [`GroundError::Radius`].
    fn normal(&self, direction: DVec3, level: u8) -> Result<DVec3, GroundError> {
        let up = checked(direction, level)?;
        let stencil = NormalStencil::new(up, self.radius_m(), level)?;
        let mut heights = [0.0; 4];
        self.heights(&stencil.around, level, &mut heights)?;
        Ok(stencil.normal(heights))
    }

    /// All there is to know of the ground at a direction of any length. The same as single
    /// questions at the unit direction; a ground that finds a place once for all of them is faster.
    ///
    /// # Errors
    /// As [`normal`](Self::normal).
    fn sample(&self, direction: DVec3, level: u8) -> Result<Sample, GroundError> {
        let up = checked(direction, level)?;
        let height_m = self.height(up, level)?;
        let water_m = self.water(up, level)?;
        let normal = self.normal(up, level)?;
        let climate = self.climate(up, height_m)?;
        Ok(Sample::new(up, height_m, water_m, normal, climate))
    }

    /// The ground at many directions, in their order and with the bits of
    /// [`sample`](Self::sample), on all threads.
    ///
    /// # Errors
    /// As [`sample`](Self::sample), for the first refused direction.
    fn samples(&self, directions: &[DVec3], level: u8) -> Result<Vec<Sample>, GroundError> {
        let sample = |&direction: &DVec3| self.sample(direction, level);
        // Collected first: which of several errors is told must not depend on the threads.
        let runs: Vec<Vec<_>> = directions
            .par_chunks(SAMPLES_PER_RUN)
            .map(|run| run.iter().map(sample).collect())
            .collect();
        runs.into_iter().flatten().collect()
    }

    /// Lowest and highest ground in m that there can be; rays are followed between them.
    fn bounds_m(&self) -> [f64; 2] {
        [-15_000.0, 15_000.0]
    }
}

/// Refuses two slices of different lengths.
pub(super) fn check_same_length(directions: &[DVec3], heights: &[f32]) -> Result<(), GroundError> {
    let n = directions.len();
    check_count("the number of heights", heights.len(), [n, n])
}

#[cfg(test)]
#[path = "ground_tests.rs"]
mod tests;
