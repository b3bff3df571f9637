//! The triangle that contains a direction, and its barycentric weights.
//!
//! Weights are those of the point where the ray along `p` pierces the flat triangle (gnomonic): p
//! is parallel to the weighted sum of the corners. The weight of a corner a is the determinant (p,
//! b, c), whose sign also says on which side of the edge bc the direction lies. The search begins
//! with the triangle at the nearest sample that faces `p` and crosses edges that have `p` on their
//! far side, as an obtuse triangle need not touch the sample nearest to a point in it (Devillers,
//! Pion and Teillaud 2002).

use super::SphereMesh;
use bevy::math::DVec3;
use bevy::reflect::Reflect;

/// Where a direction lies in a [`SphereMesh`].
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct Location {
    /// The nearest sample; mostly, but not always, a corner of the triangle.
    pub nearest: u32,
    /// Corners of the containing triangle, counter-clockwise seen from outside.
    pub vertices: [u32; 3],
    /// Barycentric weights of the corners: none negative, sum 1.
    pub weights: [f64; 3],
}

impl Location {
    /// All weight on the sample `nearest`, in the triangle of it and its neighbours `b` and `c`.
    fn at_sample(nearest: u32, b: u32, c: u32) -> Self {
        Self {
            nearest,
            vertices: [nearest, b, c],
            weights: [1.0, 0.0, 0.0],
        }
    }

    /// The weighted mean of a quantity given at the samples.
    #[inline]
    pub fn interpolate(&self, value: impl Fn(u32) -> f64) -> f64 {
        let [a, b, c] = self.vertices;
        let [u, v, w] = self.weights;
        u * value(a) + v * value(b) + w * value(c)
    }
}

/// Most edges crossed. A walk from the nearest sample crosses one or two; the limit stops one that
/// rounding, or a `nearest` that is far away, would keep going.
const MAX_CROSSINGS: usize = 4096;

impl SphereMesh {
    /// The triangle that contains the unit vector `p`.
    ///
    /// ```
    /// # use bevy_pangaea::{math, sphere::SphereMesh};
    /// let mesh = SphereMesh::fibonacci(2000)?;
    /// let p = math::direction(47.0, 8.0);
    /// let here = mesh.locate(p);
    /// let height = here.interpolate(|i| mesh.point(i).z);
    /// assert!((height - p.z).abs() < 0.01);
    /// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
    /// ```
    #[inline]
    pub fn locate(&self, p: DVec3) -> Location {
        self.locate_from(p, self.nearest(p))
    }

    /// The triangle that contains the unit vector `p`, whose nearest sample is known.
    ///
    /// A direction with the very bits of the sample `nearest` has weight 1 on it.
    pub fn locate_from(&self, p: DVec3, nearest: u32) -> Location {
        let ring = self.ring(nearest);
        if self.point(nearest) == p {
            return Location::at_sample(nearest, ring[0], ring[1]);
        }
        let mut vertices = self.facing_triangle(p, nearest);
        let mut weights = self.determinants(p, vertices);
        // A negative weight says that `p` lies beyond the edge opposite to its corner.
        for _ in 0..MAX_CROSSINGS {
            let Some(corner) = most_negative(weights) else {
                break;
            };
            vertices = self.across(vertices, corner);
            weights = self.determinants(p, vertices);
        }
        match normalised(weights) {
            Some(weights) => Location {
                nearest,
                vertices,
                weights,
            },
            None => Location::at_sample(nearest, ring[0], ring[1]),
        }
    }

    /// The triangle at sample `i` in whose wedge the direction `p` lies.
    fn facing_triangle(&self, p: DVec3, i: u32) -> [u32; 3] {
        let origin = self.point(i);
        let normal = (p - origin).cross(origin);
        let ring = self.ring(i);
        // Does `p` lie to the left of the edge from `i` to `j`? The determinant (i, j, p).
        let lies_left = |j: u32| (self.point(j) - origin).dot(normal) >= 0.0;
        let mut previous = ring[ring.len() - 1];
        let mut was_left = lies_left(previous);
        // The wedge lies between the last edge that has `p` on its left and the first that has not.
        for &j in ring {
            let is_left = lies_left(j);
            if was_left && !is_left {
                return [i, previous, j];
            }
            (previous, was_left) = (j, is_left);
        }
        [i, ring[0], ring[1]]
    }

    /// Barycentric weights, not normalised. Corners are taken relative to `p`: determinants of the
    /// plain vectors would lose half of their digits in small triangles. Seen from the two sides of
    /// an edge they are exactly opposite, so a walk never steps back and forth.
    #[inline]
    fn determinants(&self, p: DVec3, vertices: [u32; 3]) -> [f64; 3] {
        let [a, b, c] = vertices.map(|i| self.point(i) - p);
        [p.dot(b.cross(c)), p.dot(c.cross(a)), p.dot(a.cross(b))]
    }

    /// The triangle beyond the edge opposite to a corner (0, 1 or 2).
    fn across(&self, vertices: [u32; 3], corner: usize) -> [u32; 3] {
        let (b, c) = (vertices[(corner + 1) % 3], vertices[(corner + 2) % 3]);
        // The ring of `b` goes counter-clockwise: what comes before `c` lies to the right of the
        // edge.
        let ring = self.ring(b);
        let k = ring.iter().position(|&j| j == c).unwrap_or(0);
        let beyond = ring[if k == 0 { ring.len() - 1 } else { k - 1 }];
        [b, beyond, c]
    }
}

/// The corner of the least weight if that is negative.
#[inline]
fn most_negative(weights: [f64; 3]) -> Option<usize> {
    let mut least = 0;
    for k in 1..3 {
        if weights[k] < weights[least] {
            least = k;
        }
    }
    (weights[least] < 0.0).then_some(least)
}

/// Weights cut off at 0 and scaled to the sum 1; `None` if that sum is 0 or not finite.
#[inline]
fn normalised(weights: [f64; 3]) -> Option<[f64; 3]> {
    let weights = weights.map(|w| w.max(0.0));
    let sum = weights[0] + weights[1] + weights[2];
    (sum > 0.0 && sum.is_finite()).then(|| weights.map(|w| w / sum))
}

#[cfg(test)]
#[path = "locate_tests.rs"]
mod tests;
