//! The finest levels, edges of 50 m and less: rock and soil (release, level >= 10).

use super::super::arith::{mix, mul_q16};
use super::super::control::VertexKind;
use super::super::fixed::Q16;
use super::super::seed::share;
use super::super::vertex::EdgeContext;
use super::Ground;
use super::landform::steepness;
use super::preset::Rules;
use super::terrain::ordered;

/// The ground in the middle of a fine edge.
pub fn halve(rules: &Rules, context: &EdgeContext) -> Ground {
    Ground::dry(VertexKind::Terrain, height(rules, context))
}

/// Its height: near the middle of its ends, less spread the finer the level, and a little roughness of its own.
///
/// Release: α = ½ - q/2 + qξ with q = 1 - 0.618 (λ/16)², then up to length / 6.82 above. Ours: soil smooths, so both
/// shrink with the level; steep ground stays rougher than flat.
pub fn height(rules: &Rules, context: &EdgeContext) -> i32 {
    let new = context.new;
    let (low, high) = ordered(context.a.height, context.b.height);
    let xi = share(new.seed, 0);
    let level = context.level.min(16) as i32;
    if !rules.landforms {
        let q = Q16 - level * level * 158;
        let base = mix(low, high, Q16 / 2 + mul_q16(q, xi - Q16 / 2));
        let rough = mul_q16(share(new.seed, 1), share(new.seed, 2));
        let raised = base + mul_q16(context.length, rough) / 7;
        return mix(base, raised, mul_q16(share(new.seed, 3), share(new.seed, 4)));
    }
    let base = mix(low, high, Q16 / 2 + mul_q16(xi - Q16 / 2, 20_000));
    let toss = share(new.seed, 1) + share(new.seed, 2) - Q16;
    let rough = mul_q16(context.length, steepness(rules, new) + 1_311);
    base + mul_q16(rough, toss) / (5 + (level - 10).max(0) * (level - 9) / 2)
}
