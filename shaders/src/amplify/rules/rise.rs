//! How high the ground between two drains stands: what all graphs of ours share.
//!
//! Real slopes rise from their drains as steeply as their rock lets them, and meet in crests. Every
//! vertex drains down one of its edges; between two that stand level there is a divide, and the
//! middle of their edge bulges above them. Where one stands higher by a whole slope there is none,
//! but a hillside, hollow as the profiles of its gullies are. The bulge is no more than the slope
//! over half the edge from the lower end, and no more than a part of what the crust leaves. It
//! always stands above its lower end: every vertex can drain there, and no closed hollow is made.

use super::super::arith::{mix, mul_q16, ratio};
use super::super::fixed::Q16;
use super::super::seed::share;
use super::super::vertex::EdgeContext;
use super::landform::{steepness, worn};
use super::preset::Rules;
use super::terrain::ordered;
use super::{FACE_LEVEL, fine};

/// Height of the middle of an edge. `bulge` (Q16) is the share of the full slope by which it
/// overtops the higher end.
pub fn height(rules: &Rules, context: &EdgeContext, bulge: i32) -> i32 {
    let new = context.new;
    let (low, high) = ordered(context.a.height, context.b.height);
    let small = context.level >= FACE_LEVEL;
    // An edge along a thin face is long, but the rock beside it is no larger than that of others.
    let length = if small {
        context.length.min(context.span)
    } else {
        context.length
    };
    let slope = mul_q16(length / 2, steepness(rules, new));
    let (xi, chi) = (share(new.seed, 0), share(new.seed, 1));
    // 1 between level ends, 0 where one is a whole slope above the other.
    let keen = ratio((slope - (high - low)).max(0), slope.max(1));
    let room = (new.crust - high).max(0);
    let free = mul_q16(
        mul_q16(
            mul_q16(mul_q16(slope, keen), bulge),
            fading(context.level, worn(new)),
        ),
        8_000 + mul_q16(xi, 80_000),
    );
    // Saturates, half-way there where the two are equal, so that summits stay apart.
    let gain = mul_q16(
        room,
        mul_q16(ratio(free, free + room + 1), part(context.level, chi)),
    );
    let hillside = if small {
        context.face + fine::rough(rules, context)
    } else {
        mix(low, high, hollow(context.level) + mul_q16(xi, 14_000))
    };
    let crest = mix(hillside, high, mul_q16(mul_q16(keen, keen), bulge.min(Q16))) + gain;
    let steepest = low + mul_q16(slope, 62_000 + mul_q16(chi, 30_000));
    let least = mix(low, high, 10_000) + (context.length >> 12).max(1);
    // The face drains to its lowest corner, which need not be an end of the edge.
    crest.min(steepest).max(if small {
        least.min(context.face)
    } else {
        least
    })
}

/// Most that a crest takes of the room, least and greatest draw; Q16. Little while edges are longer
/// than the spacing of valleys: where a coarse vertex stood near C already, the land around it
/// would fill up to a table under C, and no crest could stand out.
fn part(level: u32, chi: i32) -> i32 {
    let [least, greatest] = match level {
        0 => [4_000, 26_000],
        1 => [8_000, 42_000],
        2 => [16_000, 60_000],
        3 => [24_000, 62_000],
        _ => [28_000, 60_000],
    };
    mix(least, greatest, chi)
}

/// Bulges fade below the spacing of the smallest valleys, a kilometre or two: hillslopes are cut by
/// shallow gullies only, and by fewer where the land is worn. Q16.
const fn fading(level: u32, worn: i32) -> i32 {
    let keen = match level {
        0..=3 => 90_000,
        4 => 80_000,
        5 => 64_000,
        6 => 44_000,
        7 => 30_000,
        _ => 20_000,
    };
    if level < 3 {
        keen
    } else {
        keen - mul_q16(mul_q16(keen, worn), 26_000)
    }
}

/// Least share of the rise that the middle of a hillside takes: little, so that valleys are wide
/// and crests stand out. Q16.
const fn hollow(level: u32) -> i32 {
    12_000 + 1_500 * level as i32
}
