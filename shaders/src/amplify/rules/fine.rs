//! The finest levels, edges of 50 m and less: rock and soil (release, level >= 10).

use super::super::arith::{mix, mul_q16};
use super::super::control::VertexKind;
use super::super::fixed::Q16;
use super::super::seed::share;
use super::super::vertex::EdgeContext;
use super::VertexGround;
use super::landform::steepness;
use super::noise::{CornerCache, gradient};
use super::preset::Rules;
use super::terrain::ordered;

/// The ground in the middle of a fine edge.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    VertexGround::dry(VertexKind::Terrain, height(rules, context))
}

/// Its height: in ours that of the face there, and the level's own roughness.
///
/// Release: α = ½ - q/2 + qξ between the ends, with q = 1 - 0.618 (λ/16)², then up to length / 6.82
/// above.
pub fn height(rules: &Rules, context: &EdgeContext) -> i32 {
    let new = context.new;
    let (low, high) = ordered(context.a.height, context.b.height);
    let toss = share(new.seed, 0) - Q16 / 2;
    if !rules.landforms {
        let level = context.level.min(16) as i32;
        let base = mix(
            low,
            high,
            Q16 / 2 + mul_q16(Q16 - level * level * 158, toss),
        );
        let rough = mul_q16(share(new.seed, 1), share(new.seed, 2));
        let raised = base + mul_q16(context.length, rough) / 7;
        return mix(
            base,
            raised,
            mul_q16(share(new.seed, 3), share(new.seed, 4)),
        );
    }
    context.face + mul_q16(high - low, mul_q16(toss, 6_000)) + rough(rules, context)
}

/// Roughness of a level: noise whose cells are two edges wide, a third of the slope high. A draw
/// for every edge would make streaks of thin faces; noise is alike in all directions, whatever the
/// faces are.
pub fn rough(rules: &Rules, context: &EdgeContext) -> i32 {
    let new = context.new;
    // Edges of level 0 have about 2²⁴ direction units.
    let cell = 25 - context.level.min(16);
    let noise = gradient(
        &mut CornerCache::default(),
        new.direction,
        cell,
        0x0f1e_0000 + context.level,
    );
    // Soil, too, is uneven: tan 1.1°.
    mul_q16(mul_q16(context.span, steepness(rules, new) + 1_311), noise) / 3
}
