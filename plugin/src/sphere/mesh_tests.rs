//! Construction: limits, bad input, rings, order, determinism.

use super::*;
use crate::random::{Purpose, Stream};

fn random_points(n: u64) -> Vec<DVec3> {
    let stream = Stream::new(31, Purpose::Relief, 0);
    (0..n).map(|i| stream.direction(i)).collect()
}

#[test]
fn sample_counts_have_limits() {
    let mesh = SphereMesh::fibonacci(100).unwrap();
    assert!(mesh.len() == 100 && mesh.is_fibonacci());
    for n in [0, 99, 2_000_001, u32::MAX] {
        assert_eq!(
            SphereMesh::fibonacci(n).unwrap_err(),
            SphereError::SampleCount(n)
        );
    }
}

#[test]
fn bad_points_are_errors() {
    let error = |points: Vec<DVec3>| SphereMesh::from_points(points).unwrap_err();
    assert_eq!(error(vec![]), SphereError::PointCount(0));
    assert_eq!(error(random_points(3)), SphereError::PointCount(3));
    for bad in [
        DVec3::ZERO,
        DVec3::new(f64::NAN, 0.0, 1.0),
        DVec3::new(0.0, f64::INFINITY, 0.0),
    ] {
        let mut points = random_points(50);
        points[7] = bad;
        assert_eq!(error(points), SphereError::NotADirection(7));
    }
    for copy in [0, 20] {
        let mut points = random_points(50);
        points[33] = points[copy] * 3.0;
        points[copy] *= 3.0;
        assert_eq!(error(points), SphereError::Duplicate);
    }
}

/// Twelve points on the circle at height `z`.
fn circle(z: f64) -> Vec<DVec3> {
    let turn = |i| math::sin_cos(math::TAU * f64::from(i) / 12.0);
    let points = (0..12).map(turn);
    points.map(|(s, c)| DVec3::new(c, s, z)).collect()
}

#[test]
fn points_of_one_hemisphere_are_an_error() {
    let upper = |p: DVec3| DVec3::new(p.x, p.y, p.z.abs() + 1e-3);
    let half: Vec<DVec3> = random_points(200).into_iter().map(upper).collect();
    for points in [half, circle(0.0), circle(0.5)] {
        assert!(SphereMesh::from_points(points).is_err());
    }
}

#[test]
fn given_points_keep_their_order_and_unit_vectors_their_bits() {
    let points = random_points(300);
    let mesh = SphereMesh::from_points(points.clone()).unwrap();
    assert!(
        mesh.points()
            .iter()
            .zip(&points)
            .all(|(a, b)| (*a - *b).length() < 1e-15)
    );
    let again = SphereMesh::from_points(mesh.points().to_vec()).unwrap();
    assert_eq!(mesh.points(), again.points());
    assert_eq!(mesh.triangles(), again.triangles());
    assert!(!mesh.is_fibonacci());
    for scale in [1e-300, 3.0, 1e300] {
        let scaled = points.iter().map(|p| *p * scale).collect();
        let mesh = SphereMesh::from_points(scaled).unwrap();
        assert!(
            mesh.points()
                .iter()
                .zip(&points)
                .all(|(a, b)| (*a - *b).length() < 1e-15)
        );
    }
}

/// A triangle with its lowest index first.
fn lowest_first(mut triangle: [u32; 3]) -> [u32; 3] {
    let lowest = (0..3).min_by_key(|&k| triangle[k]).unwrap();
    triangle.rotate_left(lowest);
    triangle
}

#[test]
fn rings_are_the_fans_of_the_triangles() {
    let random = SphereMesh::from_points(random_points(3000)).unwrap();
    for mesh in [SphereMesh::fibonacci(3000).unwrap(), random] {
        let mut sorted = mesh.triangles().to_vec();
        assert!(sorted.iter().all(|&t| t == lowest_first(t)));
        assert!(sorted.windows(2).all(|w| w[0][0] <= w[1][0]));
        sorted.sort_unstable();
        let mut fans = 0;
        for i in 0..mesh.len() as u32 {
            let ring = mesh.ring(i);
            assert_eq!(ring.iter().min(), ring.first());
            for (&j, &next) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let triangle = lowest_first([i, j, next]);
                assert!(sorted.binary_search(&triangle).is_ok(), "{triangle:?}");
                assert!(mesh.ring(j).contains(&i));
                fans += 1;
            }
        }
        assert_eq!(fans, 3 * sorted.len());
    }
}

#[test]
fn neighbours_are_close_in_memory() {
    let n = 50_000;
    let mesh = SphereMesh::fibonacci(n).unwrap();
    let mut sum = 0.0;
    let mut near = 0;
    let mut count = 0;
    for i in 0..n {
        for &j in mesh.ring(i) {
            sum += f64::from(i.abs_diff(j));
            near += u32::from(i.abs_diff(j) < 256);
            count += 1;
        }
    }
    let (mean, share) = (sum / f64::from(count), f64::from(near) / f64::from(count));
    assert!(
        mean < 0.02 * f64::from(n) && share > 0.9,
        "mean {mean}, near {share}"
    );
}

#[test]
fn spacing_is_the_mean_length_of_an_edge() {
    let mesh = SphereMesh::fibonacci(20_000).unwrap();
    let (mut sum, mut count) = (0.0, 0);
    for i in 0..mesh.len() as u32 {
        for &j in mesh.ring(i) {
            sum += math::angle_between(mesh.point(i), mesh.point(j));
            count += 1;
        }
    }
    let mean = sum / f64::from(count);
    assert!(
        (mean / mesh.spacing() - 1.0).abs() < 0.05,
        "{mean} {}",
        mesh.spacing()
    );
}

fn build_on(threads: usize) -> SphereMesh {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
    let build = || SphereMesh::fibonacci(30_000).unwrap();
    pool.build().unwrap().install(build)
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let (one, many) = (build_on(1), build_on(5));
    assert_eq!(one.points(), many.points());
    assert_eq!(one.triangles(), many.triangles());
    assert!(
        one.areas()
            .iter()
            .zip(many.areas())
            .all(|(a, b)| a.to_bits() == b.to_bits())
    );
    assert_eq!(one.seeds.seeds(), many.seeds.seeds());
}
