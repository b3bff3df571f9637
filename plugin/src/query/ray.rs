//! Where a ray meets the ground.
//!
//! The ray is followed between the spheres that the ground lies between. A step is a third of the
//! height above the ground, which no slope below 70° can overtake, but at least a quarter of an
//! edge: thinner ground at the asked level may be passed. The crossing is then bisected.
//! A tree of triangles would have to be built for every place that a ray might come to; for many
//! rays against one place there is [`PatchTree`](super::PatchTree).

use super::check::{check_length, check_position, check_radius, checked};
use super::error::GroundError;
use super::ground::Ground;
use super::level::spacing;
use bevy::math::DVec3;
use bevy::reflect::Reflect;

/// Where a ray meets the ground.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct RayHit {
    /// Distance from the ray's origin in m.
    pub distance_m: f64,
    /// The point in m from the planet's centre.
    pub point: DVec3,
    /// Unit normal of the ground there.
    pub normal: DVec3,
}

/// Part of the height above the ground that one step goes: no slope below 70° rises faster.
const STEP_OF_CLEARANCE: f64 = 1.0 / 3.0;

/// Shortest step in edges of the level.
const SHORTEST_STEP_EDGES: f64 = 0.25;

/// Most steps: a ray that skims the finest ground for 40 km gives up.
const MAX_STEPS: usize = 400_000;

/// Length in m to which a crossing is bisected: a tenth of a millimetre.
const CROSSING_TOLERANCE_M: f64 = 1e-4;

/// The first point of the ground on the ray from `origin`, in m from the planet's centre, along
/// `direction` (of any length), at most `max_m` away. A ray that begins below the ground hits it at
/// once. `None` if it meets none.
///
/// ```
/// use bevy::math::DVec3;
/// use bevy_pangaea::query::{Ground, PlanetGround, Rules, cast_ray};
/// use pangaea_shaders::amplify::synthetic::control_mesh;
///
/// let ground = PlanetGround::new(&control_mesh(6_370_000, 3, 7), Rules::default())?;
/// // Straight down from 20 km.
/// let origin = DVec3::Y * (ground.radius_m() + 20_000.0);
/// let hit = cast_ray(&ground, origin, -DVec3::Y, 1e6, 10)?;
/// let height = f64::from(ground.height(DVec3::Y, 10)?);
/// assert!(hit.is_some_and(|hit| (hit.distance_m - (20_000.0 - height)).abs() < 0.1));
/// # Ok::<(), bevy_pangaea::query::GroundError>(())
/// ```
///
/// # Errors
/// As [`Ground::height`]; [`GroundError::Length`] for a `max_m` that is negative or NaN;
/// [`GroundError::Radius`]; [`GroundError::Unavailable`] for a ray that skims the ground for too
/// long.
pub fn cast_ray(
    ground: &(impl Ground + ?Sized),
    origin: DVec3,
    direction: DVec3,
    max_m: f64,
    level: u8,
) -> Result<Option<RayHit>, GroundError> {
    let along = checked(direction, level)?;
    check_position(origin)?;
    let radius = ground.radius_m();
    check_radius(radius)?;
    check_length("the ray", max_m, [0.0, f64::INFINITY])?;
    let ray = Ray {
        ground,
        origin,
        along,
        radius,
        level,
    };
    let [lowest, highest] = ground.bounds_m();
    // Above the highest ground there is nothing to meet.
    let Some((start, end)) = within_ball(origin, along, radius + highest) else {
        return Ok(None);
    };
    // Below the lowest ground, the ray has met it.
    let end = match within_ball(origin, along, radius + lowest) {
        Some((deep, _)) => end.min(deep.max(start) + 1.0),
        None => end,
    };
    match ray.crossing(start, end.min(max_m))? {
        Some(distance_m) => ray.hit(distance_m).map(Some),
        None => Ok(None),
    }
}

struct Ray<'a, G: ?Sized> {
    ground: &'a G,
    origin: DVec3,
    along: DVec3,
    radius: f64,
    level: u8,
}

impl<G: Ground + ?Sized> Ray<'_, G> {
    fn point(&self, t: f64) -> DVec3 {
        self.origin + self.along * t
    }

    /// Height above the ground at `t` in m. The centre of the planet is as deep as can be.
    fn clearance(&self, t: f64) -> Result<f64, GroundError> {
        let point = self.point(t);
        let distance = point.length();
        if distance == 0.0 {
            return Ok(-self.radius);
        }
        Ok(distance - self.radius - f64::from(self.ground.height(point, self.level)?))
    }

    /// The first `t` from `start` to `end` at which the ray is not above the ground.
    fn crossing(&self, start: f64, end: f64) -> Result<Option<f64>, GroundError> {
        if start > end {
            return Ok(None);
        }
        let shortest = SHORTEST_STEP_EDGES * spacing(self.radius, self.level);
        let mut t = start;
        let mut clearance = self.clearance(start)?;
        for _ in 0..MAX_STEPS {
            if clearance <= 0.0 {
                return Ok(Some(t));
            }
            if t >= end {
                return Ok(None);
            }
            let step = (STEP_OF_CLEARANCE * clearance).max(shortest);
            // A step that rounding would swallow still goes on.
            let next = (t + step).max(t.next_up()).min(end);
            let ahead = self.clearance(next)?;
            if ahead <= 0.0 {
                return self.bisect(t, next).map(Some);
            }
            (t, clearance) = (next, ahead);
        }
        Err(GroundError::Unavailable(
            "the ray skims the ground for too long".into(),
        ))
    }

    /// Where between `above` and `below` the ray meets the ground.
    fn bisect(&self, mut above: f64, mut below: f64) -> Result<f64, GroundError> {
        while below - above > CROSSING_TOLERANCE_M {
            let middle = 0.5 * (above + below);
            // Far away, numbers are coarser than the tolerance.
            if middle <= above || middle >= below {
                break;
            }
            if self.clearance(middle)? > 0.0 {
                above = middle
            } else {
                below = middle
            }
        }
        Ok(below)
    }

    fn hit(&self, distance_m: f64) -> Result<RayHit, GroundError> {
        let point = self.point(distance_m);
        // At the centre every direction is up.
        let up = if point.length_squared() > 0.0 {
            point
        } else {
            -self.along
        };
        Ok(RayHit {
            distance_m,
            point,
            normal: self.ground.normal(up, self.level)?,
        })
    }
}

/// Where on the ray, from 0 on, the ball of `radius` about the centre begins and ends; `None` if it
/// is missed.
fn within_ball(origin: DVec3, along: DVec3, radius: f64) -> Option<(f64, f64)> {
    let middle = -origin.dot(along);
    let closest = origin + along * middle;
    let half = radius * radius - closest.length_squared();
    if radius <= 0.0 || half < 0.0 || !half.is_finite() {
        return None;
    }
    let half = half.sqrt();
    (middle + half >= 0.0).then(|| ((middle - half).max(0.0), middle + half))
}

#[cfg(test)]
#[path = "ray_tests.rs"]
mod tests;
