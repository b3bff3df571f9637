//! Meanders: how a river winds about the axis of its valley.
//!
//! The axis is a smooth curve from vertex to vertex ([`curve`](crate::amplify::curve)). The river
//! crosses it at both ends of a piece and in between once every half-wave, and swings from side to
//! side as a sine-generated curve does, whose direction is θ = ω sin φ (W. Langbein and L. Leopold,
//! River meanders, theory of minimum variance, 1966). With Bessel functions J of ω it is, in waves
//! of length λ over the axis,
//!
//! ```text
//! x = λ/2π (φ - J₂/J₀ sin 2φ),  y = λ/2π 2J₁/J₀ sin φ,  sinuosity 1/J₀
//! ```
//!
//! A wave is 11 widths long (10 to 14: L. Leopold and M. Wolman, River meanders, 1960), so that
//! bends have radii of two to three widths. Both pieces at a vertex have its wave there, its
//! winding and the way that it crosses, so the river runs on without a kink; within a piece waves
//! and swings are drawn uneven.
//!
//! Nothing here hangs on the level: a long piece has many bends, a short one few. Once a piece has
//! a handful, finer levels keep it whole ([`RiverSegment::kept`]), and the banks with it.
//!
//! [`RiverSegment::kept`]: crate::amplify::vertex::RiverSegment::kept

use super::estuary::OCTAVE;
use crate::amplify::arith::{
    cos_turn, length, linear_step, mix, mul_q16, ratio, saturate, smooth, smoothstep, square,
};
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::geometry::damped_projection;
use crate::amplify::seed::{centred_share, pcg, share};
use crate::amplify::vertex::RiverSegment;

/// Half a wave in widths of its river.
pub const HALF_WAVE: i32 = q16(5.5);

/// Fall of a river in its length: up to the first it winds fully, from the second on not at all.
const FALL: [i32; 2] = [q16(0.001), q16(0.01)];

/// Least winding that the draw leaves to a slow river, as a share of the full one, of ω = 1.6.
const LEAST_WINDING: i32 = q16(0.85);

/// Swing of a full winding in half-waves: 2J₁/J₀ of 1.6, over π; and how much of it the winding
/// takes evenly, the rest with its square.
const SWING: [i32; 2] = [q16(0.7967), q16(0.6)];

/// How far bends of a full winding lean over, in half-waves: J₂/J₀ of 1.6, over π; with the square
/// of the winding evenly, the rest with its fourth power.
const LEAN: [i32; 2] = [q16(0.1796), q16(0.5)];

/// Winding of the widest and of the narrowest bend that is drawn, as a share of its river's.
const UNEVEN: [i32; 2] = [q16(1.2), q16(0.55)];

/// Half-waves by which the draws move the middle of a piece along it, to either side, and spread
/// its halves: shares of them all.
const UNEVEN_WAVES: [i32; 2] = [q16(0.08), q16(0.07)];

/// Most half a wave by which its bends swing, as a share of that of its width.
const MOST_SWING: i32 = q16(1.25);

/// Most half-waves of a piece: those of greater ones would have no room in 32 bits. Only brooks on
/// coarse levels have more.
const MOST_WAVES: i32 = 4_000;

/// Longest axis of a winding piece, grains: a few bends of the greatest river, far beyond any edge
/// of a planet's control mesh.
const LONGEST_AXIS: i32 = metres(200_000);

/// Distances from the axis in half-waves: beyond the second the river counts as straight, up to the
/// first not at all.
const FAR_AWAY: [i32; 2] = [q16(1.25), q16(2.0)];

/// Sixteenths of the reach of mean bends over which a flood plain is laid: wider ones cut into the
/// sides of their valley, which stand as bluffs over them.
const BELT: i32 = 13;

/// Tries for the nearest point on either side, a quarter of a half-wave apart.
const TRIES: i32 = 4;

/// Steps from the best of them towards the nearest point.
const STEPS: u32 = 3;

/// π in Q16.
const PI: i32 = q16(core::f64::consts::PI);

crate::wgsl::shared!(
    HALF_WAVE,
    FALL,
    LEAST_WINDING,
    SWING,
    LEAN,
    UNEVEN,
    UNEVEN_WAVES,
    MOST_SWING,
    MOST_WAVES,
    LONGEST_AXIS,
    FAR_AWAY,
    BELT,
    TRIES,
    WANDER_STEPS = STEPS,
    PI,
);

/// How much a river with a fall (Q16) winds at a vertex of a seed, as [`Vertex::winding`]: 0..1 in
/// Q15, negative where it crosses to the right.
///
/// It crosses to the side of a tributary: so its last bend before the junction lies on the other
/// side, and does not cut the tributary off.
///
/// [`Vertex::winding`]: crate::amplify::vertex::Vertex::winding
pub fn winding(fall: i32, seed: u32, to_left: bool) -> i16 {
    let slow = Q16 - linear_step(FALL[0], FALL[1], fall);
    let winding = mul_q16(slow, mix(LEAST_WINDING, Q16, share(seed, 30))) / 2;
    let winding = winding.min(0x7fff) as i16;
    if to_left { winding } else { -winding }
}

/// A place beside the axis in grains: along it, and across to its left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Beside {
    /// Along the axis, grains.
    pub along: i32,
    /// To the left of it, grains.
    pub across: i32,
}

/// How the river of a segment winds about its axis.
#[derive(Clone, Copy, Debug)]
pub struct Wander {
    /// Half-waves from end to end.
    waves: i32,
    /// Half-waves that would fit with the waves of either end, Q16.
    fitting: [i32; 2],
    /// Half a wave at the ends, grains.
    half_waves: [i32; 2],
    /// Winding at the ends, Q16.
    winding: [i32; 2],
    /// Side of the first bend: 1 to the left, -1 to the right.
    side: i32,
    seed: u32,
}

/// The river at a share of its axis.
#[derive(Clone, Copy, Debug)]
struct Wave {
    /// Half-waves up to there, Q16.
    phase: i32,
    /// Half-waves in the length of the axis at the rate there, Q16.
    rate: i32,
    /// Half a wave, grains.
    half_wave: i32,
    /// Half a wave as its ends have it, grains.
    even: i32,
    /// How far the belt of its bends reaches from the axis, grains.
    belt: i32,
    /// How far bends reach from the axis, grains; negative where odd ones lie to the left.
    swing: i32,
    /// How far they lean over, grains.
    lean: i32,
}

/// The nearest point of a winding river.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// Where it lies: share of the axis, Q16.
    pub along: i32,
    /// The way from it, grains along and across the axis.
    pub off: [i32; 3],
    /// Tangent there, grains a half-wave.
    pub tangent: [i32; 3],
    /// Distance to it, grains.
    pub distance: i32,
    /// Distance to the belt that its bends sweep, grains; at most that to the river.
    pub belt: i32,
}

impl Wander {
    /// The wander of a segment with an axis of so many grains, and half-waves of a river of its
    /// width at its ends; `None` where it does not wind.
    pub fn new(segment: &RiverSegment, axis: i32, half_waves: [i32; 2]) -> Option<Self> {
        let winding = [0, 1].map(|end| {
            // Tides straighten a funnel.
            let tide = ratio(i32::from(segment.tide[end]), OCTAVE);
            mul_q16(2 * i32::from(segment.winding[end].abs()), Q16 - tide)
        });
        let longest = half_waves[0].max(half_waves[1]);
        let shortest = half_waves[0].min(half_waves[1]);
        let is_long = axis > LONGEST_AXIS || axis / MOST_WAVES >= shortest;
        if winding == [0, 0] || axis < longest || is_long {
            return None;
        }
        let seeds = segment.ends.map(seed_of);
        let is_right = segment.winding.map(|winding| winding < 0);
        let fitting = half_waves.map(|half_wave| (axis / (half_wave >> 8).max(1)) << 8);
        Some(Self {
            waves: waves(fitting, i32::from(is_right[0] != is_right[1])),
            fitting,
            half_waves,
            winding,
            side: 1 - 2 * i32::from(is_right[0]),
            seed: pcg(seeds[0] ^ pcg(seeds[1])),
        })
    }

    /// The river at a share of the axis (Q16), where the axis has `speed` grains a whole.
    fn wave(&self, at: i32, speed: i32) -> Wave {
        let (phase, rate) = self.phase(at);
        let half_wave = mul_q16(speed, ratio(Q16, rate));
        let even = mix(self.half_waves[0], self.half_waves[1], at);
        let drawn = half_wave.min(mul_q16(even, MOST_SWING));
        let mean = mix(self.winding[0], self.winding[1], at);
        let uneven = mix(UNEVEN[0], UNEVEN[1], self.unevenness(phase));
        let winding = mul_q16(mean, uneven);
        let squared = square(winding);
        let lean = mul_q16(squared, mix(squared, Q16, LEAN[1]));
        Wave {
            phase,
            rate,
            half_wave,
            even,
            belt: mul_q16(even, swing(mean)) / 16 * BELT,
            swing: self.side * mul_q16(drawn, swing(winding)),
            lean: mul_q16(half_wave, mul_q16(LEAN[0], lean)),
        }
    }

    /// Half-waves up to a share of the axis, and their rate there; Q16. A cubic that has the rates
    /// of the ends, with a draw in between.
    fn phase(&self, at: i32) -> (i32, i32) {
        let rest = Q16 - at;
        let middle = mul_q16(at, rest);
        let [first, last] = self.fitting;
        let back = rest - at;
        let [moved, spread] = [0, 1].map(|k| {
            2 * self.waves * mul_q16(centred_share(self.seed, k), UNEVEN_WAVES[k as usize])
        });
        let phase = self.waves * smooth(at) + mul_q16(first, mul_q16(middle, rest))
            - mul_q16(last, mul_q16(middle, at))
            + mul_q16(moved + mul_q16(spread, back), 16 * square(middle));
        let rate = self.waves * 6 * middle + mul_q16(first, mul_q16(rest, Q16 - 3 * at))
            - mul_q16(last, mul_q16(at, 2 * Q16 - 3 * at))
            + mul_q16(moved + mul_q16(spread, back), 32 * mul_q16(middle, back))
            - mul_q16(spread, 32 * square(middle));
        (phase.clamp(0, self.waves * Q16), rate.max(Q16 / 4))
    }

    /// How narrow a bend is drawn, 0..1 in Q16; half-way at the ends of the piece.
    fn unevenness(&self, phase: i32) -> i32 {
        let crossing = phase >> 16;
        let [here, next] = [crossing, crossing + 1].map(|crossing| {
            if crossing <= 0 || crossing >= self.waves {
                Q16 / 2
            } else {
                share(self.seed, 1 + crossing as u32)
            }
        });
        mix(here, next, smooth(phase & 0xffff))
    }

    /// The nearest point of the river to a place beside the axis at a share of it (Q16), where the
    /// axis has `speed` grains a whole.
    pub fn nearest(&self, at: i32, speed: i32, place: Beside) -> Nearest {
        let wave = self.wave(at, speed);
        let near = self.bounded(&wave, wave.first_try(self.waves, place), place);
        // Once more from there, as waves differ along the piece.
        let there = saturate(at + mul_q16(near, ratio(Q16, wave.rate)));
        let moved = mul_q16(speed, there - at);
        let place = Beside {
            along: place.along - moved,
            ..place
        };
        let wave = self.wave(there, speed);
        let way = self.bounded(&wave, 0, place);
        let along = if way == -wave.phase {
            0
        } else if way == self.waves * Q16 - wave.phase {
            Q16
        } else {
            saturate(there + mul_q16(way, ratio(Q16, wave.rate)))
        };
        let off = wave.off(way, place);
        let straight = length(place.along + moved, place.across, 0);
        let far = smoothstep(
            mul_q16(wave.even, FAR_AWAY[0]),
            mul_q16(wave.even, FAR_AWAY[1]),
            straight,
        );
        let distance = mix(distance(off), straight, far);
        Nearest {
            along,
            off,
            tangent: wave.tangent(way),
            distance,
            belt: distance.min((straight - wave.belt).max(0)),
        }
    }

    /// The way to the nearest point by steps from a way, within the piece.
    fn bounded(&self, wave: &Wave, mut way: i32, place: Beside) -> i32 {
        let [first, last] = [-wave.phase, self.waves * Q16 - wave.phase];
        for _ in 0..STEPS {
            let step = damped_projection(wave.tangent(way), wave.off(way, place));
            way = (way + step).clamp(first, last);
        }
        way
    }

    /// The place of the river at a share of its axis (Q16), where the axis has `speed` grains a
    /// whole, from there.
    pub fn at(&self, at: i32, speed: i32) -> Beside {
        let [along, across, _] = self.wave(at, speed).place(0);
        Beside { along, across }
    }
}

impl Wave {
    /// The place of the river so many half-waves on, Q16.
    fn place(&self, way: i32) -> [i32; 3] {
        let phase = self.phase + way;
        let lean = mul_q16(self.lean, sin_turn(phase));
        let swing = mul_q16(self.swing, sin_turn(phase >> 1));
        [mul_q16(self.half_wave, way) - lean, swing, 0]
    }

    /// The best of some ways to the nearest point, in a piece of so many half-waves.
    fn first_try(&self, waves: i32, place: Beside) -> i32 {
        let [first, last] = [-self.phase, waves * Q16 - self.phase];
        let ways = (-TRIES..=TRIES).map(|k| (k * (Q16 / TRIES)).clamp(first, last));
        ways.min_by_key(|&way| distance(self.off(way, place)))
            .unwrap_or(0)
    }

    /// The vector from there to a place.
    fn off(&self, way: i32, place: Beside) -> [i32; 3] {
        let [along, across, _] = self.place(way);
        [place.along - along, place.across - across, 0]
    }

    /// The tangent there, grains a half-wave.
    fn tangent(&self, way: i32) -> [i32; 3] {
        let phase = self.phase + way;
        let lean = 2 * mul_q16(mul_q16(self.lean, PI), cos_turn(phase));
        let swing = mul_q16(mul_q16(self.swing, PI), cos_turn(phase >> 1));
        [self.half_wave - lean, swing, 0]
    }
}

/// How far bends of a winding reach from the axis, in half-waves, Q16.
const fn swing(winding: i32) -> i32 {
    mul_q16(
        SWING[0],
        mul_q16(winding, mix(square(winding), Q16, SWING[1])),
    )
}

/// The whole number of half-waves, odd or even, that fits best.
const fn waves(fitting: [i32; 2], odd: i32) -> i32 {
    // Rather fewer: short waves have sharp bends.
    let mean = (fitting[0] / 2 + fitting[1] / 2) / 16 * 15;
    let pairs = (mean - odd * Q16 + Q16) >> 17;
    let waves = 2 * pairs + odd;
    if waves > 0 { waves } else { 2 - odd }
}

const fn distance([along, across, _]: [i32; 3]) -> i32 {
    length(along, across, 0)
}

/// sin(2πt) of a phase whose whole turn is 2¹⁶, Q16.
const fn sin_turn(t: i32) -> i32 {
    cos_turn(t - 0x4000)
}

/// A seed of a place.
const fn seed_of([x, y, z]: [i32; 3]) -> u32 {
    pcg(x as u32 ^ pcg(y as u32 ^ pcg(z as u32)))
}

#[cfg(test)]
#[path = "meander_tests.rs"]
mod tests;
