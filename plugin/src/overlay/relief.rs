//! Gradient, slope, Laplacian and shading of the elevation at every sample.
//!
//! Both come from one fit by least squares to the ring of a sample: z = g · d + c d², with the
//! gradient g and the Laplacian 4 c. A plane alone would see slopes in hollows, and the mean of the
//! ring alone hollows on slopes, wherever a ring is not centred on its sample.

use super::OverlayInput;
use crate::math;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::{DVec3, Vec3};

/// Gradient of the elevation at every sample: a tangent vector in km per km, uphill.
pub fn gradients(input: &OverlayInput) -> Vec<Vec3> {
    gradients_of(input, |z| z)
}

/// Gradient of a function of the elevation in km at every sample, as [`gradients`].
pub fn gradients_of(input: &OverlayInput, height: impl Fn(f32) -> f32 + Sync) -> Vec<Vec3> {
    let elevation = |i: u32| f64::from(height(input.surface.elevation(i as usize)));
    parallel::map(input.mesh.len(), |i| {
        (fit(input.mesh, i, elevation).0 / input.planet.radius).as_vec3()
    })
}

/// Slope at every sample in m per km.
pub fn slopes(input: &OverlayInput) -> Vec<f32> {
    gradients(input)
        .into_iter()
        .map(|g| 1000.0 * g.length())
        .collect()
}

/// Laplacian of the elevation at every sample in m per km²: positive in hollows, negative on
/// crests.
pub fn laplacians(input: &OverlayInput) -> Vec<f32> {
    let elevation = |i: u32| f64::from(input.surface.elevation(i as usize));
    let unit = 1000.0 / (input.planet.radius * input.planet.radius);
    parallel::map(input.mesh.len(), |i| {
        (fit(input.mesh, i, elevation).1 * unit) as f32
    })
}

/// Gradient of `value` at sample `i`, per radian, and its Laplacian, per square radian.
pub(crate) fn fit(mesh: &SphereMesh, i: u32, value: impl Fn(u32) -> f64) -> (DVec3, f64) {
    let p = mesh.point(i);
    let (east, north) = axes(p);
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

/// East and north at the unit direction `p`; at a pole any two axes that fit.
pub fn axes(p: DVec3) -> (DVec3, DVec3) {
    let across = DVec3::new(-p.y, p.x, 0.0);
    let east = if across.length_squared() > 1e-24 {
        across.normalize()
    } else {
        math::any_tangent(p)
    };
    (east, p.cross(east))
}

/// Azimuth of the tangent vector `v` at `p` in degrees clockwise from north, 0..360.
pub fn azimuth(p: DVec3, v: DVec3) -> f64 {
    let (east, north) = axes(p);
    let degrees = math::atan2(v.dot(east), v.dot(north)).to_degrees();
    if degrees < 0.0 {
        degrees + 360.0
    } else {
        degrees
    }
}

/// Brightness of ground with the uphill `gradient` (km per km, exaggerated as wanted) under a sun
/// in the north-west at 45 degrees; 1 on level ground.
pub fn shade(p: Vec3, gradient: Vec3) -> f32 {
    let (east, north) = axes(p.as_dvec3());
    let (gx, gy) = (gradient.dot(east.as_vec3()), gradient.dot(north.as_vec3()));
    const SUN: Vec3 = Vec3::new(-0.5, 0.5, core::f32::consts::FRAC_1_SQRT_2);
    let normal = Vec3::new(-gx, -gy, 1.0);
    (normal.dot(SUN) / (normal.length() * SUN.z)).max(0.0)
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

    #[test]
    fn azimuth_goes_clockwise_from_north() {
        let p = math::direction(30.0, 50.0);
        let (east, north) = axes(p);
        for (v, degrees) in [(north, 0.0), (east, 90.0), (-north, 180.0), (-east, 270.0)] {
            assert!((azimuth(p, v) - degrees).abs() < 1e-9);
        }
        assert!(azimuth(DVec3::Z, DVec3::X).is_finite());
    }

    #[test]
    fn slopes_towards_the_sun_are_brighter() {
        let p = math::direction(10.0, 20.0);
        let (east, north) = axes(p);
        let uphill_to_south_east = (east - north).as_vec3();
        assert!((shade(p.as_vec3(), Vec3::ZERO) - 1.0).abs() < 1e-6);
        assert!(shade(p.as_vec3(), uphill_to_south_east * 0.3) > 1.1);
        assert!(shade(p.as_vec3(), -uphill_to_south_east * 0.3) < 0.9);
    }
}
