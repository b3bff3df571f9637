//! Edges of the sea: sea floor, shore, and the slope from one to the other.
//!
//! In ours the shore is the sign of a continuous field: the height of the flat face, moved by one
//! octave of isotropic noise on every level. The noise does not lift the ground but moves it
//! sideways, by a share of the edge: headlands rise by as much as the land behind them does over
//! that way, and bays fall as the sea floor before them falls. So it is as strong on steep coasts
//! as on level ones, and land and sea win as much of each other.
//!
//! A vertex is *coast*, at any height, while the octaves that follow may carry the shore past it;
//! beyond their reach it is land or sea, and stays so. Print and release know coasts at 0 only.

use super::noise::{CornerCache, EDGE_BITS, gradient};
use super::preset::Rules;
use super::{STRAIGHT_LEVEL, VertexGround};
use crate::amplify::arith::{mix, mul_q16, ordered, ratio, smoothstep, square};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{GRAINS, Q16, q16};
use crate::amplify::seed::centred_share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// Tangent up to which a coast is a plain's, and from which on it is rocky.
const ROCKY: [i32; 2] = [q16(0.004), q16(0.04)];

/// How far, as a share of the edge, the noise moves the shore where it is 1: on rocky coasts.
const ROCKY_MOVE: i32 = q16(0.9);

/// Share of that move that a young coast lacks: it is straight as its faults are.
const YOUNG_LOSS: i32 = q16(0.2);

/// The same move of a plain's coast on level 0, and how much less it is with every level: waves
/// and drift smooth the shore of sand.
const PLAIN_MOVE: [i32; 2] = [q16(0.8), q16(0.06)];

/// Least move of a plain's coast.
const LEAST_MOVE: i32 = q16(0.45);

/// How far from the shore, as a share of the land's height or the sea's depth beside it, a vertex
/// is coast.
const REACH: i32 = q16(0.35);

/// Least height of the land beside a shore as a share of the depth of the sea there, and of the
/// depth as a share of the height: islets and lagoons come where there is no other land or sea.
const LEAST_SIDE: i32 = q16(0.06);

/// How far the middle of an edge is that of its ends' distances from the shore rather than of their
/// heights: the sea floor falls more steeply than the land rises, and the mean of heights alone
/// would let the sea win.
const EVEN: i32 = q16(0.5);

/// Seed of the shore's noise; each level adds its number.
const SHORE_SEED: u32 = 0x0c0a_5700;

/// How much less the sea floor spreads with every level.
const SPREAD_LOSS: i32 = q16(0.03052);

/// How far the sea floor of level 0 may lie from the mean of its ends, as a share of their fall.
const FLOOR_SPREAD: i32 = q16(0.5);

/// The sea floor sways by this share of the edge's length from one side to the other.
const FLOOR_SWAY: i32 = q16(0.008);

crate::wgsl::shared!(
    ROCKY,
    ROCKY_MOVE,
    YOUNG_LOSS,
    PLAIN_MOVE,
    LEAST_MOVE,
    SHORE_REACH = REACH,
    LEAST_SIDE,
    EVEN,
    SHORE_SEED,
    SPREAD_LOSS,
    FLOOR_SPREAD,
    FLOOR_SWAY,
);

/// Whether an edge has an end in the sea or at the shore.
pub fn is_shore(a: VertexKind, b: VertexKind) -> bool {
    [a, b]
        .iter()
        .any(|kind| matches!(kind, VertexKind::Sea | VertexKind::Coast))
}

/// The vertex of an edge with an end in the sea, or at the shore.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    use VertexKind::{Coast, Sea};
    match (context.a.kind, context.b.kind) {
        (Sea, Sea) => under_water(floor(rules, context)),
        _ if rules.landforms => shore(context),
        (Coast, Coast) => VertexGround::dry(Coast, 0),
        (Sea, Coast) | (Coast, Sea) => under_water(floor(rules, context)),
        // Between land and sea print and release keep the mean.
        _ => by_sign(between(context, 0)),
    }
}

/// The middle of an edge at the shore: the face there, moved by the level's octave.
fn shore(context: &EdgeContext) -> VertexGround {
    let relief = Relief::around(context);
    let mean = level_between(context);
    if context.level >= STRAIGHT_LEVEL {
        return by_sign(mean);
    }
    let before = relief.away(mean) + mul_q16(relief.bend(context), EVEN);
    let moved = mul_q16(noise(context), most_move(context, &relief));
    // Far from the shore the ground keeps its height.
    let away = before + mul_q16(moved, square(Q16 - before.abs().min(Q16)));
    let ground = by_sign(relief.height(away));
    let is_near = away.abs() < REACH && !touches_lake(context);
    VertexGround {
        kind: if is_near {
            VertexKind::Coast
        } else {
            ground.kind
        },
        ..ground
    }
}

/// The heights beside a shore, grains: how high the land stands over the sea within the faces of an
/// edge, and how deep the sea is.
struct Relief {
    land: i32,
    sea: i32,
}

impl Relief {
    fn around(context: &EdgeContext) -> Self {
        let [lowest, highest] = context.range;
        let (land, sea) = (highest.max(0), (-lowest).max(0));
        Self {
            land: land.max(mul_q16(sea, LEAST_SIDE)).max(1),
            sea: sea.max(mul_q16(land, LEAST_SIDE)).max(1),
        }
    }

    /// How far a height is from the shore: 1 at the highest land, -1 at the deepest sea; Q16.
    fn away(&self, height: i32) -> i32 {
        if height > 0 {
            ratio(height, self.land)
        } else {
            -ratio(-height, self.sea)
        }
    }

    /// How much farther from the shore the mean of an edge's ends is, by their distance, than the
    /// mean of their heights.
    fn bend(&self, context: &EdgeContext) -> i32 {
        let [a, b] = [context.a, context.b].map(Vertex::surface);
        let places = (self.away(a) + self.away(b)) / 2;
        places - self.away(a + (b - a) / 2)
    }

    /// The height so far from the shore.
    fn height(&self, away: i32) -> i32 {
        let side = if away > 0 { self.land } else { self.sea };
        mul_q16(side, away)
    }
}

/// Height between the ends, grains: of the face, or of the water of ends that are wet.
fn level_between(context: &EdgeContext) -> i32 {
    let (a, b) = (context.a, context.b);
    if a.is_wet() || b.is_wet() {
        a.surface() + (b.surface() - a.surface()) / 2
    } else {
        context.face
    }
}

/// A lake's shore must hold its water back, so it is land.
fn touches_lake(context: &EdgeContext) -> bool {
    [context.a, context.b]
        .iter()
        .any(|v| v.kind == VertexKind::Lake)
}

/// How much farther than its ends the middle of an edge is moved by the octaves of the level, whose
/// waves are four and two edges long; about -1..1 in Q16. Both ends are asked for, too: where they
/// were made finer octaves were not known, and no cape may stay behind there.
fn noise(context: &EdgeContext) -> i32 {
    let [a, b, new] = [context.a, context.b, context.new].map(|v| octaves(context.level, v));
    new - (a / 2 + b / 2)
}

/// The octaves of a level at a vertex.
fn octaves(level: u32, vertex: &Vertex) -> i32 {
    let cell = EDGE_BITS - level.min(16);
    2 * octave(vertex, cell) + octave(vertex, cell - 1)
}

/// The octave of a size of cells at a vertex.
fn octave(vertex: &Vertex, cell: u32) -> i32 {
    let cache = &mut CornerCache::default();
    gradient(cache, vertex.direction, cell, SHORE_SEED + cell)
}

/// How far the noise moves the shore at most, as a share of the edge, Q16.
fn most_move(context: &EdgeContext, relief: &Relief) -> i32 {
    let level = context.level.min(16) as i32;
    let plain = (PLAIN_MOVE[0] - level * PLAIN_MOVE[1]).max(LEAST_MOVE);
    let young = mul_q16(Q16 - i32::from(context.new.worn), YOUNG_LOSS);
    let rocky = mul_q16(ROCKY_MOVE, Q16 - young);
    let slope = ratio(relief.land / 2 + relief.sea / 2, context.length);
    mix(plain, rocky, smoothstep(ROCKY[0], ROCKY[1], slope))
}

/// Height of the sea floor between two places of it: the mean, and in ours a little to either side,
/// in proportion to the fall and to the edge, so that no facet of the control mesh shows.
fn floor(rules: &Rules, context: &EdgeContext) -> i32 {
    let (a, b) = (context.a.height, context.b.height);
    if !rules.landforms {
        return a + (b - a) / 2;
    }
    // The draw is wide at coarse levels and narrows with each finer one.
    let spread = FLOOR_SPREAD - SPREAD_LOSS * context.level.min(14) as i32;
    // Less sway in shallow water: at most a sixth of the depth at the deeper end.
    let most_sway = mul_q16(context.length, FLOOR_SWAY).min(-a.min(b) / 6);
    let sway = mul_q16(most_sway, centred_share(context.new.seed, 1));
    // Never dry: between two vertices of the sea there is no shore.
    (between(context, spread) + sway).min(-GRAINS / 4)
}

/// A height between the ends, drawn from the middle `spread` (Q16) of their difference.
fn between(context: &EdgeContext, spread: i32) -> i32 {
    let (low, high) = ordered(context.a.height, context.b.height);
    let toss = centred_share(context.new.seed, 0);
    mix(low, high, Q16 / 2 + mul_q16(toss, spread))
}

/// Sea floor or land, as the height is below or above the sea.
fn by_sign(height: i32) -> VertexGround {
    if height <= 0 {
        under_water(height)
    } else {
        VertexGround::dry(VertexKind::Terrain, height)
    }
}

/// Sea floor: its water is the sea's.
fn under_water(height: i32) -> VertexGround {
    VertexGround {
        kind: VertexKind::Sea,
        height,
        bed: height,
        water: 0.max(height),
    }
}
