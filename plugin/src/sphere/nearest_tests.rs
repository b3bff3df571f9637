//! The nearest sample against brute force.

use crate::math;
use crate::random::{Purpose, Stream};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

fn random_mesh(n: u64) -> SphereMesh {
    let stream = Stream::new(41, Purpose::Relief, 0);
    SphereMesh::from_points((0..n).map(|i| stream.direction(i)).collect()).unwrap()
}

/// Samples crowded within 0.01 rad of one axis, and a few that close the sphere.
fn clustered_mesh() -> SphereMesh {
    let stream = Stream::new(42, Purpose::Relief, 0);
    let mut points: Vec<DVec3> = (0..40).map(|i| stream.direction(i)).collect();
    points.extend((40..1000).map(|i| DVec3::X + stream.direction(i) * 0.01));
    SphereMesh::from_points(points).unwrap()
}

fn meshes() -> [SphereMesh; 4] {
    let fibonacci = |n| SphereMesh::fibonacci(n).unwrap();
    [
        fibonacci(100),
        fibonacci(2500),
        random_mesh(1500),
        clustered_mesh(),
    ]
}

/// The policy in words: least distance, then least index.
fn brute_force(mesh: &SphereMesh, p: DVec3) -> u32 {
    let distance = |i: u32| (mesh.point(i) - p).length_squared();
    (0..mesh.len() as u32)
        .min_by(|&a, &b| distance(a).total_cmp(&distance(b)).then(a.cmp(&b)))
        .unwrap()
}

fn check(mesh: &SphereMesh, p: DVec3) {
    let expected = brute_force(mesh, p);
    assert_eq!(mesh.nearest(p), expected, "{p}");
    for hint in [
        0,
        17,
        mesh.len() as u32 / 2,
        mesh.len() as u32 - 1,
        u32::MAX,
    ] {
        assert_eq!(mesh.nearest_from(p, hint), expected, "{p} from {hint}");
    }
}

#[test]
fn random_directions_and_poles() {
    for mesh in meshes() {
        let stream = Stream::new(43, Purpose::Relief, 1);
        for i in 0..3000 {
            check(&mesh, stream.direction(i));
        }
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            check(&mesh, axis);
            check(&mesh, -axis);
        }
        // Borders and corners of the grid's faces.
        for (x, y, z) in [
            (1., 1., 1.),
            (-1., 1., 1.),
            (1., -1., -1.),
            (1., 1., 0.),
            (0., -1., 1.),
        ] {
            check(&mesh, DVec3::new(x, y, z).normalize());
        }
    }
}

#[test]
fn samples_and_points_next_to_them() {
    for mesh in meshes() {
        let stream = Stream::new(44, Purpose::Relief, 2);
        for i in 0..mesh.len() as u32 {
            let p = mesh.point(i);
            assert_eq!(mesh.nearest(p), i);
            let q = (p + stream.direction(i.into()) * 1e-12).normalize();
            assert_eq!(mesh.nearest(q), i);
        }
    }
}

#[test]
fn points_on_bisectors_and_voronoi_corners() {
    for mesh in meshes() {
        for &t in mesh.triangles().iter().step_by(3) {
            let [a, b, c] = t.map(|i| mesh.point(i));
            check(&mesh, (a + b).normalize());
            check(&mesh, (b - a).cross(c - a).normalize());
        }
    }
}

/// The policy holds from every sample that a search may start from.
fn check_all_hints(mesh: &SphereMesh, p: DVec3) {
    let expected = brute_force(mesh, p);
    for hint in 0..mesh.len() as u32 {
        assert_eq!(mesh.nearest_from(p, hint), expected, "{p} from {hint}");
    }
}

#[test]
fn ties_between_four_samples_go_to_the_lowest_index() {
    // The centre of a cube's face is equally far from four samples, of which two are no neighbours.
    let side = |i: i32, bit: i32| if i & bit == 0 { -1.0 } else { 1.0 };
    let corner = |i: i32| DVec3::new(side(i, 1), side(i, 2), side(i, 4)).normalize();
    for turn in 0..8 {
        let points = (0..8).map(|i| corner((i + turn) % 8)).collect();
        let mesh = SphereMesh::from_points(points).unwrap();
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            check_all_hints(&mesh, axis);
            check_all_hints(&mesh, -axis);
        }
    }
}

#[test]
fn ties_between_a_whole_parallel_go_to_the_lowest_index() {
    let mut points = vec![DVec3::NEG_Z];
    for lat in (-80..=80).step_by(20) {
        let meridians = (0..360).step_by(6);
        points.extend(meridians.map(|lon| math::direction(lat.into(), lon.into())));
    }
    let mesh = SphereMesh::from_points(points).unwrap();
    check_all_hints(&mesh, DVec3::Z);
}

#[test]
fn close_samples_are_told_apart() {
    // Two samples 1e-9 rad apart: dot products with both round to 1.
    let mut points: Vec<DVec3> = random_mesh(200).points().to_vec();
    points.push((points[5] + math::any_tangent(points[5]) * 1e-9).normalize());
    let mesh = SphereMesh::from_points(points).unwrap();
    let (a, b) = (mesh.point(5), mesh.point(200));
    for (share, expected) in [
        (0.0, 5),
        (0.3, 5),
        (0.48, 5),
        (0.52, 200),
        (0.8, 200),
        (1.0, 200),
    ] {
        assert_eq!(mesh.nearest(a + (b - a) * share), expected);
    }
}

#[test]
fn zero_and_infinite_directions_return_some_sample() {
    let mesh = SphereMesh::fibonacci(3000).unwrap();
    for x in [0.0, f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, 1e-300] {
        for p in [
            DVec3::splat(x),
            DVec3::new(x, 0.0, 0.0),
            DVec3::new(0.3, x, -2.0),
        ] {
            assert!((mesh.nearest(p) as usize) < mesh.len());
            assert!((mesh.nearest_from(p, 9) as usize) < mesh.len());
        }
    }
}
