//! Land: the level of the field with the wanted share, without specks and ponds.

use crate::math;
use crate::parallel;
use crate::plate::partition::connected_regions;
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::{TravelSource, least_travel_times};
use bevy::math::DVec3;
use rayon::prelude::*;

/// Fewest samples of an island or of a sea.
const LEAST_SAMPLES: u32 = 5;

/// Share of the sphere below which an enclosed sea is filled: 300,000 km² on Earth, somewhat less
/// than the Caspian Sea.
const LEAST_SEA_SHARE: f64 = 6e-4;

/// Rounds of removing specks; each leaves fewer.
const ROUNDS: usize = 6;

/// The first rounds find the level anew, as what they remove is land that is missing elsewhere.
const LEVEL_ROUNDS: usize = 3;

/// Least and greatest share of an edge at which the coast may cross it. On the coast itself, at
/// distance 0, a sample would have neither the heights of land nor those of the sea.
const CROSSING_RANGE: [f64; 2] = [0.15, 0.85];

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
    // Specks and ponds are decided once and for all: their field is put beyond every level.
    let mut ranked = field.clone();
    let mut land = Land {
        mask: Vec::new(),
        field,
        level: 0.0,
    };
    for round in 0..ROUNDS {
        if round < LEVEL_ROUNDS {
            land.level = share.map_or(0.0, |share| level(mesh, &ranked, share));
        }
        land.mask = ranked.iter().map(|&f| f > land.level).collect();
        // Only samples of specks change sides, so what is removed cannot come back.
        let specks = specks(mesh, &land.mask);
        for &i in &specks {
            ranked[i] = if land.mask[i] {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            };
            land.mask[i] = !land.mask[i];
        }
        if specks.is_empty() {
            break;
        }
    }
    land
}

/// The samples of islands and seas that are too small.
fn specks(mesh: &SphereMesh, mask: &[bool]) -> Vec<usize> {
    let samples: Vec<u32> = (0..mesh.len() as u32).collect();
    let labels: Vec<u16> = mask.iter().map(|&land| u16::from(land)).collect();
    let regions = connected_regions(mesh, &samples, &labels);
    let mut area = vec![0.0; regions.size.len()];
    for (&region, sample_area) in regions.region.iter().zip(mesh.areas()) {
        area[region as usize] += sample_area;
    }
    let is_sea = |region: usize| regions.label[region] == 0;
    let is_pond = |region| is_sea(region) && area[region] < LEAST_SEA_SHARE * 4.0 * math::PI;
    let is_small = |region| is_pond(region) || regions.size[region] < LEAST_SAMPLES;
    let small = (0..mesh.len()).filter(|&i| is_small(regions.region[i] as usize));
    small.collect()
}

/// The level above which the field covers `share` of the sphere, to half a sample.
fn level(mesh: &SphereMesh, field: &[f64], share: f64) -> f64 {
    // The index breaks ties, so the order is the same on any number of threads.
    let mut order: Vec<(f64, u32)> = field.iter().copied().zip(0..).collect();
    order.par_sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let wanted = share * 4.0 * math::PI;
    let mut area = 0.0;
    for &(value, i) in &order {
        // The sample whose middle the wanted area reaches is the last on its side.
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
        let area = |i: usize| if self.mask[i] { mesh.areas()[i] } else { 0.0 };
        parallel::sum(mesh.len(), area)
    }

    /// Distance of every sample to the nearest coast in rad; infinite on a planet without coasts.
    pub(super) fn coast_distance(&self, mesh: &SphereMesh) -> Vec<f64> {
        let mut coast = Vec::new();
        for i in 0..mesh.len() as u32 {
            let is_land = |j: u32| self.mask[j as usize];
            for &j in mesh.ring(i).iter().filter(|&&j| is_land(i) != is_land(j)) {
                coast.push(TravelSource {
                    sample: i,
                    point: self.crossing(mesh, i, j),
                    slowness: 1.0,
                });
            }
        }
        least_travel_times(mesh, &coast).time
    }

    /// Where the coast crosses the edge from sample `i` to sample `j`: where the field crosses its
    /// level, or half way if a speck or pond was removed.
    fn crossing(&self, mesh: &SphereMesh, i: u32, j: u32) -> DVec3 {
        let above = |j: u32| self.field[j as usize] - self.level;
        let crossing = above(i) / (above(i) - above(j));
        let share = if crossing > 0.0 && crossing < 1.0 {
            let [least, most] = CROSSING_RANGE;
            crossing.clamp(least, most)
        } else {
            0.5
        };
        mesh.point(i).lerp(mesh.point(j), share).normalize()
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
    let is_shallow = |&i: &u32| !land[i as usize] && z(i) >= deepest;
    let mut order: Vec<u32> = (0..mesh.len() as u32).filter(is_shallow).collect();
    order.par_sort_unstable_by(|&a, &b| z(b).total_cmp(&z(a)).then(a.cmp(&b)));
    let mut continental = land.to_vec();
    let mut shelf = Vec::new();
    let mut covered = 0.0;
    for i in order {
        covered += mesh.area(i);
        if covered > area {
            break;
        }
        continental[i as usize] = true;
        shelf.push(i);
    }
    shelf.extend(enclosed(mesh, &continental));
    shelf
}

/// The samples of oceanic regions of fewer than [`LEAST_SAMPLES`] samples.
fn enclosed(mesh: &SphereMesh, continental: &[bool]) -> Vec<u32> {
    let samples: Vec<u32> = (0..mesh.len() as u32).collect();
    let labels: Vec<u16> = continental.iter().map(|&is| u16::from(is)).collect();
    let regions = connected_regions(mesh, &samples, &labels);
    let is_sea = |region: usize| regions.label[region] == 0;
    let is_small = |region: usize| regions.size[region] < LEAST_SAMPLES;
    let is_enclosed = |region: u32| is_sea(region as usize) && is_small(region as usize);
    let samples = samples.into_iter();
    samples
        .filter(|&i| is_enclosed(regions.region[i as usize]))
        .collect()
}
