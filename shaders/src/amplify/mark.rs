//! Pass: a face decides whether it is split for a view.
//!
//! A face of level L is split where its centre is nearer than c·ℓ_L to the camera or the disc, ℓ_L
//! the theoretical edge. The bound halves with the level while neighbours are about ℓ_L apart, so
//! where c is at least 6 every face within three rings of a split one exists at its level:
//! neighbours differ by one level at most, and no pass has to spread splits. A split face's
//! neighbours are its halo: see [`SplitMark::Halo`].

use super::arith::{length, mul_q16, ratio};
use super::fixed::{GRAINS, Q16, difference, mul_shift, q16};
use super::scale::PlanetScale;
use super::topology::{Edge, Face, NONE, SplitMark};
use super::vertex::Vertex;

/// Least and greatest [`View::sharpness`] that keep neighbours within a level: 6 and 250, Q8.
pub const SHARPNESS: (u32, u32) = (6 << 8, 250 << 8);

/// Sharpness of a disc's finest level, 3 in Q8: nothing finer follows, so it needs no margin but a
/// face's own size.
const RIM_SHARPNESS: u32 = 3 << 8;

/// Grains in a sixteenth of a metre.
const GRAINS_IN_SIXTEENTH: i32 = GRAINS / 16;

/// The part of the ground that is refined, and how finely: for a camera, or a disc or a square of
/// ground.
///
/// ```
/// use pangaea_shaders::amplify::fixed::{ONE, metres};
/// use pangaea_shaders::amplify::mark::View;
///
/// // Ground with edges of 0.4 m around the north pole, coarser from 50 m on.
/// let disc = View::disc([0, 0, ONE], 50, 17);
/// // The same place seen from an altitude of 300 m, as far as 20 km.
/// let camera = View {
///     altitude: Some(metres(300)),
///     radius: 0,
///     horizon: 20_000 * 16,
///     ..disc
/// };
/// assert!(camera.altitude > disc.altitude);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct View {
    /// Direction of its centre, in units of 1 / `ONE`.
    pub direction: [i32; 3],
    /// Height of its centre above sea level, grains; `None` measures along the ground only.
    pub altitude: Option<i32>,
    /// Radius of the disc that is refined evenly, sixteenths of a metre; 0 for a camera.
    pub radius: i32,
    /// Unit tangents, Q16: only the square in the disc whose sides run along them is refined
    /// evenly; zero for the whole disc.
    pub sides: [[i32; 3]; 2],
    /// c: distance over edge length at which a face is split, Q8; 117 gives edges of 8 pixels at
    /// 1080p.
    pub sharpness: u32,
    /// Finest level, 0..=17.
    pub level: u32,
    /// Ground as far as this from the centre is always there, if only as coarse faces; sixteenths
    /// of a metre, as a chord. Coarse faces farther off may be left out.
    pub horizon: i32,
}

impl View {
    /// The whole planet at one level.
    pub const fn whole(level: u32) -> Self {
        Self {
            direction: [0; 3],
            altitude: None,
            radius: i32::MAX,
            sides: [[0; 3]; 2],
            sharpness: SHARPNESS.0,
            level,
            horizon: i32::MAX,
        }
    }

    /// A disc of ground at one level, coarser around it; `radius` in metres.
    pub fn disc(direction: [i32; 3], radius: u32, level: u32) -> Self {
        let radius = radius.saturating_mul(16).min(1 << 28) as i32;
        let sides = [[0; 3]; 2];
        Self {
            direction,
            altitude: None,
            radius,
            sides,
            sharpness: SHARPNESS.0,
            level,
            horizon: radius,
        }
    }

    /// A square of ground at one level, coarser around it. Its corners lie `radius` metres from the
    /// centre, its sides run along two unit tangents in Q16.
    pub fn square(direction: [i32; 3], sides: [[i32; 3]; 2], radius: u32, level: u32) -> Self {
        Self {
            sides,
            ..Self::disc(direction, radius, level)
        }
    }

    /// Distance from the camera or the disc to a face's centre, sixteenths of a metre.
    #[inline]
    pub fn distance(&self, scale: &PlanetScale, corners: [&Vertex; 3]) -> i32 {
        let [a, b, c] = corners;
        let [ab, ac] = [b, c].map(|v| difference(v.direction, a.direction));
        let centre = [0, 1, 2].map(|i| a.direction[i] + (ab[i] + ac[i]) / 3);
        // Along the ground and above it, as the legs of a right triangle.
        let ground = scale.chord(centre, self.direction);
        let above = self.above(corners);
        // Held to 2²⁸ sixteenths, 16,777 km, so that `length` keeps its range.
        let distance = length(ground, above.clamp(-(1 << 28), 1 << 28), 0);
        let outside = distance.saturating_sub(self.radius).max(0);
        // A square lies in its disc; the greater distance outside of the two counts.
        outside.max(self.beside(scale, centre))
    }

    /// Height of the camera above the middle of a face, sixteenths of a metre; 0 for a disc.
    #[inline]
    fn above(&self, corners: [&Vertex; 3]) -> i32 {
        self.altitude.map_or(0, |altitude| {
            let heights = corners.map(|v| v.height / GRAINS_IN_SIXTEENTH);
            altitude / GRAINS_IN_SIXTEENTH - heights.iter().sum::<i32>() / 3
        })
    }

    /// How far a direction lies beside the square, across the nearer pair of its sides; sixteenths
    /// of a metre, at most 0 within them.
    #[inline]
    fn beside(&self, scale: &PlanetScale, direction: [i32; 3]) -> i32 {
        if self.sides == [[0; 3]; 2] {
            return 0;
        }
        // Quarters of units, so that opposite sides of the planet keep 32 bits.
        let offset = difference(direction.map(|x| x >> 2), self.direction.map(|x| x >> 2));
        let [x, y] = self.sides.map(|side| {
            let along: i32 = (0..3).map(|i| mul_q16(offset[i], side[i])).sum();
            along.unsigned_abs()
        });
        // Half a side is the radius over the root of two.
        scale.sixteenths(x.max(y)) - mul_q16(self.radius, q16(core::f64::consts::FRAC_1_SQRT_2))
    }

    /// Distance within which a face of a level is split, sixteenths of a metre.
    #[inline]
    pub fn bound(&self, scale: &PlanetScale, level: u32) -> i32 {
        // A camera, of radius 0, refines no ground evenly.
        let finest = self.radius > 0 && level + 1 == self.level;
        let sharpness = if finest {
            RIM_SHARPNESS
        } else {
            self.sharpness.clamp(SHARPNESS.0, SHARPNESS.1)
        };
        mul_shift(scale.edge, sharpness, 8 + level)
    }

    /// Level that the view shows at a vertex, Q16: that of the leaves at its distance, evenly from
    /// one to the next.
    pub fn shown_level(&self, scale: &PlanetScale, vertex: &Vertex) -> i32 {
        let finest = self.level as i32 * Q16;
        let distance = self.distance(scale, [vertex; 3]).max(1) as u32;
        let sharpness = self.sharpness.clamp(SHARPNESS.0, SHARPNESS.1);
        // Half a level finer than the split: leaves of two levels meet there.
        let farthest = mul_shift(scale.edge, sharpness + sharpness / 2, 8) as u32;
        if distance >= farthest {
            return 0;
        }
        // Levels go by the logarithm of the distance, linear between powers of two.
        let halvings = (farthest / distance).ilog2();
        let nearest = (farthest >> halvings) as i32;
        let share = ratio(2 * (nearest - distance as i32), nearest);
        (halvings as i32 * Q16 + share).min(finest)
    }

    /// Whether a face of a level is split.
    #[inline]
    pub fn splits(&self, scale: &PlanetScale, level: u32, corners: [&Vertex; 3]) -> bool {
        level < self.level && self.distance(scale, corners) < self.bound(scale, level)
    }
}

/// A face's mark once the splits are known: split, beside a split one, or neither.
#[inline]
pub fn halo(face: &Face, index: u32, edges: &[Edge], splits: impl Fn(u32) -> bool) -> SplitMark {
    if splits(index) {
        return SplitMark::Split;
    }
    // A face beside a split one is halo.
    let beside = face.edges.iter().any(|&e| {
        let [f, g] = edges[e as usize].faces;
        let other = if f == index { g } else { f };
        other != NONE && splits(other)
    });
    if beside {
        SplitMark::Halo
    } else {
        SplitMark::Leaf
    }
}

/// An edge's mark: the greater of its faces'.
#[inline]
pub fn edge_mark(edge: &Edge, faces: &[Face]) -> SplitMark {
    let [left, right] = edge
        .faces
        .map(|f| faces.get(f as usize).map_or(SplitMark::Leaf, |f| f.mark));
    left.max(right)
}
