//! The side of a valley: how high it stands over the river, by its archetype.
//!
//! The side begins where the bed ends, and rises along the archetype e_r's curve to half-width D,
//! blended into the ground by a cubic Hermite step. D follows φ, the root of the discharge: the
//! power law of exponent ½ (release: D = 50 km at φ = 1, 4 km at 0).
//!
//! It is measured where a vertex touches its river; between such vertices and beyond it is halved
//! as the ground is ([`ValleySection`]). Nearest pieces of river change from one vertex to the next,
//! and a side measured from each would break off along seams.
//!
//! Departures: D is bounded by a share of the control mesh's edge, so that small planets have
//! valleys too; the curve never raises ground above the land beside it.

use super::reach::Reach;
use crate::amplify::arith::{mix, mul_q16, ratio, saturate, smoothstep, square};
use crate::amplify::control::ValleyShape;
use crate::amplify::fixed::{Q16, q16, tan_deg};
use crate::amplify::rules::Rules;
use crate::amplify::scale::PlanetScale;
use crate::amplify::vertex::{FAR, ValleySection, Vertex};

/// Tangent of a valley's sides beside a brook and beside the greatest river.
const SIDE_SLOPE: [i32; 2] = [tan_deg(20.0), tan_deg(3.5)];

/// Share of the valley's width at which the ground's own height sets in, and at which it is full.
const OWN_HEIGHT: [i32; 2] = [q16(0.1), q16(0.9)];

/// Where the side of a flat floor begins and ends to rise, as shares of the valley's width.
const FLOOR_RISER: [i32; 2] = [q16(0.15), q16(0.8)];

/// The same of a terraced side's lower riser.
const LOWER_RISER: [i32; 2] = [q16(0.05), q16(0.35)];

/// The same of a terraced side's upper riser.
const UPPER_RISER: [i32; 2] = [q16(0.55), q16(0.95)];

crate::wgsl::shared!(
    SIDE_SLOPE,
    OWN_HEIGHT,
    FLOOR_RISER,
    LOWER_RISER,
    UPPER_RISER,
);

/// The four archetypes of a valley's side, height over distance, both 0..1 in Q16; monotone, 0 at 0
/// and 1 at 1.
pub const fn archetype(shape: ValleyShape, x: i32) -> i32 {
    let x = saturate(x);
    match shape {
        // Half linear, so that the side starts steeply at the river.
        ValleyShape::V => x / 2 + square(x) / 2,
        // A riser, and a quarter of a parabola that keeps the floor from being level.
        ValleyShape::FlatFloor => mul_q16(riser(FLOOR_RISER, x), Q16 - x / 4) + square(x) / 4,
        ValleyShape::IceTrough => mul_q16(square(x), x),
        ValleyShape::Terraced => (riser(LOWER_RISER, x) + riser(UPPER_RISER, x)) / 2,
    }
}

/// A smooth rise from 0 to 1 between two places.
const fn riser([foot, top]: [i32; 2], x: i32) -> i32 {
    smoothstep(foot, top, x)
}

/// The side that the valley of a vertex's river has at the vertex.
pub fn section(scale: &PlanetScale, rules: &Rules, vertex: &Vertex) -> ValleySection {
    if vertex.river_distance >= FAR || vertex.river.flow == [0, 0] {
        // A lake's shore: no stream shapes it.
        return ValleySection::outside(vertex.height);
    }
    let reach = Reach::of(scale, rules, vertex);
    // The side begins where the bed ends.
    let across = (vertex.river_distance - reach.half_bed).max(0);
    let width = width(scale, vertex, &reach);
    if across >= width {
        return ValleySection::outside(vertex.height);
    }
    let x = ratio(across, width);
    let shape = shape(rules, vertex);
    // Greater rivers have gentler sides.
    let tangent = mix(SIDE_SLOPE[0], SIDE_SLOPE[1], reach.strength);
    let rise = mul_q16(mul_q16(width, tangent), archetype(shape, x));
    // It stands on the bank and never above the crust.
    let room = (vertex.crust - reach.water).max(0);
    let height = reach.water.saturating_add(rise.min(room));
    ValleySection {
        height,
        own: riser(OWN_HEIGHT, x),
    }
}

const fn shape(rules: &Rules, vertex: &Vertex) -> ValleyShape {
    if rules.archetypes {
        ValleyShape::from_number(vertex.valley)
    } else {
        ValleyShape::V
    }
}

/// Half-width of a vertex's valley, grains. A tributary is known no farther than its reach: its
/// valley ends before.
pub(super) fn width(scale: &PlanetScale, vertex: &Vertex, reach: &Reach) -> i32 {
    let valley = reach.half_valley(scale.edge_grains(0));
    // An eighth short, so that the valley has ended where vertices no longer know the river.
    valley.min(vertex.river.reach(scale) / 8 * 7).max(1)
}
