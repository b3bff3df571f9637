//! (r, T, r): the crest between two rivers, and between two gullies (paper 002 Fig. 13; rule R2).

use super::preset::Rules;
use super::{VertexGround, fine, nodes, rise};
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

crate::wgsl::shared!(LEAST_OVER_RIVERS, LEAST_OVER_GULLIES, DRAWN_SHARE,);

/// The crest between two rivers: above both.
pub fn between_rivers(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let draw = share(context.new.seed, 0);
    let height = height(rules, context, LEAST_OVER_RIVERS, draw);
    VertexGround::dry(VertexKind::Terrain, height)
}

/// The crest between two gullies: above both.
pub fn between_gullies(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let xi = share(context.new.seed, 0);
    let cube = mul_q16(square(xi), xi);
    let draw = nodes::cliff(xi, cube, i32::from(context.new.plateau));
    let height = height(rules, context, LEAST_OVER_GULLIES, draw);
    VertexGround::dry(VertexKind::Terrain, height)
}

/// Height of a crest, grains. The release sets it (1 - 0.95r²)·min(C, 0.2 length) above the sea, r
/// the `draw`, at least min(0.2 length, `least`) above its rivers; ours raises it by the land's
/// slope over half the edge, as far as the crust allows.
fn height(rules: &Rules, context: &EdgeContext, least: i32, draw: i32) -> i32 {
    if rules.landforms {
        return rise::divide(rules, context);
    }
    if context.level >= rules.fine_level {
        return fine::height(rules, context);
    }
    let new = context.new;
    let rise = mul_q16(context.length, rules.crest_rise);
    let over_drains = context.a.height.max(context.b.height) + rise.min(least);
    let kept = Q16 - mul_q16(square(draw), DRAWN_SHARE);
    over_drains.max(mul_q16(rise.min(new.crust), kept))
}
