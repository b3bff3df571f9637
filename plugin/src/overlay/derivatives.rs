//! Gradient, slope, Laplacian and shading of the elevation at every sample.

use super::OverlayInput;
use crate::math::east_north;
use crate::parallel;
use crate::sphere::gradient::fit;
use bevy::math::Vec3;

/// Direction to the sun of maps (east, north, up): in the north-west at 45 degrees, from where
/// readers of maps expect it.
const MAP_SUN: Vec3 = Vec3::new(-0.5, 0.5, core::f32::consts::FRAC_1_SQRT_2);

/// Gradient of the elevation at every sample: a tangent vector in km per km, uphill.
pub(super) fn gradients(input: &OverlayInput) -> Vec<Vec3> {
    gradients_of(input, |z| z)
}

/// Gradient of a function of the elevation in km at every sample, as [`gradients`].
pub(super) fn gradients_of(input: &OverlayInput, height: impl Fn(f32) -> f32 + Sync) -> Vec<Vec3> {
    let elevation = |i: u32| f64::from(height(input.surface.elevation(i as usize)));
    parallel::map(input.mesh.len(), |i| {
        (fit(input.mesh, i, elevation).0 / input.planet.radius).as_vec3()
    })
}

/// Slope at every sample in m per km.
pub(super) fn slopes(input: &OverlayInput) -> Vec<f32> {
    gradients(input)
        .into_iter()
        .map(|g| 1000.0 * g.length())
        .collect()
}

/// Laplacian of the elevation at every sample in m per km²: positive in hollows, negative on
/// crests.
pub(super) fn laplacians(input: &OverlayInput) -> Vec<f32> {
    let elevation = |i: u32| f64::from(input.surface.elevation(i as usize));
    let unit = 1000.0 / (input.planet.radius * input.planet.radius);
    parallel::map(input.mesh.len(), |i| {
        (fit(input.mesh, i, elevation).1 * unit) as f32
    })
}

/// Brightness of ground with the uphill `gradient` (km per km, exaggerated as wanted) under a sun
/// in the north-west at 45 degrees; 1 on level ground.
pub(super) fn shade(p: Vec3, gradient: Vec3) -> f32 {
    let (east, north) = east_north(p.as_dvec3());
    let eastward = gradient.dot(east.as_vec3());
    let northward = gradient.dot(north.as_vec3());
    // The normal of a slope leans downhill.
    let normal = Vec3::new(-eastward, -northward, 1.0);
    // Relative to level ground, so that plains keep their colour.
    (normal.dot(MAP_SUN) / (normal.length() * MAP_SUN.z)).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::direction;

    #[test]
    fn slopes_towards_the_sun_are_brighter() {
        let p = direction(10.0, 20.0);
        let (east, north) = east_north(p);
        let uphill_to_south_east = (east - north).as_vec3();
        assert!((shade(p.as_vec3(), Vec3::ZERO) - 1.0).abs() < 1e-6);
        assert!(shade(p.as_vec3(), uphill_to_south_east * 0.3) > 1.1);
        assert!(shade(p.as_vec3(), -uphill_to_south_east * 0.3) < 0.9);
    }
}
