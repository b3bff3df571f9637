//! The relief as it is drawn.
//!
//! A globe should show the planet, not its lattice. Land and sea floor are two surfaces, each a
//! little smoothed and each continued for one sample beyond the coast, so that neither leans
//! towards the other. A third quantity, the side of the coast, says which of the two is seen: its
//! contour runs between the samples of land and those of the sea.

use crate::crust::Surface;
use crate::parallel;
use crate::sphere::SphereMesh;
use crate::sphere::gradient::fit;
use bevy::math::DVec3;

/// Elevation in km from which ground is wholly land.
const COAST_RISE_KM: f32 = 0.25;

/// Elevation in km of land that has no neighbour on land to be continued from.
const LONE_LAND_KM: f32 = 0.03;
/// Elevation in km of sea floor that has no neighbour in the sea to be continued from.
const LONE_FLOOR_KM: f32 = -0.08;

/// The relief as it is drawn.
pub(super) struct DrawnRelief {
    /// Elevation of the land in km.
    pub(super) land: Vec<f32>,
    /// Elevation of the sea floor in km; the same as that of the land where there is no sea.
    pub(super) floor: Vec<f32>,
    /// Side of the coast: 1 on land, -1 in the sea, between them where they mix. It is smoothed
    /// without bias, so land keeps its area.
    pub(super) coast: Vec<f32>,
    /// How much the side changes towards the neighbours, 0..=1: how far a coast may be moved.
    pub(super) rough: Vec<f32>,
    /// Gradient of what is seen in km per radian, a tangent vector.
    pub(super) gradient: Vec<DVec3>,
}

impl DrawnRelief {
    /// The relief of `surface`, with a `sea` or without.
    pub(super) fn new(mesh: &SphereMesh, surface: &Surface, sea: bool) -> Self {
        let raw: Vec<f32> = (0..mesh.len()).map(|i| surface.elevation(i)).collect();
        let is_land = |i: u32| !sea || raw[i as usize] > 0.0;
        let land = one_side(mesh, &raw, is_land, LONE_LAND_KM);
        let floor = if sea {
            one_side(mesh, &raw, |i| !is_land(i), LONE_FLOOR_KM)
        } else {
            land.clone()
        };
        let (coast, rough) = coasts(mesh, &raw);
        // Of the surface that is seen, which does not lean towards the other at the coast.
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
/// that side, for samples of the other side that mean alone, or `lone` without such neighbours.
fn one_side(
    mesh: &SphereMesh,
    raw: &[f32],
    inside: impl Fn(u32) -> bool + Sync,
    lone: f32,
) -> Vec<f32> {
    parallel::map(mesh.len(), |i| {
        let (mut sum, mut count) = (0.0, 0.0);
        for &j in mesh.ring(i).iter().filter(|&&j| inside(j)) {
            sum += raw[j as usize];
            count += 1.0;
        }
        // Own side: half smoothed, which hides the lattice and keeps the relief. Other side:
        // continued.
        match (inside(i), count > 0.0) {
            (true, true) => 0.5 * (raw[i as usize] + sum / count),
            (true, false) => raw[i as usize],
            (false, true) => sum / count,
            (false, false) => lone,
        }
    })
}

/// Side of the coast at every sample, and how much it changes towards the neighbours.
fn coasts(mesh: &SphereMesh, raw: &[f32]) -> (Vec<f32>, Vec<f32>) {
    let side = |i: u32| (raw[i as usize] / COAST_RISE_KM).clamp(-1.0, 1.0);
    let coast = parallel::map(mesh.len(), |i| {
        let ring = mesh.ring(i);
        let mean = ring.iter().map(|&j| side(j)).sum::<f32>() / ring.len().max(1) as f32;
        0.5 * (side(i) + mean)
    });
    // Where all neighbours agree the coast is far, and nothing may move.
    let rough = parallel::map(mesh.len(), |i| {
        let steps = mesh.ring(i).iter().map(|&j| (side(j) - side(i)).abs());
        steps.fold(0.0, f32::max).min(1.0)
    });
    (coast, rough)
}

#[cfg(test)]
mod tests;
