//! Age, elevation and ridge direction of the initial ocean floor.
//!
//! The borders along which plates draw apart are ridges from the start. The age is the shortest
//! time in which crust could have come from one of them, and levels off at [`OLDEST_MY`]; the
//! elevation is `z_a + (z_r - z_a) exp(-age / subsidence_time)`, thermal subsidence to the abyss
//! (Parsons and Sclater 1977).

use crate::crust::FrameId;
use crate::math;
use crate::parallel;
use crate::params::TectonicParams;
use crate::planet::PlanetRecipe;
use crate::plate::motion::PlateMotion;
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::{TravelSource, least_travel_times};
use bevy::math::{DVec3, Vec3};

/// Age that the floor approaches far from every ridge, in My; Earth's oldest is 180.
pub(super) const OLDEST_MY: f64 = 160.0;

/// Slowest half-speed of a ridge in km/My; slower ones would drop to the abyss within a few
/// samples.
const LEAST_RIDGE_SPEED: f64 = 9.0;

/// Past speed at which crust left a ridge, relative to that at which the plates part now. The time
/// from the nearest ridge is the least that the age can be; this makes its mean that of Earth's
/// floor, 60 My.
pub(super) const PAST_SPEED: f64 = 0.18;

/// A border is a ridge where it opens with at least this share of the relative speed: elsewhere it
/// is a transform fault.
const RIDGE_OPENING: f64 = 0.4;

/// Rounds of smoothing of ridge directions, which follow the lattice beside a ridge.
const SMOOTHING_ROUNDS: usize = 3;

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
    motions: &[PlateMotion],
    open: impl Fn(usize) -> bool,
) -> Seafloor {
    let ridges = ridges(recipe, mesh, owner, motions, open);
    let nearest = least_travel_times(mesh, &ridges);
    let age = parallel::map(mesh.len(), |i| age(nearest.time[i as usize]));
    let elevation = parallel::map(mesh.len(), |i| elevation(&recipe.params, age[i as usize]));
    let ridge = parallel::map(mesh.len(), |i| {
        let source = nearest.source[i as usize] as usize;
        along_ridge(mesh.point(i), ridges.get(source))
    });
    Seafloor {
        age: age.into_iter().map(|age| age as f32).collect(),
        elevation,
        ridge: (0..SMOOTHING_ROUNDS).fold(ridge, |ridge, _| smoothed(mesh, &ridge)),
    }
}

/// The points of all ridges.
fn ridges(
    recipe: &PlanetRecipe,
    mesh: &SphereMesh,
    owner: &[FrameId],
    motions: &[PlateMotion],
    open: impl Fn(usize) -> bool,
) -> Vec<TravelSource> {
    let mut ridges = Vec::new();
    for i in 0..mesh.len() {
        if let Some((point, relative)) = diverging_border(mesh, owner, motions, i)
            && open(i)
        {
            let speed = (PAST_SPEED * relative * recipe.radius).max(LEAST_RIDGE_SPEED);
            ridges.push(TravelSource {
                sample: i as u32,
                point,
                slowness: recipe.radius / speed,
            });
        }
    }
    ridges
}

/// Age in My of floor that is `time` My away from the nearest ridge.
fn age(time: f64) -> f64 {
    OLDEST_MY * (1.0 - math::exp(-time / OLDEST_MY))
}

/// Elevation in km of ocean floor of an age in My.
fn elevation(params: &TectonicParams, age: f64) -> f32 {
    let z_a = params.abyss_elevation;
    let z_r = params.ridge_elevation;
    (z_a + (z_r - z_a) * math::exp(-age / params.subsidence_time)) as f32
}

/// Direction at `p` of the ridge that its floor came from: across the way from there.
fn along_ridge(p: DVec3, ridge: Option<&TravelSource>) -> Vec3 {
    let q = ridge.map_or(p, |ridge| ridge.point);
    (p - q).cross(p).normalize_or_zero().as_vec3()
}

/// The point of a diverging border beside sample `i`, and the speed in rad/My at which the plates
/// part.
fn diverging_border(
    mesh: &SphereMesh,
    owner: &[FrameId],
    motions: &[PlateMotion],
    i: usize,
) -> Option<(DVec3, f64)> {
    let p = mesh.point(i as u32);
    let owner_of = |&j: &u32| owner[j as usize];
    let ring = mesh.ring(i as u32).iter();
    // At a triple junction the first foreign neighbour stands for all.
    let other = ring
        .clone()
        .map(owner_of)
        .find(|&plate| plate != owner[i])?;
    let across = ring.filter(|j| owner_of(j) == other);
    let (sum, count) = across.fold((DVec3::ZERO, 0.0), |(q, n), &j| {
        (q + mesh.point(j), n + 1.0)
    });
    // From the middle of the neighbours on the other plate to the sample: across the border.
    let away = p - sum / count;
    let velocity = |plate: FrameId| Some(motions.get(usize::from(plate))?.velocity(p));
    let relative = velocity(owner[i])? - velocity(other)?;
    let opening = relative.dot(away) / away.length();
    // The border runs half way between the sample and its neighbours beyond.
    let point = (p - 0.5 * away).normalize();
    (opening > RIDGE_OPENING * relative.length()).then(|| (point, relative.length()))
}

/// The mean direction of each sample and its neighbours.
fn smoothed(mesh: &SphereMesh, ridge: &[Vec3]) -> Vec<Vec3> {
    parallel::map(mesh.len(), |i| {
        let own = ridge[i as usize];
        let mut sum = own;
        for &j in mesh.ring(i) {
            // A ridge has no head: a direction and its opposite are the same.
            let other = ridge[j as usize];
            sum += if other.dot(own) < 0.0 { -other } else { other };
        }
        let p = mesh.point(i).as_vec3();
        (sum - p * sum.dot(p)).normalize_or_zero()
    })
}
