//! Bits of noise.

use super::arithmetic::any_share;
use pangaea_shaders::amplify::rules::noise::{CornerCache, cell_hash, fade, fbm, gradient};
use pangaea_shaders::amplify::rules::ocean::phasor::{PacketCache, StripeNoise};
use pangaea_tests::gpu::assert_twin;

const NOISE: &str = "amplify/rules/noise";
const PHASOR: &str = "amplify/rules/ocean/phasor";

#[test]
fn gradient_noise_has_the_same_bits() {
    assert_twin(NOISE, "cell_hash", Some, |(x, y, z, seed)| {
        cell_hash(x, y, z, seed)
    });
    assert_twin(NOISE, "fade", |(t,)| Some((any_share(t),)), |(t,)| fade(t));
    let cell = |(p, cell, seed): ([i32; 3], u32, u32)| Some((p, 1 + cell % 30, seed));
    assert_twin(NOISE, "gradient", cell, |(p, cell, seed)| {
        gradient(&mut CornerCache::default(), p, cell, seed)
    });
}

#[test]
fn sums_of_octaves_have_the_same_bits() {
    type Input = (u32, [i32; 3], u32, i32, u32);
    let input = |(octaves, p, cell, gain, seed): Input| {
        Some((octaves % 14, p, 1 + cell % 30, any_share(gain), seed))
    };
    assert_twin(NOISE, "fbm", input, |(octaves, p, cell, gain, seed)| {
        let mut caches = [CornerCache::default(); 14];
        fbm(&mut caches[..octaves as usize], p, cell, gain, seed)
    });
}

#[test]
fn stripes_have_the_same_bits() {
    type Input = ((u32, i32, i32, u32), [i32; 3], [i16; 3]);
    let input = |((cell, waves, spread, seed), point, axis): Input| {
        // Up to eight waves in a cell.
        let noise = (18 + cell % 9, waves & 0x7_ffff, spread & 0x7fff, seed);
        Some((noise, point, axis))
    };
    assert_twin(PHASOR, "stripe_noise_at", input, |(noise, point, axis)| {
        let (cell, waves, spread, seed) = noise;
        let noise = StripeNoise {
            cell,
            waves,
            spread,
            seed,
        };
        let phasor = noise.at(&mut PacketCache::default(), point, axis);
        (phasor.cosine, phasor.sine, phasor.presence)
    });
}
