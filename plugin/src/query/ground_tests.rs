use super::*;
use crate::math;
use crate::query::GroundSurface;

/// A cone around +z: its flanks fall at `slope` (a tangent); the rest is sea floor at -100 m.
struct ConicalIsland {
    slope: f64,
}

impl Ground for ConicalIsland {
    fn radius_m(&self) -> f64 {
        1e6
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let up = checked(direction, level)?;
        let away = math::angle_between(up, DVec3::Z) * 1e6;
        Ok((5000.0 - self.slope * away).max(-100.0) as f32)
    }

    fn climate(&self, _: DVec3, _: f32) -> Result<ClimateSample, GroundError> {
        Ok(ClimateSample {
            temperature_c: 10.0,
            wetness: 0.3,
        })
    }
}

#[test]
fn normals_of_a_cone_have_its_slope_and_point_away_from_its_axis() {
    let ground = ConicalIsland { slope: 0.5 };
    for lon in [0.0, 77.0, 200.0] {
        let up = math::direction(89.8, lon);
        let n = ground.normal(up, 12).unwrap();
        let slope = math::angle_between(up, n);
        // The radius at that height is 1e6 + 3255 m.
        let tangent = math::sin(slope) / math::cos(slope);
        assert!((tangent - 0.5).abs() < 4e-3, "{slope}");
        assert!((n - up * n.dot(up)).dot(DVec3::Z) < 0.0);
    }
    let level = math::direction(12.0, 5.0);
    let flat = ground.normal(level, 9).unwrap();
    assert!(math::angle_between(flat, level) < 1e-9);
    assert!(ground.normal(DVec3::Z, 17).unwrap().dot(DVec3::Z) > 0.999);
}

#[test]
fn a_sample_knows_water_and_surface() {
    let steep = ConicalIsland { slope: 1.0 };
    let flank = steep.sample(math::direction(89.9, 0.0) * 7.0, 14).unwrap();
    assert_eq!(flank.surface, GroundSurface::Rock);
    assert_eq!(flank.water_m, flank.height_m);
    let sea = steep.sample(DVec3::X, 14).unwrap();
    assert_eq!(sea.surface, GroundSurface::SeaFloor);
    assert_eq!([sea.height_m, sea.water_m], [-100.0, 0.0]);
    assert_eq!(steep.sample(DVec3::X, 18), Err(GroundError::Level(18)));
    let nowhere = steep.sample(DVec3::ZERO, 3);
    assert_eq!(nowhere, Err(GroundError::NotADirection));
}

#[test]
fn a_batch_has_the_samples_of_single_questions() {
    let cone = ConicalIsland { slope: 0.7 };
    let direction = |i| math::direction(89.0 + 1e-3 * f64::from(i), f64::from(i));
    let directions: Vec<DVec3> = (0..1000).map(direction).collect();
    let batch = cone.samples(&directions, 14).unwrap();
    let single = directions.iter().map(|&p| cone.sample(p, 14).unwrap());
    assert!(batch.iter().copied().eq(single) && batch[0] != batch[999]);
    assert_eq!(cone.samples(&[], 14), Ok(vec![]));
}

#[test]
fn a_batch_tells_the_first_error() {
    let cone = ConicalIsland { slope: 0.7 };
    let mut directions = vec![DVec3::Z; 1000];
    let refused = cone.samples(&directions, 18);
    assert_eq!(refused, Err(GroundError::Level(18)));
    directions[990] = DVec3::NAN;
    let refused = cone.samples(&directions, 14);
    assert_eq!(refused, Err(GroundError::NotADirection));
}

#[test]
fn a_planet_without_size_has_no_normals() {
    struct Dot;
    impl Ground for Dot {
        fn radius_m(&self) -> f64 {
            0.0
        }

        fn height(&self, _: DVec3, _: u8) -> Result<f32, GroundError> {
            Ok(0.0)
        }
    }
    assert_eq!(Dot.normal(DVec3::X, 3), Err(GroundError::Radius(0.0)));
}

#[test]
fn batches_must_fit() {
    let mut heights = [0.0; 2];
    let cone = ConicalIsland { slope: 1.0 };
    let refused = cone.heights(&[DVec3::X; 3], 3, &mut heights);
    let expected = GroundError::Count {
        what: "the number of heights",
        value: 2,
        min: 3,
        max: 3,
    };
    assert_eq!(refused, Err(expected));
}
