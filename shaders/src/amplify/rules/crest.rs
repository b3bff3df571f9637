//! (r, T, r): the crest between two rivers, and between two gullies (paper 002 Fig. 13; rule R2).

use super::super::arith::{mul_q16, square};
use super::super::control::VertexKind;
use super::super::fixed::{GRAINS, Q16};
use super::super::seed::share;
use super::super::vertex::EdgeContext;
use super::preset::Rules;
use super::{VertexGround, rise};

/// The crest between two rivers: above both.
pub fn between_rivers(rules: &Rules, context: &EdgeContext) -> VertexGround {
    VertexGround::dry(VertexKind::Terrain, height(rules, context, 50 * GRAINS))
}

/// The crest between two gullies: above both.
pub fn between_gullies(rules: &Rules, context: &EdgeContext) -> VertexGround {
    VertexGround::dry(VertexKind::Terrain, height(rules, context, 25 * GRAINS))
}

/// Height of a crest, grains. The release sets it (1 - 0.95ξ²)·min(C, 0.2 length) above the sea, at
/// least min(0.2 length, `least`) above its rivers; ours raises it by the land's slope over half
/// the edge, as far as the crust allows.
fn height(rules: &Rules, context: &EdgeContext, least: i32) -> i32 {
    if !rules.landforms {
        let top = context.a.height.max(context.b.height);
        let new = context.new;
        let xi = share(new.seed, 0);
        let rise = mul_q16(context.length, rules.crest_rise);
        let floor = top + rise.min(least);
        return floor.max(mul_q16(
            rise.min(new.crust),
            Q16 - mul_q16(square(xi), 62_259),
        ));
    }
    rise::height(rules, context, 90_000)
}
