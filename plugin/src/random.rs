//! Counter-based random numbers.
//!
//! A number depends only on (seed, purpose, id, counter), never on what was drawn before it:
//! switching one process off does not change what the others draw, and neither the number of
//! threads nor the order of a loop can change a planet.

use crate::math::{TAU, sin_cos};
use bevy::math::DVec3;
use bevy::reflect::Reflect;

/// The use of a random number. Each purpose has a stream of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Reflect)]
#[repr(u64)]
pub enum Purpose {
    /// Centroids of the initial plates (paper 000 §3).
    PlateCentroids = 1,
    /// Motions of the initial plates.
    PlateMotion,
    /// Which plates carry continents.
    Continents,
    /// Warp of plate borders.
    BorderWarp,
    /// Warp of coasts and relief of the initial continents.
    Coast,
    /// Whether a plate rifts in this step (paper 000 §4.4).
    RiftTrigger,
    /// Shape and motion of a rift.
    RiftShape,
    /// Warp of rift lines.
    RiftWarp,
    /// Coherent noise of the relief (paper 000 §4.5).
    Relief,
    /// Points of the base mesh (paper 002 §4).
    BaseMesh,
    /// Relief of the base mesh between the samples of the crust.
    BaseRelief,
    /// The growth of rivers from the coasts (paper 002 §4).
    RiverGrowth,
    /// Seeds of the vertices of the control mesh.
    Control,
    /// Places whose relief is measured.
    ReliefSites = 100,
}

/// A stream of random numbers addressed by a counter.
///
/// ```
/// # use bevy_pangaea::random::{Purpose, Stream};
/// let stream = Stream::new(7, Purpose::RiftTrigger, 3);
/// assert!((0.0..1.0).contains(&stream.unit(0)));
/// // The tenth number does not depend on whether the first nine were drawn.
/// assert_eq!(stream.unit(9), Stream::new(7, Purpose::RiftTrigger, 3).unit(9));
/// ```
#[derive(Clone, Copy, Debug, Reflect)]
pub struct Stream {
    key: u64,
}

impl Stream {
    /// The stream of `purpose` for the thing `id` (a plate, a sample) of the planet `seed`.
    pub fn new(seed: u64, purpose: Purpose, id: u64) -> Self {
        Self {
            key: mix(mix(mix(seed) ^ purpose as u64) ^ id),
        }
    }

    /// 64 random bits.
    #[inline]
    pub fn bits(&self, counter: u64) -> u64 {
        mix(self.key ^ mix(counter))
    }

    /// A number in 0..1 (1 excluded).
    #[inline]
    pub fn unit(&self, counter: u64) -> f64 {
        // An f64 has 53 bits of precision.
        (self.bits(counter) >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// A number in `low..high`.
    #[inline]
    pub fn range(&self, counter: u64, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit(counter)
    }

    /// A direction, uniform on the sphere; uses the counters `2 counter` and `2 counter + 1`.
    pub fn direction(&self, counter: u64) -> DVec3 {
        // Slices of a sphere of equal height have equal areas (Archimedes).
        let z = self.range(2 * counter, -1.0, 1.0);
        let (s, c) = sin_cos(TAU * self.unit(2 * counter + 1));
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * c, r * s, z)
    }
}

/// A bijective mixer of 64 bits: two rounds of multiply and xor-shift (the finaliser of SplitMix64,
/// Steele, Lea and Flood 2014).
#[inline]
pub fn mix(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_uniform() {
        let stream = Stream::new(7, Purpose::PlateCentroids, 0);
        let n = 20_000;
        let mean = (0..n).map(|i| stream.direction(i)).sum::<DVec3>() / n as f64;
        assert!(mean.length() < 0.02, "{mean}");
        assert!((0..n).all(|i| (stream.direction(i).length() - 1.0).abs() < 1e-12));
    }

    #[test]
    fn streams_are_independent_of_each_other() {
        let a = Stream::new(1, Purpose::RiftTrigger, 3);
        let b = Stream::new(1, Purpose::RiftTrigger, 4);
        let c = Stream::new(1, Purpose::RiftShape, 3);
        assert!(a.bits(0) != b.bits(0) && a.bits(0) != c.bits(0) && a.bits(0) != a.bits(1));
        assert_eq!(a.bits(9), Stream::new(1, Purpose::RiftTrigger, 3).bits(9));
    }
}
