//! Which plates carry continents, and the discs that make their rough shapes.
//!
//! As on Earth a few continents hold most of the land and lie on large plates, off their centres,
//! so that one coast is near a border and the other is not. Each is a core with side lobes along an
//! axis; small blocks, some of them off a large coast, make islands.

use crate::math;
use crate::planet::{DiscRecipe, PlanetRecipe};
use crate::plate::partition::{PlateSite, cap_radius, first_or_best};
use crate::random::{Purpose, Stream};
use bevy::math::DVec3;

/// Share of the land that large continents take; islands take the rest, as on Earth.
const CONTINENT_SHARE: f64 = 0.94;

/// Plates that may carry a large continent, the largest ones: on smaller ones it would not fit.
const HOSTS: usize = 12;

/// Places tried for a continent before the best one is taken.
const PLACES_TRIED: u64 = 40;

/// Farthest that the centre of a continent lies from that of its plate, in radii of the plate.
const FARTHEST_OFF_CENTRE: f64 = 0.5;

/// Distance that two continents keep, relative to the sum of their radii: a strait is left.
const CONTINENT_SEPARATION: f64 = 1.05;

/// Room in rad beyond which more is no better.
const ENOUGH_ROOM: f64 = 0.5;

/// Room in rad that a plate must offer more if it carries a continent already.
const USED_PENALTY: f64 = 0.3;

/// Largest radius of a continent relative to that of its plate; larger ones overhang on every side.
const LARGEST_ON_PLATE: f64 = 0.85;

/// Room in rad that a plate must offer more per rad of overhang.
const OVERHANG_PENALTY: f64 = 2.0;

/// Radius of the middle lobe relative to that of the continent.
const MIDDLE_RADIUS: f64 = 0.6;

/// Ranges of a side lobe's radius and of its distance from the middle, in radii of the continent.
struct SideLobe {
    radius: [f64; 2],
    distance: [f64; 2],
}

/// The two large side lobes, which make a continent longer than it is wide.
const ALONG_AXIS: SideLobe = SideLobe {
    radius: [0.4, 0.65],
    distance: [0.7, 1.1],
};

/// The small ones, which make peninsulas.
const ANYWHERE: SideLobe = SideLobe {
    radius: [0.25, 0.5],
    distance: [0.6, 0.9],
};

/// A disc of continental crust.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lobe {
    /// Unit direction of the centre.
    pub(super) center: DVec3,
    /// Angular radius in rad.
    pub(super) radius: f64,
}

impl Lobe {
    /// A disc of the recipe on a planet of `radius` km.
    fn given(disc: &DiscRecipe, radius: f64) -> Self {
        Self {
            center: disc.direction(),
            radius: (disc.radius / radius).min(math::PI),
        }
    }
}

/// The rough shapes of a planet's continents.
#[derive(Clone, Debug, Default)]
pub(super) struct Continents {
    pub(super) lobes: Vec<Lobe>,
}

impl Continents {
    /// The discs of the recipe, or random continents on some of `sites`. A planet without land has
    /// no lobes.
    pub(super) fn new(recipe: &PlanetRecipe, sites: &[PlateSite]) -> Self {
        if !recipe.continents.is_empty() {
            let discs = recipe.continents.iter();
            return Self {
                lobes: discs.map(|disc| Lobe::given(disc, recipe.radius)).collect(),
            };
        }
        if recipe.land <= 0.0 {
            return Self::default();
        }
        let cores = cores(recipe, sites);
        let mut lobes: Vec<Lobe> = Vec::new();
        for (k, core) in (0..).zip(&cores) {
            let stream = Stream::new(recipe.seed, Purpose::Continents, 10 + k);
            lobes.extend(shape(core, &stream));
        }
        lobes.extend(blocks(recipe, &cores));
        Self { lobes }
    }

    /// Rough share of continental crust on the plate at `site`, 0..1.
    pub(super) fn cover(&self, site: &PlateSite) -> f64 {
        let depth = |lobe: &Lobe| lobe.radius - math::angle_between(lobe.center, site.centroid);
        let deepest = self.lobes.iter().map(depth).fold(-math::PI, f64::max);
        // Half where the edge of a lobe runs through the centre of the plate.
        math::smoothstep(0.5 + deepest / (2.0 * site.radius))
    }
}

/// One disc for each large continent, the largest first.
fn cores(recipe: &PlanetRecipe, sites: &[PlateSite]) -> Vec<Lobe> {
    let stream = Stream::new(recipe.seed, Purpose::Continents, 0);
    let count = 4 + stream.bits(0) % 4;
    // A power law of the rank, like the plates: the first is three to five times the last.
    let weight = |k: u64| stream.range(1 + k, 0.7, 1.3) / (k as f64 + 1.5);
    let total: f64 = (0..count).map(weight).sum();
    let mut hosts = Hosts::new(sites);
    let mut cores: Vec<Lobe> = Vec::new();
    for k in 0..count {
        let radius = cap_radius(CONTINENT_SHARE * recipe.land * weight(k) / total);
        let draw = Stream::new(recipe.seed, Purpose::Continents, 100 + k);
        let places = (0..PLACES_TRIED).map(|t| hosts.place(&draw, t));
        let score = |(host, center)| hosts.score(host, Lobe { center, radius }, &cores);
        if let Some((host, center)) = first_or_best(places, score, 0.0) {
            hosts.is_used[host] = true;
            cores.push(Lobe { center, radius });
        }
    }
    cores
}

/// The plates that may carry large continents.
struct Hosts<'a> {
    sites: &'a [PlateSite],
    /// Numbers of the largest plates.
    largest: Vec<usize>,
    /// Whether a plate carries a continent already.
    is_used: Vec<bool>,
}

impl<'a> Hosts<'a> {
    fn new(sites: &'a [PlateSite]) -> Self {
        let mut largest: Vec<usize> = (0..sites.len()).collect();
        largest.sort_by(|&a, &b| sites[b].radius.total_cmp(&sites[a].radius).then(a.cmp(&b)));
        largest.truncate(HOSTS);
        Self {
            sites,
            largest,
            is_used: vec![false; sites.len()],
        }
    }

    /// A random plate and a random place on it.
    fn place(&self, draw: &Stream, t: u64) -> (usize, DVec3) {
        let host = self.largest[(draw.bits(3 * t) % self.largest.len() as u64) as usize];
        let site = &self.sites[host];
        let off = site.radius * draw.range(3 * t + 1, 0.0, FARTHEST_OFF_CENTRE);
        let bearing = draw.range(3 * t + 2, 0.0, math::TAU);
        (host, step(site.centroid, bearing, off))
    }

    /// Room in rad of a new core beside the others, less for a plate that carries a continent
    /// already or is too small for this one.
    fn score(&self, host: usize, new: Lobe, cores: &[Lobe]) -> f64 {
        let apart = |core: &Lobe| math::angle_between(new.center, core.center);
        let room = |core: &Lobe| apart(core) - CONTINENT_SEPARATION * (new.radius + core.radius);
        let room = cores.iter().map(room).fold(ENOUGH_ROOM, f64::min);
        let used = if self.is_used[host] {
            USED_PENALTY
        } else {
            0.0
        };
        let overhang = (new.radius - LARGEST_ON_PLATE * self.sites[host].radius).max(0.0);
        room - used - OVERHANG_PENALTY * overhang
    }
}

/// The lobes of one continent of about the area of the disc `core`.
fn shape(core: &Lobe, stream: &Stream) -> Vec<Lobe> {
    let axis = stream.range(0, 0.0, math::TAU);
    let sides = 3 + stream.bits(1) % 3;
    let mut lobes = vec![Lobe {
        center: core.center,
        radius: MIDDLE_RADIUS * core.radius,
    }];
    for k in 0..sides {
        let draw = |j: u64, [low, high]: [f64; 2]| stream.range(10 * (k + 1) + j, low, high);
        // Two lobes lie at the ends of the axis, the others anywhere.
        let (kind, bearing) = if k < 2 {
            let end = axis + math::PI * k as f64;
            (ALONG_AXIS, end + draw(0, [-0.5, 0.5]))
        } else {
            (ANYWHERE, draw(0, [0.0, math::TAU]))
        };
        let radius = core.radius * draw(1, kind.radius);
        let distance = core.radius * draw(2, kind.distance);
        lobes.push(Lobe {
            center: step(core.center, bearing, distance),
            radius,
        });
    }
    lobes
}

/// Small blocks: every second one off the coast of a large continent, the others anywhere.
fn blocks(recipe: &PlanetRecipe, cores: &[Lobe]) -> Vec<Lobe> {
    let weight = |k: usize| 1.0 / (k as f64 + 2.0);
    let count = recipe.islands as usize;
    let total: f64 = (0..count).map(weight).sum();
    let share = |k: usize| (1.0 - CONTINENT_SHARE) * recipe.land * weight(k) / total;
    let block = |k: usize| block(recipe.seed, cores, k, cap_radius(share(k)));
    (0..count).map(block).collect()
}

/// The block number `k` of the given radius.
fn block(seed: u64, cores: &[Lobe], k: usize, radius: f64) -> Lobe {
    let stream = Stream::new(seed, Purpose::Continents, 1);
    let draw = |j: usize| stream.unit((4 * k + j) as u64);
    // The continents in turn; without any, every block lies anywhere.
    let center = match cores.get(k / 2 % cores.len().max(1)) {
        Some(core) if k.is_multiple_of(2) => {
            let off = core.radius * (1.1 + 0.5 * draw(1)) + radius;
            step(core.center, math::TAU * draw(0), off)
        }
        _ => Stream::new(seed, Purpose::Continents, 2).direction(k as u64),
    };
    Lobe { center, radius }
}

/// The point `angle` rad from `from` in the direction `bearing`.
fn step(from: DVec3, bearing: f64, angle: f64) -> DVec3 {
    let east = math::any_tangent(from);
    let north = from.cross(east);
    let (s, c) = math::sin_cos(bearing);
    let (sin, cos) = math::sin_cos(angle);
    (from * cos + (east * c + north * s) * sin).normalize()
}
