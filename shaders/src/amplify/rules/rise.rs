//! How high the ground between two drains stands: what all graphs of ours share.
//!
//! Real slopes rise from their drains as steeply as their rock lets them, and meet in crests. So the middle of an edge
//! that drains at both ends bulges above them, by no more than the slope over half the edge from the lower end, and by
//! no more than a part of what the crust leaves. It always stands above its lower end: every vertex can drain there,
//! and no closed hollow is made.

use super::super::arith::{mix, mul_q16, ratio};
use super::super::seed::share;
use super::super::vertex::EdgeContext;
use super::landform::{steepness, worn};
use super::preset::Rules;
use super::terrain::ordered;

/// Height of the middle of an edge. `bulge` (Q16) is the share of the full slope by which it overtops the higher end.
pub fn height(rules: &Rules, context: &EdgeContext, bulge: i32) -> i32 {
    let new = context.new;
    let (low, high) = ordered(context.a.height, context.b.height);
    let slope = mul_q16(context.length / 2, steepness(rules, new));
    let (xi, chi) = (share(new.seed, 0), share(new.seed, 1));
    let room = (new.crust - high).max(0);
    let free = mul_q16(
        mul_q16(mul_q16(slope, bulge), fading(context.level, worn(new))),
        8_000 + mul_q16(xi, 80_000),
    );
    // Saturates at 0.4 to 0.8 of the room, half-way there where the two are equal, so that summits stay apart.
    let gain = mul_q16(room, mul_q16(ratio(free, free + room + 1), 26_000 + mul_q16(chi, 26_000)));
    // Without a bulge the ground lies between its ends.
    let hang = mix(low, high, hollow(context.level) + mul_q16(xi, 16_000));
    let crest = if gain > 0 && bulge >= 49_152 { high + gain } else { hang + gain };
    let steepest = low + mul_q16(slope, 62_000 + mul_q16(chi, 30_000));
    let least = mix(low, high, 21_000) + (context.length >> 12).max(1);
    crest.min(steepest).max(least)
}

/// Bulges fade below the spacing of valleys, some 6 km: hillslopes are cut by shallow gullies only, and by fewer where
/// the land is worn. Q16.
const fn fading(level: u32, worn: i32) -> i32 {
    let keen = match level {
        0..=2 => 90_000,
        3 => 78_000,
        4 => 50_000,
        5 => 32_000,
        6 => 24_000,
        7 => 20_000,
        _ => 18_000,
    };
    if level < 3 { keen } else { keen - mul_q16(mul_q16(keen, worn), 26_000) }
}

/// Least share of the rise that the middle of a hanging edge takes: at coarse levels little, so that valleys are wide
/// and crests stand out, at fine ones nearly half, so that slopes are even. Q16.
const fn hollow(level: u32) -> i32 {
    if level < 6 { 18_000 + 1_500 * level as i32 } else { 26_000 }
}
