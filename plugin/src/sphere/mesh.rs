//! The immutable lattice of samples that a planet's crust is stored on.

use super::nearest::{SeedGrid, Walk, clearance};
use super::rings::NeighbourRings;
use super::triangulation::triangulate;
use super::{SphereError, area, sampling};
use crate::{math, parallel::CHUNK};
use bevy::math::DVec3;
use rayon::prelude::*;
use std::fmt;

/// Samples on the unit sphere, their spherical Delaunay triangulation, Voronoi areas and a lookup
/// of the nearest sample.
///
/// Takes about 100 bytes per sample. Indices are `u32`; methods that take the index of a sample
/// panic, like a slice, if there is no such sample.
///
/// ```
/// # use bevy_pangaea::{math, sphere::{SphereError, SphereMesh}};
/// let mesh = SphereMesh::fibonacci(2000)?;
/// let p = math::direction(47.0, 8.0);
/// let nearest = mesh.nearest(p);
/// assert!(math::angle_between(mesh.point(nearest), p) < mesh.spacing());
///
/// // Around every sample its neighbours lie in order; all cells together cover the sphere.
/// assert!((3..12).contains(&mesh.ring(nearest).len()));
/// assert!((mesh.areas().iter().sum::<f64>() - 4.0 * math::PI).abs() < 1e-9);
/// # Ok::<(), SphereError>(())
/// ```
#[derive(Clone)]
pub struct SphereMesh {
    points: Vec<DVec3>,
    rings: NeighbourRings,
    seeds: SeedGrid,
    clearance: f64,
    triangles: Vec<[u32; 3]>,
    areas: Vec<f64>,
    is_fibonacci: bool,
}

impl SphereMesh {
    /// Fewest samples of a planet.
    pub const MIN_SAMPLES: u32 = 100;
    /// Most samples of a planet.
    pub const MAX_SAMPLES: u32 = 2_000_000;

    /// `samples` spherical Fibonacci points, evenly spread.
    ///
    /// # Errors
    /// [`SphereError::SampleCount`] outside of 100..=2,000,000.
    pub fn fibonacci(samples: u32) -> Result<Self, SphereError> {
        if !(Self::MIN_SAMPLES..=Self::MAX_SAMPLES).contains(&samples) {
            return Err(SphereError::SampleCount(samples));
        }
        let mesh = Self::build(sampling::fibonacci(samples))?;
        Ok(Self {
            is_fibonacci: true,
            ..mesh
        })
    }

    /// A mesh of any points, in the order given.
    ///
    /// Points need not have length 1; those that have it keep their bits.
    ///
    /// # Errors
    /// [`SphereError`] for fewer than 4 or more than 2,000,000 points, for points that are zero,
    /// infinite or NaN, for points that coincide, and for points that leave a hemisphere empty.
    ///
    /// ```
    /// # use bevy::math::DVec3;
    /// # use bevy_pangaea::sphere::{SphereError, SphereMesh};
    /// let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
    /// let octahedron = SphereMesh::from_points(axes.to_vec())?;
    /// assert_eq!(octahedron.ring(0), [1, 2, 4, 5]);
    /// assert_eq!(octahedron.triangles().len(), 8);
    ///
    /// let half = axes[..5].to_vec();
    /// assert_eq!(SphereMesh::from_points(half).unwrap_err(), SphereError::EmptyHemisphere);
    /// # Ok::<(), SphereError>(())
    /// ```
    pub fn from_points(points: Vec<DVec3>) -> Result<Self, SphereError> {
        Self::build(checked(points)?)
    }

    fn build(points: Vec<DVec3>) -> Result<Self, SphereError> {
        let rings = neighbours(&points)?;
        let triangles = rings.triangles();
        let areas = area::voronoi_areas(&points, &rings);
        let clearance = clearance(&points, &rings);
        let seeds = SeedGrid::new(Walk {
            points: &points,
            rings: &rings,
            clearance,
        });
        Ok(Self {
            points,
            rings,
            seeds,
            clearance,
            triangles,
            areas,
            is_fibonacci: false,
        })
    }

    #[inline(always)]
    fn walk(&self) -> Walk<'_> {
        Walk {
            points: &self.points,
            rings: &self.rings,
            clearance: self.clearance,
        }
    }

    /// The sample nearest to the unit vector `p`; of several, the one with the lowest index.
    #[inline]
    pub fn nearest(&self, p: DVec3) -> u32 {
        self.walk().nearest(p, self.seeds.seed(p))
    }

    /// The sample nearest to the unit vector `p`, searched from the sample `hint`.
    ///
    /// Gives what [`nearest`](Self::nearest) gives. Cheaper than that if `hint` is next to `p`; the
    /// cost grows with the number of samples between.
    #[inline]
    pub fn nearest_from(&self, p: DVec3, hint: u32) -> u32 {
        self.walk()
            .nearest(p, hint.min(self.points.len() as u32 - 1))
    }

    /// Number of samples.
    #[inline]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Never true: a mesh has at least four samples.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Whether this mesh was made by [`fibonacci`](Self::fibonacci), and so follows from its number
    /// of samples.
    #[inline]
    pub fn is_fibonacci(&self) -> bool {
        self.is_fibonacci
    }

    /// All samples, unit vectors.
    #[inline]
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// Sample `i`, a unit vector.
    #[inline]
    pub fn point(&self, i: u32) -> DVec3 {
        self.points[i as usize]
    }

    /// The 2n - 4 triangles, counter-clockwise seen from outside, each with its lowest index first,
    /// in the order of that index.
    #[inline]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Neighbours of sample `i`, counter-clockwise seen from outside, beginning with the lowest
    /// index.
    #[inline]
    pub fn ring(&self, i: u32) -> &[u32] {
        self.rings.of(i)
    }

    /// Area of the Voronoi cell of sample `i`, in steradian.
    #[inline]
    pub fn area(&self, i: u32) -> f64 {
        self.areas[i as usize]
    }

    /// Areas of all Voronoi cells, in steradian; they sum to 4π.
    #[inline]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Mean distance of neighbouring samples in radians, that of a hexagonal lattice of the same
    /// density.
    pub fn spacing(&self) -> f64 {
        (8.0 * math::PI / (3.0_f64.sqrt() * self.len() as f64)).sqrt()
    }
}

impl fmt::Debug for SphereMesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SphereMesh")
            .field("samples", &self.len())
            .finish_non_exhaustive()
    }
}

/// Unit vectors of as many points as a mesh may have.
pub(super) fn checked(mut points: Vec<DVec3>) -> Result<Vec<DVec3>, SphereError> {
    if points.len() < 4 || points.len() > SphereMesh::MAX_SAMPLES as usize {
        return Err(SphereError::PointCount(points.len()));
    }
    for (i, p) in points.iter_mut().enumerate() {
        *p = normalised(*p).ok_or(SphereError::NotADirection(i))?;
    }
    Ok(points)
}

/// Neighbours of unit vectors in their Delaunay triangulation.
pub(super) fn neighbours(points: &[DVec3]) -> Result<NeighbourRings, SphereError> {
    let triangles = triangulate(points)?;
    if !surrounds_centre(points, &triangles) {
        return Err(SphereError::EmptyHemisphere);
    }
    // Triangles follow from the rings again, in order: both at once would double the memory.
    NeighbourRings::new(points.len(), &triangles).ok_or(SphereError::EmptyHemisphere)
}

/// The direction of `p`, the same bits if it is a unit vector already; `None` if `p` is zero or not
/// finite.
fn normalised(p: DVec3) -> Option<DVec3> {
    if (p.length_squared() - 1.0).abs() < 1e-15 {
        return Some(p);
    }
    let largest = p.abs().max_element();
    // Dividing by the largest coordinate first keeps the length clear of overflow and underflow.
    (p.is_finite() && largest > 0.0).then(|| (p / largest).normalize())
}

/// Whether all triangles face away from the centre, as those of points around it do.
fn surrounds_centre(points: &[DVec3], triangles: &[[u32; 3]]) -> bool {
    triangles.par_iter().with_min_len(CHUNK).all(|t| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        a.dot((b - a).cross(c - a)) > 0.0
    })
}

#[cfg(test)]
#[path = "mesh_tests.rs"]
mod tests;
