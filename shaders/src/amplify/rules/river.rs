//! (r, R, r) and (r, R, t): along a river, and at its spring (paper 002 rules R1, R4).

use super::VertexGround;
use super::preset::Rules;
use crate::amplify::arith::{mix, mul_q16};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{GRAINS, Q16, metres, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// A spring rises from its mouth by the spring slope over this share of the edge.
const SPRING_REACH: i32 = q16(0.6);

/// Most that a spring rises over its mouth, grains.
const MOST_SPRING_RISE: i32 = metres(1_500);

/// Least share of the way up to the land that a spring may be drawn to.
const LEAST_SPRING: i32 = q16(0.4);

/// How much farther up the draw may put it.
const DRAWN_SPRING: i32 = q16(0.2);

/// Most depth of water at a spring of ours, grains; the release's springs have none.
const SPRING_DEPTH: i32 = GRAINS / 4;

crate::wgsl::shared!(
    SPRING_REACH,
    MOST_SPRING_RISE,
    LEAST_SPRING,
    DRAWN_SPRING,
    SPRING_DEPTH,
    NO_MOUTH = 2_u32,
);

/// The vertex that halves a river edge: a bed between those of its ends, or the spring of a
/// tributary.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    match mouth([context.a.kind, context.b.kind]) {
        Some(0) => spring(rules, context, context.a, context.b),
        Some(_) => spring(rules, context, context.b, context.a),
        None => along(rules, context),
    }
}

/// The end of a river edge, 0 or 1, at which the tributary joins whose spring halves the edge;
/// `None` where the river runs from end to end.
pub(super) fn mouth([a, b]: [VertexKind; 2]) -> Option<usize> {
    let is_wet = |kind| matches!(kind, VertexKind::River | VertexKind::Lake);
    match (is_wet(a), is_wet(b)) {
        (true, false) if b == VertexKind::Terrain => Some(0),
        (false, true) => Some(1),
        _ => None,
    }
}

/// R1: the bed falls from one end to the other, at the coarse levels more on the first half than on
/// the second, so that the long profile is hollow. Water likewise.
fn along(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (up, down) = (context.a, context.b);
    let [first, end] = rules.hollow_levels;
    let share_of_fall = if (first..end).contains(&context.level) {
        rules.hollow_fall
    } else {
        Q16 / 2
    };
    let bed = descend(up.bed, down.bed, share_of_fall);
    let water = descend(up.water, down.water, share_of_fall);
    if rules.landforms && down.water == 0 {
        // The sea stands in a drowned valley as far inland as the bed lies below it.
        let level = bed + (up.water - up.bed).max(0);
        return river(bed, water.min(level.max(0)));
    }
    river(bed, water)
}

/// A height that falls from `up` to `down`, strictly between the two where they are two grains
/// apart or more.
pub(super) fn descend(up: i32, down: i32, share_of_fall: i32) -> i32 {
    let fall = up - down;
    if fall < 2 {
        return down + fall.max(0);
    }
    up - mul_q16(fall, share_of_fall).clamp(1, fall - 1)
}

/// R4: the spring of a tributary, on the way from its mouth to the land above. The half beyond it
/// stays land.
fn spring(rules: &Rules, context: &EdgeContext, mouth: &Vertex, land: &Vertex) -> VertexGround {
    let reach = mul_q16(context.length, rules.spring_slope);
    // Not steeper than a brook may be, nor farther up than the land.
    let gentle = mouth.bed + mul_q16(reach, SPRING_REACH).min(MOST_SPRING_RISE);
    let xi = share(context.new.seed, 0);
    let drawn = mix(
        mouth.bed,
        // Land may lie below the mouth; the spring never does.
        land.height.max(mouth.bed + 2),
        LEAST_SPRING + mul_q16(xi, DRAWN_SPRING),
    );
    let bed = gentle.min(drawn).max(mouth.bed + 1);
    let depth = if rules.landforms { SPRING_DEPTH } else { 0 };
    river(bed, mouth.water.min(bed + depth))
}

/// A river's bed under its water, which never lies below it; grains.
fn river(bed: i32, water: i32) -> VertexGround {
    VertexGround {
        kind: VertexKind::River,
        height: bed,
        bed,
        water: water.max(bed),
    }
}
