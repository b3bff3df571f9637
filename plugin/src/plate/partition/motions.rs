//! How the initial plates move.

use super::sites::PlateSite;
use crate::math;
use crate::planet::{PlanetRecipe, PlateRecipe};
use crate::plate::motion::PlateMotion;
use crate::random::{Purpose, Stream};
use bevy::math::DVec3;

/// Range of the speed of a random oceanic plate, as a share of the highest.
const SPEED_SHARE: [f64; 2] = [0.45, 0.95];

/// Share of its speed that a plate loses if it is all continent: on Earth such plates go at less
/// than half of the speed of oceanic ones.
const CONTINENTAL_DRAG: f64 = 0.55;

/// Most by which the angle from a plate's centroid to its pole of rotation differs from 90 degrees,
/// in rad: at 60 to 120 degrees the plate travels rather than spins.
const MAX_TILT: f64 = math::PI / 6.0;

/// Motions of the recipe's plates: as given, or random.
///
/// `continental` is the share of continental crust at a site. A plate without a pole moves at
/// random, but with its own speed if that is not 0.
pub(in crate::plate) fn motions(
    recipe: &PlanetRecipe,
    sites: &[PlateSite],
    continental: impl Fn(&PlateSite) -> f64,
) -> Vec<PlateMotion> {
    let mut motions = Vec::with_capacity(sites.len());
    for (plate, site) in sites.iter().enumerate() {
        let random = random_motion(recipe, plate, site, continental(site));
        motions.push(plate_motion(
            recipe.plates.get(plate),
            recipe.radius,
            random,
        ));
    }
    motions
}

/// The motion of a plate as far as it is given, on a planet of `radius` km.
fn plate_motion(given: Option<&PlateRecipe>, radius: f64, random: PlateMotion) -> PlateMotion {
    let Some(&PlateRecipe { pole, speed, .. }) = given else {
        return random;
    };
    match pole {
        Some((latitude, longitude)) => {
            given_motion(math::direction(latitude, longitude), speed, radius)
        }
        None if speed != 0.0 => given_motion(random.axis, speed, radius),
        None => random,
    }
}

/// The motion about `pole` with `speed` km/My at 90 degrees from it on a planet of `radius` km.
fn given_motion(pole: DVec3, speed: f64, radius: f64) -> PlateMotion {
    PlateMotion {
        axis: if speed < 0.0 { -pole } else { pole },
        speed: speed.abs() / radius,
    }
}

/// A random motion of a plate whose crust is continental to the share `continental`.
fn random_motion(
    recipe: &PlanetRecipe,
    plate: usize,
    site: &PlateSite,
    continental: f64,
) -> PlateMotion {
    let stream = Stream::new(recipe.seed, Purpose::PlateMotion, plate as u64);
    // Any two tangents will do: the bearing is random.
    let east = math::any_tangent(site.centroid);
    let north = site.centroid.cross(east);
    let (sin_bearing, cos_bearing) = math::sin_cos(stream.range(0, 0.0, math::TAU));
    let (sin_tilt, cos_tilt) = math::sin_cos(stream.range(1, -MAX_TILT, MAX_TILT));
    // A bearing on the circle 90 degrees off, then tilted towards the centroid or away.
    let axis = (east * cos_bearing + north * sin_bearing) * cos_tilt + site.centroid * sin_tilt;
    let [slow, fast] = SPEED_SHARE;
    let share = stream.range(2, slow, fast) * (1.0 - CONTINENTAL_DRAG * continental);
    PlateMotion {
        axis: axis.normalize(),
        speed: share * recipe.params.max_speed / recipe.radius,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plate::partition::sites;

    #[test]
    fn continents_slow_a_plate_down() {
        let recipe = PlanetRecipe::default();
        let sites = sites(&recipe);
        let oceanic = motions(&recipe, &sites, |_| 0.0);
        let continental = motions(&recipe, &sites, |_| 1.0);
        for (fast, slow) in oceanic.iter().zip(&continental) {
            assert_eq!(fast.axis, slow.axis);
            assert!((slow.speed / fast.speed - 0.45).abs() < 1e-12);
        }
    }
}
