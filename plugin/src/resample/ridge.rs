//! New ocean floor between parting plates (paper 000 §4.3).
//!
//! The ridge runs halfway between the rims, and the floor is younger the nearer it is:
//!
//! ```text
//! alpha = d_G / (d_G + d_P)          z = alpha z_mean + (1 - alpha) z_G(d_G)
//! z_G(d) = z_a + (z_r - z_a) 2^(-d / sigma)            r = (p - q) x p
//! age = T d_G / (d_G + d_P),  T the shorter of the time since the last resample and the time
//!                             that the gap needed to open
//! ```
//!
//! d_G is the distance to the ridge, d_P to the rim, q the projection of p onto the ridge. sigma
//! grows with the spreading rate, so that z_G agrees with the subsidence of floor that spread at
//! that rate; the parameter holds for [`REFERENCE_RATE`].

use super::input::GapInput;
use crate::crust::{CrustRow, Surface};
use crate::math::exp2;
use crate::params::TectonicParams;
use crate::sphere::angle_of_chord;
use bevy::math::DVec3;

/// Half-spreading rate in km/My at which `ridge_width` agrees with the default `subsidence_time`.
pub const REFERENCE_RATE: f64 = 12.8;

/// A sample of a gap and the rims on both sides of it.
pub(super) struct Between {
    /// The sample.
    pub sample: u32,
    /// The nearest rim.
    pub near: u32,
    /// The nearest rim of another plate.
    pub far: u32,
}

/// How fast a gap opens.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Opening {
    /// As fast as its plates part; where they do not, there is no ridge.
    Measured,
    /// The gap closes now; the reference rate stands for that at which it once opened.
    Past,
}

impl Opening {
    /// Speed in km/My at which the gap opens in the direction `across`.
    fn rate(self, input: &GapInput, surface: &Surface, between: &Between, across: DVec3) -> f64 {
        match self {
            // The reference rate is that of one flank.
            Self::Past => 2.0 * REFERENCE_RATE,
            Self::Measured => parting_rate(input, surface, between, across),
        }
    }
}

/// New ocean crust between two rims; `None` where the plates do not part, or where both rims lie in
/// one direction.
pub(super) fn ridge_row(
    input: &GapInput,
    surface: &Surface,
    between: &Between,
    opening: Opening,
) -> Option<CrustRow> {
    let mesh = input.planet.mesh;
    let p = mesh.point(between.sample);
    let across = mesh.point(between.far) - mesh.point(between.near);
    // Along the ground; the part that points up comes of the sphere's curvature.
    let across = (across - p * across.dot(p)).try_normalize()?;
    let rate = opening.rate(input, surface, between, across);
    if rate <= 0.0 {
        return None;
    }
    let floor = NewFloor::between(input, between, rate);
    let elevation = |rim: u32| f64::from(surface.crust.elevation[rim as usize]);
    let (near, far) = (elevation(between.near), elevation(between.far));
    Some(CrustRow {
        frame: surface.crust.frame[between.near as usize],
        elevation: floor.elevation(input.planet.params, near, far) as f32,
        ocean_age: floor.age(input.elapsed) as f32,
        ridge: across.cross(p).normalize_or(DVec3::ZERO).as_vec3(),
        ..CrustRow::ocean(input.planet.params)
    })
}

/// A place on new floor: distances in km to both rims, and the rate in km/My at which they part.
struct NewFloor {
    to_near: f64,
    to_far: f64,
    rate: f64,
}

impl NewFloor {
    /// The place of a sample between two rims that part at `rate` km/My.
    fn between(input: &GapInput, between: &Between, rate: f64) -> Self {
        let mesh = input.planet.mesh;
        let p = mesh.point(between.sample);
        let distance = |rim: u32| angle_of_chord(p.distance(mesh.point(rim))) * input.planet.radius;
        Self {
            to_near: distance(between.near),
            to_far: distance(between.far),
            rate,
        }
    }

    /// Half of the way from rim to rim in km.
    fn half(&self) -> f64 {
        0.5 * (self.to_near + self.to_far)
    }

    /// d_G in km.
    fn to_ridge(&self) -> f64 {
        (self.half() - self.to_near).max(0.0)
    }

    /// alpha: 0 on the ridge, 1 on the rim.
    fn alpha(&self) -> f64 {
        self.to_ridge() / self.half()
    }

    /// Elevation of the new floor in km, between rims at `near` and `far` km.
    fn elevation(&self, params: &TectonicParams, near: f64, far: f64) -> f64 {
        // z_mean: each rim counts the more the nearer it is.
        let mean = (near * self.to_far + far * self.to_near) / (self.to_near + self.to_far);
        let alpha = self.alpha();
        let ridge = ridge_profile(params, self.to_ridge(), 0.5 * self.rate);
        alpha * mean + (1.0 - alpha) * ridge
    }

    /// Age of the new floor in My; the gap has been open for `elapsed` My at most.
    fn age(&self, elapsed: f64) -> f64 {
        // Beside the rim the floor is as old as the gap. A gap that is narrower than its plates
        // have parted since the last resample was closed at first: it opened when its width says.
        self.alpha() * elapsed.min(2.0 * self.half() / self.rate)
    }
}

/// Speed in km/My at which the plates of two rims part in the direction `across`; negative where
/// they approach each other.
fn parting_rate(input: &GapInput, surface: &Surface, between: &Between, across: DVec3) -> f64 {
    let spin = |rim: u32| input.plates.angular_velocity(surface.plate[rim as usize]);
    let relative = spin(between.far) - spin(between.near);
    let p = input.planet.mesh.point(between.sample);
    relative.cross(p).dot(across) * input.planet.radius
}

/// Template z_G of the floor at `d` km from a ridge that spreads at `rate` km/My to either side.
pub fn ridge_profile(params: &TectonicParams, d: f64, rate: f64) -> f64 {
    // The slowest ridges keep a tenth of the width, or they would be walls.
    let sigma = params.ridge_width * (rate / REFERENCE_RATE).max(0.1);
    params.abyss_elevation + (params.ridge_elevation - params.abyss_elevation) * exp2(-d / sigma)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_template_has_its_closed_form() {
        let params = TectonicParams::default();
        assert_eq!(
            ridge_profile(&params, 0.0, REFERENCE_RATE),
            params.ridge_elevation
        );
        let middle = 0.5 * (params.ridge_elevation + params.abyss_elevation);
        assert!(
            (ridge_profile(&params, params.ridge_width, REFERENCE_RATE) - middle).abs() < 1e-12
        );
        assert!(
            (ridge_profile(&params, 1e5, REFERENCE_RATE) - params.abyss_elevation).abs() < 1e-6
        );
    }

    #[test]
    fn the_template_agrees_with_subsidence() {
        let params = TectonicParams::default();
        for rate in [10.0, 25.0, 50.0] {
            for age in [5.0, 20.0, 60.0] {
                let depth = crate::math::exp(-age / params.subsidence_time);
                let sunk = params.abyss_elevation
                    + (params.ridge_elevation - params.abyss_elevation) * depth;
                assert!((ridge_profile(&params, rate * age, rate) - sunk).abs() < 0.05);
            }
        }
    }
}
