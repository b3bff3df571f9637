//! Phasor noise: stripes of one direction and about one wavelength, that fork and end as real
//! faults do.
//!
//! Source: Tricard et al., Procedural phasor noise, 2019; it takes the phase of the sparse
//! convolution of Lagae et al., Procedural noise using sparse Gabor convolution, 2009, which paper
//! 000 §5 names. One wave packet lies in each cell of a lattice of 2^`cell` direction units, at a
//! place drawn by hash. Its phase is 0 or ½, so the noise is the same for a direction and its
//! opposite: ridge directions have no sign.

use crate::amplify::arith::{cos_turn, isqrt, mul_q16, ratio, signed_ratio};
use crate::amplify::fixed::{Q16, q16};
use crate::amplify::rules::noise::cell_hash;
use crate::wgsl::WgslValue;

/// Weight of all packets from which on a point counts as covered by them: three quarters of the
/// mean, 0.46 of a packet at its middle. Where all are far the nearest alone would decide, and its
/// region would end in a scarp.
const FULL_WEIGHT: i32 = q16(0.35) << 4;

/// Bits of a packet's phase and presence: two squares of them fit 32.
const PHASE_BITS: u32 = 15;

crate::wgsl::shared!(FULL_WEIGHT, PHASE_BITS);

/// Stripes of one direction and about one wavelength.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StripeNoise {
    /// A lattice's cell of 2^`cell` direction units holds one wave packet; 18..=26.
    pub cell: u32,
    /// Wavelengths in a cell, Q16.
    pub waves: i32,
    /// A packet's wavelength lies within this share of the noise's, so that stripes are no grating;
    /// Q16.
    pub spread: i32,
    /// Where the random numbers begin.
    pub seed: u32,
}

impl WgslValue for StripeNoise {
    fn type_name() -> String {
        "StripeNoise".into()
    }

    fn expression(&self) -> String {
        let Self {
            cell,
            waves,
            spread,
            seed,
        } = self;
        format!("StripeNoise({cell}u, {waves}, {spread}, {seed}u)")
    }
}

/// Phase and presence of the stripes at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Phasor {
    /// Cosine of the phase, -1..1 in Q16: 1 on crests, -1 in troughs.
    pub cosine: i32,
    /// Sine of the phase, -1..1 in Q16: 1 on the flank a quarter wave along the axis from a crest. It
    /// changes its sign with the axis.
    pub sine: i32,
    /// How far the packets agree, 0..1 in Q16: 0 where stripes fork or end.
    pub presence: i32,
}

/// A wave packet: its place, and the hash that drew it.
#[derive(Clone, Copy, Debug, Default)]
struct Packet {
    place: [i32; 3],
    hash: u32,
}

/// The packets of a cell and of those around it; points of a patch share them.
#[derive(Clone, Copy, Debug)]
pub struct PacketCache {
    home: [i32; 3],
    packets: [Packet; 27],
}

impl Default for PacketCache {
    /// A cell that does not exist: addresses have 14 bits at most.
    fn default() -> Self {
        Self {
            home: [i32::MIN; 3],
            packets: [Packet::default(); 27],
        }
    }
}

impl StripeNoise {
    /// The stripes at a point. `axis` is the direction across them, components times 32767. `cache`
    /// must be used with this noise alone; it saves work and changes no result.
    pub fn at(&self, cache: &mut PacketCache, point: [i32; 3], axis: [i16; 3]) -> Phasor {
        // A packet reaches one cell far, so 27 of them matter.
        let home = point.map(|c| c >> self.cell);
        if cache.home != home {
            *cache = PacketCache {
                home,
                packets: core::array::from_fn(|k| self.packet(home, k as i32)),
            };
        }
        let mut sum = PacketSum::default();
        for packet in &cache.packets {
            let away = [0, 1, 2].map(|i| point[i].wrapping_sub(packet.place[i]));
            if let Some(weight) = self.weight(away) {
                sum.add(self.turn(packet, away, axis), weight);
            }
        }
        sum.phasor()
    }

    /// The `k`th of the 27 packets around a cell.
    fn packet(&self, home: [i32; 3], k: i32) -> Packet {
        let at = [
            home[0] + k % 3 - 1,
            home[1] + k / 3 % 3 - 1,
            home[2] + k / 9 - 1,
        ];
        let hash = cell_hash(at[0] as u32, at[1] as u32, at[2] as u32, self.seed);
        // Ten bits of place an axis. `turn` takes the phase from the top bit, and the pitch from
        // bits that the place has too.
        let place = [0, 1, 2].map(|i| {
            let inside = ((hash >> (10 * i) & 1023) as i32) << (self.cell - 10);
            (at[i] << self.cell).wrapping_add(inside)
        });
        Packet { place, hash }
    }

    /// Weight of a packet at a distance from its middle: (1 - d²)⁴ times 16; `None` a cell away.
    fn weight(&self, away: [i32; 3]) -> Option<i32> {
        // Fifteen bits of a cell: with eight, weights have steps that show as a grid.
        let near = away.map(|x| (x >> (self.cell - 15)).unsigned_abs());
        if near.into_iter().any(|x| x > 0x7fff) {
            return None;
        }
        let square = ((near[0] * near[0] + near[1] * near[1] + near[2] * near[2]) >> 14) as i32;
        if square >= Q16 {
            return None;
        }
        let fall = mul_q16(Q16 - square, Q16 - square);
        // Four bits more than a share, for where all packets are far.
        Some(mul_q16(fall << 4, fall))
    }

    /// Phase of a packet at a distance from its middle; a whole turn is 2¹⁶.
    fn turn(&self, packet: &Packet, away: [i32; 3], axis: [i16; 3]) -> i32 {
        let along = mul_q16(away[0], 2 * i32::from(axis[0]))
            + mul_q16(away[1], 2 * i32::from(axis[1]))
            + mul_q16(away[2], 2 * i32::from(axis[2]));
        let drawn = (packet.hash >> 7 & 0xffff) as i32;
        let pitch = Q16 - self.spread + mul_q16(drawn, 2 * self.spread);
        // A phase of 0 or ½ makes the noise even in its axis.
        let half_turn = ((packet.hash >> 31) << 15) as i32;
        (mul_q16(along, mul_q16(self.waves, pitch)) >> (self.cell - 16)) + half_turn
    }
}

/// Sum of the packets at a point, as complex numbers.
#[derive(Clone, Copy, Debug, Default)]
struct PacketSum {
    real: i32,
    imaginary: i32,
    weight: i32,
}

impl PacketSum {
    fn add(&mut self, turn: i32, weight: i32) {
        self.real += mul_q16(cos_turn(turn), weight);
        // The sine is the cosine a quarter turn earlier.
        self.imaginary += mul_q16(cos_turn(turn - 0x4000), weight);
        self.weight += weight;
    }

    fn phasor(self) -> Phasor {
        let all = self.real.unsigned_abs() | self.imaginary.unsigned_abs() | self.weight as u32;
        let bits = 32 - all.leading_zeros();
        let [x, y, weight] =
            [self.real, self.imaginary, self.weight].map(|v| to_phase_bits(v, bits));
        let size = isqrt((x * x) as u32 + (y * y) as u32) as i32;
        Phasor {
            // All packets out of reach or cancelled: any phase serves, its presence is 0.
            cosine: if size == 0 {
                Q16
            } else {
                signed_ratio(x, size)
            },
            sine: if size == 0 { 0 } else { signed_ratio(y, size) },
            presence: mul_q16(ratio(size, weight.max(1)), ratio(self.weight, FULL_WEIGHT)),
        }
    }
}

/// A number of at most `bits` bits brought to [`PHASE_BITS`], so that little is lost where all
/// packets are far.
const fn to_phase_bits(v: i32, bits: u32) -> i32 {
    if bits > PHASE_BITS {
        v >> (bits - PHASE_BITS)
    } else {
        v << (PHASE_BITS - bits)
    }
}

#[cfg(test)]
#[path = "phasor_tests.rs"]
mod tests;
