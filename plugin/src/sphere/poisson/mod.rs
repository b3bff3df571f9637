//! Poisson-disk sampling of the sphere: random points, no two of which are closer than a given
//! angle, and so many that hardly a place is left for one more (Bridson 2007; paper 002 §4).
//!
//! Darts are thrown at random places in the cells of latitude bands; one that falls too close to a
//! point is dropped, else it becomes a point. A cell is so small that it holds one point at most,
//! so a dart is checked against some twenty cells. A block of bands touches its two neighbours
//! alone: first every other block is filled, then those between, whose darts are checked against
//! the first as well. Blocks depend on the angle alone and a dart on its cell and round, so any
//! number of threads finds the same points.

mod bands;
mod block;

use super::cube::along_curve;
use crate::random::{Purpose, Stream};
use bands::Bands;
use bevy::math::DVec3;
use block::Block;
use rayon::prelude::*;

/// Smallest angle between points in radians: about four million points.
const MIN_DISTANCE: f64 = 0.0015;

/// Largest angle between points in radians: about a dozen points.
const MAX_DISTANCE: f64 = 0.8;

/// Points in random places, no two closer than `distance` radians (clamped to 0.0015..=0.8),
/// ordered along a space-filling curve. The mean distance of neighbours is about 1.3 times
/// `distance`.
///
/// ```
/// # use bevy_pangaea::{math, sphere::poisson_disk};
/// let points = poisson_disk(7, 0.3);
/// for (i, &p) in points.iter().enumerate() {
///     assert!(points[..i].iter().all(|&q| math::angle_between(p, q) > 0.3 - 1e-9));
/// }
/// assert_eq!(points, poisson_disk(7, 0.3));
/// ```
pub fn poisson_disk(seed: u64, distance: f64) -> Vec<DVec3> {
    let bands = Bands::new(distance.clamp(MIN_DISTANCE, MAX_DISTANCE));
    let stream = Stream::new(seed, Purpose::BaseMesh, 0);
    let nothing = vec![Vec::new(); bands.block_count()];
    let even = fill_blocks(&bands, stream, 0, &nothing);
    let odd = fill_blocks(&bands, stream, 1, &even);
    // Each block is empty in one of the two lists.
    let mut points = Vec::new();
    for (a, b) in even.into_iter().zip(odd) {
        points.extend(a.into_iter().chain(b).filter(|p| *p != DVec3::ZERO));
    }
    along_curve(points.len() as u32, |i| points[i as usize])
}

/// Fills every second block, beginning with number `parity`; the others stay empty. `done` holds
/// the blocks that are filled already.
fn fill_blocks(
    bands: &Bands,
    stream: Stream,
    parity: usize,
    done: &[Vec<DVec3>],
) -> Vec<Vec<DVec3>> {
    let blocks = (0..bands.block_count()).into_par_iter();
    blocks
        .map(|number| {
            if number % 2 == parity {
                Block::new(bands, number, done).filled(stream)
            } else {
                Vec::new()
            }
        })
        .collect()
}

#[cfg(test)]
mod tests;
