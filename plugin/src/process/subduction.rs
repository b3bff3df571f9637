//! Subduction: ocean crust sinks, and the overriding plate rises (paper 000 §4.1).
//!
//! ```text
//! u(p) = u_0 f(d) g(v) h(z_i)           z' = z + u dt         f' = f + beta (s_i - s_j) dt
//! f(d)  0 at the front, 1 at d_c, 0 from rho r_s on (rho: subduction_reach): two smoothstep pieces
//! g(v) = v / v_0
//! h(z_i) = ((z_i - z_t) / (z_c - z_t))²  of the crust going under, unbent
//! ```
//!
//! The printed h lacks its square and bounds; the cubic of paper 004 is negative at the front. A
//! weight w turns each factor x into 1 + w (x - 1). Every uplift saturates towards z_c. Orogeny
//! becomes Andean where continental crust rises faster than `orogeny_rate`, unless a collision
//! folded it in the last [`HIMALAYAN_MEMORY`] My. Thickness follows by isostasy; on continents it
//! is booked as subduction uplift. *Forced subduction*: where the crust going under is continental,
//! h is large and so is the uplift.
//!
//! Reads: contacts, distances. Writes: elevation, thickness, fold, orogeny type and age.

use crate::crust::isostasy::Isostasy;
use crate::crust::{Cause, Crust, Ledger, Orogeny};
use crate::math::smoothstep;
use crate::parallel::CHUNK;
use crate::params::TectonicParams;
use crate::planet::{Lattice, Planet};
use crate::plate::boundary::Rim;
use crate::plate::contact::{Contact, Contacts, Role};
use crate::plate::front::{FrontField, FrontInput};
use crate::process::saturating_rise;
use crate::schedule::{CurrentPlanet, Stage, StepCursor, TectonicStep, TectonicSystems};
use crate::sphere::SphereMesh;
use bevy::prelude::*;
use rayon::prelude::*;

/// For so long a collision's belt stays Himalayan above a subduction zone, in My.
pub const HIMALAYAN_MEMORY: f32 = 60.0;

/// Adds [`subduction`] to the step.
pub struct SubductionPlugin;

impl Plugin for SubductionPlugin {
    fn build(&self, app: &mut App) {
        app.add_systems(
            TectonicStep,
            subduction.in_set(TectonicSystems::Process(Stage::Subduction)),
        );
    }
}

/// Raises the overriding plates of the current planet.
pub fn subduction(
    current: Res<CurrentPlanet>,
    mut planets: Query<(
        (&Planet, &Lattice, &TectonicParams, &Rim, &Contacts),
        (&mut Crust, &mut FrontField, &mut Ledger, &mut StepCursor),
    )>,
) {
    let Ok((input, (mut crust, mut field, mut ledger, mut cursor))) = planets.get_mut(current.0)
    else {
        return;
    };
    let (planet, lattice, params, rim, contacts) = input;
    if !params.processes.subduction {
        field.stale = true;
        return;
    }
    let reach = (params.uplift_end() / planet.radius).min(2.0);
    let front = FrontInput {
        mesh: lattice,
        frame: &crust.frame,
        rim,
        contacts,
        reach,
    };
    if !field.refresh(&front, || cursor.out_of_time()) {
        cursor.hold();
        return;
    }
    let volume = rise(
        lattice,
        &mut crust,
        &field,
        rim,
        contacts,
        &Uplift::new(params, planet.radius),
    );
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
        Self {
            params,
            isostasy: Isostasy::new(params),
            radius,
        }
    }

    /// f: the profile over the distance `d` from the front in km, 0..1.
    pub fn distance_profile(&self, d: f64) -> f64 {
        let (peak, end) = (self.params.uplift_peak, self.params.uplift_end());
        if d < peak {
            smoothstep(d / peak)
        } else {
            smoothstep((end - d) / (end - peak).max(1.0))
        }
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
        let p = self.params;
        p.uplift
            * weigh(p.weight_distance, self.distance_profile(d))
            * weigh(p.weight_speed, self.speed_profile(v))
            * weigh(p.weight_relief, self.relief_profile(z_i))
    }
}

/// 1 + w (x - 1): a factor that counts as much as its weight.
fn weigh(weight: f64, factor: f64) -> f64 {
    1.0 + weight * (factor - 1.0)
}

/// The law with all divisions done, in single precision, for the sweep.
struct Sweep {
    radius: f32,
    /// Distance in km at which the rising piece ends, and the inverse lengths of both pieces.
    peak: f32,
    end: f32,
    rising: f32,
    falling: f32,
    /// The factors of distance and speed as a + b x.
    distance: [f32; 2],
    speed: [f32; 2],
    /// Turn of the fold direction per km/My in one step.
    fold: f32,
    /// Rate of uplift in km/My from which continental crust is being folded.
    folding: f32,
    dt: f32,
    ceiling: f32,
    isostasy: Isostasy,
}

/// What a sample of the front does to all samples that it is nearest to.
#[derive(Clone, Copy)]
struct Push {
    /// Angular velocity relative to the plate going under, times the planet's radius, in km/My.
    spin: Vec3,
    /// Rate of uplift in km/My before distance and speed are counted.
    rate: f32,
}

impl Sweep {
    fn new(law: &Uplift) -> Self {
        let p = law.params;
        let linear = |weight: f64, slope: f64| [(1.0 - weight) as f32, (weight * slope) as f32];
        Self {
            radius: law.radius as f32,
            peak: p.uplift_peak as f32,
            end: p.uplift_end() as f32,
            rising: (1.0 / p.uplift_peak.max(1e-3)) as f32,
            falling: (1.0 / (p.uplift_end() - p.uplift_peak).max(1.0)) as f32,
            distance: linear(p.weight_distance, 1.0),
            speed: linear(p.weight_speed, 1.0 / p.max_speed),
            fold: (p.fold_rate * p.time_step) as f32,
            folding: p.orogeny_rate as f32,
            dt: p.time_step as f32,
            ceiling: p.summit_elevation as f32,
            isostasy: law.isostasy,
        }
    }

    /// Rate of uplift in km/My at the direction `n`, `angle` radians from the front, and the turn
    /// of the fold direction.
    #[inline]
    fn at(&self, push: &Push, n: Vec3, angle: f32) -> (f32, Vec3) {
        let d = angle * self.radius;
        let x = if d < self.peak {
            d * self.rising
        } else {
            (self.end - d) * self.falling
        };
        let x = x.clamp(0.0, 1.0);
        let profile = x * x * (3.0 - 2.0 * x);
        let velocity = push.spin.cross(n);
        let near = self.distance[0] + self.distance[1] * profile;
        let fast = self.speed[0] + self.speed[1] * velocity.length();
        (push.rate * near * fast, velocity * (self.fold * profile))
    }
}

/// What the samples of the rim push; those that do not override push nothing.
fn pushes(law: &Uplift, contacts: &Contacts) -> Vec<Option<Push>> {
    let push = |contact: &Contact| {
        let rate = law.params.uplift
            * weigh(
                law.params.weight_relief,
                law.relief_profile(f64::from(contact.other_elevation)),
            );
        let spin = (contact.relative * law.radius).as_vec3();
        (contact.role == Role::Overriding).then_some(Push {
            spin,
            rate: rate as f32,
        })
    };
    contacts.0.iter().map(push).collect()
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
    let (sweep, pushes) = (Sweep::new(law), pushes(law, contacts));
    let volumes: Vec<f64> = (
        crust.elevation.par_chunks_mut(CHUNK),
        crust.thickness.par_chunks_mut(CHUNK),
        crust.fold.par_chunks_mut(CHUNK),
        crust.orogeny.par_chunks_mut(CHUNK),
        crust.orogeny_age.par_chunks_mut(CHUNK),
    )
        .into_par_iter()
        .enumerate()
        .map(
            |(chunk, (elevation, thickness, fold, orogeny, orogeny_age))| {
                let start = chunk * CHUNK;
                let mut volume = 0.0;
                for k in 0..elevation.len() {
                    let i = start + k;
                    let Some((source, distance)) = field.nearest(i as u32) else {
                        continue;
                    };
                    // A sample stays on the front for a while after it overrode.
                    let Some(Some(push)) = pushes.get(rim.index[source as usize] as usize) else {
                        continue;
                    };
                    let n = mesh.points()[i].as_vec3();
                    let (rate, drag) = sweep.at(push, n, distance);
                    let z = elevation[k];
                    let raised = saturating_rise(z, rate * sweep.dt, sweep.ceiling);
                    let thicker = thickness[k] + sweep.isostasy.thickening(z, raised - z);
                    let continental = kind[i] == crate::crust::CrustKind::Continental;
                    if continental {
                        volume += f64::from(thicker - thickness[k]) * mesh.areas()[i];
                    }
                    elevation[k] = raised;
                    thickness[k] = thicker;
                    fold[k] = turned(fold[k], drag, n);
                    if continental && rate > sweep.folding {
                        let himalayan =
                            orogeny[k] == Orogeny::Himalayan && orogeny_age[k] < HIMALAYAN_MEMORY;
                        if !himalayan {
                            orogeny[k] = Orogeny::Andean;
                            orogeny_age[k] = 0.0;
                        }
                    }
                }
                volume
            },
        )
        .collect();
    volumes.into_iter().sum::<f64>() * law.radius * law.radius
}

/// A fold direction after it was dragged by `drag`: a tangent vector at the direction `n`, at most
/// of unit length.
fn turned(fold: Vec3, drag: Vec3, n: Vec3) -> Vec3 {
    let sum = fold + drag;
    let tangent = sum - n * sum.dot(n);
    let length = tangent.length();
    if length > 1.0 {
        tangent / length
    } else {
        tangent
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bevy::math::DVec3;

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
    fn the_sweep_follows_the_law() {
        let params = TectonicParams {
            weight_speed: 0.7,
            weight_relief: 0.4,
            ..default()
        };
        let law = Uplift::new(&params, 6370.0);
        let sweep = Sweep::new(&law);
        for (km, speed, z) in [
            (0.0, 30.0, -6.0),
            (120.0, 80.0, -2.0),
            (700.0, 10.0, 0.5),
            (1799.0, 99.0, -8.0),
        ] {
            let relative = DVec3::Z * (speed / 6370.0);
            let contact = Contact {
                role: Role::Overriding,
                relative,
                other_elevation: z as f32,
                ..default()
            };
            let push = pushes(&law, &Contacts(vec![contact]))[0].unwrap();
            let (rate, drag) = sweep.at(&push, Vec3::X, (km / 6370.0) as f32);
            assert!((f64::from(rate) - law.rate(km, speed, z)).abs() < 1e-5 * params.uplift);
            let turn = params.fold_rate * params.time_step * law.distance_profile(km) * speed;
            assert!((drag - Vec3::Y * turn as f32).length() < 1e-5);
        }
    }

    #[test]
    fn a_weight_of_zero_takes_a_factor_out() {
        let params = TectonicParams {
            weight_distance: 0.0,
            weight_speed: 0.0,
            ..default()
        };
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
