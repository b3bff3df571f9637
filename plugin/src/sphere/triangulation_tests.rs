//! The Delaunay property, by brute force and by opposite corners.

use super::*;
use crate::random::{Purpose, Stream};
use crate::sphere::{SphereMesh, sampling};

fn random_points(id: u64, n: u64) -> Vec<DVec3> {
    let stream = Stream::new(21, Purpose::Relief, id);
    (0..n).map(|i| stream.direction(i)).collect()
}

/// Signed volume: positive where `p` lies inside the circumcircle of `t`.
fn inside(points: &[DVec3], t: [u32; 3], p: u32) -> f64 {
    let [a, b, c] = t.map(|i| points[i as usize] - points[p as usize]);
    -a.dot(b.cross(c))
}

/// Edges of the triangles, each direction once, sorted.
fn directed_edges(triangles: &[[u32; 3]]) -> Vec<(u32, u32)> {
    let mut edges: Vec<_> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)])
        .collect();
    edges.sort_unstable();
    edges
}

fn check_surface(points: &[DVec3], triangles: &[[u32; 3]]) {
    assert_eq!(triangles.len(), 2 * points.len() - 4);
    let edges = directed_edges(triangles);
    assert!(
        edges.windows(2).all(|w| w[0] != w[1]),
        "an edge is used twice in one direction"
    );
    assert!(
        edges
            .iter()
            .all(|&(a, b)| edges.binary_search(&(b, a)).is_ok()),
        "an open edge"
    );
    for &t in triangles {
        let [a, b, c] = t.map(|i| points[i as usize]);
        assert!(a.dot((b - a).cross(c - a)) > 0.0, "{t:?} faces inwards");
    }
}

#[test]
fn every_circumcircle_is_empty() {
    for points in [
        sampling::fibonacci(100),
        sampling::fibonacci(777),
        random_points(0, 400),
    ] {
        let triangles = triangulate(&points).unwrap();
        check_surface(&points, &triangles);
        for &t in &triangles {
            for p in 0..points.len() as u32 {
                assert!(
                    t.contains(&p) || inside(&points, t, p) < 1e-15,
                    "{p} lies in {t:?}"
                );
            }
        }
    }
}

#[test]
fn ten_thousand_samples_are_locally_delaunay() {
    // A triangulation is Delaunay as soon as no corner beyond an edge lies in a circumcircle.
    for points in [sampling::fibonacci(10_000), random_points(1, 10_000)] {
        let triangles = triangulate(&points).unwrap();
        check_surface(&points, &triangles);
        let mut corners: Vec<_> = triangles
            .iter()
            .flat_map(|&[a, b, c]| [((a, b), c), ((b, c), a), ((c, a), b)])
            .collect();
        corners.sort_unstable();
        for &((a, b), c) in &corners {
            let twin = corners.binary_search_by_key(&(b, a), |e| e.0).unwrap();
            assert!(inside(&points, [a, b, c], corners[twin].1) < 1e-15);
        }
    }
}

/// The edges of the triangulation that is projected from the point `pole`.
fn edges_from_pole(points: &[DVec3], pole: usize) -> Vec<(u32, u32)> {
    let mut turned = points.to_vec();
    turned.rotate_left(pole);
    let back = |i: u32| (i + pole as u32) % points.len() as u32;
    let triangles = triangulate(&turned).unwrap();
    directed_edges(&triangles.iter().map(|t| t.map(back)).collect::<Vec<_>>())
}

#[test]
fn the_pole_of_projection_does_not_matter() {
    let points = random_points(2, 500);
    let edges = edges_from_pole(&points, 0);
    for pole in [1, 77, 250, 499] {
        assert_eq!(edges, edges_from_pole(&points, pole));
    }
}

fn check_mesh(points: Vec<DVec3>) {
    let mesh = SphereMesh::from_points(points).unwrap();
    check_surface(mesh.points(), mesh.triangles());
}

/// Corner 0..8 of a cube.
fn cube_corner(i: i32) -> DVec3 {
    let side = |bit: i32| if i & bit == 0 { -1.0 } else { 1.0 };
    DVec3::new(side(1), side(2), side(4)).normalize()
}

#[test]
fn four_points_are_triangulated() {
    check_mesh([0, 3, 5, 6].map(cube_corner).to_vec());
}

#[test]
fn cocircular_points_are_triangulated() {
    check_mesh((0..8).map(cube_corner).collect());
    // A globe of meridians and parallels: every point has cocircular ones, the poles have rings of
    // 36.
    let mut globe = vec![DVec3::Z, DVec3::NEG_Z];
    for lat in (-80..=80).step_by(10) {
        let meridians = (0..360).step_by(10);
        globe.extend(meridians.map(|lon| math::direction(lat.into(), lon.into())));
    }
    check_mesh(globe);
}

#[test]
fn close_neighbours_of_the_pole_are_told_apart() {
    let mut points = sampling::fibonacci(300);
    for (x, y) in [(1e-9, 0.0), (-1e-9, 1e-9), (0.0, -1e-9)] {
        let pole = points[0];
        let e = math::any_tangent(pole);
        points.push((pole + e * x + pole.cross(e) * y).normalize());
    }
    let mesh = SphereMesh::from_points(points).unwrap();
    check_surface(mesh.points(), mesh.triangles());
    let mut around: Vec<u32> = mesh.ring(0).to_vec();
    around.sort_unstable();
    assert_eq!(around, [300, 301, 302]);
}
