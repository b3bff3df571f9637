//! How high the ground between two drains stands: the common part of all graphs of ours.
//!
//! Real slopes rise from their drains as steeply as their rock lets them, and meet in crests. Every
//! vertex drains down one of its edges. The middle of an edge follows from the edge's rise, the
//! difference in height of its ends, and from its slope, the rise over half the edge at the land's
//! steepness:
//!
//! - ends of one height have a divide between them, and the middle bulges above both;
//! - where the rise is a whole slope or more the edge is a hillside, and the middle lies below the
//!   mean of its ends, as the profile of a gully is hollow;
//! - in between the two are mixed.
//!
//! The middle stands at most about a slope above the lower end, and a bulge takes at most a part of
//! the room that is left under the crust elevation C. The middle always stands above the lower end,
//! so that it can drain there and no closed hollow is made.
//!
//! The numbers are chosen so that slopes and spectra are those of real relief.

use super::fold::RiseDraws;
use super::landform::steepness;
use super::preset::Rules;
use super::{FACE_LEVEL, fine};
use crate::amplify::arith::{mix, mul_q16, ordered, ratio};
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::vertex::EdgeContext;

/// Bulge of divides: between two drains, and on open ground.
pub(super) const DIVIDE_BULGE: i32 = q16(1.37329);

/// Bulge of the slope between a drain and the land above it.
pub(super) const SLOPE_BULGE: i32 = q16(0.1831);

/// Least bulge, as a share of the full one, and how much the draw adds to it.
const DRAWN_BULGE: [i32; 2] = [q16(0.12207), q16(1.2207)];

/// How much farther up than the hollow's share the draw may put the middle of a hillside.
const DRAWN_HILLSIDE: i32 = q16(0.21362);

/// The steepest ground over the lower end, as a share of the landform's slope, and how much the
/// draw adds to it.
const STEEPEST: [i32; 2] = [q16(0.94604), q16(0.45776)];

/// Least share of the way up at which the middle of an edge stands.
const LEAST_RISE: i32 = q16(0.15259);

/// Share of the bulge that worn land loses.
const WORN_LOSS: i32 = q16(0.39673);

/// Roughness of hillsides, as a share of that of fine ground: it breaks the facets of faces.
const HILLSIDE_ROUGHNESS: i32 = q16(1.4);

/// One beyond the last level whose ground goes on across its edges without a crease.
const BENT_LEVELS: u32 = 4;

/// Most rise of a slope, grains: beyond any crust, and products of it fit 32 bits on any planet.
const MOST_SLOPE: i32 = metres(400_000);

/// First level whose bulges fade where the land is worn.
const FIRST_WORN_LEVEL: u32 = 3;

/// Height of the middle of an edge. `bulge` (Q16) is the share of the full slope by which it
/// overtops the higher end.
pub fn height(rules: &Rules, context: &EdgeContext, bulge: i32) -> i32 {
    let (low, high) = ordered(context.a.height, context.b.height);
    let slope = slope(rules, context);
    let draws = RiseDraws::of(context);
    let bulge = mul_q16(bulge, draws.bulge);
    let evenness = evenness(slope, high - low);
    // Between level ends the ground is a crest, beside a whole slope a hillside, in between both.
    let hillside = hillside(rules, context, draws.xi);
    // Squared, so that a hillside stays one until its ends are nearly level.
    let towards_crest = mul_q16(mul_q16(evenness, evenness), bulge.min(Q16));
    let gain = gain(
        context,
        draws,
        high,
        mul_q16(mul_q16(slope, evenness), bulge),
    );
    let crest = mix(hillside, high, towards_crest) + gain + bend(context);

    // No rock stands steeper, drawn anew for each edge so that faces do not become planes.
    let steepest = low + mul_q16(slope, STEEPEST[0] + mul_q16(draws.chi, STEEPEST[1]));
    crest.min(steepest).max(least(context, low, high))
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

/// How level the ends of an edge are, Q16: 1 where they are, 0 where one stands a whole slope above
/// the other.
fn evenness(slope: i32, rise: i32) -> i32 {
    ratio((slope - rise).max(0), slope.max(1))
}

/// Whether an edge is no longer than a hillside.
const fn is_small(context: &EdgeContext) -> bool {
    context.level >= FACE_LEVEL
}

/// Rise over half the edge at the landform's steepness, grains.
fn slope(rules: &Rules, context: &EdgeContext) -> i32 {
    // An edge along a thin face is long, but the rock beside it is no larger than that of others.
    let length = if is_small(context) {
        context.length.min(context.span)
    } else {
        context.length
    };
    mul_q16(length / 2, steepness(rules, context.new)).min(MOST_SLOPE)
}

/// How much a crest gains over the higher end: a draw of the bulge, bounded by the room that the
/// crust leaves.
fn gain(context: &EdgeContext, draws: RiseDraws, high: i32, bulge: i32) -> i32 {
    let new = context.new;
    // Summits reach the crust elevation C and no more.
    let room = (new.crust - high).max(0);
    let free = mul_q16(
        mul_q16(bulge, fading(context.level, i32::from(new.worn))),
        DRAWN_BULGE[0] + mul_q16(draws.xi, DRAWN_BULGE[1]),
    );
    // Saturates, half-way there where the two are equal, so that summits stay apart.
    let saturated = mul_q16(
        ratio(free, free + room + 1),
        part(context.level, draws.chi).max(draws.crest),
    );
    mul_q16(room, saturated)
}

/// Height of the middle of an edge on an even hillside.
fn hillside(rules: &Rules, context: &EdgeContext, xi: i32) -> i32 {
    if is_small(context) {
        // On the face itself, so that an even slope stays even under sideways moves.
        return context.face + mul_q16(fine::rough(rules, context), HILLSIDE_ROUGHNESS);
    }
    let (low, high) = ordered(context.a.height, context.b.height);
    mix(
        low,
        high,
        hollow(context.level) + mul_q16(xi, DRAWN_HILLSIDE),
    )
}

/// The lowest that the middle of an edge may stand, so that it drains to the lower end.
fn least(context: &EdgeContext, low: i32, high: i32) -> i32 {
    // The last term lifts the middle of a level edge, by a 4096th of its length.
    let least = mix(low, high, LEAST_RISE) + (context.length >> 12).max(1);
    // A small face drains to its lowest corner, which need not be an end of the edge.
    if is_small(context) {
        least.min(context.face)
    } else {
        least
    }
}

/// Most that a crest takes of the room, between the least and the greatest draw; Q16. Little while
/// edges are longer than the spacing of valleys: where a coarse vertex stood near C already, the
/// land around it would fill up to a table under C, and no crest could stand out.
fn part(level: u32, chi: i32) -> i32 {
    /// By level; the last holds for all that follow.
    const LEAST_AND_GREATEST: [[i32; 2]; 5] = [
        [q16(0.06104), q16(0.39673)],
        [q16(0.12207), q16(0.64087)],
        [q16(0.24414), q16(0.91553)],
        [q16(0.36621), q16(0.94604)],
        [q16(0.42725), q16(0.91553)],
    ];
    let [least, greatest] = LEAST_AND_GREATEST[level.min(4) as usize];
    mix(least, greatest, chi)
}

/// Bulges fade below the spacing of the smallest valleys, a kilometre or two: hillslopes are cut by
/// shallow gullies only, and by fewer where the land is worn. Q16.
const fn fading(level: u32, worn: i32) -> i32 {
    let kept = match level {
        0..=1 => q16(1.37329),
        2..=3 => q16(1.03),
        4 => q16(1.2207),
        5 => q16(0.97656),
        6 => q16(0.537),
        7 => q16(0.366),
        _ => q16(0.30518),
    };
    if level < FIRST_WORN_LEVEL {
        kept
    } else {
        kept - mul_q16(mul_q16(kept, worn), WORN_LOSS)
    }
}

/// Least share of the rise that the middle of a hillside takes: little, so that valleys are wide
/// and crests stand out. Q16.
const fn hollow(level: u32) -> i32 {
    q16(0.1831) + q16(0.02289) * level as i32
}
