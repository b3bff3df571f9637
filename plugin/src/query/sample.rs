//! All there is to know of one point of the ground.

use super::{Ground, GroundError, GroundSurface, Site, checked, classify, spacing};
use crate::math;
use crate::math::east_north;
use bevy::math::DVec3;
use rayon::prelude::*;

/// Points of a batch that a thread asks for in a row: neighbours share work.
const RUN: usize = 64;

/// The ground at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Height of the ground above sea level in m.
    pub height_m: f32,
    /// Level of the water in m; the height of the ground where it is dry.
    pub water_m: f32,
    /// Unit normal of the ground, in the planet's axes.
    pub normal: DVec3,
    /// What the ground is made of.
    pub surface: GroundSurface,
}

/// The ground at a direction of any length.
///
/// # Errors
/// As [`Ground::height`].
pub fn sample(
    ground: &(impl Ground + ?Sized),
    direction: DVec3,
    level: u8,
) -> Result<Sample, GroundError> {
    let up = checked(direction, level)?;
    let height_m = ground.height(up, level)?;
    let water_m = ground.water(up, level)?;
    let normal = normal(ground, up, level)?;
    let slope_deg = math::angle_between(up, normal).to_degrees() as f32;
    let climate = ground.climate(up, height_m)?;
    let surface = classify(&Site {
        height_m,
        water_m,
        slope_deg,
        climate,
    });
    Ok(Sample {
        height_m,
        water_m,
        normal,
        surface,
    })
}

/// The ground at many directions, in their order and with the bits of [`sample`], on all threads.
///
/// # Errors
/// As [`sample`], for the first refused direction.
pub fn samples(
    ground: &(impl Ground + ?Sized),
    directions: &[DVec3],
    level: u8,
) -> Result<Vec<Sample>, GroundError> {
    let run = |directions: &[DVec3]| -> Vec<_> {
        directions
            .iter()
            .map(|&direction| sample(ground, direction, level))
            .collect()
    };
    // Collected first: which of several errors is told must not depend on the threads.
    let runs: Vec<Vec<_>> = directions.par_chunks(RUN).map(run).collect();
    runs.into_iter().flatten().collect()
}

/// Unit normal of the ground in the planet's axes: of the surface through the four points that lie
/// one edge of the level to the east, west, north and south.
///
/// # Errors
/// As [`Ground::height`]; [`GroundError::Radius`].
pub fn normal(
    ground: &(impl Ground + ?Sized),
    direction: DVec3,
    level: u8,
) -> Result<DVec3, GroundError> {
    let up = checked(direction, level)?;
    let radius = ground.radius_m();
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(GroundError::Radius(radius));
    }
    let (east, north) = east_north(up);
    let step = spacing(radius, level) / radius;
    let around = [east, -east, north, -north].map(|side| (up + side * step).normalize());
    let mut heights = [0.0_f32; 4];
    ground.heights(&around, level, &mut heights)?;
    let corner = |k: usize| around[k] * (radius + f64::from(heights[k]));
    let normal = (corner(0) - corner(1)).cross(corner(2) - corner(3));
    Ok(normal.try_normalize().unwrap_or(up))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::query::Climate;

    /// A cone around +z: its flanks fall at `slope` (a tangent); the rest is sea floor at -100 m.
    struct Cone {
        slope: f64,
    }

    impl Ground for Cone {
        fn radius_m(&self) -> f64 {
            1e6
        }

        fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
            let up = checked(direction, level)?;
            let away = math::angle_between(up, DVec3::Z) * 1e6;
            Ok((5000.0 - self.slope * away).max(-100.0) as f32)
        }

        fn climate(&self, _: DVec3, _: f32) -> Result<Climate, GroundError> {
            Ok(Climate {
                temperature_c: 10.0,
                wetness: 0.3,
            })
        }
    }

    #[test]
    fn normals_of_a_cone_have_its_slope_and_point_away_from_its_axis() {
        let ground = Cone { slope: 0.5 };
        for lon in [0.0, 77.0, 200.0] {
            let up = math::direction(89.8, lon);
            let n = normal(&ground, up, 12).unwrap();
            let slope = math::angle_between(up, n);
            // The radius at that height is 1e6 + 3255 m.
            assert!(
                (math::sin(slope) / math::cos(slope) - 0.5).abs() < 4e-3,
                "{slope}"
            );
            assert!((n - up * n.dot(up)).dot(DVec3::Z) < 0.0);
        }
        let flat = normal(&ground, math::direction(12.0, 5.0), 9).unwrap();
        assert!(math::angle_between(flat, math::direction(12.0, 5.0)) < 1e-9);
        assert!(normal(&ground, DVec3::Z, 17).unwrap().dot(DVec3::Z) > 0.999);
    }

    #[test]
    fn a_sample_knows_water_and_surface() {
        let steep = Cone { slope: 1.0 };
        let flank = sample(&steep, math::direction(89.9, 0.0) * 7.0, 14).unwrap();
        assert_eq!(
            (flank.surface, flank.water_m),
            (GroundSurface::Rock, flank.height_m)
        );
        let sea = sample(&steep, DVec3::X, 14).unwrap();
        assert_eq!(
            (sea.height_m, sea.water_m, sea.surface),
            (-100.0, 0.0, GroundSurface::SeaFloor)
        );
        assert_eq!(sample(&steep, DVec3::X, 18), Err(GroundError::Level(18)));
        assert_eq!(
            sample(&steep, DVec3::ZERO, 3),
            Err(GroundError::NotADirection)
        );
    }

    #[test]
    fn a_batch_has_the_samples_of_single_questions_and_tells_the_first_error() {
        let cone = Cone { slope: 0.7 };
        let mut directions: Vec<DVec3> = (0..1000)
            .map(|i| math::direction(89.0 + 1e-3 * f64::from(i), f64::from(i)))
            .collect();
        let batch = samples(&cone, &directions, 14).unwrap();
        let single: Vec<_> = directions
            .iter()
            .map(|&p| sample(&cone, p, 14).unwrap())
            .collect();
        assert!(batch == single && batch[0] != batch[999]);
        assert_eq!(samples(&cone, &[], 14), Ok(vec![]));
        assert_eq!(samples(&cone, &directions, 18), Err(GroundError::Level(18)));
        directions[990] = DVec3::NAN;
        assert_eq!(
            samples(&cone, &directions, 14),
            Err(GroundError::NotADirection)
        );
    }

    #[test]
    fn a_planet_without_size_has_no_normals() {
        struct Point;
        impl Ground for Point {
            fn radius_m(&self) -> f64 {
                0.0
            }
            fn height(&self, _: DVec3, _: u8) -> Result<f32, GroundError> {
                Ok(0.0)
            }
        }
        assert_eq!(normal(&Point, DVec3::X, 3), Err(GroundError::Radius(0.0)));
    }

    #[test]
    fn batches_must_fit() {
        let mut heights = [0.0; 2];
        let result = Cone { slope: 1.0 }.heights(&[DVec3::X; 3], 3, &mut heights);
        assert!(matches!(
            result,
            Err(GroundError::Count {
                value: 2,
                min: 3,
                ..
            })
        ));
    }
}
