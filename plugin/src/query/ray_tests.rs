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
    let (from, to) = (DVec3::X, DVec3::X);
    let nowhere = Err(GroundError::NotADirection);
    assert_eq!(cast_ray(&Ball, DVec3::NAN, to, 1.0, 3), nowhere);
    assert_eq!(cast_ray(&Ball, from, DVec3::ZERO, 1.0, 3), nowhere);
    let too_fine = cast_ray(&Ball, from, to, 1.0, 18);
    assert_eq!(too_fine, Err(GroundError::Level(18)));
    for max in [-1.0, f64::NAN] {
        let refused = cast_ray(&Ball, from, to, max, 3);
        assert!(matches!(refused, Err(GroundError::Length { .. })));
    }
}
