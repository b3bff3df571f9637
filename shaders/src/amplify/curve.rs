//! The course of a river between two of its vertices: the cubic that leaves the one and reaches the
//! other along their headings (C. Hermite), so that pieces of a river join without a kink.

use super::arith::{length, mul_q16, ratio, saturate};
use super::fixed::{Q16, difference, weigh};
use super::geometry::{damped_projection, nearest_on};

/// Steps towards the nearest point of a curve from that of its chord: two leave less than a
/// hundredth of the chord.
const STEPS: u32 = 2;

/// A unit tangent's length.
const UNIT: i32 = 32_767;

crate::wgsl::shared!(STEPS, UNIT);

/// A piece of a river's course.
#[derive(Clone, Copy, Debug)]
pub struct Curve {
    ends: [[i32; 3]; 2],
    /// From its start to its end.
    chord: [i32; 3],
    /// How far the tangents at both ends differ from the chord.
    bends: [[i32; 3]; 2],
}

impl Curve {
    /// The course between two directions less than 15° apart, upstream first. A heading is a unit
    /// tangent times 32767; zero stands for the way from end to end.
    pub fn new(ends: [[i32; 3]; 2], headings: [[i16; 3]; 2]) -> Self {
        let chord = difference(ends[1], ends[0]);
        let size = length(chord[0], chord[1], chord[2]);
        Self {
            ends,
            chord,
            bends: headings.map(|heading| bend(heading, chord, size)),
        }
    }

    /// The way from its start to the point at a share of it, Q16.
    pub fn at(&self, share: i32) -> [i32; 3] {
        let rest = Q16 - share;
        let middle = mul_q16(share, rest);
        let (first, second) = (mul_q16(middle, rest), mul_q16(middle, share));
        let [leaving, arriving] = &self.bends;
        [0, 1, 2].map(|i| {
            weigh(share, self.chord[i]) + weigh(first, leaving[i]) - weigh(second, arriving[i])
        })
    }

    /// A quarter of its tangent at a share of it, which fits 32 bits whatever the bends.
    pub fn quarter_tangent(&self, share: i32) -> [i32; 3] {
        let rest = Q16 - share;
        let first = mul_q16(rest, Q16 - 3 * share);
        let second = mul_q16(share, 2 * Q16 - 3 * share);
        let [leaving, arriving] = &self.bends;
        [0, 1, 2].map(|i| {
            (self.chord[i] >> 2) + weigh(first, leaving[i] >> 2) - weigh(second, arriving[i] >> 2)
        })
    }

    /// The vector from its point at a share of it to `p`.
    fn off(&self, share: i32, p: [i32; 3]) -> [i32; 3] {
        // From the end itself, whose distance must not hang on rounding of the way there.
        if share >= Q16 {
            return difference(p, self.ends[1]);
        }
        difference(difference(p, self.ends[0]), self.at(share))
    }

    /// Where its point nearest to `p` lies: share of the way in Q16, and the vector from there to
    /// `p`.
    pub fn nearest(&self, p: [i32; 3]) -> (i32, [i32; 3]) {
        let (mut share, off) = nearest_on(self.ends, p);
        if self.bends == [[0; 3]; 2] {
            return (share, off);
        }
        for _ in 0..STEPS {
            let off = self.off(share, p).map(|x| x >> 2);
            share = saturate(share + damped_projection(self.quarter_tangent(share), off));
        }
        (share, self.off(share, p))
    }
}

/// How far the tangent of a heading differs from the chord. A heading far from the chord, which
/// would make a loop, has a short tangent.
fn bend(heading: [i16; 3], chord: [i32; 3], size: i32) -> [i32; 3] {
    if heading == [0; 3] || size == 0 {
        return [0; 3];
    }
    let heading = heading.map(i32::from);
    // The chord's components get 14 bits: three products with 15 fit 32.
    let shift = (32 - size.leading_zeros()).saturating_sub(14);
    let along: i32 = (0..3).map(|i| heading[i] * (chord[i] >> shift)).sum();
    // 1 up to 60° from the chord, 0 across it.
    let kept = ratio(2 * (along / UNIT).max(0), (size >> shift).max(1));
    [0, 1, 2].map(|i| weigh(mul_q16(2 * heading[i], kept), size) - chord[i])
}

/// The heading of a vector: its direction times 32767; zero for the zero vector.
pub fn heading_of(v: [i32; 3]) -> [i16; 3] {
    // Fifteen bits, of long and of short vectors: their products with the unit fit 32.
    let all = v.iter().fold(0, |all, x| all | x.unsigned_abs());
    let bits = 32 - all.leading_zeros();
    let v = v.map(|x| x >> bits.saturating_sub(15) << 15_u32.saturating_sub(bits));
    let size = length(v[0], v[1], v[2]).max(1);
    v.map(|x| (x * UNIT / size).clamp(-UNIT, UNIT) as i16)
}

#[cfg(test)]
#[path = "curve_tests.rs"]
mod tests;
