//! The place of a new river vertex: on the curve between its ends, and, while edges are longer than
//! a few bends of the river, moved aside from it, so that valleys wind at every scale.

use super::place::{Shares, turned, unless_flat, within_bounds};
use crate::amplify::arith::mul_q16;
use crate::amplify::curve::Curve;
use crate::amplify::fixed::{Q16, difference, q16, weigh};
use crate::amplify::geometry::{Stance, share_along};
use crate::amplify::seed::centred_share;
use crate::amplify::vertex::Vertex;

/// How far the middle of a valley is drawn aside, from side to side, as a share of the height of
/// the triangle there.
const SWAY: i32 = q16(0.3);

crate::wgsl::shared!(SWAY,);

/// The course of a river along an edge.
pub(super) struct Course {
    /// The axis of its valley.
    pub(super) curve: Curve,
    /// Whether finer levels keep it.
    pub(super) is_kept: bool,
}

/// Where the vertex that halves a river edge lies half-way along its course, within the same bounds as
/// any other displaced vertex; `None` in the middle.
pub(super) fn on_course(
    course: &Course,
    seed: u32,
    ends: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> Option<Shares> {
    let [Some(x), Some(y)] = opposite else {
        return None;
    };
    let [a, b] = ends;
    let [ab, ax, ay] = [b, x, y].map(|v| difference(v.direction, a.direction));
    let (along, across) = off_middle(&course.curve, ab);
    let stances = [ax, ay].map(|corner| Stance::of(ab, corner));
    // Shares of the ways up to both corners, on whichever side the course bends.
    let [up, down] = [(ax, stances[0]), (ay, stances[1])]
        .map(|(corner, stance)| share_along(upright(ab, corner, stance), across));
    let sway = if course.is_kept {
        0
    } else {
        mul_q16(centred_share(seed, 12), SWAY)
    };
    let aside = up.max(0) - down.max(0) + sway;
    let is_second = aside < 0;
    let stances = turned(stances, is_second);
    let weight = unless_flat(stances);
    // A sixth at most: the bounds allow no more.
    let wx = weigh(weight, aside.abs().min(Q16 / 6));
    let towards_b = weigh(weight, along) - weigh(stances[0].along << 4, wx);
    let [end, corner] = within_bounds(towards_b, wx, stances);
    Some(Shares {
        end,
        corner,
        is_second,
    })
}

/// Where the middle of the course lies: share of the edge from its middle, and the vector across
/// the edge.
fn off_middle(curve: &Curve, ab: [i32; 3]) -> (i32, [i32; 3]) {
    let middle = curve.at(Q16 / 2);
    let off = [0, 1, 2].map(|i| middle[i] - ab[i] / 2);
    let along = share_along(ab, off);
    (along, [0, 1, 2].map(|i| off[i] - weigh(along, ab[i])))
}

/// The vector from the line of an edge up to a corner.
fn upright(ab: [i32; 3], corner: [i32; 3], stance: Stance) -> [i32; 3] {
    let along = (stance.along << 4).clamp(1 - 2 * Q16, 2 * Q16 - 1);
    [0, 1, 2].map(|i| corner[i] - weigh(along, ab[i]))
}
