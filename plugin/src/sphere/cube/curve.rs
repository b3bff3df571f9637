//! A Hilbert curve over the six faces: points that follow each other on it are close on the sphere,
//! so what is close on the sphere is close in memory.

use super::stretched::{stretched_cell, stretched_project};
use crate::parallel::CHUNK;
use bevy::math::DVec3;
use rayon::prelude::*;

/// Bits per axis of a face: cells of about 150 m on Earth.
const AXIS_BITS: u32 = 16;

/// Bits of a sort key that hold the index of the point; the position on the curve takes 35 others.
const INDEX_BITS: u32 = 24;

/// The points 0..n (n < 2^24) in the order of the curve.
pub(in crate::sphere) fn along_curve(n: u32, point: impl Fn(u32) -> DVec3 + Sync) -> Vec<DVec3> {
    let mut keys: Vec<u64> = (0..n)
        .into_par_iter()
        .with_min_len(CHUNK)
        .map(|i| (curve_position(point(i)) << INDEX_BITS) | u64::from(i))
        .collect();
    // Every key is unique, so the order is, too.
    keys.par_sort_unstable();
    let index = |key: u64| (key & ((1 << INDEX_BITS) - 1)) as u32;
    keys.into_par_iter()
        .with_min_len(CHUNK)
        .map(|key| point(index(key)))
        .collect()
}

/// Position of a direction along the curve, 35 bits: the faces follow each other.
fn curve_position(p: DVec3) -> u64 {
    let at = stretched_project(p);
    let side = 1 << AXIS_BITS;
    let on_face = hilbert(stretched_cell(at.u, side), stretched_cell(at.v, side));
    (u64::from(at.face) << (2 * AXIS_BITS)) | on_face
}

/// Index of the cell (x, y) along the Hilbert curve of a square of 2^16 cells a side:
/// quadrant by quadrant, each one turned into the frame of the curve inside it.
fn hilbert(mut x: u32, mut y: u32) -> u64 {
    let mut index = 0;
    for bit in (0..AXIS_BITS).rev() {
        let right = (x >> bit) & 1;
        let top = (y >> bit) & 1;
        // The curve visits lower left, upper left, upper right, lower right.
        index = (index << 2) | u64::from((3 * right) ^ top);
        // The lower quadrants hold the curve mirrored: the left one at the diagonal, the right one
        // at the other diagonal.
        if top == 0 {
            if right == 1 {
                let mask = (1 << AXIS_BITS) - 1;
                (x, y) = (!x & mask, !y & mask);
            }
            (x, y) = (y, x);
        }
    }
    index
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_steps_from_a_cell_to_one_beside_it() {
        // Cells of the coarse 16 x 16 square: the curve's first 8 bits order them.
        let mut cells = [None; 256];
        for (x, y) in (0..16).flat_map(|x| (0..16).map(move |y| (x, y))) {
            cells[(hilbert(x << 12, y << 12) >> 24) as usize] = Some((x, y));
        }
        let cells = cells.map(Option::unwrap);
        for pair in cells.windows(2) {
            assert_eq!(
                pair[0].0.abs_diff(pair[1].0) + pair[0].1.abs_diff(pair[1].1),
                1
            );
        }
    }
}
