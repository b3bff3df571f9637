//! The base mesh: an irregular triangulation with edges of about 52 km on an Earth-sized planet
//! (paper 002 §4).
//!
//! It depends on the seed alone and is built once. Its spacing is an angle: a planet of any radius
//! has the same number of vertices, about 230,000.

use crate::climate::Winds;
use crate::noise::Noise;
use crate::parallel;
use crate::random::Purpose;
use crate::sphere::{SphereError, SphereMesh, poisson_disk, relaxed_points};
use bevy::math::DVec3;
use bevy::reflect::Reflect;

/// Smallest distance of vertices in radians that gives edges of 52 km in the mean on an Earth-sized
/// planet (paper 002 §4).
pub const BASE_SPACING: f64 = 0.005_83;

/// Steps of relaxation. Halving hands the shape of a triangle on to all that are made within it, so
/// that an obtuse one would show as streaks down to the finest ground.
const RELAXATION_STEPS: u32 = 3;

/// Frequency in periods per radian of the relief between samples: 150 km on Earth, the distance of
/// samples of the crust.
const RELIEF_FREQUENCY: f64 = 42.0;

/// Octaves of that relief: the second has 75 km, the shortest wave that edges of 52 km hold.
const RELIEF_OCTAVES: u32 = 2;

/// Vertices and triangles, and all that follows from them and the seed alone.
#[derive(Clone, Debug)]
pub struct BaseMesh {
    /// Seed of the planet.
    pub seed: u64,
    /// Vertices and triangles.
    pub mesh: SphereMesh,
    /// The winds at its vertices.
    pub winds: Winds,
    /// Coherent noise of the relief that the crust's samples are too far apart to show, about
    /// -1..1.
    pub noise: Vec<f32>,
}

impl BaseMesh {
    /// The base mesh of a planet; `spacing` is the smallest distance of vertices in radians,
    /// [`BASE_SPACING`] for a planet as the paper has it.
    ///
    /// # Errors
    /// [`SphereError`] if so few points come out that they do not surround the centre.
    ///
    /// ```
    /// use bevy_pangaea::hydrology::BaseMesh;
    ///
    /// let base = BaseMesh::new(7, 0.1)?;
    /// assert!(base.mesh.len() > 500);
    /// assert_eq!(base.noise.len(), base.mesh.len());
    /// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
    /// ```
    pub fn new(seed: u64, spacing: f64) -> Result<Self, SphereError> {
        let points = relaxed_points(poisson_disk(seed, spacing), RELAXATION_STEPS)?;
        // Triangulation has one thread; meanwhile another makes what needs the points alone.
        let (mesh, noise) = rayon::join(
            || SphereMesh::from_points(points.clone()),
            || between_samples(seed, &points),
        );
        let mesh = mesh?;
        let winds = Winds::new(&mesh);
        Ok(Self {
            seed,
            mesh,
            winds,
            noise,
        })
    }
}

/// Noise of the relief between samples at some directions.
fn between_samples(seed: u64, points: &[DVec3]) -> Vec<f32> {
    let noise = Noise::new(seed, Purpose::BaseRelief, 0);
    parallel::map(points.len(), |i| {
        noise.fractal(points[i as usize], RELIEF_FREQUENCY, RELIEF_OCTAVES) as f32
    })
}

/// Where each vertex of the base mesh lies between the samples of another mesh.
#[derive(Clone, Debug, Reflect)]
pub struct Transfer {
    samples: usize,
    corners: Vec<([u32; 3], [f32; 3])>,
}

impl Transfer {
    /// Looks up the vertices of `base` in `lattice`.
    pub fn new(lattice: &SphereMesh, base: &SphereMesh) -> Self {
        let corners = parallel::map(base.len(), |i| {
            let at = lattice.locate(base.point(i));
            (at.vertices, at.weights.map(|w| w as f32))
        });
        Self {
            samples: lattice.len(),
            corners,
        }
    }

    /// Number of samples of the other mesh.
    pub fn samples(&self) -> usize {
        self.samples
    }

    /// Samples around vertex `i` and their weights.
    #[inline]
    pub fn corners(&self, i: usize) -> ([usize; 3], [f32; 3]) {
        let (vertices, weights) = self.corners[i];
        (vertices.map(|v| v as usize), weights)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sphere::relaxed;

    #[test]
    fn a_base_mesh_is_that_of_whole_meshes_one_after_the_other() {
        let base = BaseMesh::new(3, 0.04).unwrap();
        let random = SphereMesh::from_points(poisson_disk(3, 0.04)).unwrap();
        let mesh = SphereMesh::from_points(relaxed(&random, 3)).unwrap();
        assert_eq!(base.mesh.points(), mesh.points());
        assert_eq!(base.mesh.triangles(), mesh.triangles());
        let noise = Noise::new(3, Purpose::BaseRelief, 0);
        let at = |&p: &DVec3| noise.fractal(p, 42.0, 2) as f32;
        assert_eq!(base.noise, mesh.points().iter().map(at).collect::<Vec<_>>());
    }
}
