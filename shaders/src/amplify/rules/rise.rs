//! How high the ground between two drains stands: the common part of all graphs of ours.
//!
//! Real slopes rise from their drains as steeply as their rock lets them, and meet in crests. Every
//! vertex has a way down along one of its edges. The middle of an edge follows from the edge's rise,
//! the difference in height of its ends, and from its slope, the rise over half the edge at the
//! land's steepness:
//!
//! - ends of one height with lower ground on both sides have a divide between them ([`divide`]);
//! - where the rise is a whole slope or more the edge is a hillside;
//! - in between the two are mixed;
//! - the floor of a valley stands little above its lower end ([`gully`]);
//! - the sides of valleys rise at the angle of their rock, whatever draw there is ([`threshold`]).
//!
//! From no corner around it does the middle stand steeper than its rock bears: so the sides of a
//! valley rise from its floor evenly, whatever levels make them.
//!
//! A vertex is made above the lower end of its edge, and keeps the way down to it for ever: the half
//! between them, a descent where no gully runs along it, and all that it is cut into never overtop
//! their ends. So no closed hollow is made, drained or not; and all other edges may rise, so that
//! those of no level stand out as lines without relief.
//!
//! The numbers are chosen so that slopes and spectra are those of real relief.

use super::divide::{evenness, gain};
use super::edge_land::{EdgeLand, is_small, least, lowest_cone};
use super::preset::{FACE_LEVEL, Rules};
use super::{fine, gully, threshold};
use crate::amplify::arith::{mix, mul_q16, ordered};
use crate::amplify::control::VertexKind;
use crate::amplify::fixed::{Q16, q16};
use crate::amplify::vertex::EdgeContext;

/// Bulge of divides: between two drains, and on open ground.
const DIVIDE_BULGE: i32 = q16(1.37329);

/// Bulge of hillsides between a drain and the land above it.
const SLOPE_BULGE: i32 = q16(0.1831);

/// Least share of the rise that the middle of a hillside takes, by level; the last holds for all that
/// follow. On the coarsest levels little, so that valleys are wide; then nearly half: between
/// gullies, which are hollow, spurs stand out.
const SPUR: [i32; 3] = [q16(0.1831), q16(0.206), q16(0.42)];

/// How much farther up than the hollow's share the draw may put the middle of a hillside.
const DRAWN_HILLSIDE: i32 = q16(0.21362);

/// The steepest ground over a corner, as a share of the landform's slope, and how much the draw adds
/// to it.
const STEEPEST: [i32; 2] = [q16(0.5), q16(0.2)];

/// Last level whose edges may rise to crests. Shorter ones, of 400 m and less on an Earth-sized
/// planet, keep between their ends: crests of theirs would be knobs and pits on hillsides.
const LAST_CREST_LEVEL: u32 = FACE_LEVEL;

/// The middle of a descent keeps a sixteenth of the rise away from both ends.
const LEAST_STEP: i32 = 16;

/// How far the foot of a hillside over a gully is hollow: an eighth of the rise.
const HOLLOW_FOOT: i32 = 8;

/// Roughness of hillsides, as a share of that of fine ground: it breaks the facets of faces.
const HILLSIDE_ROUGHNESS: i32 = q16(1.4);

/// One beyond the last level whose ground goes on across its edges without a crease.
const BENT_LEVELS: u32 = 4;

crate::wgsl::shared!(
    DIVIDE_BULGE,
    SLOPE_BULGE,
    SPUR,
    DRAWN_HILLSIDE,
    STEEPEST,
    LAST_CREST_LEVEL,
    LEAST_STEP,
    HOLLOW_FOOT,
    HILLSIDE_ROUGHNESS,
    BENT_LEVELS,
);

/// Height of the middle of an edge between two drains or on open ground.
pub fn divide(rules: &Rules, context: &EdgeContext) -> i32 {
    height(rules, context, DIVIDE_BULGE)
}

/// Height of the middle of an edge between a drain and the land above it.
pub fn hillslope(rules: &Rules, context: &EdgeContext) -> i32 {
    // On longer edges there is a divide between the drain and the land.
    let bulge = if is_small(context) {
        SLOPE_BULGE
    } else {
        DIVIDE_BULGE
    };
    height(rules, context, bulge)
}

/// Height of the middle of an edge. `bulge` (Q16) is the share of the full slope by which it
/// overtops the higher end.
fn height(rules: &Rules, context: &EdgeContext, bulge: i32) -> i32 {
    let land = EdgeLand::of(rules, context);
    let (low, high) = ordered(context.a.height, context.b.height);
    let risen = match gully::most_rise(context.level, land.slope, land.draws.xi) {
        Some(most) if context.new.is_drained => {
            let floor = least(context).max(low + most);
            crest(rules, context, &land, bulge).min(floor)
        }
        _ if threshold::holds(context.level) => threshold::height(context, &land) + bend(context),
        _ => crest(rules, context, &land, bulge),
    };
    if context.level > LAST_CREST_LEVEL || context.is_descent {
        let step = (high - low) / LEAST_STEP;
        risen.clamp(low + step, high - step)
    } else {
        risen
    }
}

/// Height of the middle of an edge between a crest, if its ends are level, and an even hillside.
fn crest(rules: &Rules, context: &EdgeContext, land: &EdgeLand, bulge: i32) -> i32 {
    let EdgeLand {
        steep,
        slope,
        draws,
    } = *land;
    let high = context.a.height.max(context.b.height);
    let bulge = mul_q16(bulge, draws.bulge);
    let evenness = evenness(context, slope);
    // Between level ends the ground is a crest, beside a whole slope a hillside, in between both.
    // Squared, so that a hillside stays one until its ends are nearly level.
    let towards_crest = mul_q16(mul_q16(evenness, evenness), bulge.min(Q16));
    let even = mix(hillside(rules, context, draws.xi), high, towards_crest);
    let full = mul_q16(mul_q16(slope, evenness), bulge);
    let crest = even + gain(context, draws, steep, full) + bend(context);
    let most = steepest(context, steep, slope, draws.chi);
    crest.min(most).max(least(context))
}

/// The highest that the middle of an edge may stand over the corners around it, drawn anew for each
/// edge so that faces do not become planes. The land's tangent is `steep`.
fn steepest(context: &EdgeContext, steep: i32, slope: i32, chi: i32) -> i32 {
    let share = STEEPEST[0] + mul_q16(chi, STEEPEST[1]);
    lowest_cone(context, mul_q16(slope, share), mul_q16(share, steep))
}

/// How far the middle of a coarse edge bends up, grains. Faces that met at a crease along their edge
/// would show the edges of the control mesh.
const fn bend(context: &EdgeContext) -> i32 {
    if context.level < BENT_LEVELS {
        context.curvature
    } else {
        0
    }
}

/// Height of the middle of an edge on an even hillside.
fn hillside(rules: &Rules, context: &EdgeContext, xi: i32) -> i32 {
    if is_small(context) {
        // On the face itself, so that an even slope stays even under sideways moves.
        let rough = mul_q16(fine::rough(rules, context), HILLSIDE_ROUGHNESS);
        return context.face - foot(context) + rough;
    }
    let (low, high) = ordered(context.a.height, context.b.height);
    let spur = SPUR[context.level.min(2) as usize];
    mix(low, high, spur + mul_q16(xi, DRAWN_HILLSIDE))
}

/// How far a hillside is hollow over the gully at its foot, grains.
const fn foot(context: &EdgeContext) -> i32 {
    let rise = context.b.height - context.a.height;
    let lower = if rise < 0 { context.b } else { context.a };
    if matches!(lower.kind, VertexKind::Gully) {
        rise.abs() / HOLLOW_FOOT
    } else {
        0
    }
}

#[cfg(test)]
#[path = "rise_tests.rs"]
mod tests;
