//! Banks, levees and flood plains.
//!
//! Beside the bed the bank goes on to rise. Floods drop the most where they leave the bed: the
//! levee falls away from the river, 1 in 500, to a flood plain that stands half as high over the
//! water. Old arms, bars and swales leave relief in it, of the river's own measure: gradient
//! noise, so that it has no direction.

use super::reach::Reach;
use crate::amplify::arith::{mul_q16, ratio, smooth, square};
use crate::amplify::fixed::{Q16, metres, q16};
use crate::amplify::rules::noise::{CornerCache, fbm};

/// Widths of a bank: of its height, and of half its bed.
const BANK_WIDTH: [i32; 2] = [2, 4];

/// How far a levee reaches, in its own height: it falls 1 in 500.
const LEVEE_LENGTH: i32 = 500;

/// Share of the height over the water that relief may take: what is left stays dry.
const MOST_RELIEF: i32 = q16(0.8);

/// Most height of relief, grains.
const HIGHEST_RELIEF: i32 = metres(3) / 2;

/// Distance from a bank at which the relief is full, grains, and in half-widths of the bed.
const FULL_RELIEF: [i32; 2] = [metres(20), 1];

/// Binary logarithm of the longest wave in direction units: 410 m on Earth.
const LONGEST_WAVE: u32 = 17;

/// Amplitude of an octave, as a share of the one before.
const GAIN: i32 = q16(0.55);

const OCTAVES: usize = 7;

const SEED: u32 = 0x0f10_0d01;

crate::wgsl::shared!(
    BANK_WIDTH,
    LEVEE_LENGTH,
    MOST_RELIEF,
    HIGHEST_RELIEF,
    FULL_RELIEF,
    LONGEST_WAVE,
    PLAIN_GAIN = GAIN,
    PLAIN_OCTAVES = OCTAVES as u32,
    PLAIN_SEED = SEED,
);

/// Noise drawn for the last vertex, one per octave: waves of 410 to 6 m. It saves work and changes
/// no result.
pub(super) type PlainCache = [CornerCache; OCTAVES];

/// Ground outside the bed of a river as its floods leave it, grains: at the water's level at the
/// bed's rim, above it everywhere else.
pub(super) fn flood_plain(
    cache: &mut PlainCache,
    direction: [i32; 3],
    reach: &Reach,
    distance: i32,
) -> i32 {
    let bank = reach.bank();
    let beyond_bed = distance - reach.half_bed;
    let width = (BANK_WIDTH[0] * bank).max(reach.half_bed / BANK_WIDTH[1]);
    let beyond_bank = beyond_bed - width;
    if beyond_bank < 0 {
        // As steep as the bed's rim below, level at its top.
        let left = Q16 - ratio(beyond_bed, width);
        return reach.water + mul_q16(bank, Q16 - square(left));
    }
    // Half of the bank's height is left at the levee's foot, where it ends in a curve.
    let fallen = smooth(ratio(beyond_bank, LEVEE_LENGTH * bank));
    let over_water = bank - mul_q16(bank / 2, fallen);
    reach.water + over_water + relief(cache, direction, reach, over_water, beyond_bank)
}

/// Relief of a flood plain, grains.
fn relief(
    cache: &mut PlainCache,
    direction: [i32; 3],
    reach: &Reach,
    over_water: i32,
    beyond_bank: i32,
) -> i32 {
    let far = FULL_RELIEF[0] + FULL_RELIEF[1] * reach.half_bed;
    let most = mul_q16(over_water, MOST_RELIEF).min(HIGHEST_RELIEF);
    let height = mul_q16(most, smooth(ratio(beyond_bank, far)));
    if height == 0 {
        return 0;
    }
    let noise = fbm(cache, direction, LONGEST_WAVE, GAIN, SEED);
    mul_q16(height, noise.clamp(-Q16, Q16))
}

/// The higher of two heights, with a round edge between them that begins where they differ by
/// `edge` grains and is a quarter of that high.
pub(super) fn smooth_max(a: i32, b: i32, edge: i32) -> i32 {
    let near = (edge - (a - b).abs()).max(0);
    let rounded = mul_q16(near, ratio(near, edge.max(1))) / 4;
    a.max(b) + rounded
}
