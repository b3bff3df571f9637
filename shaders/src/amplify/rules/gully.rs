//! Gullies: dry drainage lines that cut the slopes between rivers (paper 002 §5.3).
//!
//! A gully follows the rules of a river without its water. It climbs steeper, and branches down to
//! hillslopes.

use super::super::arith::{mix, mul_q16};
use super::super::control::VertexKind;
use super::super::fixed::{GRAINS, Q16};
use super::super::seed::share;
use super::super::vertex::{EdgeContext, Vertex};
use super::VertexGround;
use super::preset::Rules;
use super::terrain::ordered;

/// The vertex that halves a gully edge: 0.4..0.5 of the way up, in ours less at the coarse levels,
/// so that the profile is hollow.
pub fn along(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let xi = share(context.new.seed, 0);
    let (low, high) = ordered(context.a.height, context.b.height);
    let lean = if rules.landforms {
        (9_000 + 2_900 * context.level.min(6) as i32).min(26_214)
    } else {
        26_214
    };
    let height = mix(low, high, lean + mul_q16(xi, 6_554));
    let mouth = if context.b.is_wet() {
        Some(context.b)
    } else {
        context.a.is_wet().then_some(context.a)
    };
    let height = match mouth {
        Some(river) if height <= river.height => {
            let up = mul_q16(context.length, 6_554).min(500 * GRAINS);
            river.height + 31 * GRAINS + mul_q16(up, xi)
        }
        _ => height,
    };
    VertexGround::dry(VertexKind::Gully, height)
}

/// Whether an internal edge of a level becomes a tributary of the river at its junction; the angle
/// is tested before. `flow` and `height` are the junction's, `spring` the height of the other end,
/// `seed` the junction's (Q16, grains).
pub fn is_tributary(
    rules: &Rules,
    level: u32,
    flow: i32,
    height: i32,
    spring: i32,
    seed: u32,
) -> bool {
    if level < rules.tributary_levels[0] || level >= rules.tributary_levels[1] || spring <= height {
        return false;
    }
    // Great rivers branch less: up to 100 of 128 draws fail at a flow of a half.
    let refused = mul_q16(51_200, super::super::arith::smoothstep(0, Q16 / 2, flow));
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
    !off_gully
        || (share(seed, 9) < rules.gully_branching
            && (rules.landforms || tip > height + 50 * GRAINS))
}

/// Whether new dry land drains along the half of its edge that leads to `end`: to the lower end of
/// an edge of the ground, while gullies still branch. So every vertex has a way down, and drainage
/// is a tree at every scale.
pub fn drains(rules: &Rules, level: u32, new: &Vertex, end: &Vertex, other: &Vertex) -> bool {
    rules.landforms
        && level < rules.gully_levels
        && new.kind == VertexKind::Terrain
        && new.height > end.height
        && (end.height, end.seed) < (other.height, other.seed)
}
