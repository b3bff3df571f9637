//! The sphere as six square faces: the map behind the sample order and the lookup grid.
//!
//! A direction is projected from the centre to the cube's face, and the face's coordinates are
//! stretched by a cubic polynomial so that equal squares cover nearly equal solid angles
//! (85 % to 130 % of their mean). Only multiplications and one division: fast, and the same bits
//! anywhere.

use bevy::math::DVec3;

/// Slope of the stretch at the centre of a face; its slope at the border is 3 - 2 x this.
const SLOPE: f64 = 1.22;

/// Face 0..6 (+x, -x, +y, -y, +z, -z) and stretched coordinates in -1..=1 of a direction.
#[inline]
pub(super) fn project(p: DVec3) -> (u32, f64, f64) {
    let a = p.abs();
    let (face, side, major, u, v) = if a.x >= a.y && a.x >= a.z {
        (0, p.x, a.x, p.y, p.z)
    } else if a.y >= a.z {
        (2, p.y, a.y, p.x, p.z)
    } else {
        (4, p.z, a.z, p.x, p.y)
    };
    let scale = 1.0 / major;
    (
        face + u32::from(side < 0.0),
        stretch(u * scale),
        stretch(v * scale),
    )
}

/// The direction (not normalised) of plane coordinates on a face: the inverse of the projection
/// for coordinates that went through [`unstretch`].
pub(super) fn unproject(face: u32, u: f64, v: f64) -> DVec3 {
    let side = if face & 1 == 0 { 1.0 } else { -1.0 };
    match face / 2 {
        0 => DVec3::new(side, u, v),
        1 => DVec3::new(u, side, v),
        _ => DVec3::new(u, v, side),
    }
}

#[inline]
fn stretch(x: f64) -> f64 {
    x * (SLOPE - (SLOPE - 1.0) * x * x)
}

/// The inverse of the stretch, by Newton's method.
pub(super) fn unstretch(y: f64) -> f64 {
    let mut x = y;
    for _ in 0..8 {
        x -= (stretch(x) - y) / (SLOPE - 3.0 * (SLOPE - 1.0) * x * x);
    }
    x
}

/// Row or column 0..side of a stretched coordinate.
#[inline]
pub(super) fn cell(x: f64, side: u32) -> u32 {
    (((x + 1.0) * (0.5 * f64::from(side))) as u32).min(side - 1)
}

/// Bits per axis of [`curve_key`].
const KEY_BITS: u32 = 16;

/// Position of a direction along a Hilbert curve over the six faces, 35 bits.
pub(super) fn curve_key(p: DVec3) -> u64 {
    let (face, u, v) = project(p);
    let side = 1 << KEY_BITS;
    (u64::from(face) << (2 * KEY_BITS)) | hilbert(cell(u, side), cell(v, side))
}

/// Index of the cell (x, y) along the Hilbert curve of a square of 2^16 cells a side:
/// quadrant by quadrant, each one turned into the frame of the curve inside it.
fn hilbert(mut x: u32, mut y: u32) -> u64 {
    let mut index = 0;
    for bit in (0..KEY_BITS).rev() {
        let (right, top) = ((x >> bit) & 1, (y >> bit) & 1);
        index = (index << 2) | u64::from((3 * right) ^ top);
        if top == 0 {
            if right == 1 {
                let mask = (1 << KEY_BITS) - 1;
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
    use crate::random::{Purpose, Stream};

    #[test]
    fn projection_and_its_inverse_agree() {
        let stream = Stream::new(3, Purpose::Relief, 0);
        for i in 0..2000 {
            let p = stream.direction(i);
            let (face, u, v) = project(p);
            assert!(face < 6 && u.abs() <= 1.0 && v.abs() <= 1.0);
            let q = unproject(face, unstretch(u), unstretch(v)).normalize();
            assert!((p - q).length() < 1e-14, "{p} {q}");
        }
    }

    #[test]
    fn squares_cover_nearly_equal_areas() {
        let side = 8;
        let mut count = vec![0u32; 6 * 64];
        let stream = Stream::new(4, Purpose::Relief, 0);
        for i in 0..400_000 {
            let (face, u, v) = project(stream.direction(i));
            count[(face * 64 + cell(v, side) * side + cell(u, side)) as usize] += 1;
        }
        let mean = 400_000.0 / 384.0;
        let (low, high) = (count.iter().min().unwrap(), count.iter().max().unwrap());
        assert!(
            f64::from(*low) > 0.78 * mean && f64::from(*high) < 1.32 * mean,
            "{low} {high}"
        );
    }

    #[test]
    fn the_curve_steps_from_a_cell_to_one_beside_it() {
        // Cells of the coarse 16 x 16 square: the curve's first 8 bits order them.
        let mut cells: Vec<(u64, i32, i32)> = Vec::new();
        for (x, y) in (0..16).flat_map(|x| (0..16).map(move |y| (x, y))) {
            cells.push((hilbert(x << 12, y << 12) >> 24, x as i32, y as i32));
        }
        cells.sort_unstable();
        assert!(cells.iter().enumerate().all(|(i, c)| c.0 == i as u64));
        assert!(
            cells
                .windows(2)
                .all(|w| (w[0].1 - w[1].1).abs() + (w[0].2 - w[1].2).abs() == 1)
        );
    }
}
