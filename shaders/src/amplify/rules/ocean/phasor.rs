//! Phasor noise: stripes of one direction and about one wavelength, that fork and end as real
//! faults do.
//!
//! Source: Tricard et al., Procedural phasor noise, 2019; it takes the phase of the sparse
//! convolution of Lagae et al., Procedural noise using sparse Gabor convolution, 2009, which paper
//! 000 §5 names. One wave packet lies in each cell of a lattice of 2^`cell` direction units, at a
//! place drawn by hash. Its phase is 0 or ½, so the noise is the same for a direction and its
//! opposite: ridge directions have no sign.

use super::super::super::arith::{cos_turn, isqrt, mul_q16, ratio};
use super::super::super::fixed::Q16;
use super::super::noise::cell_hash;

/// Phase and presence of the stripes at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Phasor {
    /// Cosine of the phase, -1..1 in Q16: 1 on crests, -1 in troughs.
    pub cosine: i32,
    /// How far the packets agree, 0..1 in Q16: 0 where stripes fork or end.
    pub presence: i32,
}

/// A wave packet: where it lies, and the hash that drew it.
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
    /// Those of no cell: addresses have 14 bits at most.
    fn default() -> Self {
        Self {
            home: [i32::MIN; 3],
            packets: [Packet::default(); 27],
        }
    }
}

impl PacketCache {
    fn around(home: [i32; 3], cell: u32, seed: u32) -> Self {
        let packet = |k: usize| {
            let k = k as i32;
            let at = [
                home[0] + k % 3 - 1,
                home[1] + k / 3 % 3 - 1,
                home[2] + k / 9 - 1,
            ];
            let hash = cell_hash(at[0] as u32, at[1] as u32, at[2] as u32, seed);
            // Ten bits of place an axis, two bits more of phase and pitch.
            let inside = |i: u32| ((hash >> (10 * i) & 1023) as i32) << (cell - 10);
            Packet {
                place: [0, 1, 2].map(|i| (at[i] << cell).wrapping_add(inside(i as u32))),
                hash,
            }
        };
        Self {
            home,
            packets: core::array::from_fn(packet),
        }
    }
}

/// The stripes at a point. `axis` is the direction across them, components times 32767; `waves`
/// their number in a cell, Q16; `cell` 18..=26. `cache` is what the last point of the same `cell`
/// and `seed` left; it changes no bit.
pub fn phasor(
    cache: &mut PacketCache,
    point: [i32; 3],
    axis: [i16; 3],
    cell: u32,
    waves: i32,
    seed: u32,
) -> Phasor {
    let (mut real, mut imaginary, mut total) = (0_i32, 0_i32, 0_i32);
    let home = point.map(|c| c >> cell);
    if cache.home != home {
        *cache = PacketCache::around(home, cell, seed);
    }
    for &Packet { place, hash } in &cache.packets {
        let away = [0, 1, 2].map(|i| point[i].wrapping_sub(place[i]));
        // Fifteen bits of a cell: with eight, weights have steps that show as a grid.
        let near = away.map(|x| (x >> (cell - 15)).unsigned_abs());
        if near[0].max(near[1]).max(near[2]) > 0x7fff {
            continue;
        }
        let square = ((near[0] * near[0] + near[1] * near[1] + near[2] * near[2]) >> 14) as i32;
        if square >= Q16 {
            continue;
        }
        let fall = mul_q16(Q16 - square, Q16 - square);
        // Four bits more than a share, for where all packets are far.
        let weight = mul_q16(fall << 4, fall);
        let along = mul_q16(away[0], 2 * i32::from(axis[0]))
            + mul_q16(away[1], 2 * i32::from(axis[1]))
            + mul_q16(away[2], 2 * i32::from(axis[2]));
        // Pitch 0.85..1.15, so that the stripes are not a grating.
        let pitch = 55_706 + mul_q16((hash >> 7 & 0xffff) as i32, 19_660);
        let turn =
            (mul_q16(along, mul_q16(waves, pitch)) >> (cell - 16)) + ((hash >> 31) << 15) as i32;
        real += mul_q16(cos_turn(turn), weight);
        imaginary += mul_q16(cos_turn(turn - 0x4000), weight);
        total += weight;
    }
    // Brought to fifteen bits, so that two squares fit and little is lost where packets are far.
    let bits = 32 - (real.unsigned_abs() | imaginary.unsigned_abs() | total as u32).leading_zeros();
    let fit = |v: i32| {
        if bits > 15 {
            v >> (bits - 15)
        } else {
            v << (15 - bits)
        }
    };
    let (x, y) = (fit(real), fit(imaginary));
    let size = isqrt((x * x) as u32 + (y * y) as u32) as i32;
    let cosine = if size == 0 {
        Q16
    } else {
        signed_ratio(x, size)
    };
    Phasor {
        cosine,
        presence: ratio(size, fit(total).max(1)),
    }
}

/// x / size in Q16, -1..1.
const fn signed_ratio(x: i32, size: i32) -> i32 {
    if x < 0 {
        -ratio(-x, size)
    } else {
        ratio(x, size)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::super::fixed::ONE;
    use super::*;

    /// The stripes at a point that nothing was asked before.
    fn phasor(point: [i32; 3], axis: [i16; 3], cell: u32, waves: i32, seed: u32) -> Phasor {
        super::phasor(&mut PacketCache::default(), point, axis, cell, waves, seed)
    }

    /// Energy of the noise's changes over a step of a sixteenth of a wave along a direction.
    fn energy(step: [i32; 3]) -> f64 {
        let axis = [0, 32_767, 0];
        let mut sum = 0.0;
        for i in 0..60 {
            for j in 0..60 {
                let p = [ONE - 1_000_000, i * 2_600_003, j * 2_600_003];
                let q = [p[0], p[1] + step[1], p[2] + step[2]];
                let [a, b] = [p, q].map(|p| phasor(p, axis, 24, 2 * Q16, 5));
                let change = f64::from(a.cosine - b.cosine);
                sum += change * change;
            }
        }
        sum
    }

    #[test]
    fn stripes_lie_across_their_axis() {
        let d = 1 << 19;
        assert!(
            energy([0, d, 0]) > 5.0 * energy([0, 0, d]),
            "{} {}",
            energy([0, d, 0]),
            energy([0, 0, d])
        );
    }

    #[test]
    fn spectrum_peaks_at_the_wavelength() {
        // A cell of 2²⁴ holds two waves: over 2²³ the phase turns once, over 2²² half.
        let correlation = |d: i32| {
            (0..3_000)
                .map(|i| {
                    let p = [ONE - 7_000_000, (i % 55) * 3_100_007, (i / 55) * 3_100_007];
                    let at = |y: i32| {
                        f64::from(phasor([p[0], y, p[2]], [0, 32_767, 0], 24, 2 * Q16, 9).cosine)
                    };
                    at(p[1]) * at(p[1] + d)
                })
                .sum::<f64>()
        };
        assert!(correlation(1 << 22) < 0.0);
        assert!(correlation(1 << 23) > 0.0);
        assert!(correlation(1 << 23) < correlation(1 << 18));
    }

    #[test]
    fn opposite_axes_agree() {
        for i in 0..200 {
            let p = [ONE / 2 + i * 77_777, i * 1_234_567, ONE / 3];
            let (a, b) = (
                phasor(p, [9_000, 30_000, -8_000], 25, Q16, 3),
                phasor(p, [-9_000, -30_000, 8_000], 25, Q16, 3),
            );
            // Floors of negative numbers differ by a unit of a far packet.
            assert!(
                (a.cosine - b.cosine).abs() < 512 || a.presence < 3_000,
                "{a:?} {b:?}"
            );
        }
    }

    #[test]
    fn stripes_have_no_steps() {
        // 1.5 m on Earth: the phase turns by two units of Q16, the cosine changes by 14 and
        // rounding; more where packets disagree.
        for i in 0..1_000 {
            let p = [ONE / 2 + i * 777_777, i * 1_234_567, ONE / 3 - i * 55_555];
            let at = |p| phasor(p, [9_000, 30_000, -8_000], 26, 3 * Q16, 3);
            for axis in 0..3 {
                let mut q = p;
                q[axis] += 500;
                let (a, b) = (at(p), at(q));
                assert!(
                    mul_q16((a.cosine - b.cosine).abs(), a.presence) < 40,
                    "{p:?} {a:?} {b:?}"
                );
            }
        }
    }

    #[test]
    fn a_cache_changes_no_bit() {
        let mut cache = PacketCache::default();
        for i in 0..500 {
            let p = [ONE / 2 + i * 777_777, i * 1_234_567, ONE / 3];
            let want = phasor(p, [9_000, 30_000, -8_000], 25, Q16, 3);
            assert_eq!(
                super::phasor(&mut cache, p, [9_000, 30_000, -8_000], 25, Q16, 3),
                want
            );
        }
    }

    #[test]
    fn bits_are_pinned() {
        let got = phasor([ONE / 2, ONE / 3, ONE / 4], [32_767, 0, 0], 24, Q16, 1);
        assert_eq!(
            got,
            Phasor {
                cosine: 24_594,
                presence: 63_275
            }
        );
    }
}
