//! (r, T, t) and (g, T, t): the ground between a river or a gully and the land above it (paper 002
//! Fig. 12; rule R3).

use super::super::arith::{mix, mul_q16, square};
use super::super::control::VertexKind;
use super::super::fixed::{GRAINS, Q16};
use super::super::seed::share;
use super::super::vertex::{EdgeContext, Vertex};
use super::preset::Rules;
use super::{VertexGround, fine, rise};

/// The slope beside a river.
pub fn from_river(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (wet, dry) = if context.a.is_wet() {
        (context.a, context.b)
    } else {
        (context.b, context.a)
    };
    let least = context.new.crust - wet.height;
    VertexGround::dry(
        VertexKind::Terrain,
        height(rules, context, wet, dry, least.max(100 * GRAINS), 13_107),
    )
}

/// The slope beside a gully.
pub fn from_gully(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let gully_first = context.a.kind == VertexKind::Gully;
    let (gully, land) = if gully_first {
        (context.a, context.b)
    } else {
        (context.b, context.a)
    };
    let least = context.new.crust - land.height;
    VertexGround::dry(
        VertexKind::Terrain,
        height(rules, context, gully, land, least.max(10 * GRAINS), 6_554),
    )
}

/// Height between a drain and the land above it: a share 0.1 + 0.9r of the rise, r = ξ, on plateaus
/// 1 - ξ³, so that those break off steeply. Land below its drain rises again by `rise` (Q16) of the
/// length, at most `least`.
fn height(
    rules: &Rules,
    context: &EdgeContext,
    drain: &Vertex,
    land: &Vertex,
    least: i32,
    rise: i32,
) -> i32 {
    let new = context.new;
    let xi = share(new.seed, 0);
    let cliff = Q16 - mul_q16(square(xi), xi);
    let r = mix(xi, cliff, i32::from(new.plateau));
    if !rules.landforms {
        if land.height <= drain.height {
            let up = least.min(mul_q16(context.length, rise));
            return drain.height + mul_q16(up, 3_277 + mul_q16(r, 62_259));
        }
        return mix(drain.height, land.height, 6_554 + mul_q16(r, 58_982));
    }
    if context.level >= rules.fine_level {
        return fine::height(rules, context);
    }
    rise::height(rules, context, 12_000)
}
