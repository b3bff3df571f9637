//! Random numbers without state: a vertex's seed comes from its parents' seeds, its draws from its
//! own.
//!
//! Paper 002 §7 sums the parents' seeds, which is linear: far relatives share draws. Here both go
//! through a permutation first. Neither depends on the order of the parents, on the view, nor on
//! the order of the work.
//!
//! ```
//! use pangaea_shaders::amplify::seed::{between, share};
//!
//! let seed = between(17, 4);
//! assert_eq!(seed, between(4, 17));
//! assert!((0..65_536).contains(&share(seed, 0)));
//! ```

use super::fixed::Q16;

/// Factor and increment of PCG's state, and the factor of its output.
const PCG_FACTOR: u32 = 747_796_405;
const PCG_STEP: u32 = 2_891_336_453;
const PCG_OUTPUT: u32 = 277_803_737;

/// Added to one of the parents: an odd number near 2³² over the golden ratio.
const PARENT_STEP: u32 = 0x9e37_79b9;

/// From a seed's draw to its next: odd, so that no two draws are the same number of the sequence.
const DRAW_STEP: u32 = 0x8549_1f4d;

crate::wgsl::shared!(PCG_FACTOR, PCG_STEP, PCG_OUTPUT, PARENT_STEP, DRAW_STEP,);

/// The PCG-RXS-M-XS permutation of 32 bits (M. O'Neill, PCG, 2014).
#[inline]
pub const fn pcg(value: u32) -> u32 {
    let state = value.wrapping_mul(PCG_FACTOR).wrapping_add(PCG_STEP);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(PCG_OUTPUT);
    (word >> 22) ^ word
}

/// Seed of the vertex between two others; the same for both orders.
#[inline]
pub const fn between(a: u32, b: u32) -> u32 {
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    // Without the inner permutation this would be linear in the seeds, as their sum is.
    pcg(low ^ pcg(high.wrapping_add(PARENT_STEP)))
}

/// The `k`th random number of a seed, 32 bits.
#[inline]
pub const fn draw(seed: u32, k: u32) -> u32 {
    pcg(seed.wrapping_add(k.wrapping_mul(DRAW_STEP)))
}

/// The `k`th random share ξ of a seed, Q16, 0..65,536 exclusive.
#[inline]
pub const fn share(seed: u32, k: u32) -> i32 {
    (draw(seed, k) >> 16) as i32
}

/// The `k`th random number of a seed in -½..½, Q16; at the same time its `k`th share less a half.
#[inline]
pub const fn centred_share(seed: u32, k: u32) -> i32 {
    share(seed, k) - Q16 / 2
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seed_does_not_depend_on_the_order_of_the_parents() {
        for k in 0..1000 {
            let (a, b) = (pcg(k), pcg(k + 7777));
            assert_eq!(between(a, b), between(b, a));
        }
    }

    #[test]
    fn shares_fill_their_range_evenly() {
        let mut bins = [0_u32; 16];
        for seed in 0..4096 {
            for k in 0..16 {
                bins[(share(seed, k) >> 12) as usize] += 1;
            }
        }
        assert!(bins.iter().all(|&n| n.abs_diff(4096) < 4 * 64), "{bins:?}");
    }

    #[test]
    fn draws_of_one_seed_and_of_relatives_differ() {
        let a = between(1, 2);
        assert_ne!(draw(a, 0), draw(a, 1));
        assert_ne!(between(a, 1), between(a, 2));
    }
}
