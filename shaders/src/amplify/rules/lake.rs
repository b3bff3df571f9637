//! Lakes: widened rivers with a level surface (paper 002 §5.3, Figs. 14, 15; rule R3 with a lake).

use super::super::arith::{mul_q16, smoothstep};
use super::super::control::VertexKind;
use super::super::fixed::{GRAINS, Q16};
use super::super::seed::share;
use super::super::vertex::{EdgeContext, Vertex};
use super::landform::dryness;
use super::preset::Rules;
use super::{VertexGround, crest};

/// Chance that the edge from a river vertex to the land above becomes a lake, Q16: in high wet
/// land, or high in the mountains, on the coarse levels only.
pub fn chance(rules: &Rules, level: u32, river: &Vertex, crust: i32, wetness: u16) -> i32 {
    if level >= rules.lake_levels || river.bed <= 10 * GRAINS || river.branched {
        return 0;
    }
    // The release's lakes are as long as 26 km and as thin as a river; ours begin two levels on.
    let first = if rules.landforms { 2 } else { 0 };
    if level < first {
        return 0;
    }
    let coarse = Q16 - ((level - first).min(4) as i32) * (Q16 / 4);
    let high = smoothstep(200 * GRAINS, 1_000 * GRAINS, river.bed)
        + 2 * smoothstep(1_500 * GRAINS, 2_500 * GRAINS, crust);
    let wet = Q16 - mul_q16(dryness(wetness), 58_982);
    mul_q16(mul_q16(mul_q16(rules.lake_chance, coarse), high), wet)
}

/// Chance that a lake reaches half the way to land beside it. In ours on all levels: bays and
/// points of all sizes make its shore, as they make a coast.
fn spread(rules: &Rules) -> i32 {
    if rules.landforms { 30_000 } else { 0 }
}

/// R3 with a lake: the new vertex lies under the river's water, or nothing where no lake forms.
pub fn halve(rules: &Rules, context: &EdgeContext) -> Option<VertexGround> {
    let (river, land) = if context.a.is_wet() {
        (context.a, context.b)
    } else {
        (context.b, context.a)
    };
    let on_land = matches!(land.kind, VertexKind::Terrain | VertexKind::Gully);
    // Land lower than the water is the valley below: no lake there.
    if !on_land || river.water <= river.bed || land.height <= river.water {
        return None;
    }
    let new = context.new;
    let born = river.kind == VertexKind::River;
    let chance = if born {
        chance(rules, context.level, river, new.crust, new.wetness)
    } else {
        spread(rules)
    };
    if share(new.seed, 10) >= chance {
        return None;
    }
    let bed = if born || context.level < rules.lake_levels {
        let depth = 20 * GRAINS + mul_q16(100 * GRAINS, share(new.seed, 11));
        river.bed - depth.min(river.bed - GRAINS).max(0)
    } else {
        // The floor shelves towards the shore.
        river.bed + (river.water - river.bed) / 2
    };
    Some(VertexGround {
        kind: VertexKind::Lake,
        height: bed,
        bed,
        water: river.water,
    })
}

/// Between two lake vertices: the floor of their lake, or a crest between two lakes.
pub fn between(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (a, b) = (context.a, context.b);
    if a.lake != b.lake || a.water != b.water {
        return crest::between_rivers(rules, context);
    }
    let bed = a.bed + (b.bed - a.bed) / 2;
    VertexGround {
        kind: VertexKind::Lake,
        height: bed,
        bed,
        water: a.water,
    }
}
