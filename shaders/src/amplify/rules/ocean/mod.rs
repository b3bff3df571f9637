//! The ocean floor's relief, laid on once the subdivision is done (paper 000 §5).
//!
//! Three layers: transform faults, narrow troughs perpendicular to the ridge, hundreds of
//! kilometres long; abyssal hills, low waves parallel to it, here high and there hardly to be seen;
//! and fine gradient noise. The first two follow the recorded ridge direction r, are strong where
//! the floor is young and are buried by sediment as it ages. All fade out towards the shore, and
//! none rises above the sea.
//!
//! All three are dear, and are drawn at vertices of coarse levels alone, 200 m apart on an
//! Earth-sized planet. Finer ones lie between their edges' ends, off by a draw that halves with the
//! level: the spectrum goes on as the noise's would, at the price of land.

pub mod phasor;

use super::noise::{CornerCache, fbm};
use crate::amplify::arith::{length, mul_q16, ratio, saturate, smoothstep, square};
use crate::amplify::fixed::{ONE, Q16, metres, million_years, q16};
use crate::amplify::seed::share;
use crate::amplify::vertex::Vertex;
use crate::wgsl::WgslValue;
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
    octaves: 5,
    seed: 0x0cea_0001,
};

/// Coarse gradient noise.
const COARSE: Roughness = Roughness {
    height: metres(260),
    cell: 25,
    gain: q16(0.55),
    octaves: 4,
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
    octaves: usize,
    seed: u32,
}

impl WgslValue for Roughness {
    fn type_name() -> String {
        "Roughness".into()
    }

    fn expression(&self) -> String {
        let Self {
            height,
            cell,
            gain,
            octaves,
            seed,
        } = self;
        format!("Roughness({height}, {cell}u, {gain}, {octaves}u, {seed}u)")
    }
}

impl Roughness {
    /// The noise at a vertex, about -1..1 in Q16.
    fn at(&self, cache: &mut [CornerCache], vertex: &Vertex) -> i32 {
        fbm(cache, vertex.direction, self.cell, self.gain, self.seed)
    }
}

/// Last level whose vertices draw the long waves.
const SWELL_LEVEL: u8 = 8;

/// Most by which a vertex of the level after leaves the mean of its edge, grains; on each later
/// level it is [`FINE`]'s gain of that. Its mean square is that of the octave of its level.
const GRIT: i32 = 1_517;

crate::wgsl::shared!(
    FULL_RELIEF_EDGE,
    FULL_RELIEF_DEPTH,
    HALF_AGE,
    FINE,
    COARSE,
    FAULTS,
    HILLS,
    FAULT_DEPTH,
    FAULT_PRESENCE,
    AGREEMENT,
    HILL_HEIGHT,
    UNBURIED,
    SWELL_LEVEL = u32::from(SWELL_LEVEL),
    GRIT,
);

/// Noise drawn for the last vertex: vertices of a patch share most of it. It saves work and changes
/// no result.
#[derive(Clone, Debug, Default)]
pub struct OceanCache {
    /// One per octave: waves of 6.5 km to 400 m.
    fine: [CornerCache; FINE.octaves],
    /// One per octave: waves of 104 to 13 km.
    coarse: [CornerCache; COARSE.octaves],
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
    // Small planets have small oceans.
    let size = ratio(edge, FULL_RELIEF_EDGE);
    let offset = mul_q16(swell(cache, vertex), size);
    // At most half the depth upwards, so that no relief reaches the surface.
    mul_q16(offset, smoothstep(0, FULL_RELIEF_DEPTH, depth)).min(depth / 2)
}

/// Relief of the sea floor at a vertex, grains, as on an Earth-sized planet and far from shores.
pub fn swell(cache: &mut OceanCache, vertex: &Vertex) -> i32 {
    if vertex.level == 0 {
        drawn(cache, vertex)
    } else {
        vertex.swell
    }
}

/// The relief that a vertex of a coarse level draws, grains. On land there is none.
fn drawn(cache: &mut OceanCache, vertex: &Vertex) -> i32 {
    if vertex.height >= 0 {
        return 0;
    }
    let fine = FINE.at(&mut cache.fine, vertex);
    let coarse = COARSE.at(&mut cache.coarse, vertex);
    let rough = mul_q16(FINE.height, fine) + mul_q16(COARSE.height, coarse);
    // No spreading is even: hills of one patch are up to five times as high as another's.
    let uneven = Q16 / 4 + saturate(Q16 / 2 + coarse);
    rough + ridge_relief(cache, vertex, uneven)
}

/// The relief between vertices of an edge and of the faces beside it needs that of each; 0 where the
/// new vertex draws its own.
pub fn swells<const N: usize>(vertices: [&Vertex; N]) -> [i32; N] {
    // An edge has the level of one of its ends.
    if vertices.iter().all(|v| v.level < SWELL_LEVEL) {
        return [0; N];
    }
    vertices.map(|vertex| match vertex.level {
        0 => drawn(&mut OceanCache::default(), vertex),
        _ => vertex.swell,
    })
}

/// Settles the relief at the vertex that halves an edge, which has that of the flat face there.
pub fn settle(cache: &mut OceanCache, new: &mut Vertex, ends: [&Vertex; 2]) {
    if new.level <= SWELL_LEVEL {
        new.swell = drawn(cache, new);
    } else {
        new.swell += grit(new, ends);
    }
}

/// How far the vertex that halves an edge lies off the sea floor between its ends, grains.
fn grit(new: &Vertex, ends: [&Vertex; 2]) -> i32 {
    if ends.iter().all(|end| end.height >= 0) {
        return 0;
    }
    let finer = SWELL_LEVEL + 1..new.level;
    let most = finer.fold(GRIT, |most, _| mul_q16(most, FINE.gain));
    mul_q16(2 * share(new.seed, 14) - Q16, most)
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
mod tests;
