//! Subduction: ocean crust sinks, and the overriding plate rises (paper 000 §4.1).
//!
//! ```text
//! u(p) = u_0 f(d) g(v) h(z_i)           z' = z + u dt         f' = f + beta (s_i - s_j) dt
//! f(d)  0 at the front, 1 at d_c, 0 from rho r_s on (rho: subduction_reach): two smoothstep pieces
//! g(v) = v / v_0
//! h(z_i) = ((z_i - z_t) / (z_c - z_t))²  of the crust going under, unbent
//! ```
//!
//! The printed h lacks its square and bounds; the cubic of paper 004 is negative at the front. A weight w
//! turns each factor x into 1 + w (x - 1). Every uplift saturates towards z_c. Orogeny becomes Andean where
//! continental crust rises faster than `orogeny_rate`, unless a collision folded it in the last
//! [`HIMALAYAN_MEMORY`] My. Thickness follows by isostasy; on continents it is booked as subduction uplift.
//! *Forced subduction*: where the crust going under is continental, h is large and so is the uplift.
//!
//! Reads: contacts, distances. Writes: elevation, thickness, fold, orogeny type and age.

use crate::crust::isostasy::Isostasy;
use crate::crust::{Cause, Crust, Ledger, Orogeny};
use crate::math::smoothstep;
use crate::parallel::CHUNK;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contact, Contacts, Role};
use crate::process::front::FrontField;
use crate::process::saturating_rise;
use crate::schedule::{CurrentPlanet, Stage, TectonicStep, TectonicSystems};
use crate::sphere::SphereMesh;
use crate::sphere::spread::UNREACHED;
use bevy::prelude::*;
use rayon::prelude::*;

/// For so long a collision's belt stays Himalayan above a subduction zone, in My.
pub const HIMALAYAN_MEMORY: f32 = 60.0;

/// Adds [`subduction`] to the step.
pub struct SubductionPlugin;

impl Plugin for SubductionPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(TectonicStep, subduction.in_set(TectonicSystems::Process(Stage::Subduction)));
    }
}

/// Raises the overriding plates of the current planet.
pub fn subduction(
    current: Res<CurrentPlanet>,
    mut planets: Query<(
        (&Planet, &Lattice, &TectonicParams, &GeologicClock, &crate::crust::Frames, &Rim, &Contacts),
        (&mut Crust, &mut FrontField, &mut Ledger),
    )>,
) {
    let Ok((input, (mut crust, mut field, mut ledger))) = planets.get_mut(current.0) else { return };
    let (planet, lattice, params, clock, frames, rim, contacts) = input;
    if !params.processes.subduction {
        field.stale = true;
        return;
    }
    let reach = (params.uplift_end() / planet.radius).min(2.0);
    field.refresh(lattice, &crust.frame, frames, rim, contacts, reach, clock.step);
    let volume = rise(lattice, &mut crust, &field, rim, contacts, &Uplift::new(params, planet.radius));
    ledger.book(Cause::SubductionUplift, 0.0, volume);
}

/// The uplift law of one set of parameters.
pub struct Uplift<'a> {
    params: &'a TectonicParams,
    isostasy: Isostasy,
    radius: f64,
}

impl<'a> Uplift<'a> {
    /// The law on a planet of `radius` km.
    pub fn new(params: &'a TectonicParams, radius: f64) -> Self {
        Self { params, isostasy: Isostasy::new(params), radius }
    }

    /// f: the profile over the distance `d` from the front in km, 0..1.
    pub fn distance_profile(&self, d: f64) -> f64 {
        let (peak, end) = (self.params.uplift_peak, self.params.uplift_end());
        if d < peak { smoothstep(d / peak) } else { smoothstep((end - d) / (end - peak).max(1.0)) }
    }

    /// g: the influence of the relative speed `v` in km/My.
    pub fn speed_profile(&self, v: f64) -> f64 {
        v / self.params.max_speed
    }

    /// h: the influence of the elevation `z_i` in km of the crust going under.
    pub fn relief_profile(&self, z_i: f64) -> f64 {
        let (low, high) = (self.params.trench_elevation, self.params.summit_elevation);
        let normalised = ((z_i - low) / (high - low)).clamp(0.0, 1.0);
        normalised * normalised
    }

    /// The rate of uplift in km/My.
    pub fn rate(&self, d: f64, v: f64, z_i: f64) -> f64 {
        self.weighted(self.distance_profile(d), v, z_i)
    }

    fn weighted(&self, distance_profile: f64, v: f64, z_i: f64) -> f64 {
        let weigh = |weight: f64, factor: f64| 1.0 + weight * (factor - 1.0);
        let p = self.params;
        p.uplift
            * weigh(p.weight_distance, distance_profile)
            * weigh(p.weight_speed, self.speed_profile(v))
            * weigh(p.weight_relief, self.relief_profile(z_i))
    }
}

/// Raises all samples near a front. Returns the volume in km³ that continents gained.
fn rise(
    mesh: &SphereMesh,
    crust: &mut Crust,
    field: &FrontField,
    rim: &Rim,
    contacts: &Contacts,
    law: &Uplift,
) -> f64 {
    let kind = &crust.kind;
    let volumes: Vec<f64> = (
        crust.elevation.par_chunks_mut(CHUNK),
        crust.thickness.par_chunks_mut(CHUNK),
        crust.fold.par_chunks_mut(CHUNK),
        crust.orogeny.par_chunks_mut(CHUNK),
        crust.orogeny_age.par_chunks_mut(CHUNK),
    )
        .into_par_iter()
        .enumerate()
        .map(|(chunk, (elevation, thickness, fold, orogeny, orogeny_age))| {
            let start = chunk * CHUNK;
            let mut volume = 0.0;
            for k in 0..elevation.len() {
                let i = start + k;
                let source = field.source[i];
                if source == UNREACHED {
                    continue;
                }
                // A front sample may have become interior or stopped overriding since distances were spread.
                let at = rim.index[source as usize];
                let Some(contact) = contacts.0.get(at as usize) else { continue };
                if contact.role != Role::Overriding {
                    continue;
                }
                let (rate, drag) = law.at(mesh, i, field.distance[i], contact);
                let dt = law.params.time_step as f32;
                let z = elevation[k];
                let raised = saturating_rise(z, rate * dt, law.params.summit_elevation as f32);
                let thicker = thickness[k] + law.isostasy.thickening(z, raised - z);
                let continental = kind[i] == crate::crust::CrustKind::Continental;
                if continental {
                    volume += f64::from(thicker - thickness[k]) * mesh.areas()[i];
                }
                elevation[k] = raised;
                thickness[k] = thicker;
                fold[k] = turned(fold[k], drag, mesh.points()[i].as_vec3());
                if continental && f64::from(rate) > law.params.orogeny_rate {
                    let himalayan = orogeny[k] == Orogeny::Himalayan && orogeny_age[k] < HIMALAYAN_MEMORY;
                    if !himalayan {
                        orogeny[k] = Orogeny::Andean;
                        orogeny_age[k] = 0.0;
                    }
                }
            }
            volume
        })
        .collect();
    volumes.into_iter().sum::<f64>() * law.radius * law.radius
}

impl Uplift<'_> {
    /// Rate of uplift in km/My at sample `i`, and the turn of its fold direction in one step.
    fn at(&self, mesh: &SphereMesh, i: usize, distance: f32, contact: &Contact) -> (f32, Vec3) {
        let velocity = contact.relative.cross(mesh.points()[i]) * self.radius;
        let d = f64::from(distance) * self.radius;
        let profile = self.distance_profile(d);
        let rate = self.weighted(profile, velocity.length(), f64::from(contact.other_elevation));
        let strength = self.params.fold_rate * self.params.time_step * profile;
        (rate as f32, (velocity * strength).as_vec3())
    }
}

/// A fold direction after it was dragged by `drag`: a tangent vector at the direction `n`, at most of unit length.
fn turned(fold: Vec3, drag: Vec3, n: Vec3) -> Vec3 {
    let sum = fold + drag;
    let tangent = sum - n * sum.dot(n);
    let length = tangent.length();
    if length > 1.0 { tangent / length } else { tangent }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn profiles_have_the_closed_forms_of_the_paper() {
        let params = TectonicParams::default();
        let law = Uplift::new(&params, 6370.0);
        assert_eq!(law.distance_profile(0.0), 0.0);
        assert_eq!(law.distance_profile(params.uplift_peak), 1.0);
        assert_eq!(law.distance_profile(params.uplift_end()), 0.0);
        assert_eq!(law.distance_profile(2.0 * params.subduction_distance), 0.0);
        assert!((law.distance_profile(150.0) - 0.5).abs() < 1e-12);
        let middle = 0.5 * (params.uplift_peak + params.uplift_end());
        assert!((law.distance_profile(middle) - 0.5).abs() < 1e-12);
        assert_eq!(law.speed_profile(params.max_speed), 1.0);
        assert_eq!(law.relief_profile(params.summit_elevation), 1.0);
        assert_eq!(law.relief_profile(params.trench_elevation), 0.0);
        assert!((law.relief_profile(0.0) - 0.25).abs() < 1e-12);
        assert!((law.rate(300.0, 100.0, 10.0) - params.uplift).abs() < 1e-12);
    }

    #[test]
    fn a_weight_of_zero_takes_a_factor_out() {
        let params = TectonicParams { weight_distance: 0.0, weight_speed: 0.0, ..default() };
        let law = Uplift::new(&params, 6370.0);
        assert_eq!(law.rate(0.0, 3.0, 0.0), law.rate(1000.0, 90.0, 0.0));
        assert!((law.rate(0.0, 3.0, 0.0) - 0.25 * params.uplift).abs() < 1e-12);
    }

    #[test]
    fn folds_stay_tangent_and_bounded() {
        let n = Vec3::new(0.6, 0.0, 0.8);
        let mut fold = Vec3::ZERO;
        for _ in 0..30 {
            fold = turned(fold, Vec3::new(0.1, 0.2, -0.3), n);
            assert!(fold.dot(n).abs() < 1e-5 && fold.length() < 1.0001);
        }
        assert!(fold.length() > 0.99);
    }
}
