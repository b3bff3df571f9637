//! Lakes: widened rivers with a level surface (paper 002 §5.3, Figs. 14, 15; rule R3 with a lake).

use super::landform::dryness;
use super::preset::Rules;
use super::{VertexGround, crest};
use crate::amplify::arith::{mul_q16, smoothstep};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{GRAINS, Q16, metres, q16};
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

/// Chance that a lake reaches half the way to the land beside it, in ours.
const SHORE_CHANCE: i32 = q16(0.45776);

/// Least depth of a new lake, grains (release).
const LEAST_DEPTH: i32 = metres(20);

/// How much deeper than the least a new lake may be drawn, grains (release).
const DRAWN_DEPTH: i32 = metres(100);

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

/// Chance that a lake reaches half the way to the land beside it, Q16. In ours on all levels: bays
/// and points of all sizes make its shore, as they make a coast.
fn shore_chance(rules: &Rules) -> i32 {
    if rules.landforms { SHORE_CHANCE } else { 0 }
}

/// R3 with a lake: the new vertex lies under the river's water; `None` where no lake forms.
pub fn halve(rules: &Rules, context: &EdgeContext) -> Option<VertexGround> {
    let (water, land) = context.wet_end_first();
    let on_land = matches!(land.kind, VertexKind::Terrain | VertexKind::Gully);
    // Land lower than the water is the valley below: no lake there.
    if !on_land || water.water <= water.bed || land.height <= water.water {
        return None;
    }
    let new = context.new;
    let is_river = water.kind == VertexKind::River;
    let chance = if is_river {
        chance(rules, context.level, water, new.crust, new.wetness)
    } else {
        shore_chance(rules)
    };
    if share(new.seed, 10) >= chance {
        return None;
    }
    let bed = if is_river || context.level < rules.lake_levels {
        new_bed(water.bed, new.seed)
    } else {
        // The floor shelves towards the shore.
        water.bed + (water.water - water.bed) / 2
    };
    Some(lake(bed, water.water))
}

/// Floor of a new lake under the bed of its river, a metre above the sea at least; grains.
fn new_bed(bed: i32, seed: u32) -> i32 {
    let depth = LEAST_DEPTH + mul_q16(DRAWN_DEPTH, share(seed, 11));
    bed - depth.min(bed - GRAINS).max(0)
}

/// Between two lake vertices: the floor of their lake, or a crest between two lakes.
pub fn between(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (a, b) = (context.a, context.b);
    if a.lake != b.lake || a.water != b.water {
        return crest::between_rivers(rules, context);
    }
    lake(a.bed + (b.bed - a.bed) / 2, a.water)
}

/// A lake's floor under its water, grains.
const fn lake(bed: i32, water: i32) -> VertexGround {
    VertexGround {
        kind: VertexKind::Lake,
        height: bed,
        bed,
        water,
    }
}
