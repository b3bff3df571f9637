//! How far ground counts as lying from a view. What a camera does not see counts as farther than it
//! is, and so is refined less.
//!
//! Beside the field of view the distance d is multiplied by a smooth factor q of the angle, up to
//! [`View::outside`]; beyond the horizon it grows steeper by a constant slope, until nothing is
//! refined any more. The greater of the two counts.
//!
//! No vertex depends on a distance, but the mesh does: all faces within three rings of a split one
//! exist at its level as long as c is at least [`RINGS`] times the Lipschitz constant of what is
//! compared with c·ℓ. That bounds both: q - 1 may be at most (c / 4.5 - 1) / 4.5, the slope c / 4.5.
//! From an altitude h the distance itself grows by up to √(1 + h / R), by which c is divided there.

use super::arith::{isqrt, length, linear_step, mul_q16, ratio, smooth};
use super::fixed::{GRAINS, Q16, difference, mul_shift, q16};
use super::geometry::dot_q16;
use super::scale::PlanetScale;
use super::vertex::Vertex;
use super::view::View;

/// Least sharpness over the Lipschitz constant of the distance, Q8: 4.5.
pub const RINGS: u32 = 9 << 7;

/// Cosines between the border of the field of view and where q is greatest, Q16: ½.
const BAND: i32 = Q16 / 2;

/// Most that the Lipschitz constant of q·d grows with q, Q8. A smoothstep over a [`BAND`] of ½ is
/// nowhere steeper than 3, so d·q' is at most 3 (q - 1), and q·d grows by at most 1 + 4 (q - 1).
const GROWTH: u32 = 9 << 7;

/// Highest mountains that a horizon is drawn for, sixteenths of a metre: 10 km.
const HIGHEST: u32 = 160_000;

/// Greatest distance above the ground, sixteenths of a metre: 67,000 km.
const MOST_ABOVE: i32 = (1 << 30) - 1;

/// Grains in a sixteenth of a metre.
const GRAINS_IN_SIXTEENTH: i32 = GRAINS / 16;

crate::wgsl::shared!(BAND, MOST_ABOVE, GRAINS_IN_SIXTEENTH);

/// A view of a planet with everything that its faces have in common, as a uniform holds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct Sight {
    scale: PlanetScale,
    view: View,
    /// Length of a chord seen from the camera's altitude, Q10: √(1 + h / R).
    stretch: u32,
    /// Cosine between the view's direction and straight up, Q16.
    upward: i32,
    /// Most that q exceeds 1 by, Q8.
    excess: u32,
    /// Growth of the distance beyond the horizon, Q8; at least 1.
    slope: u32,
}

impl Sight {
    /// A view of a planet.
    pub fn new(scale: &PlanetScale, view: &View) -> Self {
        let stretch = stretch(scale, view.altitude.unwrap_or(0));
        // The distance itself has the Lipschitz constant `stretch`.
        let sharpness = (view.clamped_sharpness() << 8) / (stretch >> 2);
        let slope = ((sharpness << 8) / RINGS).max(1 << 8);
        let most = ((slope - (1 << 8)) << 8) / GROWTH;
        // A unit of direction is 2¹⁵ · 0.95 of Q16.
        let up = view.direction.map(|x| mul_q16(x >> 15, q16(1.052_631_58)));
        Self {
            scale: *scale,
            view: *view,
            stretch,
            upward: dot_q16(up, view.forward),
            excess: view.outside.saturating_sub(1 << 8).min(most),
            slope,
        }
    }

    /// It as a uniform: the words of its twin in WGSL.
    pub fn words(&self) -> [u32; 28] {
        let common = [self.stretch, self.upward as u32, self.excess, self.slope];
        let mut words = [0; 28];
        words[..4].copy_from_slice(&self.scale.words());
        words[4..24].copy_from_slice(&self.view.words());
        words[24..].copy_from_slice(&common);
        words
    }

    /// Distance from the camera or the disc to a face's centre, sixteenths of a metre.
    #[inline]
    pub fn distance(&self, corners: [&Vertex; 3]) -> i32 {
        let centre = centre(corners);
        self.outside(centre, self.straight(centre, self.above(corners)))
    }

    /// The same as the face counts: farther where a camera does not see it.
    #[inline]
    pub fn weighted(&self, corners: [&Vertex; 3]) -> i32 {
        let centre = centre(corners);
        let above = self.above(corners);
        let straight = self.straight(centre, above);
        let distance = self.outside(centre, straight);
        if self.view.radius > 0 {
            return distance;
        }
        let beyond = self.beyond_horizon(distance);
        if self.excess == 0 || self.view.forward == [0; 3] {
            return beyond;
        }
        let q = self.factor(self.ahead(centre, above), straight);
        beyond.max(mul_shift(distance as u32, q, 8))
    }

    /// Whether a face of a level is split.
    #[inline]
    pub fn splits(&self, level: u32, corners: [&Vertex; 3]) -> bool {
        level < self.view.level && self.weighted(corners) < self.view.bound(&self.scale, level)
    }

    /// How far faces of the control mesh may lie along the ground from the view's centre and still
    /// be split or seen, sixteenths of a metre.
    pub fn reach(&self) -> i32 {
        let bound = self.view.bound(&self.scale, 0);
        let View {
            horizon, radius, ..
        } = self.view;
        let refined = if radius == 0 && bound > horizon {
            // The inverse of `beyond_horizon`, rounded up.
            let steep = (bound.saturating_sub(horizon) as u32 / self.slope + 1).min(1 << 22) << 8;
            horizon.saturating_add(steep as i32)
        } else {
            bound
        };
        horizon.max(refined).saturating_add(radius)
    }

    /// Height of the camera above the middle of a face, sixteenths of a metre; 0 for a disc.
    #[inline]
    fn above(&self, corners: [&Vertex; 3]) -> i32 {
        self.view.altitude.map_or(0, |altitude| {
            let heights = corners.map(|v| v.height / GRAINS_IN_SIXTEENTH);
            altitude.clamp(-MOST_ABOVE / 2, MOST_ABOVE) - heights.iter().sum::<i32>() / 3
        })
    }

    /// Distance from the view's centre to a direction, `above` of which lies straight down.
    #[inline]
    fn straight(&self, centre: [i32; 3], above: i32) -> i32 {
        // |p - q|² = (a - b)² + 4ab sin²(½φ) for points at a and b from the planet's centre.
        let ground = self.scale.chord(centre, self.view.direction);
        let ground = mul_shift(ground as u32, self.stretch, 10).min(MOST_ABOVE);
        length(ground, above.clamp(-MOST_ABOVE, MOST_ABOVE), 0)
    }

    /// Distance outside the disc or the square; of a camera, all of it.
    #[inline]
    fn outside(&self, centre: [i32; 3], straight: i32) -> i32 {
        let outside = straight.saturating_sub(self.view.radius).max(0);
        // A square lies in its disc; the greater distance outside of the two counts.
        outside.max(self.view.beside(&self.scale, centre))
    }

    /// How far ahead of the camera a direction lies, `above` of which is straight down; sixteenths
    /// of a metre.
    #[inline]
    fn ahead(&self, centre: [i32; 3], above: i32) -> i32 {
        // Quarters of units, so that opposite sides of the planet keep 32 bits.
        let [to, from] = [centre, self.view.direction].map(|d| d.map(|x| x >> 2));
        let along = dot_q16(difference(to, from), self.view.forward);
        let level = self.scale.sixteenths(along.unsigned_abs());
        let level = if along < 0 { -level } else { level };
        level.saturating_sub(mul_q16(above.clamp(-MOST_ABOVE, MOST_ABOVE), self.upward))
    }

    /// q of ground so far ahead at a distance, Q8.
    #[inline]
    fn factor(&self, ahead: i32, distance: i32) -> u32 {
        let share = ratio(ahead.saturating_abs(), distance);
        let cosine = if ahead < 0 { -share } else { share };
        let rise = smooth(linear_step(0, BAND, self.view.field - cosine));
        (1 << 8) + ((self.excess * rise as u32) >> 16)
    }

    /// A distance as it counts: beyond the horizon it grows by the slope.
    #[inline]
    fn beyond_horizon(&self, distance: i32) -> i32 {
        let hidden = distance.saturating_sub(self.view.horizon).max(0);
        let steep = mul_shift(hidden as u32, self.slope, 8);
        (distance - hidden).saturating_add(steep)
    }
}

/// Distance of the farthest mountains of 10 km that are seen over the sea from an altitude, both in
/// sixteenths of a metre: the tangents from both to the sphere, √(2Rh + h²).
pub fn horizon(scale: &PlanetScale, altitude: i32) -> i32 {
    let diameter = scale.radius_m * 32;
    let [camera, summit] = [altitude.clamp(0, MOST_ABOVE) as u32, HIGHEST]
        .map(|height| root_of_product(height, diameter + height));
    (camera + summit).min(i32::MAX as u32) as i32
}

/// √(a·b) to 2⁻¹⁵ of itself, rounded down.
fn root_of_product(a: u32, b: u32) -> u32 {
    if a == 0 || b == 0 {
        return 0;
    }
    // Roots of sixteen bits, whose product has 32.
    let [p, q] = [a, b].map(|x| x.leading_zeros() & !1);
    (isqrt(a << p) * isqrt(b << q)) >> ((p + q) / 2)
}

/// √(1 + h / R), Q10; 1 below the sea.
fn stretch(scale: &PlanetScale, altitude: i32) -> u32 {
    // h / R in Q20: sixteenths over metres, and two digits of eight bits.
    let (h, r) = (altitude.clamp(0, MOST_ABOVE) as u32, scale.radius_m);
    let first = (h % r) << 8;
    let second = (first % r) << 8;
    let share = ((h / r) << 16) + ((first / r) << 8) + second / r;
    isqrt((1 << 20) + share)
}

/// Direction of the middle of a face.
#[inline]
fn centre(corners: [&Vertex; 3]) -> [i32; 3] {
    let [a, b, c] = corners.map(|v| v.direction);
    let [ab, ac] = [b, c].map(|v| difference(v, a));
    [0, 1, 2].map(|i| a[i] + (ab[i] + ac[i]) / 3)
}
