//! The finest levels, edges of 50 m and less: rock and soil (release, level >= 10).

use super::VertexGround;
use super::landform::uneven_steepness;
use super::noise::{CornerCache, EDGE_BITS, gradient};
use super::preset::Rules;
use crate::amplify::arith::{mix, mul_q16, ordered};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{Q16, q16};
use crate::amplify::seed::{centred_share, share};
use crate::amplify::vertex::EdgeContext;

/// 0.618 / 16²: how much narrower the draw between the ends gets with the squared level (release).
const NARROWING: i32 = q16(0.618) / 256;

/// Most that fine ground is drawn up, as a share of its edge: 1 / 6.82 (release).
const MOST_DRAWN_UP: i32 = q16(0.146_628);

/// How far fine ground leaves the face beside it, as a share of the difference of its ends.
const FACE_SPREAD: i32 = q16(0.09155);

/// Seed of the roughness noise; each level adds its number.
const ROUGHNESS_SEED: u32 = 0x0f1e_0000;

crate::wgsl::shared!(NARROWING, MOST_DRAWN_UP, FACE_SPREAD, ROUGHNESS_SEED,);

/// The ground in the middle of a fine edge.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    VertexGround::dry(VertexKind::Terrain, height(rules, context))
}

/// Height in the middle of a fine edge: in ours that of the face there, and the level's own
/// roughness.
pub fn height(rules: &Rules, context: &EdgeContext) -> i32 {
    let (low, high) = ordered(context.a.height, context.b.height);
    let toss = centred_share(context.new.seed, 0);
    if !rules.landforms {
        return released_height(context, low, high, toss);
    }
    context.face + mul_q16(high - low, mul_q16(toss, FACE_SPREAD)) + rough(rules, context)
}

/// α = ½ - q/2 + qξ between the ends, with q = 1 - 0.618 (λ/16)², then up to length / 6.82 above
/// (release).
fn released_height(context: &EdgeContext, low: i32, high: i32, toss: i32) -> i32 {
    let draw = |k| share(context.new.seed, k);
    let level = context.level.min(16) as i32;
    let spread = Q16 - level * level * NARROWING;
    let base = mix(low, high, Q16 / 2 + mul_q16(spread, toss));
    let rough = mul_q16(draw(1), draw(2));
    let raised = base + mul_q16(mul_q16(context.length, rough), MOST_DRAWN_UP);
    mix(base, raised, mul_q16(draw(3), draw(4)))
}

/// Roughness of a level: noise whose cells are two edges wide, a third of the slope high. A draw
/// for every edge would make streaks of thin faces; noise is alike in all directions, whatever the
/// faces are.
pub fn rough(rules: &Rules, context: &EdgeContext) -> i32 {
    let noise = gradient(
        &mut CornerCache::default(),
        context.new.direction,
        EDGE_BITS + 1 - context.level.min(16),
        ROUGHNESS_SEED + context.level,
    );
    // `span`, not `length`: long edges of thin faces are no rougher than others.
    let slope = uneven_steepness(rules, context.new);
    mul_q16(mul_q16(context.span, slope), noise) / 3
}
