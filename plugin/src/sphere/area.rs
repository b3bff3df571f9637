//! Areas of the spherical Voronoi cells.
//!
//! The cell of a sample is the polygon of the circumcentres of its triangles. It is cut into
//! triangles (sample, circumcentre, next circumcentre). The area E of a spherical triangle of unit
//! vectors a, b, c obeys tan(E/2) = a·(b×c) / (1 + a·b + b·c + c·a) (Eriksson 1990): E/2 is the
//! angle of a complex number, so a cell's area follows from the product of its triangles' numbers
//! and a single arc tangent. A Voronoi cell is smaller than a hemisphere, so that angle stays below
//! π.

use super::rings::NeighbourRings;
use crate::{math, parallel::CHUNK};
use bevy::math::DVec3;
use rayon::prelude::*;

/// Area in steradian of every sample's cell; the areas sum to 4π.
pub(super) fn voronoi_areas(points: &[DVec3], rings: &NeighbourRings) -> Vec<f64> {
    let cells = (0..points.len() as u32).into_par_iter().with_min_len(CHUNK);
    cells
        .map(|i| cell_area(points, rings.of(i), points[i as usize]))
        .collect()
}

fn cell_area(points: &[DVec3], ring: &[u32], site: DVec3) -> f64 {
    let Some(&last) = ring.last() else { return 0.0 };
    let mut edge = points[last as usize];
    let mut corner = DVec3::ZERO;
    let (mut re, mut im) = (1.0, 0.0);
    // The first turn only yields the corner that the second one starts from.
    for (k, &j) in ring.iter().chain(ring.first()).enumerate() {
        let next_edge = points[j as usize];
        let next_corner = circumcentre(site, edge, next_edge);
        if k > 0 {
            let (c, s) = half_area(site, corner, next_corner);
            // The product of complex numbers adds their angles.
            (re, im) = (re * c - im * s, re * s + im * c);
            // Only the angle counts; the length would overflow in large rings.
            if k % 64 == 0 {
                let scale = 1.0 / (re * re + im * im).sqrt();
                (re, im) = (re * scale, im * scale);
            }
        }
        (edge, corner) = (next_edge, next_corner);
    }
    2.0 * math::atan2(im, re)
}

/// Centre of the circle through three points, counter-clockwise seen from outside.
pub(super) fn circumcentre(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    let normal = (b - a).cross(c - a);
    // Nearly coincident points give a very short normal, whose square must not underflow.
    let scaled = normal / normal.abs().max_element();
    scaled / scaled.length()
}

/// A complex number whose angle is half the area of a triangle with its first corner at `a`.
fn half_area(a: DVec3, b: DVec3, c: DVec3) -> (f64, f64) {
    // a·(b×c) by differences: exact to the last digits for small triangles, too.
    (
        1.0 + a.dot(b) + b.dot(c) + c.dot(a),
        a.dot((b - a).cross(c - a)),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Stream};
    use crate::sphere::SphereMesh;

    #[test]
    fn octahedron_cells_are_a_sixth_of_the_sphere() {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z].into_iter();
        let axes = axes.flat_map(|axis| [axis, -axis]).collect();
        let mesh = SphereMesh::from_points(axes).unwrap();
        assert!(
            mesh.areas()
                .iter()
                .all(|a| (a - 4.0 * math::PI / 6.0).abs() < 1e-14)
        );
    }

    #[test]
    fn fibonacci_cells_are_equal_and_fill_the_sphere() {
        let mesh = SphereMesh::fibonacci(20_000).unwrap();
        let mean = 4.0 * math::PI / 20_000.0;
        let sum: f64 = mesh.areas().iter().sum();
        assert!((sum - 4.0 * math::PI).abs() < 1e-10, "{sum}");
        // Within a few spacings of the poles the spiral's cells vary more.
        for (p, area) in mesh.points().iter().zip(mesh.areas()) {
            let tolerance = if p.z.abs() < 0.99 { 0.02 } else { 0.15 };
            assert!(
                (area / mean - 1.0).abs() < tolerance,
                "{p}: {}",
                area / mean
            );
        }
    }

    #[test]
    fn random_cells_fill_the_sphere_and_match_counted_areas() {
        let stream = Stream::new(11, Purpose::Relief, 0);
        let mesh = SphereMesh::from_points((0..30).map(|i| stream.direction(i)).collect()).unwrap();
        let sum: f64 = mesh.areas().iter().sum();
        assert!((sum - 4.0 * math::PI).abs() < 1e-12, "{sum}");
        let darts = 200_000;
        let mut hits = [0u32; 30];
        for i in 0..darts {
            hits[mesh.nearest(stream.direction(1000 + i)) as usize] += 1;
        }
        let dart = 4.0 * math::PI / darts as f64;
        for (area, hit) in mesh.areas().iter().zip(hits) {
            assert!((area - f64::from(hit) * dart).abs() < 0.02, "{area} {hit}");
        }
    }
}
