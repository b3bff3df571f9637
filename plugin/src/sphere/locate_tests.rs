//! The containing triangle: weights, corners, edges, obtuse triangles, bad directions.

use super::*;
use crate::math;
use crate::random::{Purpose, Stream};

fn random_mesh(n: u64) -> SphereMesh {
    let stream = Stream::new(51, Purpose::Relief, 0);
    SphereMesh::from_points((0..n).map(|i| stream.direction(i)).collect()).unwrap()
}

fn meshes() -> [SphereMesh; 4] {
    let fibonacci = |n| SphereMesh::fibonacci(n).unwrap();
    [
        fibonacci(100),
        fibonacci(20_000),
        random_mesh(50),
        random_mesh(5000),
    ]
}

/// Weights are a convex combination that gives back the direction.
fn check(mesh: &SphereMesh, p: DVec3) -> Location {
    let at = mesh.locate(p);
    assert_eq!(at.nearest, mesh.nearest(p));
    assert!(at.weights.iter().all(|w| (0.0..=1.0).contains(w)), "{at:?}");
    assert!(
        (at.weights.iter().sum::<f64>() - 1.0).abs() < 1e-15,
        "{at:?}"
    );
    let coordinate = |k: usize| at.interpolate(|i| mesh.point(i)[k]);
    let q = DVec3::new(coordinate(0), coordinate(1), coordinate(2)).normalize();
    assert!((p - q).length() < 1e-14, "{p} {q} {at:?}");
    at
}

fn sorted(mut vertices: [u32; 3]) -> [u32; 3] {
    vertices.sort_unstable();
    vertices
}

fn is_triangle(mesh: &SphereMesh, at: &Location) -> bool {
    let [a, b, c] = at.vertices;
    let ring = mesh.ring(a);
    (0..ring.len()).any(|k| ring[k] == b && ring[(k + 1) % ring.len()] == c)
}

#[test]
fn random_directions_and_poles() {
    for mesh in meshes() {
        let stream = Stream::new(52, Purpose::Relief, 1);
        for i in 0..5000 {
            let at = check(&mesh, stream.direction(i));
            assert!(is_triangle(&mesh, &at), "{at:?}");
        }
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            check(&mesh, axis);
            check(&mesh, -axis);
        }
    }
}

#[test]
fn the_nearest_sample_need_not_be_a_corner() {
    let mesh = random_mesh(5000);
    let stream = Stream::new(53, Purpose::Relief, 2);
    let apart = (0..5000).filter(|&i| {
        let at = mesh.locate(stream.direction(i));
        !at.vertices.contains(&at.nearest)
    });
    assert!(apart.count() > 20, "random samples have obtuse triangles");
}

#[test]
fn a_sample_has_all_the_weight_on_itself() {
    for mesh in meshes() {
        for i in 0..mesh.len() as u32 {
            let at = mesh.locate(mesh.point(i));
            assert_eq!(
                (at.nearest, at.vertices[0], at.weights),
                (i, i, [1.0, 0.0, 0.0])
            );
            assert!(is_triangle(&mesh, &at));
            let close = (mesh.point(i) + math::any_tangent(mesh.point(i)) * 1e-12).normalize();
            let at = check(&mesh, close);
            let own = at.vertices.iter().position(|&v| v == i).unwrap();
            assert!(at.weights[own] > 1.0 - 1e-8);
        }
    }
}

#[test]
fn edges_belong_to_their_corners() {
    for mesh in meshes() {
        for &[a, b, _] in mesh.triangles().iter().step_by(7) {
            for share in [0.5, 0.1, 1e-9] {
                let at = check(&mesh, mesh.point(a).lerp(mesh.point(b), share).normalize());
                let of = |v: u32| at.vertices.iter().position(|&w| w == v);
                let weight = |v: u32| of(v).map_or(0.0, |k| at.weights[k]);
                let (u, v) = (weight(a), weight(b));
                assert!(
                    (u + v - 1.0).abs() < 1e-9 && (v - share).abs() < 1e-9,
                    "{at:?}"
                );
            }
        }
    }
}

#[test]
fn a_wrong_nearest_sample_only_costs_time() {
    let mesh = SphereMesh::fibonacci(5000).unwrap();
    let stream = Stream::new(54, Purpose::Relief, 3);
    for i in 0..2000 {
        let p = stream.direction(i);
        let (near, far) = (mesh.locate(p), mesh.locate_from(p, (i * 7 % 5000) as u32));
        assert_eq!(sorted(near.vertices), sorted(far.vertices));
    }
}

#[test]
fn zero_and_infinite_directions_have_weights_too() {
    let mesh = SphereMesh::fibonacci(3000).unwrap();
    for x in [0.0, f64::NAN, f64::INFINITY, 1e300, 1e-300] {
        for p in [
            DVec3::splat(x),
            DVec3::new(x, 0.0, 0.0),
            DVec3::new(0.3, x, -2.0),
        ] {
            let at = mesh.locate(p);
            assert!(
                (at.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12,
                "{p} {at:?}"
            );
            assert!(at.weights.iter().all(|w| *w >= 0.0));
        }
    }
}
