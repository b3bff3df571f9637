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

use super::SphereMesh;
use super::area::circumcentre;
use crate::parallel::CHUNK;
use bevy::math::DVec3;
use rayon::prelude::*;

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
    let mut points = mesh.points().to_vec();
    for _ in 0..steps {
        let sites = (0..points.len() as u32).into_par_iter().with_min_len(CHUNK);
        points = sites
            .map(|i| cell_centre(&points, mesh.ring(i), i))
            .collect();
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
