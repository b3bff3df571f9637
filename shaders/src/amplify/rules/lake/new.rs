//! Rivers that widen to new lakes: tarns and the lakes of high valleys.

use super::under;
use crate::amplify::arith::{mul_q16, smoothstep};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{GRAINS, Q16, metres, q16};
use crate::amplify::rules::landform::dryness;
use crate::amplify::rules::{Rules, VertexGround};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// A river's bed must lie higher than this to widen to a lake, grains (release).
const LEAST_BED: i32 = metres(10);

/// First level on which lakes form in ours. The release's, from level 0 on, are as long as 26 km
/// and as thin as a river.
const FIRST_LEVEL: u32 = 2;

/// Beds over which lakes become more likely, from not at all to fully; grains (release).
const HIGH_BEDS: [i32; 2] = [metres(200), metres(1_000)];

/// Crust elevations over which lakes become more likely still; grains (release).
const HIGH_CRUST: [i32; 2] = [metres(1_500), metres(2_500)];

/// How much less likely lakes are in the driest land (release).
const DRY_LOSS: i32 = q16(0.9);

/// Least depth of a new lake, grains (release).
const LEAST_DEPTH: i32 = metres(20);

/// How much deeper than the least a new lake may be drawn, grains (release).
const DRAWN_DEPTH: i32 = metres(100);

/// Most depth of a new lake of ours, as a share of the edge that it was made on.
const DEPTH_OF_EDGE: i32 = q16(0.04);

/// Most height over a new lake of ours of the land around it, in depths of the lake: its shores lie a
/// fifth of the way out at least. Where land is steeper a lake would be as thin as a needle.
const LAND_OVER_DEPTH: i32 = 4;

crate::wgsl::shared!(
    LEAST_BED,
    FIRST_LAKE_LEVEL = FIRST_LEVEL,
    HIGH_BEDS,
    HIGH_CRUST,
    DRY_LOSS,
    LEAST_DEPTH,
    DRAWN_DEPTH,
    DEPTH_OF_EDGE,
    LAND_OVER_DEPTH,
);

/// Chance that the edge from a river vertex to the land above becomes a lake, Q16: in high wet
/// land, or high in the mountains, on the coarse levels only.
pub fn chance(rules: &Rules, level: u32, river: &Vertex, crust: i32, wetness: u16) -> i32 {
    let first = if rules.landforms { FIRST_LEVEL } else { 0 };
    let is_lake_level = (first..rules.lake_levels).contains(&level);
    if !is_lake_level || river.bed <= LEAST_BED || river.branched {
        return 0;
    }
    // Less likely by a quarter with every level.
    let coarse = Q16 - ((level - first).min(4) as i32) * (Q16 / 4);
    // High crust counts twice as much as a high bed: most lakes lie in mountains.
    let high = smoothstep(HIGH_BEDS[0], HIGH_BEDS[1], river.bed)
        + 2 * smoothstep(HIGH_CRUST[0], HIGH_CRUST[1], crust);
    let wet = Q16 - mul_q16(dryness(wetness), DRY_LOSS);
    mul_q16(mul_q16(mul_q16(rules.lake_chance, coarse), high), wet)
}

/// R3 with a lake: the new vertex lies under the river's water; `None` where no lake forms.
pub fn widened(rules: &Rules, context: &EdgeContext) -> Option<VertexGround> {
    let (river, land) = context.wet_end_first();
    let on_land = matches!(land.kind, VertexKind::Terrain | VertexKind::Gully);
    // Land lower than the water is the valley below: no lake there.
    if !on_land || river.kind != VertexKind::River || land.height <= river.water {
        return None;
    }
    // The valley below may also lie beside the edge.
    let has_room = context.is_dammed && context.new.lake == 0;
    if river.water <= river.bed || (rules.landforms && !has_room) {
        return None;
    }
    let bed = new_bed(rules, context, river.bed);
    let over = context.range[1] - river.water;
    if rules.landforms && over > LAND_OVER_DEPTH.saturating_mul(river.water - bed) {
        return None;
    }
    let new = context.new;
    let chance = chance(rules, context.level, river, new.crust, new.wetness);
    (share(new.seed, 10) < chance).then(|| under(bed, river.water))
}

/// Floor of a new lake under the bed of its river, a metre above the sea at least; grains.
fn new_bed(rules: &Rules, context: &EdgeContext, bed: i32) -> i32 {
    let mut depth = LEAST_DEPTH + mul_q16(DRAWN_DEPTH, share(context.new.seed, 11));
    if rules.landforms {
        depth = depth.min(mul_q16(context.length, DEPTH_OF_EDGE));
    }
    bed - depth.min(bed - GRAINS).max(0)
}
