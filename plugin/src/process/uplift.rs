//! The law by which an overriding plate rises (paper 000 §4.1).
//!
//! ```text
//! u(p) = u_0 f(d) g(v) h(z_i)
//! f(d)  0 at the front, 1 at d_c, 0 from rho r_s on (rho: subduction_reach): two smoothstep pieces
//! g(v) = v / v_0
//! h(z_i) = ((z_i - z_t) / (z_c - z_t))²  of the crust going under, unbent
//! ```
//!
//! The printed h lacks its square and bounds; the cubic of paper 004 is negative at the front. A
//! weight w turns each factor x into 1 + w (x - 1).

use crate::crust::isostasy::Isostasy;
use crate::math::smoothstep;
use crate::params::TectonicParams;
use crate::plate::contact::{Contact, Role};
use bevy::math::Vec3;

/// The law of one set of parameters.
pub struct Uplift<'a> {
    params: &'a TectonicParams,
    radius: f64,
}

impl<'a> Uplift<'a> {
    /// The law on a planet of `radius` km.
    pub fn new(params: &'a TectonicParams, radius: f64) -> Self {
        Self { params, radius }
    }

    /// f: the profile over the distance `d` from the front in km, 0..1.
    pub fn distance_profile(&self, d: f64) -> f64 {
        let (peak, end) = (self.params.uplift_peak, self.params.uplift_end());
        if d < peak {
            smoothstep(d / peak)
        } else {
            // At least a kilometre: an end at the peak must not divide by 0.
            smoothstep((end - d) / (end - peak).max(1.0))
        }
    }

    /// g: the influence of the relative speed `v` in km/My.
    pub fn speed_profile(&self, v: f64) -> f64 {
        v / self.params.max_speed
    }

    /// h: the influence of the elevation `z_i` in km of the crust going under.
    pub fn elevation_profile(&self, z_i: f64) -> f64 {
        let (low, high) = (self.params.trench_elevation, self.params.summit_elevation);
        let normalised = ((z_i - low) / (high - low)).clamp(0.0, 1.0);
        normalised * normalised
    }

    /// The rate of uplift in km/My at `d` km from the front.
    pub fn rate(&self, d: f64, v: f64, z_i: f64) -> f64 {
        let p = self.params;
        p.uplift
            * weigh(p.weight_distance, self.distance_profile(d))
            * weigh(p.weight_speed, self.speed_profile(v))
            * weigh(p.weight_relief, self.elevation_profile(z_i))
    }

    /// The push of a contact of the front; `None` for one that does not override.
    pub(super) fn push(&self, contact: &Contact) -> Option<Push> {
        let elevation = self.elevation_profile(f64::from(contact.other_elevation));
        let rate = self.params.uplift * weigh(self.params.weight_relief, elevation);
        let spin = (contact.relative * self.radius).as_vec3();
        (contact.role == Role::Overriding).then_some(Push {
            spin,
            rate: rate as f32,
        })
    }
}

/// 1 + w (x - 1): a factor that counts as much as its weight.
fn weigh(weight: f64, factor: f64) -> f64 {
    1.0 + weight * (factor - 1.0)
}

/// The effect of a sample of the front on all samples that it is nearest to.
#[derive(Clone, Copy)]
pub(super) struct Push {
    /// Angular velocity relative to the plate going under, times the planet's radius, in km/My.
    spin: Vec3,
    /// Rate of uplift in km/My before distance and speed are counted.
    rate: f32,
}

/// A factor of the law as `offset + slope x`.
struct Linear {
    offset: f32,
    slope: f32,
}

impl Linear {
    fn new(weight: f64, slope: f64) -> Self {
        Self {
            // 1 + w (x - 1), with the slope times x for its x.
            offset: (1.0 - weight) as f32,
            slope: (weight * slope) as f32,
        }
    }

    #[inline]
    fn at(&self, x: f32) -> f32 {
        self.offset + self.slope * x
    }
}

/// The law with all divisions done, in single precision: half a million samples ask it in a step.
pub(super) struct FastUplift {
    /// Planet radius in km.
    radius: f32,
    /// Distance in km from the front at which the uplift peaks.
    peak: f32,
    /// Distance in km at which it ends.
    end: f32,
    /// One over the length of the rising piece of f, per km.
    rising: f32,
    /// One over the length of the falling piece.
    falling: f32,
    /// The factor of the distance, of f.
    distance: Linear,
    /// The factor of the speed, of v in km/My.
    speed: Linear,
    /// Turn of the fold direction per km/My in one step.
    fold: f32,
    /// Rate of uplift in km/My from which continental crust is being folded.
    pub folding: f32,
    /// Age in My below which a belt of a collision stays one.
    pub belt_memory: f32,
    /// Time step in My.
    pub dt: f32,
    /// Elevation in km that summits approach.
    pub ceiling: f32,
    /// How thick crust must be to float as high as it rises.
    pub isostasy: Isostasy,
}

impl FastUplift {
    pub(super) fn new(law: &Uplift) -> Self {
        let p = law.params;
        Self {
            radius: law.radius as f32,
            peak: p.uplift_peak as f32,
            end: p.uplift_end() as f32,
            // A peak at the front itself, or an end at the peak, must not divide by 0.
            rising: (1.0 / p.uplift_peak.max(1e-3)) as f32,
            falling: (1.0 / (p.uplift_end() - p.uplift_peak).max(1.0)) as f32,
            distance: Linear::new(p.weight_distance, 1.0),
            speed: Linear::new(p.weight_speed, 1.0 / p.max_speed),
            fold: (p.fold_rate * p.time_step) as f32,
            folding: p.orogeny_rate as f32,
            belt_memory: p.himalayan_memory as f32,
            dt: p.time_step as f32,
            ceiling: p.summit_elevation as f32,
            isostasy: Isostasy::new(p),
        }
    }

    /// Rate of uplift in km/My at the direction `n`, `angle` radians from the front, and the turn
    /// of the fold direction.
    #[inline]
    pub(super) fn at(&self, push: &Push, n: Vec3, angle: f32) -> (f32, Vec3) {
        let d = angle * self.radius;
        let x = if d < self.peak {
            d * self.rising
        } else {
            (self.end - d) * self.falling
        };
        let x = x.clamp(0.0, 1.0);
        // x runs from 0 to 1 at the peak and back: one smoothstep serves both pieces of f.
        let profile = x * x * (3.0 - 2.0 * x);
        let velocity = push.spin.cross(n);
        let near = self.distance.at(profile);
        let fast = self.speed.at(velocity.length());
        (push.rate * near * fast, velocity * (self.fold * profile))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bevy::math::DVec3;
    use bevy::utils::default;

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
        assert_eq!(law.elevation_profile(params.summit_elevation), 1.0);
        assert_eq!(law.elevation_profile(params.trench_elevation), 0.0);
        assert!((law.elevation_profile(0.0) - 0.25).abs() < 1e-12);
        assert!((law.rate(300.0, 100.0, 10.0) - params.uplift).abs() < 1e-12);
    }

    #[test]
    fn the_fast_form_follows_the_law() {
        let params = TectonicParams {
            weight_speed: 0.7,
            weight_relief: 0.4,
            ..default()
        };
        let law = Uplift::new(&params, 6370.0);
        let fast = FastUplift::new(&law);
        for (km, speed, z) in [
            (0.0, 30.0, -6.0),
            (120.0, 80.0, -2.0),
            (700.0, 10.0, 0.5),
            (1799.0, 99.0, -8.0),
        ] {
            let contact = Contact {
                role: Role::Overriding,
                relative: DVec3::Z * (speed / 6370.0),
                other_elevation: z as f32,
                ..default()
            };
            let push = law.push(&contact).unwrap();
            let (rate, drag) = fast.at(&push, Vec3::X, (km / 6370.0) as f32);
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
}
