//! Shores and floors of lakes of ours: one continuous height from the floor up to the land.
//!
//! Relief of the land's own steepness goes on under the water. It takes no more than a share of the
//! way from the floor up to the land, so that shores wander far where the ground is gentle and run
//! straight where it is steep, and less on fine levels, where waves smooth them. Floors shelve with
//! the distance from the shore, and are deepest in the middle.

use super::{Lifted, under};
use crate::amplify::arith::{linear_step, mix, mul_q16, pow_1_5, ratio, sqrt_q16};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::rules::landform::uneven_steepness;
use crate::amplify::rules::noise::{CornerCache, EDGE_BITS, gradient};
use crate::amplify::rules::{EdgeKind, Rules, STRAIGHT_LEVEL, VertexGround, rise};
use crate::amplify::vertex::EdgeContext;

/// Most relief of a shore, as a share of half the way from the floor up to the land.
const SHORE_RELIEF: i32 = q16(0.95);

/// Most relief of a floor, as a share of its depth: more than all of it makes islands.
const FLOOR_RELIEF: i32 = q16(1.1);

/// How much deeper a lake is between two of its vertices, as a share of the land's relief.
const DEEPENING: i32 = q16(0.5);

/// Depth that this does not exceed, grains: that of Lake Superior.
const DEEPEST: i32 = metres(400);

/// How far the shore is drawn towards the middle of its edge: on level 0, and less with every
/// level.
const HOLLOW: [i32; 2] = [q16(0.9), q16(0.15)];

/// Relief of an edge, as a share of what the land rises over it.
const ROUGHNESS: i32 = q16(0.2);

/// How much of it a level leaves: waves smooth what is small.
const CALM_LEVELS: [i32; 2] = [6, 13];

/// How much the noise is stretched, so that it often has its full height.
const STRETCH: i32 = q16(1.8);

/// Seed of the noise; each level adds its number.
const SHORE_SEED: u32 = 0x1a4e_0000;

crate::wgsl::shared!(
    SHORE_RELIEF,
    FLOOR_RELIEF,
    DEEPENING,
    DEEPEST,
    HOLLOW,
    ROUGHNESS,
    LAKE_CALM_LEVELS = CALM_LEVELS,
    STRETCH,
    LAKE_SHORE_SEED = SHORE_SEED,
);

/// Between two vertices of a lake: its floor, or an island where that is shallow.
pub(in crate::amplify::rules) fn floor(
    rules: &Rules,
    edge: EdgeKind,
    context: &EdgeContext,
) -> VertexGround {
    let (a, b) = (context.a, context.b);
    let level = context.new.lake_level;
    let depth = level - (a.bed + (b.bed - a.bed) / 2);
    if edge == EdgeKind::River {
        return under(level - depth, level);
    }
    let depth = depth + deepening(rules, context, depth);
    // Waves of one edge: of longer ones whole rings of vertices would emerge.
    let rough = relief(rules, context, mul_q16(depth, FLOOR_RELIEF), EDGE_BITS);
    let over = rough.max(rough / 4) - depth;
    if over < 0 {
        under(level + over, level)
    } else {
        VertexGround::dry(VertexKind::Terrain, level + 1 + over)
    }
}

/// How much deeper a lake is than between its vertices, grains: as the relief of its land has it,
/// where those are shallow.
fn deepening(rules: &Rules, context: &EdgeContext, depth: i32) -> i32 {
    // Halved once more on every level: a parabola, which has no creases.
    let basin = mul_q16(full_relief(rules, context), DEEPENING) >> context.level.min(16);
    basin.min(depth).min((DEEPEST - depth).max(0))
}

/// Between a lake and land that is not lower: lake or land, as the height lies below the level or
/// above.
pub(in crate::amplify::rules) fn shore(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (a, b) = (context.a, context.b);
    let level = context.new.lake_level;
    let is_lake = a.kind == VertexKind::Lake && a.water == level;
    let (lake, land) = if is_lake { (a, b) } else { (b, a) };
    let (depth, rise) = (level - lake.bed, land.height - level);
    let most = mul_q16(depth / 2 + rise / 2, SHORE_RELIEF);
    let kept = Q16 - hollow(rules, context, rise + depth);
    let even = mul_q16(rise / 2 - depth / 2, kept);
    let height = even + relief(rules, context, most, EDGE_BITS + 1);
    if height <= 0 {
        under(level - shelving(context.level, -height, depth), level)
    } else {
        let over = onto_land(rules, context, height, rise);
        VertexGround::dry(VertexKind::Terrain, level + over.max(1))
    }
}

/// How far the shore lies from where an even slope would cross the water, towards the middle of its
/// edge, Q16: land rises from its lakes in a hollow, but no steeper than it is elsewhere. Ends of
/// the edge differ by `fall` grains.
fn hollow(rules: &Rules, context: &EdgeContext, fall: i32) -> i32 {
    let [most, loss] = HOLLOW;
    let drawn = most - loss * context.level.min(16) as i32;
    // Halves, so that no edge of any planet is too long.
    let steep = mul_q16(context.length / 2, uneven_steepness(rules, context.new));
    mul_q16(drawn.max(0), ratio(steep, (fall / 2).max(1)))
}

/// Relief of the ground in and beside a lake, at most `most` grains high or deep: of the steepness
/// of the land, and alike in all directions. Its waves on level 0 are 2^`wave` direction units.
fn relief(rules: &Rules, context: &EdgeContext, most: i32, wave: u32) -> i32 {
    let noise = gradient(
        &mut CornerCache::default(),
        context.new.direction,
        wave - context.level.min(16),
        SHORE_SEED + context.level,
    );
    let [first, last] = CALM_LEVELS;
    let rough = Q16 - linear_step(first, last, context.level as i32);
    let height = mul_q16(full_relief(rules, context), rough).min(most);
    mul_q16(height, mul_q16(noise, STRETCH).clamp(-Q16, Q16))
}

/// Relief of the land over an edge, grains.
fn full_relief(rules: &Rules, context: &EdgeContext) -> i32 {
    mul_q16(
        context.span,
        mul_q16(uneven_steepness(rules, context.new), ROUGHNESS),
    )
}

/// Depth where the even slope from the shore down to a `depth` has that of `even`: floors are
/// hollow, about as the 0.7th power of the distance. On straight edges they are even.
fn shelving(level: u32, even: i32, depth: i32) -> i32 {
    let even = even.min(depth.max(DEEPEST));
    if level >= STRAIGHT_LEVEL || even >= depth {
        return even;
    }
    // The root of the power 1.5, which is 0.75.
    mul_q16(depth, sqrt_q16(pow_1_5(ratio(even, depth))))
}

/// Height over the lake of land on the way from the shore, where the even slope has `even`, up to
/// the land's `rise`: the farther from the shore, the more it is that of slopes without one.
fn onto_land(rules: &Rules, context: &EdgeContext, even: i32, rise: i32) -> i32 {
    if context.level >= rules.fine_level {
        return even;
    }
    let level = context.new.lake_level;
    let lifted = Lifted::of(context);
    let slope = rise::hillslope(rules, &lifted.context(context));
    let inland = ratio(2 * even, rise.max(1));
    mix(even, slope - level, inland)
}
