//! Edges of the sea: sea floor, shore, and the slope from one to the other.

use super::VertexGround;
use super::preset::Rules;
use crate::amplify::arith::{mix, mul_q16, ordered};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{GRAINS, Q16, metres, q16};
use crate::amplify::seed::{centred_share, share};
use crate::amplify::vertex::EdgeContext;

/// How far from the edge's middle the shore may cross an edge of level 0, as a share of the edge
/// from end to end.
const SHORE_SPREAD: i32 = q16(0.82397);

/// How much less the shore and the sea floor spread with every level.
const SPREAD_LOSS: i32 = q16(0.03052);

/// Last level on which a shore bends: edges of 25 m on an Earth-sized planet.
const FINEST_BEND: u32 = 11;

/// Bays and headlands: at most this share of the edge's length either way.
const BEND: i32 = q16(0.006);

/// Bays and headlands: at most this high or deep, grains.
const MOST_BEND: i32 = metres(40);

/// Draw below which the shore bends landwards: headlands are a little more frequent than bays.
const BAY_SHARE: i32 = q16(0.4);

/// How far the sea floor of level 0 may lie from the mean of its ends, as a share of their fall.
const FLOOR_SPREAD: i32 = q16(0.5);

/// The sea floor sways by this share of the edge's length from one side to the other.
const FLOOR_SWAY: i32 = q16(0.008);

/// The vertex of an edge with an end in the sea, or along the shore.
///
/// Between land and sea it keeps the mean elevation, as the release does, drawn a little at random:
/// the sign of the height makes the shore. Along the shore bays and headlands alternate. Under
/// water the floor is smooth: its relief is noise, laid on once the subdivision is done.
pub fn halve(rules: &Rules, context: &EdgeContext) -> VertexGround {
    use VertexKind::{Coast, Sea};
    match (context.a.kind, context.b.kind) {
        (Coast, Coast) => along_shore(rules, context),
        (Sea, Sea) | (Sea, Coast) | (Coast, Sea) => under_water(floor(rules, context)),
        _ => across_shore(rules, context),
    }
}

/// The middle of an edge from the land into the sea. Where the shore crosses it is drawn anew at
/// every level: no length of coast is straight.
fn across_shore(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let spread = if rules.landforms {
        // Wide at coarse levels, which draw the large bays, and narrower with each finer one.
        SHORE_SPREAD - SPREAD_LOSS * context.level.min(16) as i32
    } else {
        0
    };
    by_sign(between(context, spread))
}

/// The middle of an edge along the shore: a bay or a headland in ours, so that no coast runs
/// straight; the shore itself at the finest levels, and in print and release.
fn along_shore(rules: &Rules, context: &EdgeContext) -> VertexGround {
    if !rules.landforms || context.level > FINEST_BEND {
        return VertexGround::dry(VertexKind::Coast, 0);
    }
    let toss = share(context.new.seed, 1) - BAY_SHARE;
    let height = mul_q16(mul_q16(context.length, BEND).min(MOST_BEND), 2 * toss);
    // Not the coast itself, so that the next level may bend the shore again.
    by_sign(if height == 0 { 1 } else { height })
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
