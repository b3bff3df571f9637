//! The place of a new river vertex where the river keeps its course: on the curve between its ends.
//!
//! Rivers wind in bends of several widths; shorter edges follow them and do not bend them anew.

use super::place::{Placed, at_shares, middle, unless_flat, within_bounds};
use crate::amplify::curve::Curve;
use crate::amplify::fixed::{Q16, difference, weigh};
use crate::amplify::geometry::{Stance, share_along};
use crate::amplify::vertex::Vertex;

/// Places the vertex that halves a river edge half-way along its course, within the same bounds as
/// any other displaced vertex.
pub(super) fn on_course(
    curve: &Curve,
    seed: u32,
    ends: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> Placed {
    let [Some(x), Some(y)] = opposite else {
        return middle(seed, ends);
    };
    let [a, b] = ends;
    let [ab, ax, ay] = [b, x, y].map(|v| difference(v.direction, a.direction));
    let (along, across) = off_middle(curve, ab);
    let stances = [ax, ay].map(|corner| Stance::of(ab, corner));
    // Towards the corner on whose side the course bends.
    let wx = share_along(upright(ab, ax, stances[0]), across);
    let (wx, corner, stances) = if wx >= 0 {
        (wx, x, stances)
    } else {
        let wy = share_along(upright(ab, ay, stances[1]), across).max(0);
        (wy, y, [stances[1], stances[0]])
    };
    let weight = unless_flat(stances);
    // A sixth at most: the bounds allow no more.
    let wx = weigh(weight, wx.min(Q16 / 6));
    let towards_b = weigh(weight, along) - weigh(stances[0].along << 4, wx);
    at_shares(ends, corner, within_bounds(towards_b, wx, stances))
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
