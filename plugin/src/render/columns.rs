//! What is uploaded per sample: four words of 32 bits (see the README of `pangaea_shaders`).
//!
//! The picture should show the planet, not its lattice. Land and sea floor are two surfaces, each a
//! little smoothed and each continued for one sample beyond the coast, so that neither leans
//! towards the other. Which of the two is seen says a third quantity, the side of the coast, whose
//! contour runs between the samples of land and those of the sea.

use super::to_bevy;
use crate::crust::Surface;
use crate::overlay::palette::Rgba;
use crate::parallel;
use crate::sphere::SphereMesh;
use crate::sphere::gradient::fit;
use bevy::math::{DVec3, Vec3};

/// Bytes per sample.
const STRIDE: usize = 16;

/// Largest elevation (km) and steepest gradient (km per radian) that can be packed; the same as in
/// `sample.wgsl`.
const MAX_ELEVATION: f32 = 32.0;
const MAX_GRADIENT: f32 = 8192.0;

/// Elevation in km from which ground is wholly land.
const COAST_RISE: f32 = 0.25;

/// Elevations in km of land and sea floor that have no neighbour to be continued from.
const BEACH: f32 = 0.03;
const SHOAL: f32 = -0.08;

/// The relief as it is drawn.
pub(super) struct Shape {
    /// Elevation of the land in km.
    land: Vec<f32>,
    /// Elevation of the sea floor in km; the same as that of the land where there is no sea.
    floor: Vec<f32>,
    /// Side of the coast: 1 on land, -1 in the sea, between them where they mix. It is smoothed
    /// without bias, so land keeps its area.
    coast: Vec<f32>,
    /// How much the side changes towards the neighbours, 0..=1: how far a coast may be moved.
    rough: Vec<f32>,
    /// Gradient of what is seen in km per radian, a tangent vector.
    gradient: Vec<DVec3>,
}

impl Shape {
    /// The shape of `surface`, with a `sea` or without.
    pub(super) fn new(mesh: &SphereMesh, surface: &Surface, sea: bool) -> Self {
        let raw: Vec<f32> = (0..mesh.len()).map(|i| surface.elevation(i)).collect();
        let is_land = |i: u32| !sea || raw[i as usize] > 0.0;
        let (land, floor) = if sea {
            (
                one_side(mesh, &raw, is_land, BEACH),
                one_side(mesh, &raw, |i| !is_land(i), SHOAL),
            )
        } else {
            let all = one_side(mesh, &raw, |_| true, 0.0);
            (all.clone(), all)
        };
        let side = |i: u32| (raw[i as usize] / COAST_RISE).clamp(-1.0, 1.0);
        let coast: Vec<f32> = parallel::map(mesh.len(), |i| {
            let ring = mesh.ring(i);
            let mean = ring.iter().map(|&j| side(j)).sum::<f32>() / ring.len().max(1) as f32;
            0.5 * (side(i) + mean)
        });
        let rough = parallel::map(mesh.len(), |i| {
            mesh.ring(i)
                .iter()
                .map(|&j| (side(j) - side(i)).abs())
                .fold(0.0, f32::max)
                .min(1.0)
        });
        let gradient = parallel::map(mesh.len(), |i| {
            let seen = if coast[i as usize] > 0.0 {
                &land
            } else {
                &floor
            };
            fit(mesh, i, |j| f64::from(seen[j as usize])).0
        });
        Self {
            land,
            floor,
            coast,
            rough,
            gradient,
        }
    }

    /// Elevation in km that is drawn at a sample. The vertex shader does the same.
    pub(super) fn elevation(&self, i: usize) -> f32 {
        if self.coast[i] > 0.0 {
            self.land[i]
        } else {
            self.floor[i]
        }
    }
}

/// Elevation on one side of the coast: halfway between a sample and the mean of its neighbours on
/// that side, for samples of the other side that mean alone, or `none` where there are none.
fn one_side(
    mesh: &SphereMesh,
    raw: &[f32],
    inside: impl Fn(u32) -> bool + Sync,
    none: f32,
) -> Vec<f32> {
    parallel::map(mesh.len(), |i| {
        let (mut sum, mut count) = (0.0, 0.0);
        for &j in mesh.ring(i).iter().filter(|&&j| inside(j)) {
            sum += raw[j as usize];
            count += 1.0;
        }
        match (inside(i), count > 0.0) {
            (true, true) => 0.5 * (raw[i as usize] + sum / count),
            (true, false) => raw[i as usize],
            (false, true) => sum / count,
            (false, false) => none,
        }
    })
}

/// Packs all samples. `colors` are in sRGB; missing ones are black.
pub(super) fn pack(
    mesh: &SphereMesh,
    shape: &Shape,
    colors: &[Rgba],
    marked: impl Fn(usize) -> bool,
) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(STRIDE * mesh.len());
    for (i, &point) in mesh.points().iter().enumerate() {
        let heights = [shape.land[i], shape.floor[i]].map(|z| snorm16(z / MAX_ELEVATION));
        let [r, g, b, _] = colors.get(i).copied().unwrap_or_default();
        bytes.extend_from_slice(&heights.map(i16::to_le_bytes).concat());
        bytes.extend_from_slice(
            &gradient_words(point, shape.gradient[i])
                .map(i16::to_le_bytes)
                .concat(),
        );
        bytes.extend_from_slice(&[r, g, b, if marked(i) { 255 } else { 0 }]);
        bytes.extend_from_slice(&snorm16(shape.coast[i]).to_le_bytes());
        bytes.extend_from_slice(&snorm16(shape.rough[i]).to_le_bytes());
    }
    bytes
}

fn snorm16(x: f32) -> i16 {
    (x.clamp(-1.0, 1.0) * 32767.0).round() as i16
}

/// A gradient in km per radian in the tangent basis of its sample.
fn gradient_words(point: DVec3, gradient: DVec3) -> [i16; 2] {
    let (u, v) = tangent_basis(to_bevy(point));
    let gradient = to_bevy(gradient) / MAX_GRADIENT;
    [u, v].map(|axis| snorm16(gradient.dot(axis)))
}

/// Two unit vectors perpendicular to the unit vector `n` (Duff et al. 2017). The twin of the one in
/// `sample.wgsl`.
fn tangent_basis(n: Vec3) -> (Vec3, Vec3) {
    let s = if n.z >= 0.0 { 1.0 } else { -1.0 };
    let a = -1.0 / (s + n.z);
    let b = n.x * n.y * a;
    (
        Vec3::new(1.0 + s * n.x * n.x * a, s * b, -s * n.x),
        Vec3::new(b, s + n.y * n.y * a, -n.y),
    )
}

#[cfg(test)]
#[path = "columns_tests.rs"]
mod tests;
