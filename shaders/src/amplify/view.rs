//! The ground that a picture, a collider or an export asks for, and how finely.

use super::arith::mul_q16;
use super::fixed::{difference, mul_shift, q16};
use super::geometry::dot_q16;
use super::scale::PlanetScale;
use std::array;

/// Least and greatest [`View::sharpness`] that keep neighbours within a level: 6 and 250, Q8.
pub const SHARPNESS: (u32, u32) = (6 << 8, 250 << 8);

/// Sharpness of a disc's finest level, 3 in Q8: nothing finer follows, so it needs no margin but a
/// face's own size.
const RIM_SHARPNESS: u32 = 3 << 8;

/// Half a side of a square over half its diagonal, Q16.
const HALF_SIDE: i32 = q16(core::f64::consts::FRAC_1_SQRT_2);

crate::wgsl::shared!(
    LEAST_SHARPNESS = SHARPNESS.0,
    MOST_SHARPNESS = SHARPNESS.1,
    RIM_SHARPNESS,
    HALF_SIDE,
);

/// The part of the ground that is refined, and how finely: for a camera, or a disc or a square of
/// ground.
///
/// ```
/// use pangaea_shaders::amplify::fixed::{ONE, Q16};
/// use pangaea_shaders::amplify::mark::View;
/// use pangaea_shaders::amplify::scale::PlanetScale;
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// // Ground with edges of 0.4 m around the north pole, coarser from 50 m on.
/// let disc = View::disc([0, 0, ONE], 50, 17);
/// // The same place from an altitude of 300 m, as far as the horizon; looking along +x, the ground
/// // behind is up to four times as coarse.
/// let scale = PlanetScale::new(&control_mesh(6_371_000, 3, 1));
/// let camera = View::camera(&scale, disc.direction, 300, 17);
/// let ahead = View { forward: [Q16, 0, 0], ..camera };
/// // 62 km to the horizon of the sea, 357 km more to mountains of 10 km.
/// assert_eq!((ahead.horizon / 16_000, ahead.outside), (418, 4 << 8));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub struct View {
    /// Direction of its centre, in units of 1 / `ONE`.
    pub direction: [i32; 3],
    /// Height of its centre above sea level, sixteenths of a metre, at most 2³⁰: 67,000 km; `None`
    /// measures along the ground only.
    pub altitude: Option<i32>,
    /// Radius of the disc that is refined evenly, sixteenths of a metre; 0 for a camera.
    pub radius: i32,
    /// Unit tangents, Q16: only the square in the disc whose sides run along them is refined
    /// evenly; zero for the whole disc.
    pub sides: [[i32; 3]; 2],
    /// Unit vector that a camera looks along, Q16; zero if it looks all round.
    pub forward: [i32; 3],
    /// Cosine of the angle from `forward` within which ground is seen, Q16: half the diagonal field
    /// of view.
    pub field: i32,
    /// How many times coarser ground is where a camera does not look, from some 30 degrees beside
    /// its field on, Q8; at most what `sharpness` allows, see [`sight`](super::sight).
    pub outside: u32,
    /// c: distance over edge length at which a face is split, Q8; 117 gives edges of 8 pixels at
    /// 1080p.
    pub sharpness: u32,
    /// Finest level, 0..=17.
    pub level: u32,
    /// Ground farther than this from the centre is not seen, sixteenths of a metre in a straight
    /// line: a camera does not refine it but for a margin, and coarse faces may be left out.
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
            forward: [0; 3],
            field: q16(0.5),
            outside: 4 << 8,
            sharpness: SHARPNESS.0,
            level,
            horizon: i32::MAX,
        }
    }

    /// A disc of ground at one level, coarser around it; `radius` in metres.
    pub fn disc(direction: [i32; 3], radius: u32, level: u32) -> Self {
        let radius = radius.saturating_mul(16).min(1 << 28) as i32;
        Self {
            direction,
            radius,
            horizon: radius,
            ..Self::whole(level)
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

    /// It as a uniform: the words of its twin in WGSL.
    pub fn words(&self) -> [u32; 20] {
        let row = |[x, y, z]: [i32; 3], w: i32| [x, y, z, w].map(|x| x as u32);
        let rows = [
            row(self.direction, self.altitude.unwrap_or(0)),
            row(self.sides[0], self.radius),
            row(self.sides[1], self.horizon),
            row(self.forward, self.field),
            [
                u32::from(self.altitude.is_some()),
                self.outside,
                self.sharpness,
                self.level,
            ],
        ];
        array::from_fn(|i| rows[i / 4][i % 4])
    }

    /// [`View::sharpness`] within its limits.
    #[inline]
    pub fn clamped_sharpness(&self) -> u32 {
        self.sharpness.clamp(SHARPNESS.0, SHARPNESS.1)
    }

    /// Distance within which a face of a level is split, sixteenths of a metre.
    #[inline]
    pub fn bound(&self, scale: &PlanetScale, level: u32) -> i32 {
        // A camera, of radius 0, refines no ground evenly.
        let finest = self.radius > 0 && level + 1 == self.level;
        let sharpness = if finest {
            RIM_SHARPNESS
        } else {
            self.clamped_sharpness()
        };
        mul_shift(scale.edge, sharpness, 8 + level)
    }

    /// How far a direction lies beside the square, across the nearer pair of its sides; sixteenths
    /// of a metre, at most 0 within them.
    #[inline]
    pub(super) fn beside(&self, scale: &PlanetScale, direction: [i32; 3]) -> i32 {
        if self.sides == [[0; 3]; 2] {
            return 0;
        }
        // Quarters of units, so that opposite sides of the planet keep 32 bits.
        let offset = difference(direction.map(|x| x >> 2), self.direction.map(|x| x >> 2));
        let [x, y] = self.sides.map(|side| dot_q16(offset, side).unsigned_abs());
        // Half a side is the radius over the root of two.
        scale.sixteenths(x.max(y)) - mul_q16(self.radius, HALF_SIDE)
    }
}
