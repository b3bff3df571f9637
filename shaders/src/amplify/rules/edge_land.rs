//! The land at the middle of an edge: how steep it is, and how low it may stand.
//!
//! All rules of a rise share these numbers.

use super::fold::RiseDraws;
use super::landform::steepness;
use super::preset::{FACE_LEVEL, Rules};
use crate::amplify::arith::{mix, mul_q16, ordered};
use crate::amplify::fixed::{metres, q16};
use crate::amplify::vertex::EdgeContext;

/// Least share of the way up at which the middle of an edge stands.
const LEAST_RISE: i32 = q16(0.15259);

/// Most rise of a slope, grains: beyond any crust, and fit for the greatest bulge of a fold, which is
/// eleven times as high before it is bounded by the room under the crust.
const MOST_SLOPE: i32 = metres(150_000);

crate::wgsl::shared!(EDGE_LEAST_RISE = LEAST_RISE, MOST_SLOPE,);

/// The land at the middle of an edge, as all rules of its rise see it.
pub(super) struct EdgeLand {
    /// Tangent of its slopes, Q16.
    pub(super) steep: i32,
    /// Rise of such a slope over half of the edge, grains.
    pub(super) slope: i32,
    /// Its draws.
    pub(super) draws: RiseDraws,
}

impl EdgeLand {
    pub(super) fn of(rules: &Rules, context: &EdgeContext) -> Self {
        let steep = steepness(rules, context.new);
        Self {
            steep,
            slope: slope(context, steep),
            draws: RiseDraws::of(context),
        }
    }
}

/// Whether an edge is no longer than a hillside.
pub(super) const fn is_small(context: &EdgeContext) -> bool {
    context.level >= FACE_LEVEL
}

/// Rise over half the edge at the landform's steepness, grains.
fn slope(context: &EdgeContext, steep: i32) -> i32 {
    // An edge along a thin face is long, but the rock beside it is no larger than that of others.
    let length = if is_small(context) {
        context.length.min(context.span)
    } else {
        context.length
    };
    rise(length / 2, steep)
}

/// Rise of a slope of a tangent (Q16) over a distance, grains.
pub(super) fn rise(distance: i32, tangent: i32) -> i32 {
    mul_q16(distance, tangent).min(MOST_SLOPE)
}

/// The lowest of the cones over the corners around the middle of an edge, grains: that over its lower
/// end is `over_ends` high there, the others have a tangent (Q16).
pub(super) fn lowest_cone(context: &EdgeContext, over_ends: i32, tangent: i32) -> i32 {
    let over_ends = context.a.height.min(context.b.height) + over_ends;
    let corners = context.beside.iter().flatten();
    let over_corners = corners.map(|c| c.height + rise(c.distance, tangent));
    over_corners.fold(over_ends, i32::min)
}

/// The lowest that the middle of an edge may stand, so that it drains to the lower end.
pub(super) fn least(context: &EdgeContext) -> i32 {
    let (low, high) = ordered(context.a.height, context.b.height);
    // The last term lifts the middle of a level edge, by a 4096th of its length.
    let least = mix(low, high, LEAST_RISE) + (context.length >> 12).max(1);
    // A small face drains to its lowest corner, which need not be an end of the edge.
    if is_small(context) {
        least.min(context.face)
    } else {
        least
    }
}
