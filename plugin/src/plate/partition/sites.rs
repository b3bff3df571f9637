//! Where the initial plates are, how large, and how they move.
//!
//! Areas of random plates follow a power law of their rank, fitted to Earth's: its largest plate
//! takes a fifth of the surface, its seven largest nine tenths (Bird 2003). Large plates are placed
//! first and keep apart, small ones fall into the gaps.

use crate::math;
use crate::planet::{PlanetRecipe, PlateRecipe};
use crate::plate::continents::Continents;
use crate::plate::motion::PlateMotion;
use crate::random::{Purpose, Stream};
use bevy::math::DVec3;

/// Exponent of the power law of areas.
const RANK_POWER: f64 = 1.2;

/// Smallest area of a plate relative to the mean.
const SMALLEST_SHARE: f64 = 0.3;

/// Distance that two plates keep, relative to the sum of the radii of caps of their areas. Caps
/// that may not overlap at all cannot fill a sphere.
const SEPARATION: f64 = 0.75;

/// Positions tried for a plate before the best one is taken.
const TRIES: u64 = 48;

/// Where a plate is.
#[derive(Clone, Copy, Debug)]
pub(in crate::plate) struct Site {
    /// Unit direction of the centroid.
    pub(in crate::plate) centroid: DVec3,
    /// Weight in the partition, a chord length.
    pub(in crate::plate) weight: f64,
    /// Angular radius in rad of a cap of about the plate's area.
    pub(in crate::plate) radius: f64,
}

/// The sites of the recipe's plates: as given, or random, the largest first.
pub(in crate::plate) fn sites(recipe: &PlanetRecipe) -> Vec<Site> {
    if recipe.plates.is_empty() {
        return random_sites(recipe);
    }
    let radius = cap_radius(1.0 / recipe.plates.len() as f64);
    let site = |plate: &PlateRecipe| {
        let (latitude, longitude) = plate.centroid;
        Site {
            centroid: math::direction(latitude, longitude),
            weight: 0.0,
            radius,
        }
    };
    recipe.plates.iter().map(site).collect()
}

fn random_sites(recipe: &PlanetRecipe) -> Vec<Site> {
    let stream = Stream::new(recipe.seed, Purpose::PlateCentroids, 0);
    let mut sites: Vec<Site> = Vec::new();
    for (plate, share) in shares(recipe).into_iter().enumerate() {
        let radius = cap_radius(share);
        let room = |p: DVec3| {
            let free =
                |s: &Site| math::angle_between(p, s.centroid) - SEPARATION * (radius + s.radius);
            sites.iter().map(free).fold(f64::INFINITY, f64::min)
        };
        let tries = (0..TRIES).map(|k| stream.direction(plate as u64 * TRIES + k));
        let centroid = first_or_best(tries, room, 0.0).unwrap_or(DVec3::Z);
        sites.push(Site {
            centroid,
            weight: 0.85 * radius,
            radius,
        });
    }
    sites
}

/// The first candidate whose score reaches `enough`, or else the one with the highest score.
pub(in crate::plate) fn first_or_best<T: Copy>(
    candidates: impl Iterator<Item = T>,
    score: impl Fn(T) -> f64,
    enough: f64,
) -> Option<T> {
    let mut best: Option<(T, f64)> = None;
    for candidate in candidates {
        let score = score(candidate);
        if best.is_none_or(|(_, highest)| score > highest) {
            best = Some((candidate, score));
        }
        if score >= enough {
            break;
        }
    }
    best.map(|(candidate, _)| candidate)
}

/// Shares of the sphere's area, descending, with sum 1.
fn shares(recipe: &PlanetRecipe) -> Vec<f64> {
    let n = recipe.plate_count as usize;
    let stream = Stream::new(recipe.seed, Purpose::PlateCentroids, 1);
    let share =
        |k: usize| math::pow(k as f64 + 2.0, -RANK_POWER) * stream.range(k as u64, 0.75, 1.25);
    let mut shares: Vec<_> = (0..n).map(share).collect();
    let mean = shares.iter().sum::<f64>() / n as f64;
    shares
        .iter_mut()
        .for_each(|share| *share = share.max(SMALLEST_SHARE * mean));
    let sum: f64 = shares.iter().sum();
    shares.iter_mut().for_each(|share| *share /= sum);
    shares.sort_by(|a, b| b.total_cmp(a));
    shares
}

/// Angular radius in rad of a cap that covers `share` of the sphere.
pub(in crate::plate) fn cap_radius(share: f64) -> f64 {
    math::acos(1.0 - 2.0 * share)
}

/// Motions of the recipe's plates: as given, or random.
///
/// A plate without a pole moves at random, but with its own speed if that is not 0.
pub(in crate::plate) fn motions(recipe: &PlanetRecipe, sites: &[Site]) -> Vec<PlateMotion> {
    let continents = Continents::new(recipe, sites);
    let motion = |(plate, site): (usize, &Site)| {
        let random = random_motion(recipe, plate, site, continents.cover(site));
        match recipe.plates.get(plate) {
            Some(PlateRecipe {
                pole: Some((latitude, longitude)),
                speed,
                ..
            }) => given_motion(
                math::direction(*latitude, *longitude),
                *speed,
                recipe.radius,
            ),
            Some(PlateRecipe { speed, .. }) if *speed != 0.0 => {
                given_motion(random.axis, *speed, recipe.radius)
            }
            _ => random,
        }
    };
    sites.iter().enumerate().map(motion).collect()
}

/// The motion about `pole` with `speed` km/My at 90 degrees from it on a planet of `radius` km.
fn given_motion(pole: DVec3, speed: f64, radius: f64) -> PlateMotion {
    PlateMotion {
        axis: if speed < 0.0 { -pole } else { pole },
        speed: speed.abs() / radius,
    }
}

/// A random motion of a plate whose crust is continental to the share `continental`.
///
/// The pole is 60 to 120 degrees away, so that the plate travels rather than spins. Oceanic plates
/// go at 45 to 95 % of the highest speed, continental ones at less than half of that, as on Earth.
fn random_motion(
    recipe: &PlanetRecipe,
    plate: usize,
    site: &Site,
    continental: f64,
) -> PlateMotion {
    let stream = Stream::new(recipe.seed, Purpose::PlateMotion, plate as u64);
    let east = math::any_tangent(site.centroid);
    let north = site.centroid.cross(east);
    let (sin_bearing, cos_bearing) = math::sin_cos(stream.range(0, 0.0, math::TAU));
    let (sin_tilt, cos_tilt) = math::sin_cos(stream.range(1, -math::PI / 6.0, math::PI / 6.0));
    let axis = (east * cos_bearing + north * sin_bearing) * cos_tilt + site.centroid * sin_tilt;
    let share = stream.range(2, 0.45, 0.95) * (1.0 - 0.55 * continental);
    PlateMotion {
        axis: axis.normalize(),
        speed: share * recipe.params.max_speed / recipe.radius,
    }
}
