//! The ocean floor's relief, laid on once the subdivision is done (paper 000 §5).
//!
//! Three layers: transform faults, narrow troughs perpendicular to the ridge, hundreds of
//! kilometres long; abyssal hills, low waves parallel to it, here high and there hardly to be seen;
//! and fine gradient noise. The first two follow the recorded ridge direction r, are strong where
//! the floor is young and are buried by sediment as it ages. All fade out towards the shore, and
//! none rises above the sea.

pub mod phasor;

use super::noise::{CornerCache, fbm};
use crate::amplify::arith::{length, mul_q16, ratio, saturate, smoothstep, square};
use crate::amplify::fixed::{ONE, Q16, metres, million_years, q16};
use crate::amplify::vertex::Vertex;
use phasor::{PacketCache, StripeNoise};

/// Mean edge of a control mesh whose planet carries the full relief, grains.
const FULL_RELIEF_EDGE: i32 = metres(52_000);

/// Depth from which on the sea floor carries the full relief, grains. A shelf 130 m deep keeps a
/// fiftieth of it.
const FULL_RELIEF_DEPTH: i32 = metres(2_500);

/// Age at which half of the young floor's relief is left, 1/64 My.
const HALF_AGE: i32 = million_years(25);

/// Fine gradient noise.
const FINE: Roughness = Roughness {
    height: metres(120),
    cell: 21,
    gain: q16(0.48),
    seed: 0x0cea_0001,
};

/// Coarse gradient noise.
const COARSE: Roughness = Roughness {
    height: metres(260),
    cell: 25,
    gain: q16(0.55),
    seed: 0x0cea_0002,
};

/// How far wavelengths of faults and hills differ from their mean, Q16.
const PITCH_SPREAD: i32 = q16(0.15);

/// Transform faults: packets of 200 km, three waves each, run on as far as they agree.
const FAULTS: StripeNoise = StripeNoise {
    cell: 26,
    waves: q16(3.0),
    spread: PITCH_SPREAD,
    seed: 0x0cea_0003,
};

/// Abyssal hills: packets of 13 km, two waves each.
const HILLS: StripeNoise = StripeNoise {
    cell: 22,
    waves: q16(2.0),
    spread: PITCH_SPREAD,
    seed: 0x0cea_0004,
};

/// Depth of a fault's trough under the level floor beside it, grains.
const FAULT_DEPTH: i32 = metres(900);

/// Agreement of the packets at which faults set in, and at which they are full.
const FAULT_PRESENCE: [i32; 2] = [q16(0.15), q16(0.7)];

/// Length of the mean ridge direction at which faults and hills set in, and at which they are full:
/// where the directions that it is the mean of are 80° apart, and where they are 40°.
const AGREEMENT: [i32; 2] = [q16(0.77), q16(0.94)];

/// Mean height of abyssal hills over the mean floor, grains.
const HILL_HEIGHT: i32 = metres(180);

/// Share of a fault, and of a hill, that sediment never buries.
const UNBURIED: [i32; 2] = [Q16 / 5, Q16 / 4];

/// Gradient noise of some octaves.
struct Roughness {
    /// Height where the noise is 1, grains.
    height: i32,
    /// Binary logarithm of the longest wavelength, in direction units.
    cell: u32,
    /// Amplitude of an octave, as a share of the one before; Q16.
    gain: i32,
    seed: u32,
}

impl Roughness {
    /// The noise at a vertex, about -1..1 in Q16.
    fn at(&self, cache: &mut [CornerCache], vertex: &Vertex) -> i32 {
        fbm(cache, vertex.direction, self.cell, self.gain, self.seed)
    }
}

/// Noise drawn for the last vertex: vertices of a patch share most of it. It saves work and changes
/// no result.
#[derive(Clone, Debug, Default)]
pub struct OceanCache {
    /// One per octave: waves of 6.5 km to 1.6 m.
    fine: [CornerCache; 13],
    /// One per octave: waves of 104 to 13 km.
    coarse: [CornerCache; 4],
    faults: PacketCache,
    hills: PacketCache,
}

/// Offset of the sea floor at a vertex, grains. `edge` is the mean edge of the control mesh,
/// grains: on small planets the relief shrinks with it.
pub fn relief(cache: &mut OceanCache, vertex: &Vertex, edge: i32) -> i32 {
    let depth = -vertex.height;
    if depth <= 0 {
        return 0;
    }
    let fine = FINE.at(&mut cache.fine, vertex);
    let coarse = COARSE.at(&mut cache.coarse, vertex);
    let rough = mul_q16(FINE.height, fine) + mul_q16(COARSE.height, coarse);
    // No spreading is even: hills of one patch are up to five times as high as another's.
    let uneven = Q16 / 4 + saturate(Q16 / 2 + coarse);
    // Small planets have small oceans.
    let size = ratio(edge, FULL_RELIEF_EDGE);
    let offset = mul_q16(rough + ridge_relief(cache, vertex, uneven), size);
    // At most half the depth upwards, so that no relief reaches the surface.
    mul_q16(offset, smoothstep(0, FULL_RELIEF_DEPTH, depth)).min(depth / 2)
}

/// The ridge's direction, of unit length, and how far the directions around agree, 0..1 in Q16. Mean
/// directions of places that disagree are short, and have no direction where they are opposed.
fn ridge(vertex: &Vertex) -> ([i16; 3], i32) {
    let (unit, size) = unit_axis(vertex.ridge);
    let [none, full] = AGREEMENT;
    (unit, smoothstep(none, full, 2 * size))
}

/// Transform faults and abyssal hills, grains; `uneven` is the hills' height relative to the mean,
/// Q16.
fn ridge_relief(cache: &mut OceanCache, vertex: &Vertex, uneven: i32) -> i32 {
    if vertex.oceanic == 0 || vertex.ridge == [0; 3] {
        return 0;
    }
    // Hyperbolic in the age: sediment buries quickly first, then ever more slowly.
    let young = ratio(HALF_AGE, HALF_AGE + i32::from(vertex.ocean_age));
    let unburied = UNBURIED.map(|least| least + mul_q16(young, Q16 - least));
    let (ridge, agreement) = ridge(vertex);
    let faults = mul_q16(faults(&mut cache.faults, vertex, ridge), unburied[0]);
    let hills = mul_q16(hills(&mut cache.hills, vertex, ridge, uneven), unburied[1]);
    mul_q16(
        mul_q16(faults + hills, agreement),
        i32::from(vertex.oceanic),
    )
}

/// Transform faults before sediment, grains: sharp troughs.
fn faults(cache: &mut PacketCache, vertex: &Vertex, ridge: [i16; 3]) -> i32 {
    let stripes = FAULTS.at(cache, vertex.direction, ridge);
    // ((1 - cos) / 2)⁴ is a trough where the cosine is -1.
    let trough = square(square((Q16 - stripes.cosine) / 2));
    let [onset, full] = FAULT_PRESENCE;
    let presence = smoothstep(onset, full, stripes.presence);
    // A sixth of the depth stands as rims above the floor, the rest lies below it.
    mul_q16(mul_q16(FAULT_DEPTH, Q16 / 6 - trough), presence)
}

/// Abyssal hills before sediment, grains: waves along the ridge.
fn hills(cache: &mut PacketCache, vertex: &Vertex, ridge: [i16; 3], uneven: i32) -> i32 {
    // The floor spreads across its ridge.
    let spreading = across(vertex.direction, ridge);
    let stripes = HILLS.at(cache, vertex.direction, spreading);
    let wave = mul_q16(mul_q16(HILL_HEIGHT, uneven), stripes.cosine);
    mul_q16(wave, stripes.presence)
}

/// A mean of axes at unit length, and how long it is, at least 1; both times 32767. Means of axes
/// that differ are short.
pub(super) fn unit_axis(axis: [i16; 3]) -> ([i16; 3], i32) {
    let [x, y, z] = axis.map(i32::from);
    let size = length(x, y, z).clamp(1, 32_767);
    let unit = [x, y, z].map(|c| (c * 32_767 / size).clamp(-32_767, 32_767) as i16);
    (unit, size)
}

/// The direction along the ground at a place that is perpendicular to an axis; components times
/// 32767.
pub(super) fn across(direction: [i32; 3], axis: [i16; 3]) -> [i16; 3] {
    // 15 bits of each, so that their products fit 32.
    let n = direction.map(|c| c >> 16);
    let r = axis.map(i32::from);
    [(1, 2), (2, 0), (0, 1)].map(|(a, b)| {
        let cross = (n[a] * r[b] - n[b] * r[a]) / (ONE >> 16);
        cross.clamp(-32_767, 32_767) as i16
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::amplify::control::VertexKind;
    use crate::amplify::fixed::GRAINS;

    /// The relief at a vertex, from an empty cache.
    fn relief(vertex: &Vertex, edge: i32) -> i32 {
        super::relief(&mut OceanCache::default(), vertex, edge)
    }

    fn floor(y: i32, age_my: u16, depth_m: i32) -> Vertex {
        Vertex {
            direction: [ONE - 3_000, y, 40_000_000],
            height: -depth_m * GRAINS,
            kind: VertexKind::Sea,
            oceanic: 65_535,
            ocean_age: age_my * 64,
            ridge: [0, 32_767, 0],
            ..Vertex::default()
        }
    }

    fn spread(age: u16, depth: i32) -> f64 {
        let values: Vec<f64> = (0..2_000)
            .map(|i| f64::from(relief(&floor(i * 400_000, age, depth), 52_000 * GRAINS)) / 1024.0)
            .collect();
        let mean = values.iter().sum::<f64>() / 2_000.0;
        (values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / 2_000.0).sqrt()
    }

    #[test]
    fn young_floor_is_rougher_than_old() {
        assert!(spread(2, 2_600) > 1.3 * spread(150, 5_500));
        assert!(
            (60.0..400.0).contains(&spread(2, 2_600)),
            "{}",
            spread(2, 2_600)
        );
    }

    #[test]
    fn shelves_are_smooth_and_stay_under_water() {
        assert!(spread(100, 100) < 12.0, "{}", spread(100, 100));
        for i in 0..2_000 {
            for depth in [1, 10, 300, 3_000] {
                let vertex = floor(i * 777_777, 5, depth);
                assert!(vertex.height + relief(&vertex, 52_000 * GRAINS) < 0);
            }
        }
        assert_eq!(relief(&floor(1, 1, -5), 52_000 * GRAINS), 0);
    }

    /// Where the ridge's directions around a place are at right angles their mean is one of two, by
    /// chance. Whichever it is, the floor is the same: no scarp opens between the two.
    #[test]
    fn directions_that_disagree_make_no_scarp() {
        for i in 0..2_000 {
            let at = |z| Vertex {
                ridge: [0, 16_383, z],
                ..floor(i * 400_000, 2, 2_600)
            };
            let [a, b] = [16_383, -16_383].map(|z| relief(&at(z), 52_000 * GRAINS));
            assert_eq!(a, b, "{i}");
        }
    }

    /// A mean direction is shorter than those that it is the mean of. Its length is no wavelength:
    /// stripes keep theirs, and grow shallower.
    #[test]
    fn short_directions_bend_no_stripes() {
        for i in 0..2_000 {
            let at = |y| Vertex {
                ridge: [0, y, 0],
                ..floor(i * 400_000, 2, 2_600)
            };
            let [whole, short] = [32_767, 31_500].map(|y| relief(&at(y), 52_000 * GRAINS));
            assert!((whole - short).abs() < 200, "{i}: {whole} {short}");
        }
    }
}
