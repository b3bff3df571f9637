//! Plane geometry of small differences of directions, in 32 bits.
//!
//! Vectors are shifted to a common scale of 14 bits before they are multiplied: dot products then
//! fit an i32, and a share along a segment is right to 2⁻¹³ of it.

use super::arith::{length, mul_q16, ratio, signed_ratio};
use super::fixed::{Q16, difference, weigh};

/// Bits to shift right so that every component of both vectors is below 2¹⁴.
#[inline]
const fn common_shift(u: [i32; 3], v: [i32; 3]) -> u32 {
    let mut all = 0;
    let mut i = 0;
    while i < 3 {
        all |= u[i].unsigned_abs() | v[i].unsigned_abs();
        i += 1;
    }
    // The bits of all components together have the length of the longest.
    let bits = 32 - all.leading_zeros();
    bits.saturating_sub(14)
}

#[inline]
const fn shifted(v: [i32; 3], shift: u32) -> [i32; 3] {
    [v[0] >> shift, v[1] >> shift, v[2] >> shift]
}

#[inline]
const fn product(u: [i32; 3], v: [i32; 3]) -> i32 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

/// Dot product in a scale of its own: the sign is that of the exact one, but for angles within 2⁻¹³
/// of a right one.
#[inline]
pub const fn dot(u: [i32; 3], v: [i32; 3]) -> i32 {
    let shift = common_shift(u, v);
    product(shifted(u, shift), shifted(v, shift))
}

/// Dot product of a vector and a unit vector in Q16.
#[inline]
pub const fn dot_q16(v: [i32; 3], unit: [i32; 3]) -> i32 {
    mul_q16(v[0], unit[0]) + mul_q16(v[1], unit[1]) + mul_q16(v[2], unit[2])
}

/// The lesser triangle's area of a small quadrilateral cut along its diagonal 0-2, and along 1-3,
/// as seen from outside and in one scale; below 0 where a triangle turns over.
pub fn least_areas([a, b, c, d]: [[i32; 3]; 4]) -> [i32; 2] {
    let sides = [b, c, d].map(|p| difference(p, a));
    // Sides of 13 bits, their differences of 14, so that no sum of products leaves 32.
    let shift = common_shift(sides[0], sides[1]).max(common_shift(sides[2], sides[2])) + 1;
    let [b, c, d] = sides.map(|side| shifted(side, shift));
    let normal = shifted(a, 17);
    let area = |u, v| product(shifted(cross(u, v), 14), normal);
    let beyond = area(difference(c, b), difference(d, b));
    [area(b, c).min(area(c, d)), area(b, d).min(beyond)]
}

const fn cross(u: [i32; 3], v: [i32; 3]) -> [i32; 3] {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

/// Whether a small vector points to the left of another, seen from outside at a direction.
pub const fn is_left(up: [i32; 3], along: [i32; 3], v: [i32; 3]) -> bool {
    let shift = common_shift(along, v);
    let turn = shifted(cross(shifted(along, shift), shifted(v, shift)), 14);
    product(turn, shifted(up, 17)) > 0
}

/// Where the point of a segment nearest to `p` lies: share of the way in Q16, and the vector from
/// there to `p`.
#[inline]
pub const fn nearest_on(ends: [[i32; 3]; 2], p: [i32; 3]) -> (i32, [i32; 3]) {
    // Projected on the line of the segment, then held between its ends.
    let along = difference(ends[1], ends[0]);
    let to = difference(p, ends[0]);
    let shift = common_shift(along, to);
    let (u, v) = (shifted(along, shift), shifted(to, shift));
    let (square, part) = (product(u, u), product(u, v));
    // A segment too short for this scale counts as its nearer end.
    let t = if part <= 0 || square == 0 {
        0
    } else {
        ratio(part, square)
    };
    // From the end itself, whose distance must not hang on rounding of the way there.
    let off = if t >= Q16 {
        difference(p, ends[1])
    } else {
        [
            to[0] - weigh(t, along[0]),
            to[1] - weigh(t, along[1]),
            to[2] - weigh(t, along[2]),
        ]
    };
    (t, off)
}

/// The share of `along` on which the foot of `v` lies, Q16, -1..1.
#[inline]
pub fn share_along(along: [i32; 3], v: [i32; 3]) -> i32 {
    let shift = common_shift(along, v);
    let (u, v) = (shifted(along, shift), shifted(v, shift));
    signed_ratio(product(u, v), product(u, u))
}

/// The share of `along` on which the foot of `v` lies, Q16, -1..1. The share is the smaller the
/// farther `v` reaches: as a step towards the nearest point of a curve it then never overshoots.
#[inline]
pub fn damped_projection(along: [i32; 3], v: [i32; 3]) -> i32 {
    let shift = common_shift(along, v);
    let (u, v) = (shifted(along, shift), shifted(v, shift));
    // Each of them is below 3 · 2²⁸.
    let square = product(u, u);
    let part = product(u, v);
    let across = length(v[0], v[1], v[2]) * length(u[0], u[1], u[2]);
    signed_ratio(part, square + across / 2)
}

/// How a corner of a triangle stands over the opposite edge, in lengths of the edge, Q12, each at
/// most 7.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stance {
    /// Where it projects: 0 at the edge's start, 1 at its end.
    pub along: i32,
    /// Its height over the edge's line, at least 1/64.
    pub height: i32,
}

/// 1 in Q12.
pub const Q12: i32 = 1 << 12;

crate::wgsl::shared!(Q12);

impl Stance {
    /// The stance of a corner, both vectors from the edge's start.
    pub fn of(edge: [i32; 3], corner: [i32; 3]) -> Self {
        let shift = common_shift(edge, corner);
        let (u, v) = (shifted(edge, shift), shifted(corner, shift));
        // Shares of the squared edge in Q12.
        let unit = product(u, u) >> 12;
        // An edge without length must not divide by 0.
        let unit = if unit < 1 { 1 } else { unit };
        // Twice the area: the height times the edge. Components stay below 2²⁹, as `length` asks.
        let [x, y, z] = cross(u, v);
        let cross = length(x, y, z);
        // Up to here the products of the displacement fit 32 bits.
        let most = 7 * Q12;
        Self {
            along: (product(u, v) / unit).clamp(-most, most),
            height: (cross / unit).clamp(Q12 / 64, most),
        }
    }

    /// How far beyond the edge it projects: negative before the start, positive beyond the end, 0
    /// over it; Q12.
    pub const fn overhang(self) -> i32 {
        if self.along < 0 {
            self.along
        } else if self.along > Q12 {
            self.along - Q12
        } else {
            0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::amplify::seed::pcg;

    fn random(k: u32, bits: u32) -> [i32; 3] {
        [0, 1, 2].map(|i| (pcg(k * 3 + i) as i32) >> (32 - bits))
    }

    fn real_dot(u: [f64; 3], v: [f64; 3]) -> f64 {
        u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
    }

    fn norm(v: [f64; 3]) -> f64 {
        real_dot(v, v).sqrt()
    }

    #[test]
    fn nearest_point_agrees_with_reals() {
        for k in 0..20_000 {
            let bits = 8 + k % 17;
            let [a, b, p] = [k, k + 90_000, k + 180_000].map(|k| random(k, bits));
            let (_, off) = nearest_on([a, b], p);
            let [u, v] = [b, p].map(|q| difference(q, a).map(f64::from));
            let t = (real_dot(u, v) / real_dot(u, u)).clamp(0.0, 1.0);
            let want = norm([0, 1, 2].map(|i| v[i] - t * u[i]));
            let got = norm(off.map(f64::from));
            let slack = 2.0 + (norm(u) + norm(v)) * 6e-4;
            assert!((want - got).abs() <= slack, "{k}: {want} {got}");
        }
    }
}
