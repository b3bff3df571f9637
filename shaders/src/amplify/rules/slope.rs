//! (r, T, t) and (g, T, t): the ground between a river or a gully and the land above it (paper 002
//! Fig. 12; rule R3).

use super::preset::Rules;
use super::{VertexGround, fine, rise};
use crate::amplify::arith::{mix, mul_q16, square};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// Rise of land that lies below its river, per length of the edge (release).
const RISE_FROM_RIVER: i32 = q16(0.2);

/// Least bound of that rise, grains (release). It is bounded by the height of the crust elevation C
/// over the river; where C is lower than this, by this.
const LEAST_ROOM_OVER_RIVER: i32 = metres(100);

/// Rise of land that lies below its gully, per length of the edge (release).
const RISE_FROM_GULLY: i32 = q16(0.1);

/// Least bound of that rise, grains (release). It is bounded by the height of the crust elevation C
/// over the land; where C is lower than this, by this.
const LEAST_ROOM_OVER_GULLY: i32 = metres(10);

/// Least share of that rise that is taken, and how much the draw adds to it (release).
const LOW_LAND_SHARE: [i32; 2] = [q16(0.05), q16(0.95)];

/// Least share of the way up to the land at which the middle of a slope stands, and how much the
/// draw adds to it (paper 002 R3).
const SLOPE_SHARE: [i32; 2] = [q16(0.1), q16(0.9)];

/// The slope beside a river.
pub fn from_river(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (river, land) = context.wet_end_first();
    let most = (context.new.crust - river.height).max(LEAST_ROOM_OVER_RIVER);
    let low_land_rise = most.min(mul_q16(context.length, RISE_FROM_RIVER));
    let height = height(rules, context, [river, land], low_land_rise);
    VertexGround::dry(VertexKind::Terrain, height)
}

/// The slope beside a gully.
pub fn from_gully(rules: &Rules, context: &EdgeContext) -> VertexGround {
    let (gully, land) = if context.a.kind == VertexKind::Gully {
        (context.a, context.b)
    } else {
        (context.b, context.a)
    };
    let most = (context.new.crust - land.height).max(LEAST_ROOM_OVER_GULLY);
    let low_land_rise = most.min(mul_q16(context.length, RISE_FROM_GULLY));
    let height = height(rules, context, [gully, land], low_land_rise);
    VertexGround::dry(VertexKind::Terrain, height)
}

/// Height between a drain and the land above it: a share 0.1 + 0.9r of the rise, r = ξ, on plateaus
/// 1 - ξ³, so that those break off steeply. Land below its drain rises by a draw of
/// `low_land_rise`.
fn height(
    rules: &Rules,
    context: &EdgeContext,
    [drain, land]: [&Vertex; 2],
    low_land_rise: i32,
) -> i32 {
    if rules.landforms {
        if context.level >= rules.fine_level {
            return fine::height(rules, context);
        }
        return rise::height(rules, context, rise::SLOPE_BULGE);
    }
    let new = context.new;
    let xi = share(new.seed, 0);
    // Most draws of 1 - ξ³ are near 1: the slope keeps its height and breaks off at the drain.
    let cliff = Q16 - mul_q16(square(xi), xi);
    let r = mix(xi, cliff, i32::from(new.plateau));
    if land.height <= drain.height {
        return drain.height
            + mul_q16(
                low_land_rise,
                LOW_LAND_SHARE[0] + mul_q16(r, LOW_LAND_SHARE[1]),
            );
    }
    mix(
        drain.height,
        land.height,
        SLOPE_SHARE[0] + mul_q16(r, SLOPE_SHARE[1]),
    )
}
