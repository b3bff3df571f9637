//! (r, R, r) and (r, R, t): along a river, and at its spring (paper 002 rules R1, R4).

use super::super::arith::{mix, mul_q16};
use super::super::control::VertexKind;
use super::super::fixed::{GRAINS, Q16};
use super::super::seed::share;
use super::super::vertex::{EdgeContext, Vertex};
use super::VertexGround;
use super::preset::Rules;

/// First level whose river edges are halved evenly; coarser ones give the long profile its hollow.
const EVEN_LEVEL: u32 = 8;

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

/// R1: the bed falls from one end to the other, three quarters of the way on the first half at the
/// coarse levels, so that the long profile is hollow. Water likewise.
fn along(context: &EdgeContext) -> VertexGround {
    let (up, down) = (context.a, context.b);
    let share_of_fall = if context.level < EVEN_LEVEL && context.level > 0 {
        42_598
    } else {
        Q16 / 2
    };
    let bed = descend(up.bed, down.bed, share_of_fall);
    let water = descend(up.water, down.water, share_of_fall).max(bed);
    VertexGround {
        kind: VertexKind::River,
        height: bed,
        bed,
        water,
    }
}

/// A height between two others, strictly where they leave room.
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
    let gentle = mouth.bed
        + mul_q16(mul_q16(context.length, rules.spring_slope), 39_322).min(1_500 * GRAINS);
    let xi = share(context.new.seed, 0);
    let halfway = mix(
        mouth.bed,
        land.height.max(mouth.bed + 2),
        26_214 + mul_q16(xi, 13_107),
    );
    let bed = gentle.min(halfway).max(mouth.bed + 1);
    let water = bed.max(mouth.water.min(bed + GRAINS / 4));
    VertexGround {
        kind: VertexKind::River,
        height: bed,
        bed,
        water,
    }
}
