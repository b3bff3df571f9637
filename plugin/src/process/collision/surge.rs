//! The surge of a collision (paper 000 §4.2).
//!
//! ```text
//! r = r_c sqrt(v/v_0 A/A_0), at most r_c            (root over both, as in paper 004)
//! dz(p) = D f(d(p)),  f(x) = (1 - (x/r)²)²          D = Delta_c A, saturating at the highest surge
//! f' = (n x (p - q)/|p - q|) x n
//! ```
//!
//! d is measured from the overlap, on both sides of the suture; measured from the whole terrane, as
//! printed, a continent that collides would become one plateau. q is the terrane's centroid. Only
//! continental crust surges.

use crate::crust::isostasy::Isostasy;
use crate::crust::{Crust, Orogeny};
use crate::math::PI;
use crate::params::TectonicParams;
use crate::process::saturating_rise;
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::ReachedSamples;
use bevy::math::DVec3;

/// The surge of one collision.
pub(super) struct Surge {
    /// Radius of influence in radians.
    pub radius: f64,
    /// Surge at the suture in km.
    height: f64,
    /// Elevation in km that summits approach.
    ceiling: f32,
    /// Least share of `height` that folds.
    belt_share: f32,
    isostasy: Isostasy,
}

impl Surge {
    /// The surge of a terrane of `area` km² that arrives at `speed` km/My.
    pub(super) fn new(params: &TectonicParams, planet_radius: f64, area: f64, speed: f64) -> Self {
        let average = params.plate_share * 4.0 * PI * planet_radius * planet_radius;
        let share = (speed / params.max_speed * area / average).min(1.0).sqrt();
        let printed = params.collision_coefficient * area;
        let highest = params.collision_surge_max;
        Self {
            radius: params.collision_distance * params.collision_reach * share / planet_radius,
            // Small terranes surge as printed, large ones approach the highest surge.
            height: if printed > 0.0 {
                printed * highest / (printed + highest)
            } else {
                0.0
            },
            ceiling: params.summit_elevation as f32,
            belt_share: params.collision_belt_share as f32,
            isostasy: Isostasy::new(params),
        }
    }

    /// The profile f at `d` radians from the suture.
    fn profile(&self, d: f64) -> f64 {
        let x = d / self.radius.max(1e-9);
        let y = (1.0 - x * x).max(0.0);
        y * y
    }

    /// Raises what was reached; belts are folded around the direction `centroid`. Returns the gain
    /// of volume in km times steradians.
    pub(super) fn raise(
        &self,
        mesh: &SphereMesh,
        crust: &mut Crust,
        reached: &ReachedSamples,
        centroid: DVec3,
    ) -> f64 {
        let mut volume = 0.0;
        for (&sample, &d) in reached.samples.iter().zip(&reached.distance) {
            let i = sample as usize;
            let dz = (self.height * self.profile(f64::from(d))) as f32;
            let z = crust.elevation[i];
            let raised = saturating_rise(z, dz, self.ceiling);
            let gain = self.isostasy.thickening(z, raised - z);
            let before = crust.thickness[i];
            crust.elevation[i] = raised;
            crust.thickness[i] = before + gain;
            volume += f64::from(crust.thickness[i] - before) * mesh.areas()[i];
            if dz > self.belt_share * self.height as f32 {
                note_orogeny(crust, i, mesh.point(sample), centroid);
            }
        }
        volume
    }
}

/// Sample `i` at the direction `n` belongs to a Himalayan orogeny from now on, folded across the way
/// to the centroid.
fn note_orogeny(crust: &mut Crust, i: usize, n: DVec3, centroid: DVec3) {
    crust.orogeny[i] = Orogeny::Himalayan;
    crust.orogeny_age[i] = 0.0;
    let away = (n - centroid).normalize_or_zero();
    // Crossed twice with n: the part of the way from the centroid that lies along the ground.
    crust.fold[i] = n.cross(away).cross(n).normalize_or_zero().as_vec3();
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn radius_and_surge_follow_the_paper() {
        let params = TectonicParams::default();
        let average = params.plate_share * 4.0 * PI * 6370.0 * 6370.0;
        let full = Surge::new(&params, 6370.0, average, params.max_speed);
        assert!(
            (full.radius * 6370.0 - params.collision_distance * params.collision_reach).abs()
                < 1e-6
        );
        let quarter = Surge::new(&params, 6370.0, 0.25 * average, params.max_speed);
        assert!((quarter.radius / full.radius - 0.5).abs() < 1e-12);
        let beyond = Surge::new(&params, 6370.0, 100.0 * average, params.max_speed);
        assert_eq!(beyond.radius, full.radius);
        assert!(
            beyond.height < params.collision_surge_max
                && beyond.height > 0.9 * params.collision_surge_max
        );
        let island = Surge::new(&params, 6370.0, 1e4, params.max_speed);
        assert!(
            (island.height / 0.13 - 1.0).abs() < 0.05,
            "small terranes surge by the printed coefficient"
        );
        assert_eq!(full.profile(0.0), 1.0);
        assert_eq!(full.profile(full.radius), 0.0);
        assert!((full.profile(0.5 * full.radius) - 0.5625).abs() < 1e-12);
    }
}
