//! The ground of the crust alone: interpolated between the samples of the lattice, the same at
//! every level.
//!
//! It serves planets whose ground was not amplified, and tests.

use super::{Ground, GroundError, checked};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use std::sync::Arc;

/// A ground that interpolates heights given at the samples of a mesh.
#[derive(Clone, Debug)]
pub struct CoarseGround {
    mesh: Arc<SphereMesh>,
    heights_m: Vec<f32>,
    radius_m: f64,
    bounds_m: [f64; 2],
}

impl CoarseGround {
    /// A ground of `heights_m` above the sea at the samples of `mesh`, on a planet of `radius_m`.
    ///
    /// # Errors
    /// [`GroundError::Radius`]; [`GroundError::Count`] if there is not one height per sample;
    /// [`GroundError::Unavailable`] if one is not a number.
    pub fn new(
        mesh: Arc<SphereMesh>,
        heights_m: Vec<f32>,
        radius_m: f64,
    ) -> Result<Self, GroundError> {
        if !(radius_m > 0.0 && radius_m.is_finite()) {
            return Err(GroundError::Radius(radius_m));
        }
        if heights_m.len() != mesh.len() {
            let n = mesh.len();
            return Err(GroundError::Count {
                what: "heights",
                value: heights_m.len(),
                min: n,
                max: n,
            });
        }
        if let Some(i) = heights_m.iter().position(|height| !height.is_finite()) {
            return Err(GroundError::Unavailable(format!(
                "the height of sample {i} is not a number"
            )));
        }
        let bound = |best: fn(f32, f32) -> f32| {
            f64::from(heights_m.iter().copied().fold(heights_m[0], best))
        };
        let bounds_m = [bound(f32::min), bound(f32::max)];
        Ok(Self {
            mesh,
            heights_m,
            radius_m,
            bounds_m,
        })
    }
}

impl Ground for CoarseGround {
    fn radius_m(&self) -> f64 {
        self.radius_m
    }

    fn height(&self, direction: DVec3, level: u8) -> Result<f32, GroundError> {
        let place = self.mesh.locate(checked(direction, level)?);
        Ok(place.interpolate(|i| f64::from(self.heights_m[i as usize])) as f32)
    }

    fn bounds_m(&self) -> [f64; 2] {
        self.bounds_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_keep_their_heights_and_points_between_lie_between() {
        let mesh = Arc::new(SphereMesh::fibonacci(2000).unwrap());
        let heights: Vec<f32> = mesh.points().iter().map(|p| 1000.0 * p.z as f32).collect();
        let ground = CoarseGround::new(mesh.clone(), heights.clone(), 1e6).unwrap();
        for i in (0..2000).step_by(37) {
            assert_eq!(
                ground.height(mesh.point(i), 5).unwrap(),
                heights[i as usize]
            );
        }
        for lat in [-80.0, -12.5, 0.0, 33.0, 89.0] {
            let p = crate::math::direction(lat, 100.0 + lat);
            let found = f64::from(ground.height(p * 3.0, 17).unwrap());
            // The chords of 2000 samples sink below the sphere by 0.1 %.
            assert!((found - 1000.0 * p.z).abs() < 1.5, "{found} {}", p.z);
            assert_eq!(ground.height(p, 0), ground.height(p, 17));
        }
        let [low, high] = ground.bounds_m();
        assert!(low < -990.0 && high > 990.0);
    }

    #[test]
    fn bad_grounds_are_refused() {
        let mesh = Arc::new(SphereMesh::fibonacci(100).unwrap());
        let new = |heights: Vec<f32>, radius| {
            CoarseGround::new(mesh.clone(), heights, radius).map(|_| ())
        };
        assert_eq!(new(vec![0.0; 100], 0.0), Err(GroundError::Radius(0.0)));
        assert!(matches!(
            new(vec![0.0; 100], f64::NAN),
            Err(GroundError::Radius(_))
        ));
        assert!(matches!(
            new(vec![0.0; 99], 1e6),
            Err(GroundError::Count { value: 99, .. })
        ));
        assert!(matches!(
            new(vec![f32::NAN; 100], 1e6),
            Err(GroundError::Unavailable(_))
        ));
        let ground = CoarseGround::new(mesh.clone(), vec![0.0; 100], 1e6).unwrap();
        assert_eq!(ground.height(DVec3::X, 18), Err(GroundError::Level(18)));
        assert_eq!(
            ground.height(DVec3::NAN, 1),
            Err(GroundError::NotADirection)
        );
    }
}
