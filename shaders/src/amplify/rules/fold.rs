//! Folds: ranges and the longitudinal valleys between them, along the fold axis f of an orogeny
//! (paper 000 §4.1, the direction in which an uplift folds its crust).
//!
//! Stripes of phasor noise lie across f: anticlines, where the draws of the coarse levels are high
//! and bulges great, and synclines, where both are low. They bend with the axis, fork and end. All
//! coarse levels see the same stripes, so a crest goes on from one edge to the next.
//!
//! Ranges of one spacing and one height are no belt:
//!
//! - Great ranges and folds lie over each other. Their packets hold few waves and differ in their
//!   wavelengths: ranges are unevenly spaced, lie en echelon and end.
//! - Along the axis culminations, in which all ranges are high, change with depressions.
//! - The level that summits reach sinks in troughs: basins lie between ranges of unequal height.
//! - Crests lean to the belt's front, on whose side they are steep (vergence). The front lies where
//!   the crust falls off: an axis has no sign.
//! - Age wears great ranges down first. Ridges of folded strata are left of old belts, as in the
//!   Appalachians; land that was never folded has none.

use super::noise::{CornerCache, fbm};
use super::ocean::phasor::{PacketCache, StripeNoise};
use super::ocean::{across, unit_axis};
use super::preset::Rules;
use crate::amplify::arith::{
    length, linear_step, mix, mul_q16, ratio, saturate, smoothstep, square,
};
use crate::amplify::fixed::{Q16, difference, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::{EdgeContext, Vertex};

/// Great ranges, 35 km apart in the mean: packets of 104 km, three waves each.
const RANGES: StripeNoise = StripeNoise {
    cell: 25,
    waves: q16(3.0),
    spread: q16(0.4),
    seed: 0xf01d_0001,
};

/// Folds, 14 km apart in the mean: ridges of the Zagros and of the Appalachians stand 10 to 30 km
/// apart.
const FOLDS: StripeNoise = StripeNoise {
    cell: 24,
    waves: q16(3.6),
    spread: q16(0.35),
    seed: 0xf01d_0002,
};

/// One beyond the last level that folds shape: its edges are shorter than a sixth of a fold.
const FOLD_LEVELS: u32 = 5;

/// Levels on which the level that summits reach sinks.
const SUNKEN_LEVELS: usize = 2;

/// How much great ranges and folds count on a level; the last holds for all that follow.
const WEIGHTS: [[i32; 2]; 3] = [[q16(1.2), 0], [q16(1.0), q16(0.9)], [q16(0.6), q16(1.4)]];

/// Agreement of the packets at which stripes set in, and at which they are full.
const PRESENCE: [i32; 2] = [q16(0.05), q16(0.15)];

/// Culminations and depressions: noise whose waves are 200 and 100 km long.
const CULMINATION_CELL: u32 = 26;
const CULMINATION_SEED: u32 = 0xf01d_0003;

/// Noise at which a depression ends, and from which on a culmination is full.
const CULMINATION: [i32; 2] = [q16(-0.3), q16(0.1)];

/// Share of their grip on the draws that folds keep in a depression.
const DEPRESSED: i32 = q16(0.9);

/// Strength that age leaves to great ranges and to folds of old belts.
const WORN: [i32; 2] = [0, q16(0.9)];

/// Presence of hills in forelands that were never folded, at most, and in old belts.
const HILLS: [i32; 2] = [q16(0.72), q16(0.95)];

/// How much a full anticline adds to a bulge, and a syncline takes from it.
const FOLDED_BULGE: i32 = q16(3.0);

/// Least share of the room that the crest of a full anticline takes.
const CREST: i32 = q16(0.9);

/// How far the level that summits reach sinks from a range's crest to the trough beside it, as a
/// share of the relief; by level. Level 0 has great ranges, level 1 folds: each has edges of half a
/// wave of its own.
const SUNKEN: [i32; SUNKEN_LEVELS] = [q16(0.12), q16(0.05)];

/// How far a crest leans to its front at most.
const VERGENCE: i32 = q16(0.6);

/// Slope of the crust across folds at which they lean as far as they may: 10 m per km.
const FRONTAL_SLOPE: i32 = q16(0.01);

crate::wgsl::shared!(
    RANGES,
    FOLDS,
    FOLD_LEVELS,
    FOLD_WEIGHTS = WEIGHTS,
    PRESENCE,
    CULMINATION_CELL,
    CULMINATION_SEED,
    CULMINATION,
    DEPRESSED,
    LEFT_BY_AGE = WORN,
    BELT_HILLS = HILLS,
    FOLDED_BULGE,
    CREST,
    SUNKEN,
    SUNKEN_LEVELS = SUNKEN_LEVELS as u32,
    VERGENCE,
    FRONTAL_SLOPE,
);

/// The level that summits reach at the vertex that halves an edge, grains: on the crest of a range
/// the mean of its ends', in the basin beside it little above their ground.
pub fn summits(rules: &Rules, level: u32, new: &Vertex, [a, b]: [&Vertex; 2]) -> i32 {
    let is_folded = rules.landforms && new.fold != [0; 3];
    let Some(&sunken) = SUNKEN.get(level as usize).filter(|_| is_folded) else {
        return new.crust;
    };
    let [a, b] = [a, b].map(|end| end.height.max(0));
    let relief = (new.crust - a - (b - a) / 2).max(0);
    let axis = FoldAxis::of(new);
    let [ranges, folds] = axis.strengths();
    let wave = if level == 0 {
        axis.wave(RANGES, ranges, 0)
    } else {
        axis.wave(FOLDS, folds, 0)
    };
    // In a depression crests sink, too.
    let low = (Q16 - wave.height).max((Q16 - axis.culmination()) / 2);
    new.crust - mul_q16(relief, mul_q16(mul_q16(low, wave.share), sunken))
}

/// Random numbers of an edge's rise, and how folds change its bulge; Q16.
#[derive(Clone, Copy, Debug)]
pub(super) struct RiseDraws {
    /// How far the bulge, and the middle of a hillside, are drawn up.
    pub(super) xi: i32,
    /// How much of the room a crest takes, and how steep the ground may stand.
    pub(super) chi: i32,
    /// Factor of the bulge.
    pub(super) bulge: i32,
    /// Least share of the room that a crest takes.
    pub(super) crest: i32,
}

impl RiseDraws {
    /// The draws of a new vertex: its own, and on the coarse levels of folded land those of its
    /// fold.
    pub(super) fn of(context: &EdgeContext) -> Self {
        let new = context.new;
        let [xi, chi] = [0, 1].map(|k| share(new.seed, k));
        if context.level >= FOLD_LEVELS || new.fold == [0; 3] {
            return Self {
                xi,
                chi,
                bulge: Q16,
                crest: 0,
            };
        }
        let Fold {
            height,
            presence,
            culmination,
        } = Fold::at(context);
        let strength = mul_q16(presence, culmination);
        Self {
            xi: mix(xi, height, presence),
            chi: mix(chi, height, presence),
            bulge: (Q16 + mul_q16(mul_q16(2 * height - Q16, strength), FOLDED_BULGE)).max(0),
            crest: mul_q16(mul_q16(square(height), strength), CREST),
        }
    }
}

/// Where in a fold the middle of an edge lies; shares in Q16.
#[derive(Clone, Copy, Debug)]
struct Fold {
    /// 0 in the syncline, 1 on the anticline.
    height: i32,
    /// How far the land is folded.
    presence: i32,
    /// 0 in a depression along the axis, 1 in a culmination.
    culmination: i32,
}

impl Fold {
    fn at(context: &EdgeContext) -> Self {
        let axis = FoldAxis::of(context.new);
        let lean = axis.lean(context);
        let [ranges, folds] = axis.strengths();
        let waves = [
            axis.wave(RANGES, ranges, lean),
            axis.wave(FOLDS, folds, lean),
        ];
        let weights = WEIGHTS[context.level.min(2) as usize];
        let swing = [0, 1].map(|k| {
            let FoldWave { height, share } = waves[k];
            mul_q16(mul_q16(height - Q16 / 2, share), weights[k])
        });
        let share = waves[0].share.max(waves[1].share);
        let culmination = axis.culmination();
        Self {
            height: saturate(Q16 / 2 + swing[0] + swing[1]),
            presence: mul_q16(share, mix(DEPRESSED, Q16, culmination)),
            culmination,
        }
    }
}

/// A set of stripes at a place; shares in Q16.
struct FoldWave {
    /// 0 in the trough, 1 on the crest.
    height: i32,
    /// How far it is there.
    share: i32,
}

/// The way that folds run at a vertex.
struct FoldAxis<'a> {
    vertex: &'a Vertex,
    /// Across them; a unit tangent times 32767.
    across: [i16; 3],
    /// How far neighbours' axes agree, Q16.
    agreement: i32,
}

impl<'a> FoldAxis<'a> {
    fn of(vertex: &'a Vertex) -> Self {
        // Scaled, or folds would widen where axes differ.
        let (unit, size) = unit_axis(vertex.fold);
        Self {
            vertex,
            across: across(vertex.direction, unit),
            agreement: 2 * size,
        }
    }

    /// A set of stripes of such a strength, whose crests lean so far towards `across`, Q16.
    fn wave(&self, stripes: StripeNoise, strength: i32, lean: i32) -> FoldWave {
        if strength == 0 {
            return FoldWave {
                height: Q16 / 2,
                share: 0,
            };
        }
        let cache = &mut PacketCache::default();
        let phasor = stripes.at(cache, self.vertex.direction, self.across);
        // The sine is positive on the flank that `across` points to: the crest moves there.
        let lean = mul_q16(mul_q16(phasor.sine, phasor.cosine), lean);
        let [onset, full] = PRESENCE;
        FoldWave {
            height: saturate((phasor.cosine + lean + Q16) / 2),
            share: mul_q16(smoothstep(onset, full, phasor.presence), strength),
        }
    }

    /// Shares that age has left of great ranges and of folds, Q16.
    fn strengths(&self) -> [i32; 2] {
        let [foreland, belt] = HILLS;
        let old = linear_step(foreland, belt, i32::from(self.vertex.hills));
        let worn = i32::from(self.vertex.worn);
        WORN.map(|left| mul_q16(mix(Q16, mul_q16(left, old), worn), self.agreement))
    }

    /// How high ranges stand, from depressions along the axis to culminations; Q16.
    fn culmination(&self) -> i32 {
        let noise = fbm(
            &mut [CornerCache::default(); 2],
            self.vertex.direction,
            CULMINATION_CELL,
            Q16 / 2,
            CULMINATION_SEED,
        );
        let [depression, full] = CULMINATION;
        smoothstep(depression, full, noise)
    }

    /// How far crests at the middle of an edge lean across the axis, Q16: to the side on which the
    /// crust falls off, less the nearer the edge comes to the axis.
    fn lean(&self, context: &EdgeContext) -> i32 {
        let way = difference(context.b.direction, context.a.direction);
        let unit = (length(way[0], way[1], way[2]) >> 15).max(1);
        let part =
            |i: usize| (way[i] / unit).clamp(-0x8000, 0x8000) * i32::from(self.across[i]) / 0x8000;
        let cosine = 2 * (part(0) + part(1) + part(2));
        let fall = (context.a.crust - context.b.crust) / 2;
        let full = mul_q16(context.length / 2, FRONTAL_SLOPE).max(1);
        let share = ratio(fall.abs(), full) * fall.signum();
        mul_q16(mul_q16(share, cosine.clamp(-Q16, Q16)), VERGENCE)
    }
}

#[cfg(test)]
#[path = "fold_tests.rs"]
mod tests;
