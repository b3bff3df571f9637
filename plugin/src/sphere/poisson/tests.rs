//! Distances, gaps, evenness, determinism.

use super::*;
use crate::math;
use crate::sphere::SphereMesh;

#[test]
fn no_two_points_are_too_close_and_no_gap_is_left() {
    for (seed, distance) in [(1, 0.05), (2, 0.3), (9, 0.013)] {
        let mesh = SphereMesh::from_points(poisson_disk(seed, distance)).unwrap();
        let mut longest = 0.0_f64;
        for i in 0..mesh.len() as u32 {
            for &j in mesh.ring(i) {
                let angle = math::angle_between(mesh.point(i), mesh.point(j));
                assert!(angle >= distance * (1.0 - 1e-9), "{i} {j}: {angle}");
                longest = longest.max(angle);
            }
        }
        // Neighbours around a gap that takes no further disk are at most two distances apart;
        // the darts leave few gaps that do.
        assert!(longest < 2.7 * distance, "{longest} at {distance}");
    }
}

/// How far the directions of all edges prefer `fold` directions of the compass, 0..1.
fn angular_order(mesh: &SphereMesh, fold: f64) -> f64 {
    let mut sum = bevy::math::DVec2::ZERO;
    let mut count = 0.0;
    for i in (0..mesh.len() as u32).filter(|&i| mesh.point(i).z.abs() <= 0.9) {
        let p = mesh.point(i);
        let (east, north) = math::east_north(p);
        for &j in mesh.ring(i) {
            let d = mesh.point(j) - p;
            let (sin, cos) = math::sin_cos(fold * math::atan2(d.dot(north), d.dot(east)));
            sum += bevy::math::DVec2::new(cos, sin);
            count += 1.0;
        }
    }
    sum.length() / count
}

#[test]
fn points_are_even_but_have_no_lattice() {
    let mesh = SphereMesh::from_points(poisson_disk(4, 0.02)).unwrap();
    let n = mesh.len() as f64;
    let sum: DVec3 = mesh.points().iter().sum();
    assert!(sum.length() < 0.003 * n, "{sum}");
    // Directions of the edges, as hexagons and squares would show them.
    for fold in [2.0, 4.0, 6.0] {
        let order = angular_order(&mesh, fold);
        assert!(order < 0.02, "{fold}-fold order {order}");
    }
    // Six neighbours are common, other numbers are, too.
    let has_six = |&i: &u32| mesh.ring(i).len() == 6;
    let six = (0..mesh.len() as u32).filter(has_six).count() as f64;
    assert!(six < 0.6 * n, "{six} of {n}");
}

#[test]
fn the_same_points_on_any_number_of_threads() {
    let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let one = pool(1).unwrap().install(|| poisson_disk(5, 0.02));
    assert_eq!(one, pool(3).unwrap().install(|| poisson_disk(5, 0.02)));
    assert_ne!(one, poisson_disk(6, 0.02));
}
