//! Gradient and Laplacian of a column, by least squares.
//!
//! Both come from one fit to the ring of a sample: z = g · d + c d², with the gradient g and the
//! Laplacian 4 c. A plane alone would see slopes in hollows, and the mean of the ring alone hollows
//! on slopes, wherever a ring is not centred on its sample.

use super::SphereMesh;
use crate::math::east_north;
use bevy::math::DVec3;

/// Gradient of `value` at sample `i`, per radian, and its Laplacian, per square radian.
pub fn fit(mesh: &SphereMesh, i: u32, value: impl Fn(u32) -> f64) -> (DVec3, f64) {
    let p = mesh.point(i);
    let (east, north) = east_north(p);
    // Sums of products of x, y, r² and z over the ring.
    let (mut xx, mut xy, mut yy, mut xz, mut yz) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let (mut xr, mut yr, mut rr, mut rz) = (0.0, 0.0, 0.0, 0.0);
    for &j in mesh.ring(i) {
        let d = mesh.point(j) - p;
        let (x, y, r, z) = (
            d.dot(east),
            d.dot(north),
            d.length_squared(),
            value(j) - value(i),
        );
        (xx, xy, yy) = (xx + x * x, xy + x * y, yy + y * y);
        (xz, yz, rz) = (xz + x * z, yz + y * z, rz + r * z);
        (xr, yr, rr) = (xr + x * r, yr + y * r, rr + r * r);
    }
    let det = xx * yy - xy * xy;
    if det <= 1e-12 * (xx + yy) * (xx + yy) {
        return (DVec3::ZERO, 0.0);
    }
    let plane = |xs: f64, ys: f64| ((yy * xs - xy * ys) / det, (xx * ys - xy * xs) / det);
    let (gx, gy) = plane(xz, yz);
    let (hx, hy) = plane(xr, yr);
    let spread = rr - xr * hx - yr * hy;
    let curve = if spread > 1e-6 * rr {
        (rz - xr * gx - yr * gy) / spread
    } else {
        0.0
    };
    (
        east * (gx - curve * hx) + north * (gy - curve * hy),
        4.0 * curve,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mesh() -> SphereMesh {
        SphereMesh::fibonacci(5000).unwrap()
    }

    #[test]
    fn gradient_of_a_linear_field_is_its_tangent_part() {
        let (mesh, along) = (mesh(), DVec3::new(0.3, -0.2, 0.9));
        for i in 0..mesh.len() as u32 {
            let p = mesh.point(i);
            let expected = along - p * along.dot(p);
            let found = fit(&mesh, i, |j| mesh.point(j).dot(along)).0;
            assert!(
                (found - expected).length() < 1e-9,
                "{i}: {found} {expected}"
            );
            assert!(found.dot(p).abs() < 1e-9);
        }
    }

    #[test]
    fn laplacian_of_a_harmonic_is_its_eigenvalue() {
        let mesh = mesh();
        // Spherical harmonics of degree 1 and 2 have the eigenvalues -2 and -6. The fit is exact
        // for the first; rings that are longer in one direction see too much or too little of a
        // saddle.
        for i in 0..mesh.len() as u32 {
            let p = mesh.point(i);
            let one = fit(&mesh, i, |j| mesh.point(j).z).1;
            assert!((one + 2.0 * p.z).abs() < 1e-9, "{i}: {one} {}", -2.0 * p.z);
        }
        let at = |x: f64| 3.0 * x * x - 1.0;
        let mean: f64 = (0..mesh.len() as u32)
            .map(|i| fit(&mesh, i, |j| at(mesh.point(j).z)).1 * at(mesh.point(i).z) * mesh.area(i))
            .sum();
        let norm: f64 = (0..mesh.len() as u32)
            .map(|i| at(mesh.point(i).z) * at(mesh.point(i).z) * mesh.area(i))
            .sum();
        assert!((mean / norm + 6.0).abs() < 1.0, "{}", mean / norm);
    }
}
