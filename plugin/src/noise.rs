//! Coherent gradient noise on the sphere, from integer hashes.

use crate::random::{Purpose, Stream, mix};
use bevy::math::DVec3;
use bevy::reflect::Reflect;

/// Gradient noise in space, evaluated at unit directions scaled by a frequency.
///
/// One octave has zero mean, a range of about -1..1 and a continuous second derivative.
///
/// ```
/// # use bevy_pangaea::{math, noise::Noise, random::Purpose};
/// let noise = Noise::new(7, Purpose::Relief, 0);
/// let here = noise.fractal(math::direction(47.0, 8.0), 4.0, 5);
/// let beside = noise.fractal(math::direction(47.001, 8.0), 4.0, 5);
/// assert!(here.abs() < 1.2 && (here - beside).abs() < 0.01);
/// ```
#[derive(Clone, Copy, Debug, Reflect)]
pub struct Noise {
    key: u64,
}

impl Noise {
    /// The noise of `purpose` for the thing `id` of the planet `seed`.
    pub fn new(seed: u64, purpose: Purpose, id: u64) -> Self {
        Self {
            key: Stream::new(seed, purpose, id).bits(0),
        }
    }

    /// One octave at `p`, which is in units of the noise's lattice.
    pub fn octave(&self, p: DVec3) -> f64 {
        let (hashes, f) = self.corners(p);
        interpolate(f, |corner, d| gradient(hashes[corner], d))
    }

    /// Hashes of the corners of the cell around `p`, in the order of x, then y, then z, and the
    /// position in it.
    #[inline]
    fn corners(&self, p: DVec3) -> ([u64; 8], DVec3) {
        let cell = DVec3::new(floor(p.x), floor(p.y), floor(p.z));
        let [x, y, z] = cell.to_array().map(|c| c as i64 as u64);
        // The two planes of x are hashed once and serve four corners each.
        let planes = [0, 1].map(|i| mix(self.key ^ x.wrapping_add(i)));
        let mut hashes = [0; 8];
        for (row, hashes) in hashes.chunks_exact_mut(2).enumerate() {
            let (j, k) = (row as u64 & 1, row as u64 >> 1);
            for (plane, hash) in planes.iter().zip(hashes) {
                *hash = mix(mix(plane ^ y.wrapping_add(j)) ^ z.wrapping_add(k));
            }
        }
        (hashes, p - cell)
    }

    /// `octaves` octaves at the direction `p`: the first has `frequency` periods per radian,
    /// each further one twice the frequency and half the amplitude. Range about -1..1.
    pub fn fractal(&self, p: DVec3, frequency: f64, octaves: u32) -> f64 {
        let mut sum = 0.0;
        let mut norm = 0.0;
        let mut amplitude = 1.0;
        let mut scale = frequency;
        for octave in 0..octaves {
            sum += amplitude * self.octave(octave_position(p, scale, octave));
            norm += amplitude;
            amplitude *= 0.5;
            scale *= 2.0;
        }
        sum / norm
    }

    /// Three independent octave sums: a vector that warps positions.
    pub fn vector(&self, p: DVec3, frequency: f64, octaves: u32) -> DVec3 {
        let part = |shift: f64| self.fractal(p + DVec3::splat(shift), frequency, octaves);
        DVec3::new(part(0.0), part(31.7), part(73.1))
    }
}

/// Where octave number `octave` looks for the direction `p`, `scale` periods per radian: each at
/// another part of the lattice, or all octaves would vanish at the origin together.
#[inline]
pub(crate) fn octave_position(p: DVec3, scale: f64, octave: u32) -> DVec3 {
    p * scale + DVec3::splat(17.3 * f64::from(octave + 1))
}

/// The largest whole number not above `x`, for |x| < 2^63. Cheaper than a call of libm.
#[inline]
fn floor(x: f64) -> f64 {
    let whole = x as i64 as f64;
    if whole > x { whole - 1.0 } else { whole }
}

/// Blends the values of a cell's corners at the position `f` in it. `value` takes the number of a
/// corner and the vector from there.
#[inline]
fn interpolate(f: DVec3, value: impl Fn(usize, DVec3) -> f64) -> f64 {
    let [u, v, w] = f.to_array().map(fade);
    let offset = |i: usize, j: usize, k: usize| DVec3::new(i as f64, j as f64, k as f64);
    let corner = |i, j, k| value(i + 2 * j + 4 * k, f - offset(i, j, k));
    let edge = |j, k| lerp(u, corner(0, j, k), corner(1, j, k));
    let front = lerp(v, edge(0, 0), edge(1, 0));
    let back = lerp(v, edge(0, 1), edge(1, 1));
    lerp(w, front, back)
}

/// The quintic 6t⁵ - 15t⁴ + 10t³ from 0 to 1, level and straight at both ends (Perlin 2002).
#[inline]
fn fade(t: f64) -> f64 {
    t * t * t * (t * (6.0 * t - 15.0) + 10.0)
}

#[inline]
fn lerp(t: f64, a: f64, b: f64) -> f64 {
    a + t * (b - a)
}

/// Dot product of `d` with one of twelve edge directions of a cube, chosen by `hash` (Perlin 2002),
/// scaled so that one octave reaches about -1..1.
#[inline]
fn gradient(hash: u64, d: DVec3) -> f64 {
    let axis = ((hash >> 60) % 3) as usize;
    let a = [d.x, d.y, d.z][axis];
    let b = [d.y, d.z, d.x][axis];
    // The sign bit is set from the hash: a branch would be mispredicted every second time.
    let signed = |x: f64, bit: u64| f64::from_bits(x.to_bits() ^ (bit << 63));
    signed(a, hash & 1) + signed(b, hash >> 1 & 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_bounded_centred_and_continuous() {
        let noise = Noise::new(3, Purpose::Relief, 0);
        let stream = Stream::new(3, Purpose::Relief, 1);
        let (mut sum, mut largest) = (0.0, 0.0_f64);
        for i in 0..20_000 {
            let p = stream.direction(i);
            let a = noise.fractal(p, 4.0, 4);
            let b = noise.fractal((p + DVec3::splat(1e-6)).normalize(), 4.0, 4);
            assert!((a - b).abs() < 1e-4);
            sum += a;
            largest = largest.max(a.abs());
        }
        assert!((sum / 20_000.0).abs() < 0.05);
        assert!((0.4..1.2).contains(&largest), "{largest}");
    }
}
