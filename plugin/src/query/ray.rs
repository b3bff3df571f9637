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
mod tests {
    use super::*;
    use crate::math;
    use proptest::prelude::*;

    const R: f64 = 1e6;

    /// A ball of 1000 km.
    struct Ball;

    impl Ground for Ball {
        fn radius_m(&self) -> f64 {
            R
        }
        fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
            checked(direction, level).map(|_| 0.0)
        }
    }

    /// A cone of exact flanks: its surface is where the angle at an apex 5000 m above the north
    /// pole is 60°.
    struct ExactCone;

    /// Distance of the apex from the centre in m.
    const APEX: f64 = R + 5000.0;

    impl Ground for ExactCone {
        fn radius_m(&self) -> f64 {
            R
        }
        fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
            let up = checked(direction, level)?;
            // r sinθ = (APEX - r cosθ) tan 60° on the flank.
            let away = (up.x * up.x + up.y * up.y).sqrt();
            let tan = 3.0_f64.sqrt();
            let flank = APEX * tan / (away + up.z * tan);
            Ok(if up.z > 0.9 {
                (flank - R).max(0.0) as f32
            } else {
                0.0
            })
        }
    }

    proptest! {
        #[test]
        fn rays_meet_a_ball_where_geometry_says(
            x in -3e6..3e6_f64, y in -3e6..3e6_f64, z in 1.01e6..3e6_f64,
            dx in -1.0..1.0_f64, dy in -1.0..1.0_f64, dz in -1.0..0.2_f64,
        ) {
            let (origin, direction) = (DVec3::new(x, y, z), DVec3::new(dx, dy, dz));
            prop_assume!(direction.length() > 1e-3);
            let unit = direction.normalize();
            let b = origin.dot(unit);
            let root = b * b - origin.length_squared() + R * R;
            // Rays that graze the ball by less than a step may pass.
            prop_assume!(!(0.0..=1e6).contains(&root));
            let hit = cast_ray(&Ball, origin, direction, f64::INFINITY, 12).unwrap();
            if root < 0.0 || b > 0.0 {
                prop_assert_eq!(hit, None);
            } else {
                let hit = hit.unwrap();
                let expected = -b - root.sqrt();
                let error = (hit.distance_m - expected).abs();
                prop_assert!(error < 2e-3, "{} {expected}", hit.distance_m);
                prop_assert!(math::angle_between(hit.normal, hit.point) < 1e-6);
            }
        }
    }

    #[test]
    fn rays_meet_a_cone_where_geometry_says() {
        for (height, away) in [(3000.0, 20_000.0), (4000.0, -30_000.0), (4900.0, 9000.0)] {
            // Level with the flank at `height`, from outside towards the axis.
            let origin = DVec3::new(away, 0.0, R + height);
            let toward = DVec3::new(-away, 0.0, 0.0);
            let hit = cast_ray(&ExactCone, origin, toward, 1e6, 14).unwrap();
            let hit = hit.unwrap();
            let flank = (5000.0 - height) * 3.0_f64.sqrt();
            let error = hit.distance_m - (away.abs() - flank);
            assert!(error.abs() < 0.02, "{}", hit.distance_m);
            let expected = DVec3::new(0.5 * away.signum(), 0.0, 0.75_f64.sqrt());
            let error = math::angle_between(hit.normal, expected);
            assert!(error < 1e-3, "{error}");
        }
    }

    #[test]
    fn rays_end_where_they_are_told() {
        let origin = DVec3::new(0.0, 0.0, R + 100.0);
        let down = |max| cast_ray(&Ball, origin, -DVec3::Z, max, 17).unwrap();
        assert_eq!(down(99.0), None);
        assert!((down(101.0).unwrap().distance_m - 100.0).abs() < 1e-3);
        assert_eq!(cast_ray(&Ball, origin, DVec3::Z, 1e9, 17).unwrap(), None);
    }

    #[test]
    fn rays_from_below_the_ground_hit_it_at_once() {
        for origin in [DVec3::new(0.0, 10.0, 20.0), DVec3::ZERO] {
            let hit = cast_ray(&Ball, origin, DVec3::Z, 1e9, 3).unwrap();
            assert_eq!(hit.unwrap().distance_m, 0.0);
        }
    }

    #[test]
    fn bad_rays_are_refused() {
        let cast = |origin, direction, max, level| {
            cast_ray(&Ball, origin, direction, max, level).map(|_| ())
        };
        let (from, to) = (DVec3::X, DVec3::X);
        let nowhere = Err(GroundError::NotADirection);
        assert_eq!(cast(DVec3::NAN, to, 1.0, 3), nowhere);
        assert_eq!(cast(from, DVec3::ZERO, 1.0, 3), nowhere);
        assert_eq!(cast(from, to, 1.0, 18), Err(GroundError::Level(18)));
        for max in [-1.0, f64::NAN] {
            let refused = cast(from, to, max, 3);
            assert!(matches!(refused, Err(GroundError::Length { .. })));
        }
    }
}
