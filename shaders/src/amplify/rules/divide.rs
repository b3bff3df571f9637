//! How far the middle of an edge rises as a divide between the drains of its ends.
//!
//! A new drain cuts the ground; a divide is what the drains around it leave. So the middle of an
//! edge rises over both ends only where nothing beside the edge stands higher: on a hillside ground
//! goes on evenly, and crests go on from level to level, sharp and without bumps. What a divide
//! gains is bounded by the room under the crust elevation C, less a reserve for finer crests, and
//! most of it comes from the coarse levels: valleys are as deep as they are long.

use super::fold::RiseDraws;
use crate::amplify::arith::{mix, mul_q16, ratio};
use crate::amplify::fixed::{Q16, q16};
use crate::amplify::vertex::EdgeContext;

/// Least bulge, as a share of the full one, and how much the draw adds to it. Crests of even height
/// go on; where the draw decided most of it they were rows of knobs.
const DRAWN_BULGE: [i32; 2] = [q16(0.6), q16(0.4)];

/// Share of the bulge that worn land loses.
const WORN_LOSS: i32 = q16(0.65);

/// First level whose bulges fade where the land is worn.
const FIRST_WORN_LEVEL: u32 = 5;

/// First level whose divides must be crests already: coarser ones are the first of their kind.
const FIRST_CREST_LEVEL: u32 = 3;

/// Height that ground beside an edge may have over its middle, as a share of the slope, before the
/// edge is a hillside altogether.
const CREST_TOLERANCE: i32 = 2;

/// Room under C that a level leaves to finer ones: an edge's length times its land's steepness by
/// this number, but no more than a share of all the relief.
const RESERVE: i32 = 12;

/// That share: a quarter.
const MOST_RESERVE: i32 = 4;

/// Least and greatest part of the room that a crest takes, by level; the last holds for all that
/// follow.
const PART_OF_ROOM: [[i32; 2]; 4] = [
    [q16(0.15), q16(0.5)],
    [q16(0.3), q16(0.65)],
    [q16(0.4), q16(0.75)],
    [q16(0.4), q16(0.8)],
];

/// How much of a bulge a level keeps; the last holds for all that follow.
const KEPT_BULGE: [i32; 9] = [
    q16(1.37329),
    q16(1.37329),
    q16(2.0),
    q16(2.0),
    q16(1.0),
    q16(0.7),
    q16(0.5),
    q16(0.4),
    q16(0.3),
];

crate::wgsl::shared!(
    DRAWN_BULGE,
    WORN_LOSS,
    FIRST_WORN_LEVEL,
    FIRST_CREST_LEVEL,
    CREST_TOLERANCE,
    RESERVE,
    MOST_RESERVE,
    PART_OF_ROOM,
    KEPT_BULGE,
);

/// How level the ends of an edge are, Q16: 1 where they are, 0 where one stands a whole `slope`
/// above the other, and 0 where ground beside the edge stands half a slope above it.
pub(super) fn evenness(context: &EdgeContext, slope: i32) -> i32 {
    let rise = (context.a.height - context.b.height).abs();
    let even = ratio((slope - rise).max(0), slope.max(1));
    if context.level < FIRST_CREST_LEVEL {
        even
    } else {
        mul_q16(even, crest_share(context, slope))
    }
}

/// How far an edge is a crest, Q16: 1 where nothing beside it stands above its middle.
fn crest_share(context: &EdgeContext, slope: i32) -> i32 {
    let middle = context.a.height + (context.b.height - context.a.height) / 2;
    let beside = context.beside.iter().flatten().map(|corner| corner.height);
    let over = beside.max().unwrap_or(middle) - middle;
    Q16 - ratio(over.max(0), (slope / CREST_TOLERANCE).max(1))
}

/// How much a crest gains over the higher end in land of a tangent `steep`: a draw of the `bulge`
/// (grains), bounded by the room that the crust leaves.
pub(super) fn gain(context: &EdgeContext, draws: RiseDraws, steep: i32, bulge: i32) -> i32 {
    let worn = i32::from(context.new.worn);
    let free = mul_q16(
        mul_q16(bulge, fading(context.level, worn)),
        DRAWN_BULGE[0] + mul_q16(draws.xi, DRAWN_BULGE[1]),
    );
    let room = room(context, steep);
    // Saturates, half-way there where the two are equal, so that summits stay apart.
    let part = part(context.level, draws.chi).max(draws.crest);
    let saturated = mul_q16(ratio(free, free + room + 1), part);
    mul_q16(room, saturated)
}

/// Room between the higher end and the crust elevation C, grains.
pub(super) fn room(context: &EdgeContext, steep: i32) -> i32 {
    let new = context.new;
    let [a, b] = [context.a.height, context.b.height];
    let relief = (new.crust - a.min(b)).max(0);
    let finer = mul_q16(context.length / RESERVE, steep);
    (new.crust - finer.min(relief / MOST_RESERVE) - a.max(b)).max(0)
}

/// Most that a crest takes of the room, between the least and the greatest draw; Q16. Little while
/// edges are longer than the spacing of valleys: where a coarse vertex stood near C already, the
/// land around it would fill up to a table under C, and no crest could stand out.
pub(super) fn part(level: u32, chi: i32) -> i32 {
    let [least, greatest] = PART_OF_ROOM[level.min(3) as usize];
    mix(least, greatest, chi)
}

/// Bulges fade below the spacing of valleys, some kilometres: hillslopes are cut by shallow gullies
/// only, and by fewer where the land is worn. Q16.
fn fading(level: u32, worn: i32) -> i32 {
    let kept = KEPT_BULGE[level.min(8) as usize];
    if level < FIRST_WORN_LEVEL {
        kept
    } else {
        kept - mul_q16(mul_q16(kept, worn), WORN_LOSS)
    }
}
