//! (r, T, r): the crest between two rivers, and between two gullies (paper 002 Fig. 13; rule R2).

use super::preset::Rules;
use super::{VertexGround, rise};
use crate::amplify::arith::{mul_q16, square};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::EdgeContext;

/// Least rise of a crest over its rivers, grains (release).
const LEAST_OVER_RIVERS: i32 = metres(50);

/// Least rise of a crest over its gullies, grains (release).
const LEAST_OVER_GULLIES: i32 = metres(25);

/// How much of a crest's height its draw may take (release).
const DRAWN_SHARE: i32 = q16(0.95);

/// The crest between two rivers: above both.
pub fn between_rivers(rules: &Rules, context: &EdgeContext) -> VertexGround {
    VertexGround::dry(
        VertexKind::Terrain,
        height(rules, context, LEAST_OVER_RIVERS),
    )
}

/// The crest between two gullies: above both.
pub fn between_gullies(rules: &Rules, context: &EdgeContext) -> VertexGround {
    VertexGround::dry(
        VertexKind::Terrain,
        height(rules, context, LEAST_OVER_GULLIES),
    )
}

/// Height of a crest, grains. The release sets it (1 - 0.95ξ²)·min(C, 0.2 length) above the sea, at
/// least min(0.2 length, `least`) above its rivers; ours raises it by the land's slope over half
/// the edge, as far as the crust allows.
fn height(rules: &Rules, context: &EdgeContext, least: i32) -> i32 {
    if rules.landforms {
        return rise::height(rules, context, rise::DIVIDE_BULGE);
    }
    let new = context.new;
    let rise = mul_q16(context.length, rules.crest_rise);
    let over_drains = context.a.height.max(context.b.height) + rise.min(least);
    let kept = Q16 - mul_q16(square(share(new.seed, 0)), DRAWN_SHARE);
    over_drains.max(mul_q16(rise.min(new.crust), kept))
}
