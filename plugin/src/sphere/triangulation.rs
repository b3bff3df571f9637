//! Spherical Delaunay triangulation by a planar one.
//!
//! Stereographic projection from one of the points maps circles to circles, so a triangle's empty
//! circumcircle stays empty: the planar Delaunay triangulation of the projected points is the
//! spherical one, but for the triangles at the point projected from. Those are the fan over the
//! edges of the planar hull, as that point lies at infinity in the plane.

use super::SphereError;
use crate::math;
use bevy::math::DVec3;
use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation, mitigate_underflow};

/// A projected point and its index on the sphere.
struct Projected {
    position: Point2<f64>,
    index: u32,
}

impl HasPosition for Projected {
    type Scalar = f64;
    fn position(&self) -> Point2<f64> {
        self.position
    }
}

/// Delaunay triangles of unit vectors, counter-clockwise seen from outside, in no useful order.
///
/// The result covers the sphere only if the points surround its centre; the caller checks that.
pub(super) fn triangulate(points: &[DVec3]) -> Result<Vec<[u32; 3]>, SphereError> {
    let Some((&pole, others)) = points.split_first() else {
        return Err(SphereError::PointCount(0));
    };
    let plane = project(pole, others)?;
    let planar =
        DelaunayTriangulation::<Projected>::bulk_load(plane).map_err(|_| SphereError::Duplicate)?;
    if planar.num_vertices() != others.len() {
        return Err(SphereError::Duplicate);
    }
    // The projection mirrors: counter-clockwise in the plane is clockwise seen from outside.
    let mut triangles = Vec::with_capacity((2 * points.len()).saturating_sub(4));
    triangles.extend(planar.inner_faces().map(|face| {
        let [a, b, c] = face.vertices().map(|v| v.data().index);
        [a, c, b]
    }));
    // Hull edges have the plane's outside on their left, hence the pole.
    triangles.extend(planar.convex_hull().map(|edge| {
        let [a, b] = edge.vertices().map(|v| v.data().index);
        [b, a, 0]
    }));
    Ok(triangles)
}

/// The stereographic projections of `others` from `pole`.
fn project(pole: DVec3, others: &[DVec3]) -> Result<Vec<Projected>, SphereError> {
    let e1 = math::any_tangent(pole);
    let e2 = pole.cross(e1);
    let mut projected = Vec::with_capacity(others.len());
    for (index, &p) in (1..).zip(others) {
        // An inversion: 2 d/|d|² for d = p - pole keeps all digits for points close to the pole,
        // where the textbook form x/(1 - z) loses them.
        let d = p - pole;
        let length_squared = d.length_squared();
        if length_squared == 0.0 {
            return Err(SphereError::Duplicate);
        }
        let scale = 2.0 / length_squared;
        let position = mitigate_underflow(Point2::new(d.dot(e1) * scale, d.dot(e2) * scale));
        projected.push(Projected { position, index });
    }
    Ok(projected)
}

#[cfg(test)]
#[path = "triangulation_tests.rs"]
mod tests;
