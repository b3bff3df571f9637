//! (r, T, t) and (g, T, t): the ground between a river or a gully and the land above it (paper 002
//! Fig. 12; rule R3).

use super::preset::Rules;
use super::{VertexGround, fine, nodes, rise};
use crate::amplify::arith::{mix, mul_q16, square};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{metres, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// Rise of land that lies below its drain, per length of the edge (release).
const RISE_FROM_DRAIN: i32 = q16(0.2);

/// Least bound of that rise, grains (release). It is bounded by the height of the crust elevation C
/// over the drain; where C is lower than this, by this.
const LEAST_ROOM_OVER_DRAIN: i32 = metres(100);

/// Least share of that rise that land takes over a river, and how much the draw adds to it
/// (release).
const LOW_LAND_SHARE: [i32; 2] = [q16(0.05), q16(0.95)];

/// Least share of the way up to the land at which the middle of a slope over a river stands, and
/// how much the draw adds to it (release).
const RIVER_SHARE: [i32; 2] = [q16(0.1), q16(0.9)];

/// How far over the land the slope over a gully aims, per length of the edge (release).
const AIM_OVER_LAND: i32 = q16(0.1);

/// Least bound of that aim, grains (release). It is bounded by the height of the crust elevation C
/// over the land; where C is lower than this, by this.
const LEAST_ROOM_OVER_LAND: i32 = metres(10);

/// Least share of its way up that a slope over a gully takes, and how much the draw adds to it
/// (release).
const GULLY_SHARE: [i32; 2] = [q16(0.4), q16(0.4)];

crate::wgsl::shared!(
    RISE_FROM_DRAIN,
    LEAST_ROOM_OVER_DRAIN,
    LOW_LAND_SHARE,
    RIVER_SHARE,
    AIM_OVER_LAND,
    LEAST_ROOM_OVER_LAND,
    GULLY_SHARE,
);

/// The slope beside a river.
pub fn from_river(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let ends = context.wet_end_first();
    let height = common(rules, context).unwrap_or_else(|| above_river(context, ends));
    VertexGround::dry(VertexKind::Terrain, height)
}

/// The slope beside a gully.
pub fn from_gully(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let ends = if context.a.kind == VertexKind::Gully {
        (context.a, context.b)
    } else {
        (context.b, context.a)
    };
    let height = common(rules, context).unwrap_or_else(|| above_gully(context, ends));
    VertexGround::dry(VertexKind::Terrain, height)
}

/// Height of the slopes that are none of their own: of fine ground, and of all of ours; grains.
fn common(rules: &Rules, context: &EdgeContext) -> Option<i32> {
    if context.level >= rules.fine_level {
        return Some(fine::height(rules, context));
    }
    let ours = || rise::hillslope(rules, context);
    rules.landforms.then(ours)
}

/// R3: a share 0.1 + 0.9r of the way from a river up to the land, r = ξ, on plateaus 1 - ξ³; land
/// below its river rises over it. Grains.
fn above_river(context: &EdgeContext, (river, land): (&Vertex, &Vertex)) -> i32 {
    let xi = share(context.new.seed, 0);
    let cube = mul_q16(square(xi), xi);
    let r = nodes::cliff(xi, cube, i32::from(context.new.plateau));
    if land.height < river.height {
        return river.height + mul_q16(low_land_rise(context, river), drawn(LOW_LAND_SHARE, r));
    }
    mix(river.height, land.height, drawn(RIVER_SHARE, r))
}

/// R3 of gullies: a share 0.4 + 0.4r of the way from a gully up to a little over the land, r = ξ,
/// on plateaus 1 - ξ²; land below its gully rises over it. Grains.
fn above_gully(context: &EdgeContext, (gully, land): (&Vertex, &Vertex)) -> i32 {
    let xi = share(context.new.seed, 0);
    let r = nodes::cliff(xi, square(xi), i32::from(context.new.plateau));
    let share = drawn(GULLY_SHARE, r);
    if land.height < gully.height {
        return gully.height + mul_q16(low_land_rise(context, gully), share);
    }
    let room = (context.new.crust - land.height).max(LEAST_ROOM_OVER_LAND);
    let aim = land.height + room.min(mul_q16(context.length, AIM_OVER_LAND));
    mix(gully.height, aim, share)
}

/// Most that land below its drain rises over it, grains.
fn low_land_rise(context: &EdgeContext, drain: &Vertex) -> i32 {
    let room = (context.new.crust - drain.height).max(LEAST_ROOM_OVER_DRAIN);
    room.min(mul_q16(context.length, RISE_FROM_DRAIN))
}

/// A least share and what a draw adds to it, Q16.
const fn drawn([least, range]: [i32; 2], draw: i32) -> i32 {
    least + mul_q16(draw, range)
}
