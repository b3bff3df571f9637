//! The place of a new vertex: the middle of its edge, moved sideways (paper 002 §5.2, "Horizontal
//! displacement").
//!
//! Halving is affine: a thin face would hand its shape on to all faces that are made within it, and
//! crests and drains, which follow edges, would lie in streaks. So ours moves a new vertex on the
//! ground from the middle of its edge towards the corners beside it, as Loop's subdivision does
//! with its vertices, (3a + 3b + x + y) / 8 (Loop 1987, "Smooth subdivision surfaces based on
//! triangles"): the shape of a face becomes the mean of those around it. The draw comes on top.

use crate::amplify::arith::{linear_step, ratio};
use crate::amplify::fixed::{Q16, difference, lift, mul_high, q16, square_q32, weigh};
use crate::amplify::geometry::{Q12, Stance};
use crate::amplify::rules::shift::{Shift, shift};
use crate::amplify::rules::{EdgeKind, Rules, STRAIGHT_LEVEL, ocean};
use crate::amplify::vertex::Vertex;

/// Greatest barycentric share of a far corner that a displaced vertex may have: positive in the
/// face that it moves into, negative in the face that it leaves; Q16.
const MOST_FAR_CORNER: i32 = q16(0.17);

/// Most by which the barycentric share of an end may fall below ½, Q16: a sixth less the most that
/// rounding takes, so that a third is left.
const MOST_END_LOSS: i32 = q16(0.15666);

/// Height of a triangle over its edge, as a share of the edge's length, Q12: up to the first number
/// nothing is displaced, from the second on all.
const FLATNESS: [i32; 2] = [Q12 / 6, Q12 / 2];

/// Height over its edge of the lower triangle beside it, Q12: up to the first number a vertex is not
/// moved towards Loop's place, from the second on all the way.
const CENTRED: [i32; 2] = [Q12 / 6, Q12 / 3];

crate::wgsl::shared!(MOST_FAR_CORNER, MOST_END_LOSS, FLATNESS, CENTRED,);

/// Where a vertex lies on a face beside its edge: shares of two of the face's corners, Q16. That of
/// the edge's first end is the rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shares {
    /// Of the edge's second end.
    pub(super) end: i32,
    /// Of the corner opposite to the edge.
    pub(super) corner: i32,
    /// Whether the face is the edge's second one.
    pub(super) is_second: bool,
}

/// A place, and the height of the flat face there.
pub(super) struct Placed {
    /// Unit direction times `ONE`.
    pub(super) direction: [i32; 3],
    /// Height of the flat face, grains.
    pub(super) face: i32,
    /// [`Vertex::swell`] there, grains.
    pub(super) swell: i32,
}

/// Where the vertex that halves an edge lies, moved sideways within its safe zone; `None` in the
/// middle.
pub(super) fn shares(
    rules: &Rules,
    kind: EdgeKind,
    level: u32,
    new: &Vertex,
    ends: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> Option<Shares> {
    let [Some(x), Some(y)] = opposite else {
        return None;
    };
    if level >= STRAIGHT_LEVEL {
        return None;
    }
    let shift = shift(rules, kind, ends.map(|v| v.kind), level, new);
    // Rivers keep the course that their rule draws.
    let is_centred = rules.landforms && kind != EdgeKind::River;
    let is_moved = shift.weight > 0 || is_centred;
    is_moved.then(|| displaced(&shift, is_centred, ends, [x, y]))
}

/// Places the vertex that halves an edge: on a face beside it, or in its middle.
pub(super) fn place(
    seed: u32,
    shares: Option<Shares>,
    ends: [&Vertex; 2],
    opposite: [Option<&Vertex>; 2],
) -> Placed {
    let on_face = shares.and_then(|shares| {
        let corner = opposite[usize::from(shares.is_second)]?;
        Some(at_shares(ends, corner, shares))
    });
    on_face.unwrap_or_else(|| middle(seed, ends))
}

/// The middle of an edge. Halves round to either side by the seed, so that no direction is
/// favoured.
fn middle(seed: u32, [a, b]: [&Vertex; 2]) -> Placed {
    let ab = difference(b.direction, a.direction);
    let odd = (seed >> 7 & 1) as i32;
    let [s, t] = ocean::swells([a, b]);
    let middle = [0, 1, 2].map(|i| a.direction[i] + ((ab[i] + odd) >> 1));
    Placed {
        // Both shares are ½, so the deficit is a quarter of the edge's square.
        direction: lift(middle, square_q32(ab) / 4),
        face: a.height + (b.height - a.height) / 2,
        swell: s + (t - s) / 2,
    }
}

/// A place moved sideways; `corners` are those opposite to the edge.
fn displaced(
    shift: &Shift,
    is_centred: bool,
    [a, b]: [&Vertex; 2],
    corners: [&Vertex; 2],
) -> Shares {
    let ab = difference(b.direction, a.direction);
    let stances = corners.map(|v| Stance::of(ab, difference(v.direction, a.direction)));
    // Towards the first of these, away from the second.
    let stances = turned(stances, shift.second);
    let mut pull = drawn(shift, stances);
    if is_centred {
        pull = centred(pull, stances);
    }
    let [end, corner] = weights(pull, turned(stances, pull.is_turned));
    Shares {
        end,
        corner,
        is_second: shift.second != pull.is_turned,
    }
}

/// The stances of both corners, in the other order where they are turned.
pub(super) fn turned([x, y]: [Stance; 2], is_turned: bool) -> [Stance; 2] {
    if is_turned { [y, x] } else { [x, y] }
}

/// The place whose shares of the edge's end and of a corner are given.
fn at_shares([a, b]: [&Vertex; 2], x: &Vertex, shares: Shares) -> Placed {
    let (wb, wx) = (shares.end, shares.corner);
    let [ab, ax] = [b, x].map(|v| difference(v.direction, a.direction));
    let on_face = |[a, b, x]: [i32; 3]| a + weigh(wb, b - a) + weigh(wx, x - a);
    Placed {
        direction: blend(a.direction, ab, ax, wb, wx),
        face: on_face([a, b, x].map(|v| v.height)),
        swell: on_face(ocean::swells([a, b, x])),
    }
}

/// How far a new vertex is drawn from the middle of its edge; shares in Q16.
#[derive(Clone, Copy, Debug)]
struct Pull {
    /// Whether the corner is the second of the two beside the edge.
    is_turned: bool,
    /// Towards the edge's second end.
    towards_b: i32,
    /// Towards the corner, at least 0.
    to_corner: i32,
}

/// The drawn displacement, towards the corner `x`.
fn drawn(shift: &Shift, [x, y]: [Stance; 2]) -> Pull {
    let weight = weigh(shift.weight, unless_flat([x, y]));
    let third = shift.inward / 3;
    // The barycentre lies a third of the way to the corner.
    let to_corner = weigh(weight, third);
    let along = weigh(Q16 - shift.inward, shift.along) + third;
    Pull {
        is_turned: false,
        // A corner that leans over an end of the edge draws upwards only, not along.
        towards_b: weigh(weight, along - Q16 / 2) - q12(to_corner, x.overhang()),
        to_corner,
    }
}

/// A displacement with that to Loop's place added: an eighth of the sum of the corners' offsets
/// from the middle.
fn centred(drawn: Pull, [x, y]: [Stance; 2]) -> Pull {
    let low = x.height.min(y.height);
    let eighth = linear_step(CENTRED[0], CENTRED[1], low) / 8;
    // Lengths of the edge, Q16: along it, and over it towards x.
    let along =
        drawn.towards_b + q12(drawn.to_corner, x.along) + q12(eighth, x.along + y.along - Q12);
    let up = q12(drawn.to_corner, x.height) + q12(eighth, x.height - y.height);
    let is_turned = up < 0;
    let corner = if is_turned { y } else { x };
    let to_corner = (up.abs() << 12) / corner.height;
    Pull {
        is_turned,
        towards_b: along - q12(to_corner, corner.along),
        to_corner,
    }
}

/// Shares of the edge's end and of the corner `x` that the new vertex is drawn to; that of the
/// start is the rest. `y` is the corner on the other side.
///
/// Written in the barycentric coordinates of either face beside the edge, the vertex keeps at least
/// a third of both ends and at most [`MOST_FAR_CORNER`] of the far corner. Whatever their edges'
/// vertices do within such bounds, all four children of a face keep at least 0.045 of its area
/// (least determinant over the corners of the bounds): none turns over.
fn weights(pull: Pull, [x, y]: [Stance; 2]) -> [i32; 2] {
    let [towards_b, wx] = [pull.towards_b, pull.to_corner];
    within_bounds(towards_b, wx, [x, y])
}

/// Share of a displacement that the triangles beside an edge bear, Q16: flat ones would get
/// flatter.
pub(super) fn unless_flat([x, y]: [Stance; 2]) -> i32 {
    linear_step(FLATNESS[0], FLATNESS[1], x.height.min(y.height))
}

/// The shares of a displacement by `towards_b` along the edge and by `wx` towards the corner `x`,
/// scaled until all bounds hold.
pub(super) fn within_bounds(towards_b: i32, wx: i32, [x, y]: [Stance; 2]) -> [i32; 2] {
    // In the face beyond, the vertex has -ρ·wx of its corner, ρ the ratio of the heights.
    let owed = wx * (x.height >> 3) / (y.height >> 3).max(1);
    let in_beyond = towards_b + q12(wx, x.along) + q12(owed, y.along);
    let loss = end_loss(towards_b, wx).max(end_loss(in_beyond, -owed));
    // The whole displacement is scaled until all bounds hold in both faces.
    let kept = ratio(MOST_END_LOSS, loss)
        .min(ratio(MOST_FAR_CORNER, wx))
        .min(ratio(MOST_FAR_CORNER, owed));
    [Q16 / 2 + weigh(kept, towards_b), weigh(kept, wx)]
}

/// How much of its halves the nearer end of an edge loses to a vertex that is drawn `towards_b`,
/// and by `far` to the far corner.
#[inline]
fn end_loss(towards_b: i32, far: i32) -> i32 {
    (-towards_b).max(towards_b + far)
}

/// A share times a number in Q12 of at most 7.
#[inline]
const fn q12(share: i32, number: i32) -> i32 {
    (share * (number >> 4)) >> 8
}

/// The point a + w_b·ab + w_x·ax, lifted to the sphere by its exact deficit Σ wᵢwⱼ|pᵢ - pⱼ|².
fn blend(a: [i32; 3], ab: [i32; 3], ax: [i32; 3], wb: i32, wx: i32) -> [i32; 3] {
    // Barycentric coordinates; those of the ends and the corner sum to 1.
    let wa = Q16 - wb - wx;
    let point = [0, 1, 2].map(|i| a[i] + weigh(wb, ab[i]) + weigh(wx, ax[i]));
    // Shares below 1 in Q16, their products in Q32.
    let part = |u: i32, v: i32, d| mul_high((u as u32) * (v as u32), square_q32(d));
    let deficit = part(wa, wb, ab) + part(wa, wx, ax) + part(wb, wx, difference(ax, ab));
    lift(point, deficit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::amplify::rules::shift::LEAST;
    use crate::amplify::seed::pcg;
    use core::ops::Range;

    type Barycentric = [f64; 3];

    /// Corners of the polygon of barycentric coordinates (start, end, far corner) that a vertex on
    /// an edge may have.
    fn bounds() -> [Barycentric; 4] {
        let (third, depth) = (1.0 / 3.0, f64::from(MOST_FAR_CORNER) / 65_536.0 + 0.005);
        let rest = |far: f64| 1.0 - far - third;
        [
            [third, rest(depth), depth],
            [rest(depth), third, depth],
            [third, rest(-depth), -depth],
            [rest(-depth), third, -depth],
        ]
    }

    fn determinant(p: Barycentric, q: Barycentric, r: Barycentric) -> f64 {
        p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
            + p[2] * (q[0] * r[1] - q[1] * r[0])
    }

    #[test]
    fn no_child_turns_over_within_the_bounds() {
        // The areas are linear in each vertex, so their least values lie at corners of the bounds.
        let mut least = f64::MAX;
        for p in bounds() {
            for q in bounds().map(|[b, c, a]| [a, b, c]) {
                for r in bounds().map(|[c, a, b]| [a, b, c]) {
                    let corners = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                    least = least
                        .min(determinant(corners[0], p, r))
                        .min(determinant(corners[1], q, p))
                        .min(determinant(corners[2], r, q))
                        .min(determinant(p, q, r));
                }
            }
        }
        assert!(least > 0.045, "{least}");
    }

    /// That of a corner along an edge and above it.
    fn stance(shares: [f64; 2]) -> Stance {
        let [along, height] = shares.map(|x| (x * 4096.0) as i32);
        Stance { along, height }
    }

    #[test]
    fn without_a_draw_a_vertex_lies_at_the_place_that_loop_gives_it() {
        // In lengths of the edge: a corner stands 1.2 high over 0.3, the other 0.7 over 0.6.
        let [x, y] = [[0.3, 1.2], [0.6, 0.7]].map(stance);
        let still = Pull {
            is_turned: false,
            towards_b: 0,
            to_corner: 0,
        };
        for (corners, is_turned) in [([x, y], false), ([y, x], true)] {
            let pull = centred(still, corners);
            assert_eq!(pull.is_turned, is_turned);
            let [wb, wx] = weights(pull, [x, y]).map(|w| f64::from(w) / 65_536.0);
            // (3a + 3b + x + y) / 8 with a = (0, 0), b = (1, 0), y below the edge.
            let wanted = [(3.0 + 0.3 + 0.6) / 8.0, (1.2 - 0.7) / 8.0];
            for (got, wanted) in [wb + 0.3 * wx, 1.2 * wx].into_iter().zip(wanted) {
                assert!((got - wanted).abs() < 1e-3, "{got} {wanted}");
            }
        }
    }

    fn random(k: u32, i: u32, range: Range<i32>) -> i32 {
        range.start + (pcg(pcg(k) ^ i) % range.len() as u32) as i32
    }

    fn random_shift(k: u32) -> Shift {
        Shift {
            along: random(k, 4, LEAST..2 * LEAST),
            inward: random(k, 5, LEAST..2 * LEAST),
            second: false,
            weight: random(k, 6, 0..Q16 + 1),
        }
    }

    #[test]
    fn displaced_vertices_keep_the_bounds_in_both_faces() {
        for k in 0..200_000_u32 {
            let [x, y] = [0, 2].map(|i| Stance {
                along: random(k, i, -8192..12_288),
                height: random(k, i + 1, 300..12_288),
            });
            let mut pull = drawn(&random_shift(k), [x, y]);
            if k % 4 > 0 {
                pull = centred(pull, [x, y]);
            }
            let [x, y] = if pull.is_turned { [y, x] } else { [x, y] };
            let [wb, wx] = weights(pull, [x, y]).map(|w| f64::from(w) / 65_536.0);
            let real = |v: i32| f64::from(v) / 4096.0;
            // In the face beyond: x = s·a + t·b - ρ·y.
            let ratio = real(x.height) / real(y.height);
            let (far, end) = (
                -wx * ratio,
                wb + wx * (real(x.along) + ratio * real(y.along)),
            );
            for shares in [[1.0 - wb - wx, wb, wx], [1.0 - end - far, end, far]] {
                let least = 1.0 / 3.0;
                assert!(
                    shares[0] > least && shares[1] > least && shares[2].abs() < 0.175,
                    "{k} {shares:?} {x:?} {y:?}"
                );
            }
        }
    }
}
