//! Lloyd's relaxation: points move to the centres of their Voronoi cells (Lloyd 1982, "Least
//! squares quantization in PCM").
//!
//! Random points have obtuse triangles among them; a few steps open these and leave the mesh
//! without rows or preferred directions. The centre of a cell is the mean of its surface,
//!
//! ```text
//! c = Σ Aₖ (p + vₖ + vₖ₊₁) / 3      Aₖ: area of the triangle p, vₖ, vₖ₊₁; vₖ: circumcentres
//! ```
//!
//! back on the sphere. Neighbours are those of the first triangulation in every step: points move
//! by fractions of their distance, and a new triangulation costs ten steps.

use super::area::circumcentre;
use super::mesh::{checked, neighbours};
use super::{SphereError, SphereMesh};
use crate::parallel;
use bevy::math::DVec3;

/// The points of a mesh after some steps of relaxation, in their order.
///
/// ```
/// # use bevy_pangaea::sphere::{SphereMesh, poisson_disk, relaxed};
/// let mesh = SphereMesh::from_points(poisson_disk(7, 0.1))?;
/// let even = SphereMesh::from_points(relaxed(&mesh, 3))?;
/// let spread = |mesh: &SphereMesh| mesh.areas().iter().map(|area| area * area).sum::<f64>();
/// assert!(spread(&even) < spread(&mesh), "cells become alike");
/// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
/// ```
pub fn relaxed(mesh: &SphereMesh, steps: u32) -> Vec<DVec3> {
    moved(mesh.points().to_vec(), |i| mesh.ring(i), steps)
}

/// Points after some steps of relaxation, as [`relaxed`] has them on their mesh, of which no more is
/// made than the neighbours.
///
/// # Errors
/// As [`SphereMesh::from_points`].
///
/// ```
/// # use bevy_pangaea::sphere::{SphereMesh, poisson_disk, relaxed, relaxed_points};
/// let random = poisson_disk(7, 0.1);
/// let even = relaxed_points(random.clone(), 3)?;
/// assert_eq!(even, relaxed(&SphereMesh::from_points(random)?, 3));
/// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
/// ```
pub fn relaxed_points(points: Vec<DVec3>, steps: u32) -> Result<Vec<DVec3>, SphereError> {
    let points = checked(points)?;
    let rings = neighbours(&points)?;
    Ok(moved(points, |i| rings.of(i), steps))
}

/// Points moved by some steps, by their neighbours.
fn moved<'a>(
    mut points: Vec<DVec3>,
    ring: impl Fn(u32) -> &'a [u32] + Sync + Send,
    steps: u32,
) -> Vec<DVec3> {
    for _ in 0..steps {
        points = parallel::map(points.len(), |i| cell_centre(&points, ring(i), i));
    }
    points
}

/// Centre of the cell of point `i`, a unit vector.
fn cell_centre(points: &[DVec3], ring: &[u32], i: u32) -> DVec3 {
    let site = points[i as usize];
    let &[.., before, last] = ring else {
        return site;
    };
    let mut edge = points[last as usize];
    let mut corner = circumcentre(site, points[before as usize], edge);
    let mut sum = DVec3::ZERO;
    let mut area = 0.0;
    // Offsets from the site keep the digits that whole vectors would lose.
    for &j in ring {
        let next_edge = points[j as usize];
        let next_corner = circumcentre(site, edge, next_edge);
        let [from, to] = [corner - site, next_corner - site];
        let part = site.dot(from.cross(to));
        sum += part * (from + to) / 3.0;
        area += part;
        (edge, corner) = (next_edge, next_corner);
    }
    if area > 0.0 {
        (site + sum / area).normalize()
    } else {
        site
    }
}

#[cfg(test)]
#[path = "relaxation_tests.rs"]
mod tests;
