//! Gradient noise on integer directions: an exact lattice of cells of 2ᵏ units, from continents to
//! half a metre.
//!
//! A cell's address and the place within it are the high and low bits of a direction component, so
//! nothing is lost at any frequency: 3 mm on Earth, whatever the wavelength. Corner gradients are
//! the twelve edge directions of a cube, drawn by hash; the fade is the quintic 6t⁵ - 15t⁴ + 10t³
//! (K. Perlin, Improving noise, 2002). Shares in Q16.

use crate::amplify::arith::{mix, mul_q16};
use crate::amplify::fixed::Q16;

/// Binary logarithm of an edge of level 0, about 2²⁴ direction units.
pub(super) const EDGE_BITS: u32 = 24;

/// Factor and increment of the linear congruential generator of Numerical Recipes.
const CONGRUENTIAL_FACTOR: u32 = 1_664_525;
const CONGRUENTIAL_STEP: u32 = 1_013_904_223;

/// Draw the origin of a seed's lattice on an axis.
const AXIS_FACTOR: u32 = 0x9e37_79b9;
const ORIGIN_FACTOR: u32 = 0x85eb_ca6b;

/// From an octave's seed to the next one's.
const OCTAVE_STEP: u32 = 0x68bc_21eb;

crate::wgsl::shared!(
    CONGRUENTIAL_FACTOR,
    CONGRUENTIAL_STEP,
    AXIS_FACTOR,
    ORIGIN_FACTOR,
    OCTAVE_STEP,
    EDGE_BITS,
);

/// One step of the generator.
#[inline]
const fn congruential(x: u32) -> u32 {
    x.wrapping_mul(CONGRUENTIAL_FACTOR)
        .wrapping_add(CONGRUENTIAL_STEP)
}

/// A hash of a lattice cell, well mixed in all bits (three rounds in the manner of pcg3d, M.
/// Jarzynski and M. Olano, Hash functions for GPU rendering, 2020).
#[inline]
pub const fn cell_hash(x: u32, y: u32, z: u32, seed: u32) -> u32 {
    let mut a = congruential(x) ^ seed;
    let mut b = congruential(y);
    let mut c = congruential(z);
    a = a.wrapping_add(b.wrapping_mul(c));
    b = b.wrapping_add(c.wrapping_mul(a));
    c = c.wrapping_add(a.wrapping_mul(b));
    a ^= a >> 16;
    b ^= b >> 16;
    c ^= c >> 16;
    a = a.wrapping_add(b.wrapping_mul(c));
    b = b.wrapping_add(c.wrapping_mul(a));
    c = c.wrapping_add(a.wrapping_mul(b));
    c ^ (a >> 16) ^ (b << 16)
}

/// 6t⁵ - 15t⁴ + 10t³ of a share.
#[inline]
pub const fn fade(t: i32) -> i32 {
    // By Horner: t³(t(6t - 15) + 10).
    let cube = mul_q16(mul_q16(t, t), t);
    mul_q16(cube, mul_q16(t, 6 * t - 15 * Q16) + 10 * Q16)
}

/// Dot product of a corner's gradient, one of the twelve (±1, ±1, 0) and their like, with the
/// offset from it.
#[inline]
const fn gradient_dot(hash: u32, x: i32, y: i32, z: i32) -> i32 {
    // Sixteen cases, four of them twice, as in Perlin's table.
    let u = if hash & 8 == 0 { x } else { y };
    let v = if hash & 12 == 0 {
        y
    } else if hash & 13 == 12 {
        x
    } else {
        z
    };
    (if hash & 1 == 0 { u } else { -u }) + (if hash & 2 == 0 { v } else { -v })
}

/// The hashes drawn at the corners of the cell that was asked for last. Drawing them is most of the
/// work of the noise, and points of a patch share their cell.
#[derive(Clone, Copy, Debug)]
pub struct CornerCache {
    /// Number of the cell on each axis.
    address: [u32; 3],
    /// Hashes of the corners. The corner x, y, z cells (each 0 or 1) from `address` is item
    /// x + 2y + 4z.
    hashes: [u32; 8],
}

impl Default for CornerCache {
    /// A cell that does not exist: addresses have 31 bits at most.
    fn default() -> Self {
        Self {
            address: [u32::MAX; 3],
            hashes: [0; 8],
        }
    }
}

impl CornerCache {
    fn of(address: [u32; 3], cell: u32, seed: u32) -> Self {
        // The lattice is periodic: after its last cell comes its first.
        let top = u32::MAX >> cell;
        let hashes = [0, 1, 2, 3, 4, 5, 6, 7].map(|corner: u32| {
            let at = [0, 1, 2].map(|axis| (address[axis] + (corner >> axis & 1)) & top);
            // `gradient_dot` reads the low four bits: these come from the middle of the hash.
            cell_hash(at[0], at[1], at[2], seed) >> 7
        });
        Self { address, hashes }
    }

    /// The noise at a place in the cell, Q16 of its edge.
    #[inline]
    fn blend(&self, [x, y, z]: [i32; 3]) -> i32 {
        let [u, v, w] = [x, y, z].map(fade);
        let row = |j, k| self.blend_along_x(j, k, [x, y, z], u);
        let near = mix(row(0, 0), row(1, 0), v);
        let far = mix(row(0, 1), row(1, 1), v);
        mix(near, far, w)
    }

    /// The noise on the edge of the cell at (j, k) of its cross-section.
    #[inline]
    fn blend_along_x(&self, j: usize, k: usize, [x, y, z]: [i32; 3], fade_x: i32) -> i32 {
        let (y, z) = (y - j as i32 * Q16, z - k as i32 * Q16);
        let [near, far] = [0, 1].map(|i| self.hashes[i + 2 * j + 4 * k]);
        let near = gradient_dot(near, x, y, z);
        let far = gradient_dot(far, x - Q16, y, z);
        mix(near, far, fade_x)
    }
}

/// Gradient noise of wavelength 2^`cell` direction units at a point, about -1..1 in Q16, mean 0;
/// `cell` 1..=30. `cache` must be used with the same `cell` and `seed` in every call; it saves work
/// and changes no result.
///
/// Continuous with its first two derivatives, exact at any frequency: the lattice is addressed by
/// the bits themselves.
///
/// ```
/// use pangaea_shaders::amplify::fixed::ONE;
/// use pangaea_shaders::amplify::rules::noise::{CornerCache, gradient};
///
/// let mut cache = CornerCache::default();
/// let here = gradient(&mut cache, [ONE, 0, 0], 24, 5);
/// let beside = gradient(&mut cache, [ONE, 1_000, 0], 24, 5);
/// assert!((here - beside).abs() < 20, "a step of 3 m in waves of 52 km");
/// ```
pub fn gradient(cache: &mut CornerCache, point: [i32; 3], cell: u32, seed: u32) -> i32 {
    let mask = (1_u32 << cell) - 1;
    let mut address = [0_u32; 3];
    let mut place = [0_i32; 3];
    for axis in 0..3 {
        // Adding the origin may wrap: the lattice is periodic in 32 bits.
        let moved = (point[axis] as u32).wrapping_add(origin(axis as u32, seed));
        address[axis] = moved >> cell;
        let inside = moved & mask;
        // The place within the cell as a share of it, whatever its size.
        place[axis] = if cell > 16 {
            (inside >> (cell - 16)) as i32
        } else {
            (inside << (16 - cell)) as i32
        };
    }
    if cache.address != address {
        *cache = CornerCache::of(address, cell, seed);
    }
    cache.blend(place)
}

/// Origin of a seed's lattice on an axis: octaves must not share the zeros of their lattices.
#[inline]
const fn origin(axis: u32, seed: u32) -> u32 {
    (seed ^ axis.wrapping_mul(AXIS_FACTOR)).wrapping_mul(ORIGIN_FACTOR)
}

/// A sum of octaves of [`gradient`], each half the wavelength and `gain` (Q16) of the amplitude of
/// the last. There are as many octaves as `cache` has entries, but at most `cell`.
pub fn fbm(cache: &mut [CornerCache], point: [i32; 3], cell: u32, gain: i32, seed: u32) -> i32 {
    let mut sum = 0;
    let mut weight = Q16;
    for (octave, cache) in (0..cell).zip(cache) {
        let seed = seed.wrapping_add(octave.wrapping_mul(OCTAVE_STEP));
        sum += mul_q16(gradient(cache, point, cell - octave, seed), weight);
        weight = mul_q16(weight, gain);
    }
    sum
}

#[cfg(test)]
#[path = "noise_tests.rs"]
mod tests;
