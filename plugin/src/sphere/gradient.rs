//! Gradient and Laplacian of a column, by least squares.
//!
//! Both come from one fit to the ring of a sample: z = g · d + c d², with the gradient g and the
//! Laplacian 4 c. A plane alone would see slopes in hollows, and the mean of the ring alone hollows
//! on slopes, wherever a ring is not centred on its sample.

use super::SphereMesh;
use crate::math::east_north;
use bevy::math::DVec3;

/// Determinant below which a ring is a line, relative to the square of its size: no slope across it
/// can be known.
const LEAST_DETERMINANT: f64 = 1e-12;

/// Scatter of squared distances about their plane below which all neighbours are equally far, as
/// for four in a square: the curvature cannot be told from the plane.
const LEAST_SCATTER: f64 = 1e-6;

/// Gradient of `value` at sample `i`, per radian, and its Laplacian, per square radian.
///
/// Both are 0 where the neighbours of a sample lie on a line.
///
/// ```
/// # use bevy_pangaea::sphere::{SphereMesh, gradient};
/// # use bevy::math::DVec3;
/// let mesh = SphereMesh::fibonacci(2000)?;
/// let i = mesh.nearest(DVec3::X);
/// // The height above the equator: up along the meridian, and a harmonic of degree 1.
/// let (slope, laplacian) = gradient::fit(&mesh, i, |j| mesh.point(j).z);
/// assert!((slope - DVec3::Z).length() < 0.05);
/// assert!((laplacian + 2.0 * mesh.point(i).z).abs() < 1e-9);
/// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
/// ```
pub fn fit(mesh: &SphereMesh, i: u32, value: impl Fn(u32) -> f64) -> (DVec3, f64) {
    let p = mesh.point(i);
    let (east, north) = east_north(p);
    let mut sums = RingSums::default();
    for &j in mesh.ring(i) {
        let d = mesh.point(j) - p;
        let z = value(j) - value(i);
        sums.add(d.dot(east), d.dot(north), d.length_squared(), z);
    }
    let Some(det) = sums.determinant() else {
        return (DVec3::ZERO, 0.0);
    };
    let (gx, gy) = sums.plane(det, sums.xz, sums.yz);
    // The squared distance has a plane of its own in a ring that is not centred.
    let (hx, hy) = sums.plane(det, sums.xr, sums.yr);
    let curve = sums.curvature([gx, gy], [hx, hy]);
    let gradient = east * (gx - curve * hx) + north * (gy - curve * hy);
    (gradient, 4.0 * curve)
}

/// Sums over a ring of the products of x, y (to the east and north), r (squared distance) and z
/// (difference of the value).
#[derive(Default)]
struct RingSums {
    xx: f64,
    xy: f64,
    yy: f64,
    xz: f64,
    yz: f64,
    rz: f64,
    xr: f64,
    yr: f64,
    rr: f64,
}

impl RingSums {
    #[inline]
    fn add(&mut self, x: f64, y: f64, r: f64, z: f64) {
        self.xx += x * x;
        self.xy += x * y;
        self.yy += y * y;
        self.xz += x * z;
        self.yz += y * z;
        self.rz += r * z;
        self.xr += x * r;
        self.yr += y * r;
        self.rr += r * r;
    }

    /// Determinant of the normal equations of a plane; `None` if the ring is a line.
    #[inline]
    fn determinant(&self) -> Option<f64> {
        let det = self.xx * self.yy - self.xy * self.xy;
        let size = self.xx + self.yy;
        (det > LEAST_DETERMINANT * size * size).then_some(det)
    }

    /// The coefficient of r in the fit, from the planes `g` of z and `h` of r: only what r scatters
    /// about its plane tells the curvature.
    #[inline]
    fn curvature(&self, [gx, gy]: [f64; 2], [hx, hy]: [f64; 2]) -> f64 {
        let scatter = self.rr - self.xr * hx - self.yr * hy;
        if scatter > LEAST_SCATTER * self.rr {
            (self.rz - self.xr * gx - self.yr * gy) / scatter
        } else {
            0.0
        }
    }

    /// Slopes of the plane whose products with x and y sum to `xs` and `ys`.
    #[inline]
    fn plane(&self, det: f64, xs: f64, ys: f64) -> (f64, f64) {
        (
            // Cramer's rule for the two normal equations.
            (self.yy * xs - self.xy * ys) / det,
            (self.xx * ys - self.xy * xs) / det,
        )
    }
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
        let two = |i: u32| 3.0 * mesh.point(i).z * mesh.point(i).z - 1.0;
        let samples = 0..mesh.len() as u32;
        let mean: f64 = samples
            .clone()
            .map(|i| fit(&mesh, i, two).1 * two(i) * mesh.area(i))
            .sum();
        let norm: f64 = samples.map(|i| two(i) * two(i) * mesh.area(i)).sum();
        assert!((mean / norm + 6.0).abs() < 1.0, "{}", mean / norm);
    }
}
