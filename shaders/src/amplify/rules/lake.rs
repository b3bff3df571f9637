//! Lakes: their shores and floors, and rivers that widen to new ones (paper 002 §5.3, Figs. 14, 15;
//! rule R3 with a lake).
//!
//! In ours a shore is a contour: the height between the floor and the land is a continuous field,
//! and where it lies below the lake's level there is water. Noise moves the height on every level,
//! by what the land is rough and no more than a share of the way from the floor up to the land: so
//! shores wander far where the ground is gentle, and run straight where it is steep. Waves smooth
//! what is small.
//!
//! Dry ground beside a lake never lies below it. Where land does, the ground is made as if its ends
//! stood at the lake's level: a sill, as wide as the edge.

use super::landform::{dryness, steepness};
use super::noise::{CornerCache, gradient};
use super::preset::Rules;
use super::{EdgeKind, VertexGround, crest, graph, rise};
use crate::amplify::arith::{linear_step, mix, mul_q16, pow_1_5, ratio, smoothstep, sqrt_q16};
use crate::amplify::control::VertexKind;
use crate::amplify::edge_split::STRAIGHT_LEVEL;
use crate::amplify::fixed::{GRAINS, Q16, metres, q16};
use crate::amplify::rules::valley::Carved;
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

/// Added to the steepness of the land: the tangent of 1.1°, as level soil is uneven too.
const SOIL_SLOPE: i32 = q16(0.02);

/// Binary logarithm of an edge of level 0, about 2²⁴ direction units.
const EDGE_BITS: u32 = 24;

/// Seed of the noise; each level adds its number.
const SHORE_SEED: u32 = 0x1a4e_0000;

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
    let new = context.new;
    let chance = chance(rules, context.level, river, new.crust, new.wetness);
    (share(new.seed, 10) < chance).then(|| under(new_bed(rules, context, river.bed), river.water))
}

/// Floor of a new lake under the bed of its river, a metre above the sea at least; grains.
fn new_bed(rules: &Rules, context: &EdgeContext, bed: i32) -> i32 {
    let mut depth = LEAST_DEPTH + mul_q16(DRAWN_DEPTH, share(context.new.seed, 11));
    if rules.landforms {
        depth = depth.min(mul_q16(context.length, DEPTH_OF_EDGE));
    }
    bed - depth.min(bed - GRAINS).max(0)
}

/// Print and release: the floor between two vertices of one lake, or a crest between two lakes.
pub fn between(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (a, b) = (context.a, context.b);
    if a.lake != b.lake || a.water != b.water {
        return crest::between_rivers(rules, context);
    }
    under(a.bed + (b.bed - a.bed) / 2, a.water)
}

/// Ours: the vertex of an edge in or beside a lake.
pub fn halve(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
    let level = context.new.lake_level;
    let is_lake = |v: &Vertex| v.kind == VertexKind::Lake && v.water == level;
    let is_level = |v: &Vertex| v.is_wet() && v.water == level;
    let (a, b) = (context.a, context.b);
    if (is_lake(a) && is_level(b)) || (is_lake(b) && is_level(a)) {
        return floor(rules, edge, context);
    }
    if edge == EdgeKind::River {
        return if is_lake(b) && a.is_wet() {
            inflow(context)
        } else {
            graph(rules, edge, context)
        };
    }
    let (lake, land) = if is_lake(a) { (a, b) } else { (b, a) };
    if is_lake(lake) && !land.is_wet() && land.height >= level {
        return of_kind(edge, shore(rules, context, lake, land));
    }
    beside(rules, edge, context)
}

/// Between two vertices of a lake: its floor, or an island where that is shallow.
fn floor(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
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

/// A river that flows into a lake: the lake reaches as far up its valley as the river's bed lies
/// below it.
fn inflow(context: &EdgeContext) -> VertexGround {
    let (river, lake) = (context.a, context.b);
    let level = lake.water;
    let bed = river.bed + (lake.bed - river.bed) / 2;
    let water = bed + (river.water - river.bed).max(0);
    if water <= level {
        return under(bed, level);
    }
    VertexGround {
        kind: VertexKind::River,
        height: bed,
        bed,
        water: water.min(river.water),
    }
}

/// Between a lake and land that is not lower: lake or land, as the height lies below the level or
/// above.
fn shore(rules: &Rules, context: &EdgeContext, lake: &Vertex, land: &Vertex) -> VertexGround {
    let level = context.new.lake_level;
    let (depth, rise) = (level - lake.bed, land.height - level);
    let most = mul_q16(depth / 2 + rise / 2, SHORE_RELIEF);
    let even = mul_q16(
        rise / 2 - depth / 2,
        Q16 - hollow(rules, context, rise + depth),
    );
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
    let steep = mul_q16(context.length, slope(rules, context));
    mul_q16(drawn.max(0), ratio(steep, fall.max(1)))
}

/// Tangent of the land's slopes, with the unevenness of its soil; Q16.
fn slope(rules: &Rules, context: &EdgeContext) -> i32 {
    steepness(rules, context.new) + SOIL_SLOPE
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
    mul_q16(mul_q16(context.span, slope(rules, context)), ROUGHNESS)
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
    let slope = lifted(context, level, |lifted| {
        rise::height(rules, lifted, rise::SLOPE_BULGE)
    });
    let inland = ratio(2 * even, rise.max(1));
    mix(even, slope - level, inland)
}

/// Beside a lake: the ground is made as if its ends stood at the lake's level at least.
fn beside(rules: &Rules, edge: EdgeKind, context: &EdgeContext) -> VertexGround {
    let level = context.new.lake_level;
    let ground = lifted(context, level, |lifted| {
        if lifted.a.kind == VertexKind::Lake || lifted.b.kind == VertexKind::Lake {
            // Between two waters, or over a valley that lies lower than the lake.
            of_kind(edge, crest::between_rivers(rules, lifted))
        } else {
            graph(rules, edge, lifted)
        }
    });
    let is_dry = !matches!(
        ground.kind,
        VertexKind::Sea | VertexKind::River | VertexKind::Lake
    );
    if is_dry && ground.height <= level {
        // A hollow under the level becomes a rise over it.
        let height = level + 1 + (level - ground.height) / 4;
        return VertexGround::dry(ground.kind, height);
    }
    ground
}

/// Runs a rule on an edge whose ends stand at a level at least, or at their water.
fn lifted<T>(context: &EdgeContext, level: i32, rule: impl FnOnce(&EdgeContext) -> T) -> T {
    let [a, b] = [context.a, context.b].map(|end| match end.kind {
        VertexKind::Sea | VertexKind::Coast => *end,
        _ => Vertex {
            height: end.height.max(level).max(end.water),
            ..*end
        },
    });
    rule(&EdgeContext {
        a: &a,
        b: &b,
        face: context.face.max(a.height.min(b.height)),
        ..*context
    })
}

/// Dry ground on a gully's edge is a gully.
fn of_kind(edge: EdgeKind, ground: VertexGround) -> VertexGround {
    if edge == EdgeKind::Gully && ground.kind == VertexKind::Terrain {
        return VertexGround::dry(VertexKind::Gully, ground.height);
    }
    ground
}

/// A lake's floor under its water, grains: a grain below it at least.
fn under(bed: i32, water: i32) -> VertexGround {
    let bed = bed.min(water - 1);
    VertexGround {
        kind: VertexKind::Lake,
        height: bed,
        bed,
        water,
    }
}

/// Ground and water beside a lake: the lake's level goes on under its shore, and no valley is cut
/// below it.
pub fn held(vertex: &Vertex, carved: Carved) -> Carved {
    let is_river = carved.water > carved.ground || vertex.is_wet();
    if vertex.lake == 0 || is_river || vertex.kind == VertexKind::Sea {
        return carved;
    }
    Carved {
        ground: carved.ground.max(vertex.lake_level),
        water: vertex.lake_level,
    }
}
