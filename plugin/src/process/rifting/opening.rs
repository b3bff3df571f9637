//! Motions that open the lines of a rift: what fragments gain beside the parent's motion.
//!
//! Motions are angular velocities in rad/My; `speed` is the greatest relative speed of two
//! fragments along a line, in rad/My.

use crate::math::{PI, TAU, any_tangent, asin, atan2, sin, sin_cos};
use crate::parallel;
use bevy::math::DVec3;

/// Distance in radians from a line, its warp aside, within which the two fragments touch.
const BESIDE_LINE: f64 = 0.06;

/// Distance in radians of the pole from the end of what opens: at the pole itself nothing would
/// move.
const POLE_MARGIN: f64 = 0.15;

/// Least sine of the distance from the pole that the speed is divided by: the fragments of a very
/// short line would spin.
const LEAST_SINE: f64 = 0.1;

/// An empty range: the identity of the minimum and maximum below.
const NOWHERE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// The directions at which fragments touch along a circle that is warped by `amplitude` radians.
pub(super) fn beside_circle(
    plate: &[DVec3],
    center: DVec3,
    radius: f64,
    amplitude: f64,
) -> Vec<DVec3> {
    let width = BESIDE_LINE + amplitude;
    let off = |p: &DVec3| (asin(p.dot(center)) + radius - 0.5 * PI).abs();
    plate.iter().copied().filter(|p| off(p) < width).collect()
}

/// Two fragments turn about a pole on the extension of their line beyond the part of the plate that
/// lies beside it, given by the directions `plate`. Of a small circle the pole lies on the great
/// circle with the same centre `normal`: velocities across both are the same. Positions along the
/// line are azimuths from `origin`; `far_end` puts the pole at the end of the greater ones.
///
/// `None` if the line is so long that no pole lies outside of it.
pub(super) fn open_line(
    normal: DVec3,
    origin: DVec3,
    plate: &[DVec3],
    speed: f64,
    far_end: bool,
) -> Option<Vec<DVec3>> {
    let tangent = normal.cross(origin);
    let (low, high) = extent_along(plate, origin, tangent);
    // Half of a circle is all that one turn opens: beyond it the fragments would close in.
    if low > high || high - low + 2.0 * POLE_MARGIN >= PI {
        return None;
    }
    let at = if far_end {
        high + POLE_MARGIN
    } else {
        low - POLE_MARGIN
    };
    let (s, c) = sin_cos(at);
    let pole = origin * c + tangent * s;
    // The first fragment must move to the side of the normal all along the line.
    let middle = 0.5 * (low + high);
    let (s, c) = sin_cos(middle);
    let sign = if pole.cross(origin * c + tangent * s).dot(normal) >= 0.0 {
        1.0
    } else {
        -1.0
    };
    let farthest = if far_end { at - low } else { high - at };
    // A turn is fastest a quarter of a circle from its pole.
    let fastest = if farthest > 0.5 * PI {
        1.0
    } else {
        sin(farthest)
    };
    let half = pole * (sign * 0.5 * speed / fastest.max(LEAST_SINE));
    Some(vec![half, -half])
}

/// Least and greatest azimuth of directions; [`NOWHERE`] of none.
fn extent_along(plate: &[DVec3], origin: DVec3, tangent: DVec3) -> (f64, f64) {
    let ends = parallel::map_chunks(plate.len(), |range| {
        let along = |p: &DVec3| atan2(p.dot(tangent), p.dot(origin));
        plate[range]
            .iter()
            .map(along)
            .fold(NOWHERE, |ends, x| (ends.0.min(x), ends.1.max(x)))
    });
    ends.into_iter()
        .fold(NOWHERE, |all, part| (all.0.min(part.0), all.1.max(part.1)))
}

/// Two fragments part along one half of a whole great circle through `origin`, about the pole
/// there, and converge along the other half; `far_end` chooses which.
pub(super) fn open_half(origin: DVec3, speed: f64, far_end: bool) -> Vec<DVec3> {
    let half = origin * (0.5 * speed);
    if far_end {
        vec![half, -half]
    } else {
        vec![-half, half]
    }
}

/// Fragments move away from the junction along the middle of their sectors, which begin at the
/// azimuths.
pub(super) fn open_sectors(junction: DVec3, azimuths: &[f64], speed: f64) -> Vec<DVec3> {
    let n = azimuths.len();
    let east = any_tangent(junction);
    let north = junction.cross(east);
    // Neighbours move at an angle of 2π/n to each other, so they part at 2 sin(π/n) times their own
    // speed.
    let rate = 0.5 * speed / sin(PI / n as f64);
    (0..n)
        .map(|k| {
            let width = (azimuths[(k + 1) % n] - azimuths[k]).rem_euclid(TAU);
            let (s, c) = sin_cos(azimuths[k] + 0.5 * width);
            junction.cross(east * c + north * s) * rate
        })
        .collect()
}
