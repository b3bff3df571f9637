//! Gullies: dry drainage lines that cut the slopes between rivers (paper 002 §5.3).
//!
//! A gully follows the rules of a river without its water. It climbs steeper, and branches down to
//! hillslopes.

use super::preset::Rules;
use super::{EdgeKind, VertexGround};
use crate::amplify::arith::{mix, mul_q16, ordered, smoothstep};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// Least share of the way up that the middle of a gully's edge stands (release).
const LEAST_RISE: i32 = q16(0.4);

/// How much higher the middle's draw may raise it, as a share of the way up (release).
const DRAWN_RISE: i32 = q16(0.1);

/// Least share of the way up on level 0 in ours: gullies are hollow at the coarse levels.
const HOLLOW_RISE: i32 = q16(0.13733);

/// How much less hollow a gully is with every level.
const HOLLOW_LOSS: i32 = q16(0.026);

/// Rise of a gully whose land lies below its river: this share of the edge, times its draw
/// (release).
const RISE_FROM_RIVER: i32 = q16(0.1);

/// Most of the same, grains (release).
const MOST_RISE_FROM_RIVER: i32 = metres(500);

/// Least of the same, grains (release).
const LEAST_RISE_FROM_RIVER: i32 = metres(30);

/// The same in ours.
const OUR_LEAST_RISE_FROM_RIVER: i32 = metres(31);

/// Share of the draws for a tributary that fail beside a great river: 100 of 128 (release).
const GREAT_RIVER_REFUSAL: i32 = q16(0.78125);

/// Flow φ from which on a river is great.
const GREAT_FLOW: i32 = q16(0.5);

/// How much higher a gully's tip must stand to branch off another, grains (release).
const LEAST_HILLSLOPE: i32 = metres(50);

/// Number of coarse levels, whose edges are longer than hillsides: 6 km and more on an Earth-sized
/// planet. Their valleys are the trunks of a range.
const COARSE_LEVELS: usize = 4;

/// Share of the new land of a coarse level from which a valley leads down; from all land of finer
/// levels a gully does. Crests begin on the rest: where every edge around a vertex of a trunk valley
/// led another into it, they cut its sides down to a plain.
const DRAINED_SHARE: [i32; COARSE_LEVELS] = [Q16, q16(0.7), q16(0.7), q16(0.7)];

/// Least rise of a valley over half of an edge, as a share of the slope of the land there. The draw
/// adds as much again. The shorter a valley is the steeper it is, as small streams are.
const VALLEY_RISE: [i32; COARSE_LEVELS] = [q16(0.04), q16(0.055), q16(0.08), q16(0.12)];

/// Coarsest levels over which gullies become less hollow.
const HOLLOW_LEVELS: u32 = 9;

crate::wgsl::shared!(
    GULLY_LEAST_RISE = LEAST_RISE,
    DRAWN_RISE,
    HOLLOW_RISE,
    HOLLOW_LOSS,
    RISE_FROM_RIVER,
    MOST_RISE_FROM_RIVER,
    LEAST_RISE_FROM_RIVER,
    OUR_LEAST_RISE_FROM_RIVER,
    GREAT_RIVER_REFUSAL,
    GREAT_FLOW,
    LEAST_HILLSLOPE,
    COARSE_LEVELS = COARSE_LEVELS as u32,
    DRAINED_SHARE,
    VALLEY_RISE,
    HOLLOW_LEVELS,
);

/// The vertex that halves a gully edge: 0.4..0.5 of the way up, in ours less at the coarse levels,
/// so that the profile is hollow.
pub fn along(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let xi = share(context.new.seed, 0);
    let (low, high) = ordered(context.a.height, context.b.height);
    let rise = if rules.landforms {
        (HOLLOW_RISE + HOLLOW_LOSS * context.level.min(HOLLOW_LEVELS) as i32).min(LEAST_RISE)
    } else {
        LEAST_RISE
    };
    let height = mix(low, high, rise + mul_q16(xi, DRAWN_RISE));
    // A gully that ends in a river must lie above it.
    let river = [context.b, context.a].into_iter().find(|end| end.is_wet());
    let height = match river {
        // Its land lies below the river: no share of the way reaches above it.
        Some(river) if height <= river.height => above_river(rules, context, river.height),
        _ => height,
    };
    VertexGround::dry(VertexKind::Gully, height)
}

/// Height of a gully over a river that its land does not overtop, grains.
fn above_river(rules: &Rules, context: &EdgeContext, river: i32) -> i32 {
    let least = if rules.landforms {
        OUR_LEAST_RISE_FROM_RIVER
    } else {
        LEAST_RISE_FROM_RIVER
    };
    let most = mul_q16(context.length, RISE_FROM_RIVER).min(MOST_RISE_FROM_RIVER);
    river + least + mul_q16(most, share(context.new.seed, 0))
}

/// Whether an internal edge of a level becomes a tributary of the river at its junction; the angle
/// is tested before. `flow` (Q16) and `height` (grains) are the junction's, `spring` is the height
/// of the other end, `seed` the edge's.
pub fn is_tributary(
    rules: &Rules,
    level: u32,
    flow: i32,
    height: i32,
    spring: i32,
    seed: u32,
) -> bool {
    let [first, end] = rules.tributary_levels;
    if !(first..end).contains(&level) || spring <= height {
        return false;
    }
    // Great rivers branch less.
    let refused = mul_q16(GREAT_RIVER_REFUSAL, smoothstep(0, GREAT_FLOW, flow));
    share(seed, 8) > refused
}

/// Whether an internal edge becomes a gully: off a river or a coast where the far end is higher,
/// off a gully where chance will have it and the far end is higher by a hillslope.
pub fn is_gully(
    rules: &Rules,
    level: u32,
    off_gully: bool,
    height: i32,
    tip: i32,
    seed: u32,
) -> bool {
    if level >= rules.gully_levels || tip <= height {
        return false;
    }
    let high_enough = rules.landforms || tip > height + LEAST_HILLSLOPE;
    !off_gully || (share(seed, 9) < rules.gully_branching && high_enough)
}

/// Whether a valley is to lead down from the vertex that halves an edge between two ends; `seed` is
/// the vertex's. On the coarse levels it must lead to another one: valleys join into longer ones, all
/// the way to a river.
pub fn is_drained(edge: EdgeKind, level: u32, seed: u32, [a, b]: [&Vertex; 2]) -> bool {
    let share_of_level = match DRAINED_SHARE.get(level as usize) {
        Some(&share) if edge == EdgeKind::Terrain => share,
        _ => return true,
    };
    let lower = if is_below(a, b) { a } else { b };
    lower.is_drained && share(seed, 21) < share_of_level
}

/// Most that the floor of a valley rises over its lower end up to the middle of an edge, grains;
/// `None` on levels whose gullies climb their hillsides. `slope` is the rise of the land there over
/// half of the edge, `xi` the draw.
pub(super) fn most_rise(level: u32, slope: i32, xi: i32) -> Option<i32> {
    let &least = VALLEY_RISE.get(level as usize)?;
    Some(mul_q16(slope, least + mul_q16(xi, least)))
}

/// Whether new dry land drains by a gully along the half of its edge that leads to `end`: to the
/// lower end of an edge of the ground.
pub fn drains(rules: &Rules, level: u32, new: &Vertex, end: &Vertex, other: &Vertex) -> bool {
    rules.landforms && level < rules.gully_levels && new.is_drained && leads_down(new, end, other)
}

/// Whether the half of an edge that leads to `end` is the way down of the dry land in its middle.
pub fn leads_down(new: &Vertex, end: &Vertex, other: &Vertex) -> bool {
    new.kind == VertexKind::Terrain && new.height > end.height && is_below(end, other)
}

/// Whether an end of an edge is the lower one. Seeds decide between level ends, so that one half
/// drains and not both.
fn is_below(end: &Vertex, other: &Vertex) -> bool {
    (end.height, end.seed) < (other.height, other.seed)
}
