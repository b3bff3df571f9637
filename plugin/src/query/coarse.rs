//! The ground of the crust alone: interpolated between the samples of the lattice, the same at
//! every level.
//!
//! It serves planets whose ground was not amplified, and tests.

use super::check::{check_count, check_radius, checked};
use super::error::GroundError;
use super::ground::Ground;
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
    /// ```
    /// use bevy::math::DVec3;
    /// use bevy_pangaea::query::{CoarseGround, Ground};
    /// use bevy_pangaea::sphere::SphereMesh;
    /// use std::sync::Arc;
    ///
    /// let mesh = Arc::new(SphereMesh::fibonacci(1000)?);
    /// let heights = mesh.points().iter().map(|p| 4000.0 * p.z as f32).collect();
    /// let ground = CoarseGround::new(mesh, heights, 6_370_000.0)?;
    /// assert!(ground.height(DVec3::Z, 17)? > 3950.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`GroundError::Radius`]; [`GroundError::Count`] if there is not one height per sample;
    /// [`GroundError::Unavailable`] if one is infinite or NaN.
    pub fn new(
        mesh: Arc<SphereMesh>,
        heights_m: Vec<f32>,
        radius_m: f64,
    ) -> Result<Self, GroundError> {
        check_radius(radius_m)?;
        check_count("heights", heights_m.len(), [mesh.len(), mesh.len()])?;
        if let Some(i) = heights_m.iter().position(|height| !height.is_finite()) {
            let reason = format!("the height of sample {i} is not a number");
            return Err(GroundError::Unavailable(reason));
        }
        let mut bounds = [heights_m[0]; 2];
        for &height in &heights_m {
            bounds = [bounds[0].min(height), bounds[1].max(height)];
        }
        Ok(Self {
            mesh,
            heights_m,
            radius_m,
            bounds_m: bounds.map(f64::from),
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

    fn ground(samples: u32, height: impl Fn(DVec3) -> f32) -> CoarseGround {
        let mesh = Arc::new(SphereMesh::fibonacci(samples).unwrap());
        let heights = mesh.points().iter().map(|&p| height(p)).collect();
        CoarseGround::new(mesh, heights, 1e6).unwrap()
    }

    /// Height in m that falls from the north pole to the south pole.
    fn tilted(p: DVec3) -> f32 {
        1000.0 * p.z as f32
    }

    #[test]
    fn samples_keep_their_heights() {
        let ground = ground(2000, tilted);
        for i in (0..2000).step_by(37) {
            let p = ground.mesh.point(i);
            assert_eq!(ground.height(p, 5).unwrap(), tilted(p));
        }
        let [low, high] = ground.bounds_m();
        assert!(low < -990.0 && high > 990.0);
    }

    #[test]
    fn points_between_samples_lie_between() {
        let ground = ground(2000, tilted);
        for lat in [-80.0, -12.5, 0.0, 33.0, 89.0] {
            let p = crate::math::direction(lat, 100.0 + lat);
            let found = f64::from(ground.height(p * 3.0, 17).unwrap());
            // The chords of 2000 samples sink below the sphere by 0.1 %.
            assert!((found - 1000.0 * p.z).abs() < 1.5, "{found} {}", p.z);
            assert_eq!(ground.height(p, 0), ground.height(p, 17));
        }
    }

    /// The error of a ground of 100 samples.
    fn refused(heights: Vec<f32>, radius: f64) -> GroundError {
        let mesh = Arc::new(SphereMesh::fibonacci(100).unwrap());
        CoarseGround::new(mesh, heights, radius).unwrap_err()
    }

    #[test]
    fn bad_grounds_are_refused() {
        for radius in [0.0, f64::NAN] {
            let error = refused(vec![0.0; 100], radius);
            assert!(matches!(error, GroundError::Radius(_)));
        }
        let short = refused(vec![0.0; 99], 1e6);
        assert!(matches!(short, GroundError::Count { value: 99, .. }));
        let nan = refused(vec![f32::NAN; 100], 1e6);
        assert!(matches!(nan, GroundError::Unavailable(_)));
    }

    #[test]
    fn bad_questions_are_refused() {
        let ground = ground(100, |_| 0.0);
        assert_eq!(ground.height(DVec3::X, 18), Err(GroundError::Level(18)));
        let nowhere = ground.height(DVec3::NAN, 1);
        assert_eq!(nowhere, Err(GroundError::NotADirection));
    }
}
