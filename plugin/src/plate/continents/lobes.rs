//! Which plates carry continents, and the discs that make their rough shapes.
//!
//! As on Earth a few continents hold most of the land and lie on large plates, off their centres,
//! so that one coast is near a border and the other is not. Each is a core with side lobes along an
//! axis; small blocks, some of them off a large coast, make islands.

use crate::math;
use crate::planet::PlanetRecipe;
use crate::plate::partition::{Site, cap_radius, first_or_best};
use crate::random::{Purpose, Stream};
use bevy::math::DVec3;

/// Share of the land that large continents take; islands take the rest.
const CONTINENT_SHARE: f64 = 0.94;

/// Number of small blocks.
const BLOCKS: usize = 14;

/// Plates that may carry a large continent, the largest ones.
const HOSTS: usize = 12;

/// Positions tried for a continent.
const TRIES: u64 = 40;

/// A disc of continental crust.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lobe {
    /// Unit direction of the centre.
    pub(super) center: DVec3,
    /// Angular radius in rad.
    pub(super) radius: f64,
}

/// The rough shapes of a planet's continents.
#[derive(Clone, Debug, Default)]
pub(in crate::plate) struct Continents {
    pub(super) lobes: Vec<Lobe>,
}

impl Continents {
    /// The discs of the recipe, or random continents on some of `sites`; none for a planet without
    /// land.
    pub(in crate::plate) fn new(recipe: &PlanetRecipe, sites: &[Site]) -> Self {
        if !recipe.continents.is_empty() {
            let lobe = |disc: &crate::planet::DiscRecipe| Lobe {
                center: disc.direction(),
                radius: (disc.radius / recipe.radius).min(math::PI),
            };
            return Self {
                lobes: recipe.continents.iter().map(lobe).collect(),
            };
        }
        if recipe.land <= 0.0 {
            return Self::default();
        }
        let cores = cores(recipe, sites);
        let mut lobes: Vec<Lobe> = Vec::new();
        for (k, core) in cores.iter().enumerate() {
            lobes.extend(shape(
                core,
                &Stream::new(recipe.seed, Purpose::Continents, 10 + k as u64),
            ));
        }
        lobes.extend(blocks(recipe, &cores));
        Self { lobes }
    }

    /// Rough share of continental crust on the plate at `site`, 0..1.
    pub(in crate::plate) fn cover(&self, site: &Site) -> f64 {
        let depth = |lobe: &Lobe| lobe.radius - math::angle_between(lobe.center, site.centroid);
        let deepest = self.lobes.iter().map(depth).fold(-math::PI, f64::max);
        math::smoothstep(0.5 + deepest / (2.0 * site.radius))
    }
}

/// One disc for each large continent, the largest first.
fn cores(recipe: &PlanetRecipe, sites: &[Site]) -> Vec<Lobe> {
    let stream = Stream::new(recipe.seed, Purpose::Continents, 0);
    let count = 4 + stream.bits(0) % 4;
    let weight = |k: u64| stream.range(1 + k, 0.7, 1.3) / (k as f64 + 1.5);
    let total: f64 = (0..count).map(weight).sum();
    let mut hosts: Vec<usize> = (0..sites.len()).collect();
    hosts.sort_by(|&a, &b| sites[b].radius.total_cmp(&sites[a].radius).then(a.cmp(&b)));
    hosts.truncate(HOSTS);
    let mut used = vec![false; sites.len()];
    let mut cores: Vec<Lobe> = Vec::new();
    for k in 0..count {
        let radius = cap_radius(CONTINENT_SHARE * recipe.land * weight(k) / total);
        let draw = Stream::new(recipe.seed, Purpose::Continents, 100 + k);
        let tries = (0..TRIES).map(|t| {
            let host = hosts[(draw.bits(3 * t) % hosts.len() as u64) as usize];
            let off = sites[host].radius * draw.range(3 * t + 1, 0.0, 0.5);
            (
                host,
                step(
                    sites[host].centroid,
                    draw.range(3 * t + 2, 0.0, math::TAU),
                    off,
                ),
            )
        });
        let score = |(host, center): (usize, DVec3)| {
            let room =
                |c: &Lobe| math::angle_between(center, c.center) - 1.05 * (radius + c.radius);
            let room = cores.iter().map(room).fold(0.5, f64::min);
            // A plate that carries a continent already, or is too small for this one, is second
            // choice.
            room - if used[host] { 0.3 } else { 0.0 }
                - 2.0 * (radius - 0.85 * sites[host].radius).max(0.0)
        };
        if let Some((host, center)) = first_or_best(tries, score, 0.0) {
            used[host] = true;
            cores.push(Lobe { center, radius });
        }
    }
    cores
}

/// The lobes of one continent of about the area of the disc `core`.
fn shape(core: &Lobe, stream: &Stream) -> Vec<Lobe> {
    let axis = stream.range(0, 0.0, math::TAU);
    let sides = 3 + stream.bits(1) % 3;
    let mut lobes = vec![Lobe {
        center: core.center,
        radius: 0.6 * core.radius,
    }];
    for k in 0..sides {
        let draw = |j: u64, low, high| stream.range(10 * (k + 1) + j, low, high);
        // Two lobes lie along the axis, the others anywhere.
        let bearing = if k < 2 {
            axis + math::PI * k as f64 + draw(0, -0.5, 0.5)
        } else {
            draw(0, 0.0, math::TAU)
        };
        let radius = core.radius
            * if k < 2 {
                draw(1, 0.4, 0.65)
            } else {
                draw(1, 0.25, 0.5)
            };
        let off = core.radius
            * if k < 2 {
                draw(2, 0.7, 1.1)
            } else {
                draw(2, 0.6, 0.9)
            };
        lobes.push(Lobe {
            center: step(core.center, bearing, off),
            radius,
        });
    }
    lobes
}

/// Small blocks: every second one off the coast of a large continent, the others anywhere.
fn blocks(recipe: &PlanetRecipe, cores: &[Lobe]) -> Vec<Lobe> {
    let stream = Stream::new(recipe.seed, Purpose::Continents, 1);
    let weight = |k: usize| 1.0 / (k as f64 + 2.0);
    let total: f64 = (0..BLOCKS).map(weight).sum();
    let block = |k: usize| {
        let radius = cap_radius((1.0 - CONTINENT_SHARE) * recipe.land * weight(k) / total);
        let draw = |j: usize| stream.unit((4 * k + j) as u64);
        let center = match cores.get(k / 2 % cores.len().max(1)) {
            Some(core) if k.is_multiple_of(2) => step(
                core.center,
                math::TAU * draw(0),
                core.radius * (1.1 + 0.5 * draw(1)) + radius,
            ),
            _ => Stream::new(recipe.seed, Purpose::Continents, 2).direction(k as u64),
        };
        Lobe { center, radius }
    };
    (0..BLOCKS).map(block).collect()
}

/// The point `angle` rad from `from` in the direction `bearing`.
fn step(from: DVec3, bearing: f64, angle: f64) -> DVec3 {
    let east = math::any_tangent(from);
    let north = from.cross(east);
    let (s, c) = math::sin_cos(bearing);
    let (sin, cos) = math::sin_cos(angle);
    (from * cos + (east * c + north * s) * sin).normalize()
}
