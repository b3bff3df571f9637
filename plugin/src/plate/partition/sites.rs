//! Where the initial plates are and how large.
//!
//! Areas of random plates follow a power law of their rank, fitted to Earth's: its largest plate
//! takes a fifth of the surface, its seven largest nine tenths (Bird 2003). Large plates are placed
//! first and keep apart, small ones fall into the gaps.

use super::placement::{cap_radius, first_or_best};
use crate::math;
use crate::planet::{PlanetRecipe, PlateRecipe};
use crate::random::{Purpose, Stream};
use bevy::math::DVec3;

/// Exponent of the power law of areas, fitted to the plates of Bird 2003.
const RANK_POWER: f64 = 1.2;

/// Range of the factor by which the area of a random plate departs from the power law.
const AREA_FACTOR: [f64; 2] = [0.75, 1.25];

/// Smallest area of a plate relative to the mean: a power law alone would end in specks of a few
/// samples.
const SMALLEST_SHARE: f64 = 0.3;

/// Distance that two plates keep, relative to the sum of the radii of caps of their areas. Caps
/// that may not overlap at all cannot fill a sphere.
const SEPARATION: f64 = 0.75;

/// Weight in the partition relative to the radius of the cap: large plates push their borders out.
/// Found by trial, until the areas of cells followed those of the caps.
const WEIGHT_PER_RADIUS: f64 = 0.85;

/// Places tried for a plate before the best one is taken.
const PLACES_TRIED: u64 = 48;

/// Where a plate is.
#[derive(Clone, Copy, Debug)]
pub(in crate::plate) struct PlateSite {
    /// Unit direction of the centroid.
    pub(in crate::plate) centroid: DVec3,
    /// Weight in the partition, a chord length.
    pub(in crate::plate) weight: f64,
    /// Angular radius in rad of a cap of about the plate's area.
    pub(in crate::plate) radius: f64,
}

/// The sites of the recipe's plates: as given, or random, the largest first.
pub(in crate::plate) fn sites(recipe: &PlanetRecipe) -> Vec<PlateSite> {
    if recipe.plates.is_empty() {
        return random_sites(recipe);
    }
    let radius = cap_radius(1.0 / recipe.plates.len() as f64);
    let plates = recipe.plates.iter();
    plates
        .map(|plate| PlateSite::given(plate, radius))
        .collect()
}

impl PlateSite {
    /// The site of a plate of the recipe.
    fn given(plate: &PlateRecipe, radius: f64) -> Self {
        let (latitude, longitude) = plate.centroid;
        Self {
            centroid: math::direction(latitude, longitude),
            weight: 0.0,
            radius,
        }
    }

    /// Distance in rad that a cap of the given radius around `p` has to spare from this plate;
    /// negative where it is too near.
    fn room(&self, p: DVec3, radius: f64) -> f64 {
        math::angle_between(p, self.centroid) - SEPARATION * (radius + self.radius)
    }
}

fn random_sites(recipe: &PlanetRecipe) -> Vec<PlateSite> {
    let stream = Stream::new(recipe.seed, Purpose::PlateCentroids, 0);
    let mut sites: Vec<PlateSite> = Vec::new();
    for (plate, share) in (0..).zip(shares(recipe)) {
        let radius = cap_radius(share);
        let places = (0..PLACES_TRIED).map(|k| stream.direction(plate * PLACES_TRIED + k));
        let room = |p: DVec3| least_room(&sites, p, radius);
        let centroid = first_or_best(places, room, 0.0).unwrap_or(DVec3::Z);
        sites.push(PlateSite {
            centroid,
            weight: WEIGHT_PER_RADIUS * radius,
            radius,
        });
    }
    sites
}

/// Room beside the closest of `sites`, in rad; see [`PlateSite::room`].
fn least_room(sites: &[PlateSite], p: DVec3, radius: f64) -> f64 {
    let rooms = sites.iter().map(|site| site.room(p, radius));
    rooms.fold(f64::INFINITY, f64::min)
}

/// Shares of the sphere's area, descending, with sum 1.
fn shares(recipe: &PlanetRecipe) -> Vec<f64> {
    let n = recipe.plate_count as usize;
    let stream = Stream::new(recipe.seed, Purpose::PlateCentroids, 1);
    let [low, high] = AREA_FACTOR;
    // Ranks count from 2: from 1, the largest of 40 plates would take three tenths of the surface.
    let share =
        |k: usize| math::pow(k as f64 + 2.0, -RANK_POWER) * stream.range(k as u64, low, high);
    let mut shares: Vec<_> = (0..n).map(share).collect();
    let mean = shares.iter().sum::<f64>() / n as f64;
    // Raised before they are scaled to the sum 1, so the least ends a little below.
    for share in &mut shares {
        *share = share.max(SMALLEST_SHARE * mean);
    }
    let sum: f64 = shares.iter().sum();
    shares.iter_mut().for_each(|share| *share /= sum);
    shares.sort_by(|a, b| b.total_cmp(a));
    shares
}
