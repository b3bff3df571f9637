//! Shapes of triangles, irregularity, symmetry.

use super::*;
use crate::math;
use crate::sphere::poisson_disk;

/// Shares of the triangles that are obtuse.
fn obtuse_share(mesh: &SphereMesh) -> f64 {
    let corners = |triangle: &[u32; 3]| triangle.map(|i| mesh.point(i));
    let triangles = mesh.triangles().iter().map(corners);
    triangles.filter(is_obtuse).count() as f64 / mesh.triangles().len() as f64
}

fn is_obtuse(corners: &[DVec3; 3]) -> bool {
    (0..3).any(|k| {
        let [a, b, c] = [corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]];
        (b - a).dot(c - a) < 0.0
    })
}

#[test]
fn three_steps_leave_few_obtuse_triangles_and_no_lattice() {
    let random = SphereMesh::from_points(poisson_disk(4, 0.02)).unwrap();
    let even = SphereMesh::from_points(relaxed(&random, 3)).unwrap();
    let shares = [&random, &even].map(obtuse_share);
    assert!(
        shares[0] > 0.15 && shares[1] < 0.6 * shares[0],
        "{shares:?}"
    );
    let six = (0..even.len() as u32).filter(|&i| even.ring(i).len() == 6);
    let six = six.count() as f64 / even.len() as f64;
    assert!(six < 0.85, "{six}");
}

#[test]
fn corners_of_a_regular_solid_stay() {
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].into_iter();
    let axes: Vec<DVec3> = axes.flat_map(|axis| [axis, -axis]).collect();
    let mesh = SphereMesh::from_points(axes.clone()).unwrap();
    for (axis, point) in axes.iter().zip(relaxed(&mesh, 5)) {
        assert!(math::angle_between(*axis, point) < 1e-12);
    }
}

#[test]
fn a_point_moves_to_the_middle_of_its_neighbours() {
    let mut points = vec![DVec3::Z, -DVec3::Z, DVec3::new(0.1, 0.05, 1.0).normalize()];
    for k in 0..4 {
        let (sin, cos) = math::sin_cos(math::TAU * f64::from(k) / 4.0);
        points.push(DVec3::new(cos, sin, 1.0).normalize());
        points.push(DVec3::new(cos, sin, -0.5).normalize());
    }
    points.remove(0);
    let mesh = SphereMesh::from_points(points.clone()).unwrap();
    let before = math::angle_between(points[1], DVec3::Z);
    let after = math::angle_between(relaxed(&mesh, 1)[1], DVec3::Z);
    assert!(after < 0.7 * before, "{before} {after}");
}
