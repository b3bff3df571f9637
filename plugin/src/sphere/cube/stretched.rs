//! Coordinates on the faces of the cube that are stretched by a cubic polynomial.
//!
//! Equal squares of stretched coordinates cover nearly equal solid angles (85 % to 130 % of their
//! mean). Only multiplications and one division: fast, and the same bits anywhere.

use super::{FacePoint, project};
use bevy::math::DVec3;

/// Slope of the stretch at the centre of a face; its slope at the border is 3 - 2 x this. Of all
/// values this one makes the largest cell least large beside the smallest: 1.5 times.
const CENTRE_SLOPE: f64 = 1.22;

/// Steps of Newton's method, each of which doubles the digits: more than 53 bits need.
const NEWTON_STEPS: usize = 8;

/// Face and stretched coordinates of a direction.
#[inline]
pub(in crate::sphere) fn stretched_project(p: DVec3) -> FacePoint {
    let FacePoint { face, u, v } = project(p);
    FacePoint {
        face,
        u: stretch(u),
        v: stretch(v),
    }
}

#[inline]
fn stretch(x: f64) -> f64 {
    x * (CENTRE_SLOPE - (CENTRE_SLOPE - 1.0) * x * x)
}

/// The inverse of the stretch, by Newton's method.
pub(in crate::sphere) fn unstretch(y: f64) -> f64 {
    let mut x = y;
    for _ in 0..NEWTON_STEPS {
        x -= (stretch(x) - y) / (CENTRE_SLOPE - 3.0 * (CENTRE_SLOPE - 1.0) * x * x);
    }
    x
}

/// Row or column 0..side of a stretched coordinate.
#[inline]
pub(in crate::sphere) fn stretched_cell(x: f64, side: u32) -> u32 {
    (((x + 1.0) * (0.5 * f64::from(side))) as u32).min(side - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Stream};
    use crate::sphere::cube::unproject;

    #[test]
    fn projection_and_its_inverse_agree() {
        let stream = Stream::new(3, Purpose::Relief, 0);
        for i in 0..2000 {
            let p = stream.direction(i);
            let FacePoint { face, u, v } = stretched_project(p);
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
            let at = stretched_project(stream.direction(i));
            let row = at.face * side + stretched_cell(at.v, side);
            count[(row * side + stretched_cell(at.u, side)) as usize] += 1;
        }
        let mean = 400_000.0 / 384.0;
        let low = f64::from(*count.iter().min().unwrap());
        let high = f64::from(*count.iter().max().unwrap());
        assert!(low > 0.78 * mean && high < 1.32 * mean, "{low} {high}");
    }
}
