//! (r, R, r) and (r, R, t): along a river, and at its spring (paper 002 rules R1, R4).

use super::VertexGround;
use super::preset::Rules;
use crate::amplify::arith::{mix, mul_q16};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{GRAINS, Q16, metres, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// Levels whose river edges fall more on their first half, so that the long profile is hollow: the
/// first, and one beyond the last.
const HOLLOW_LEVELS: core::ops::Range<u32> = 1..8;

/// Share of its fall that a river edge of those levels has on its first half.
const HOLLOW_FALL: i32 = q16(0.65);

/// A spring rises from its mouth by the spring slope over this share of the edge.
const SPRING_REACH: i32 = q16(0.6);

/// Most that a spring rises over its mouth, grains.
const MOST_SPRING_RISE: i32 = metres(1_500);

/// Least share of the way up to the land that a spring may be drawn to.
const LEAST_SPRING: i32 = q16(0.4);

/// How much farther up the draw may put it.
const DRAWN_SPRING: i32 = q16(0.2);

/// Most depth of water at a spring, grains.
const SPRING_DEPTH: i32 = GRAINS / 4;

/// The vertex that halves a river edge: a bed between those of its ends, or the spring of a
/// tributary.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    match (context.a.is_wet(), context.b.is_wet()) {
        (true, false) if context.b.kind == VertexKind::Terrain => {
            spring(rules, context, context.a, context.b)
        }
        (false, true) => spring(rules, context, context.b, context.a),
        _ => along(context),
    }
}

/// R1: the bed falls from one end to the other, two thirds of the way on the first half at the
/// coarse levels, so that the long profile is hollow. Water likewise.
fn along(context: &EdgeContext) -> VertexGround {
    let (up, down) = (context.a, context.b);
    let share_of_fall = if HOLLOW_LEVELS.contains(&context.level) {
        HOLLOW_FALL
    } else {
        Q16 / 2
    };
    let bed = descend(up.bed, down.bed, share_of_fall);
    river(bed, descend(up.water, down.water, share_of_fall))
}

/// A height that falls from `up` to `down`, strictly between the two where they are two grains
/// apart or more.
fn descend(up: i32, down: i32, share_of_fall: i32) -> i32 {
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
    river(bed, mouth.water.min(bed + SPRING_DEPTH))
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
