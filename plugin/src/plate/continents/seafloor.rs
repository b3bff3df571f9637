//! Age, elevation and ridge direction of the initial ocean floor.
//!
//! The borders along which plates draw apart are ridges from the start. The age is the shortest
//! time in which crust could have come from one of them, and levels off at [`OLDEST`]; the
//! elevation is `z_a + (z_r - z_a) exp(-age / subsidence_time)`, thermal subsidence to the abyss
//! (Parsons and Sclater 1977).

use super::distance::{Source, nearest};
use crate::crust::FrameId;
use crate::math;
use crate::parallel::map_chunks;
use crate::planet::PlanetRecipe;
use crate::plate::motion::PlateMotion;
use crate::plate::partition::{motions, sites};
use crate::sphere::SphereMesh;
use bevy::math::{DVec3, Vec3};

/// Age that the floor approaches far from every ridge, in My; Earth's oldest is 180.
pub(super) const OLDEST: f64 = 160.0;

/// Slowest half-speed of a ridge in km/My; slower ones would drop to the abyss within a few
/// samples.
const SLOWEST: f64 = 9.0;

/// Past speed at which crust left a ridge, relative to that at which the plates part now. The time
/// from the nearest ridge is the least that the age can be; this makes its mean that of Earth's
/// floor, 60 My.
pub(super) const PAST: f64 = 0.18;

/// A border is a ridge where it opens with at least this share of the relative speed.
const OPENING: f64 = 0.4;

/// Rounds of smoothing of ridge directions, which follow the lattice beside a ridge.
const ROUNDS: usize = 3;

/// The ocean floor as if there were no land.
pub(super) struct Seafloor {
    /// Age in My.
    pub(super) age: Vec<f32>,
    /// Elevation in km.
    pub(super) elevation: Vec<f32>,
    /// Unit tangent vector parallel to the ridge; zero on a planet without ridges.
    pub(super) ridge: Vec<Vec3>,
}

/// The ocean floor. `open` says where a sample is far enough from land for a ridge.
pub(super) fn seafloor(
    recipe: &PlanetRecipe,
    mesh: &SphereMesh,
    owner: &[FrameId],
    open: impl Fn(usize) -> bool,
) -> Seafloor {
    let motions = motions(recipe, &sites(recipe));
    let mut sources = Vec::new();
    for i in 0..mesh.len() {
        let Some((point, relative)) = border(mesh, owner, &motions, i) else {
            continue;
        };
        if open(i) {
            let speed = (PAST * relative * recipe.radius).max(SLOWEST);
            sources.push(Source {
                sample: i as u32,
                point,
                slowness: recipe.radius / speed,
            });
        }
    }
    let near = nearest(mesh, &sources);
    let params = &recipe.params;
    let (z_a, z_r) = (params.abyss_elevation, params.ridge_elevation);
    let parts = map_chunks(mesh.len(), |range| {
        let column = |i: usize| {
            let age = OLDEST * (1.0 - math::exp(-near.cost[i] / OLDEST));
            let z = z_a + (z_r - z_a) * math::exp(-age / params.subsidence_time);
            let p = mesh.point(i as u32);
            let q = sources
                .get(near.source[i] as usize)
                .map_or(p, |source| source.point);
            (
                age as f32,
                z as f32,
                (p - q).cross(p).normalize_or_zero().as_vec3(),
            )
        };
        range.map(column).collect::<Vec<_>>()
    });
    let mut floor = Seafloor {
        age: Vec::new(),
        elevation: Vec::new(),
        ridge: Vec::new(),
    };
    for (age, elevation, ridge) in parts.into_iter().flatten() {
        floor.age.push(age);
        floor.elevation.push(elevation);
        floor.ridge.push(ridge);
    }
    (0..ROUNDS).for_each(|_| floor.ridge = smooth(mesh, &floor.ridge));
    floor
}

/// The point of a diverging border beside sample `i`, and the speed in rad/My at which the plates
/// part.
fn border(
    mesh: &SphereMesh,
    owner: &[FrameId],
    motions: &[PlateMotion],
    i: usize,
) -> Option<(DVec3, f64)> {
    let p = mesh.point(i as u32);
    let ring = mesh.ring(i as u32);
    let other = ring
        .iter()
        .find(|&&j| owner[j as usize] != owner[i])
        .map(|&j| owner[j as usize])?;
    let across = ring
        .iter()
        .filter(|&&j| owner[j as usize] == other)
        .map(|&j| mesh.point(j));
    let (sum, count) = across.fold((DVec3::ZERO, 0.0), |(sum, n), q| (sum + q, n + 1.0));
    let away = p - sum / count;
    let velocity = |plate: FrameId| {
        motions
            .get(usize::from(plate))
            .map(|motion| motion.velocity(p))
    };
    let relative = velocity(owner[i])? - velocity(other)?;
    let opening = relative.dot(away) / away.length();
    let point = (p - 0.5 * away).normalize();
    (opening > OPENING * relative.length()).then(|| (point, relative.length()))
}

/// The mean direction of each sample and its neighbours; a direction and its opposite are the same.
fn smooth(mesh: &SphereMesh, ridge: &[Vec3]) -> Vec<Vec3> {
    let parts = map_chunks(mesh.len(), |range| {
        let mean = |i: usize| {
            let own = ridge[i];
            let add = |sum: Vec3, &j: &u32| {
                let other = ridge[j as usize];
                sum + if other.dot(own) < 0.0 { -other } else { other }
            };
            let p = mesh.point(i as u32).as_vec3();
            let sum = mesh.ring(i as u32).iter().fold(own, add);
            (sum - p * sum.dot(p)).normalize_or_zero()
        };
        range.map(mean).collect::<Vec<_>>()
    });
    parts.concat()
}
