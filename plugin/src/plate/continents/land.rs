//! What is land: the level of the field with the wanted share, without specks and puddles.

use super::distance::{Source, nearest};
use crate::math;
use crate::plate::partition::connected_regions;
use crate::sphere::SphereMesh;
use rayon::prelude::*;

/// Fewest samples of an island.
const ISLAND: u32 = 5;

/// Share of the sphere below which an enclosed sea is filled: 300,000 km² on Earth.
const PUDDLE: f64 = 6e-4;

/// Rounds of removing specks; each leaves fewer.
const ROUNDS: usize = 6;

/// The first rounds find the level anew.
const LEVEL_ROUNDS: usize = 3;

/// Land and sea.
pub(super) struct Land {
    /// Whether a sample is land.
    pub(super) mask: Vec<bool>,
    field: Vec<f64>,
    level: f64,
}

/// Chooses the land: where `field` is highest to the given share of the area, or above 0 without
/// one.
pub(super) fn land(mesh: &SphereMesh, field: Vec<f64>, share: Option<f64>) -> Land {
    // Specks and puddles are decided once and for all: their field is put beyond every level.
    let mut ranked = field.clone();
    let mut land = Land {
        mask: Vec::new(),
        field,
        level: 0.0,
    };
    let samples: Vec<u32> = (0..mesh.len() as u32).collect();
    for round in 0..ROUNDS {
        if round < LEVEL_ROUNDS {
            land.level = share.map_or(0.0, |share| level(mesh, &ranked, share));
        }
        land.mask = ranked.iter().map(|&f| f > land.level).collect();
        let labels: Vec<u16> = land.mask.iter().map(|&land| u16::from(land)).collect();
        let regions = connected_regions(mesh, &samples, &labels);
        let mut area = vec![0.0; regions.size.len()];
        (0..mesh.len()).for_each(|i| area[regions.region[i] as usize] += mesh.area(i as u32));
        let small = |region: u32| {
            let region = region as usize;
            let puddle = regions.label[region] == 0 && area[region] < PUDDLE * 4.0 * math::PI;
            puddle || regions.size[region] < ISLAND
        };
        let mut clean = true;
        for i in (0..mesh.len()).filter(|&i| small(regions.region[i])) {
            ranked[i] = if land.mask[i] {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            };
            land.mask[i] = !land.mask[i];
            clean = false;
        }
        if clean {
            break;
        }
    }
    land
}

/// The level above which the field covers `share` of the sphere, to half a sample.
fn level(mesh: &SphereMesh, field: &[f64], share: f64) -> f64 {
    let mut order: Vec<(f64, u32)> = field.iter().copied().zip(0..).collect();
    order.par_sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let wanted = share * 4.0 * math::PI;
    let mut area = 0.0;
    for &(value, i) in &order {
        if area + 0.5 * mesh.area(i) >= wanted {
            return value;
        }
        area += mesh.area(i);
    }
    f64::NEG_INFINITY
}

impl Land {
    /// Area of the land in steradian.
    pub(super) fn area(&self, mesh: &SphereMesh) -> f64 {
        crate::parallel::sum(mesh.len(), |i| {
            if self.mask[i] {
                mesh.area(i as u32)
            } else {
                0.0
            }
        })
    }

    /// Distance of every sample to the nearest coast in rad, infinite where there is none.
    pub(super) fn coast_distance(&self, mesh: &SphereMesh) -> Vec<f64> {
        let mut sources = Vec::new();
        for i in 0..mesh.len() as u32 {
            let over = |j: u32| self.field[j as usize] - self.level;
            for &j in mesh
                .ring(i)
                .iter()
                .filter(|&&j| self.mask[i as usize] != self.mask[j as usize])
            {
                // Where the field crosses its level; half way if a speck or puddle was removed.
                let crossing = over(i) / (over(i) - over(j));
                let share = if crossing > 0.0 && crossing < 1.0 {
                    crossing.clamp(0.15, 0.85)
                } else {
                    0.5
                };
                let point = mesh.point(i).lerp(mesh.point(j), share).normalize();
                sources.push(Source {
                    sample: i,
                    point,
                    slowness: 1.0,
                });
            }
        }
        nearest(mesh, &sources).cost
    }
}

/// The highest sea samples with a total area of `area` steradian, none deeper than `deepest` km,
/// and the few that these enclose.
pub(super) fn shelf(
    mesh: &SphereMesh,
    land: &[bool],
    elevation: &[f32],
    area: f64,
    deepest: f32,
) -> Vec<u32> {
    let z = |i: u32| elevation[i as usize];
    let mut order: Vec<u32> = (0..mesh.len() as u32)
        .filter(|&i| !land[i as usize] && z(i) >= deepest)
        .collect();
    order.par_sort_unstable_by(|&a, &b| z(b).total_cmp(&z(a)).then(a.cmp(&b)));
    let mut covered = 0.0;
    let fits = |&&i: &&u32| {
        covered += mesh.area(i);
        covered <= area
    };
    let shelf: Vec<u32> = order.iter().take_while(fits).copied().collect();
    let mut labels: Vec<u16> = land.iter().map(|&land| u16::from(land)).collect();
    shelf.iter().for_each(|&i| labels[i as usize] = 1);
    let samples: Vec<u32> = (0..mesh.len() as u32).collect();
    let regions = connected_regions(mesh, &samples, &labels);
    let enclosed = |&i: &u32| {
        let region = regions.region[i as usize] as usize;
        regions.label[region] == 0 && regions.size[region] < ISLAND
    };
    let enclosed: Vec<u32> = samples.iter().copied().filter(enclosed).collect();
    [shelf, enclosed].concat()
}
