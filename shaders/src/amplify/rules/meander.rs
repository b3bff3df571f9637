//! Meanders: on the level whose edges are as long as a meander, a slow river leaves its edge for
//! the sides of the faces beside it.
//!
//! A displaced vertex must stay within a sixth of its triangle, or faces turn over; that makes a
//! river a fifth longer than its valley at most. A meander is half as long again. So it takes
//! another way along the mesh: from the upper end of its edge over the middle of the left face's
//! side, back to its own middle, over the middle of the right face's side and to the lower end.
//! Seen from either end the way lies on the left, so no two rivers ask for the same side.
//!
//! ```text
//!           o                 leaves to the left, comes from the right:
//!         /   \               a river twice as long where triangles are equilateral,
//!        m     .              one meander per edge
//!      /   \  /  \
//!     a --- m --- b  flow →
//!      \   /  \   /
//!        .     m
//!         \  /
//!          o
//! ```
//!
//! Meanders are 9 to 18 widths long, 12.7 in the mean of logarithms (10 to 14: L. Leopold and
//! M. Wolman, River meanders, 1960), and widths 4.8 m for the root of 1 m³/s (L. Leopold and
//! T. Maddock, 1953). On finer levels the way is bent round: an apex knows where its river flows,
//! and a new vertex lies on the cubic between two such headings.

use super::preset::Rules;
use super::river::descend;
use crate::amplify::arith::{linear_step, mul_q16, ratio};
use crate::amplify::control::VertexKind;
use crate::amplify::curve::heading_of;
use crate::amplify::fixed::{Q16, difference, metres, q16};
use crate::amplify::geometry::dot;
use crate::amplify::scale::PlanetScale;
use crate::amplify::seed::share;
use crate::amplify::vertex::{Bend, Vertex};

/// Width of a river of flow φ = 1, grains: 4.8 m · √200,000.
const FULL_WIDTH: i32 = metres(2_147);

/// Least length of a meander in widths of its river; the greatest is twice as much.
const LEAST_LENGTH: i32 = 9;

/// One beyond the last level on which rivers leave their edges: two are left to round them.
const BEND_LEVELS: u32 = 9;

/// Fall of a river in its length: up to the first it meanders wherever it can, from the second on
/// nowhere.
const FALL: [i32; 2] = [q16(0.001), q16(0.01)];

/// Share of bends that even the slowest river leaves out: none winds without a break.
const STRAIGHT_SHARE: i32 = q16(0.05);

/// Most length of a bend, in lengths of the half edge that it leaves.
const MOST_DETOUR: i32 = q16(2.9);

/// Whether a river of a flow meanders on a level, whose edges are `span` grains long.
#[inline]
pub fn is_due(rules: &Rules, level: u32, span: i32, flow: i32) -> bool {
    let least = LEAST_LENGTH * mul_q16(FULL_WIDTH, flow);
    rules.landforms && level < BEND_LEVELS && least <= span && span / 2 < least
}

/// Whether the river along an edge of a level may leave it, whatever lies beside it.
pub fn may_bend(scale: &PlanetScale, rules: &Rules, level: u32, ends: [&Vertex; 2]) -> bool {
    let span = scale.edge_grains(level);
    ends.iter().all(|end| end.kind == VertexKind::River)
        && ends
            .iter()
            .all(|end| is_due(rules, level, span, end.flow()))
}

/// Whether a river that may bend leaves its edge for the sides of a face with the corner `far`, in
/// the half at its upper end (0) or its lower end (1). `seed` is that of its middle.
pub fn bends(
    scale: &PlanetScale,
    ends: [&Vertex; 2],
    far: &Vertex,
    half: usize,
    seed: u32,
) -> bool {
    let [up, down] = ends;
    let [here, there] = [ends[half], ends[1 - half]].map(|end| end.direction);
    let [along, out, home] = [(there, here), (far.direction, here), (there, far.direction)]
        .map(|(to, from)| difference(to, from));
    let [whole, first, second] = [along, out, home].map(|way| scale.grains(way) >> 2);
    // Only at an acute angle, and not round half the country.
    let is_shapely = dot(along, out) > 0 && first + second < mul_q16(MOST_DETOUR, whole);
    let fall = ratio(up.water - down.water, 4 * whole);
    let slow = Q16 - linear_step(FALL[0], FALL[1], fall);
    let chance = mul_q16(slow, Q16 - STRAIGHT_SHARE);
    is_shapely && share(seed, 30 + half as u32) < chance
}

/// The vertex over which a river leaves its edge, in place of one on dry ground: on the way from
/// `from` to `to`, with the discharge that arrives there.
pub fn apex(ground: &Vertex, [from, to]: [&Vertex; 2], discharge: u32) -> Vertex {
    let bed = descend(from.bed, to.bed, Q16 / 2);
    Vertex {
        kind: VertexKind::River,
        height: bed,
        bed,
        water: descend(from.water, to.water, Q16 / 2).max(bed),
        discharge,
        tide: (from.tide + to.tide) / 2,
        heading: heading_of(difference(to.direction, from.direction)),
        ..*ground
    }
}

/// Whether a half of an edge with this middle is a river's though the edge is none's, and whether
/// it runs against the edge. `slot` is the half, `wet` whether its own end lies on a river.
pub const fn half_of_bend(middle: Bend, slot: usize, wet: bool) -> Option<bool> {
    // Out of the river's end, or back to it: the first half begins at its end, the second ends there.
    match (middle.is_apex() && wet, middle.has(Bend::OUT)) {
        (false, _) => None,
        (true, out) => Some(out == (slot == 1)),
    }
}

/// Whether a river's edge lies on a meander, off the river's own vertices.
pub fn is_bent(ends: [&Vertex; 2]) -> bool {
    ends.iter().any(|end| end.bend.is_bent())
}

/// Headings of a river at the ends of its edge; zero stands for the way from end to end. A river's
/// own vertices, between two bends, have the way to the bend.
pub fn headings([a, b]: [&Vertex; 2]) -> [[i16; 3]; 2] {
    let beside = |end: &Vertex, other: &Vertex| {
        if other.bend.is_bent() && !end.bend.is_bent() {
            [0; 3]
        } else {
            end.heading
        }
    };
    [beside(a, b), beside(b, a)]
}

#[cfg(test)]
#[path = "meander_tests.rs"]
mod tests;
