//! The prevailing winds: easterly trades up to 30°, westerlies up to 65°, polar easterlies (the
//! three cells of a textbook's general circulation, Hartmann 1994, ch. 6).
//!
//! Trades blow towards the equator, the others towards the pole; all belts follow the sun.
//! Directions depend on latitude and season alone, so the point upwind of each vertex is found once
//! per mesh, and so is an order in which nearly every vertex comes after its upwind neighbours: by
//! longitude, eastwards in the westerlies, westwards elsewhere. One sweep in that order carries
//! moisture around the planet.

use super::sweep::{SweepPath, Upwind};
use crate::math;
use crate::math::east_north;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::reflect::Reflect;
use rayon::prelude::*;

/// Latitude in degrees where trades give way to westerlies: the subtropical highs (Hartmann 1994).
const TRADES_END_DEG: f64 = 30.0;

/// Latitude in degrees where westerlies give way to polar easterlies: the polar front.
const WESTERLIES_END_DEG: f64 = 65.0;

/// Latitude in degrees where the poleward wind beyond the trades would end: beyond the pole, so
/// that some of it crosses the polar front and reaches the pole.
const POLEWARD_END_DEG: f64 = 100.0;

/// Strongest poleward (or equatorward) wind, relative to the strongest wind along the parallel:
/// near the ground the trades blow at 2 to 3 m/s and 6 to 7 m/s.
const MERIDIONAL_SHARE: f64 = 0.35;

/// Strongest polar easterly, relative to the trades and westerlies: polar highs are weak.
const POLAR_STRENGTH: f64 = 0.6;

/// How far the belts follow the sun, in degrees: the convergence of the trades wanders between
/// about 8° S and 8° N and beyond.
const SEASONAL_SHIFT_DEG: f64 = 8.0;

/// Square of a wind too weak to have a direction, at a pole; an easterly stands in for it.
const CALM_SQUARED: f64 = 1e-12;

/// Winds of one season on a mesh.
#[derive(Clone, Debug, PartialEq, Reflect)]
pub struct WindBelts {
    /// Degrees by which all belts lie farther north than in the mean.
    pub shift: f64,
    /// Distance of every vertex from the belts' middle in degrees.
    pub latitude: Vec<f32>,
    /// The point upwind of every vertex.
    pub upwind: Vec<Upwind>,
    /// The vertices, each after those upwind of it wherever that can be.
    pub order: Vec<u32>,
    /// The mesh in that order.
    pub path: SweepPath,
}

/// Winds on a mesh in the northern and in the southern summer.
#[derive(Clone, Debug, PartialEq, Reflect)]
pub struct Winds {
    /// The belts in both seasons.
    pub seasons: [WindBelts; 2],
}

/// Eastward and northward part of the wind at a latitude in degrees from the belts' middle; its
/// strength is 1 in the middle of the trades and westerlies.
fn wind(latitude: f64) -> (f64, f64) {
    let a = latitude.abs();
    let poleward = if a < TRADES_END_DEG {
        -MERIDIONAL_SHARE * half_wave(a, 0.0, TRADES_END_DEG)
    } else {
        // Eddies carry moisture poleward across the polar front.
        MERIDIONAL_SHARE * half_wave(a, TRADES_END_DEG, POLEWARD_END_DEG)
    };
    let north = if latitude < 0.0 { -poleward } else { poleward };
    (eastward(a), north)
}

/// Eastward part of the wind at a distance from the belts' middle in degrees.
fn eastward(beyond: f64) -> f64 {
    if beyond < TRADES_END_DEG {
        // The meridional part is strongest half way, but at the equator there still is an easterly.
        -math::cos(0.5 * math::PI * beyond / TRADES_END_DEG)
    } else if beyond < WESTERLIES_END_DEG {
        half_wave(beyond, TRADES_END_DEG, WESTERLIES_END_DEG)
    } else {
        -POLAR_STRENGTH * half_wave(beyond, WESTERLIES_END_DEG, 90.0)
    }
}

/// Half a sine wave from 0 at `from` over 1 to 0 at `to`.
fn half_wave(x: f64, from: f64, to: f64) -> f64 {
    math::sin(math::PI * (x - from) / (to - from))
}

impl Winds {
    /// The winds on `mesh`.
    ///
    /// ```
    /// use bevy_pangaea::climate::Winds;
    /// use bevy_pangaea::sphere::SphereMesh;
    ///
    /// let winds = Winds::new(&SphereMesh::fibonacci(1000)?);
    /// let [northern_summer, southern_summer] = winds.seasons;
    /// assert_eq!(northern_summer.shift, -southern_summer.shift);
    /// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
    /// ```
    pub fn new(mesh: &SphereMesh) -> Self {
        let places = parallel::map(mesh.len(), |i| math::lat_lon(mesh.point(i)));
        let shifts = [SEASONAL_SHIFT_DEG, -SEASONAL_SHIFT_DEG];
        Self {
            seasons: shifts.map(|shift| WindBelts::new(mesh, &places, shift)),
        }
    }
}

impl WindBelts {
    /// The winds on a mesh whose vertices have these latitudes and longitudes.
    fn new(mesh: &SphereMesh, places: &[(f64, f64)], shift: f64) -> Self {
        let n = mesh.len();
        let winds = parallel::map(n, |i| wind(places[i as usize].0 - shift));
        let upwind = parallel::map(n, |i| upwind(mesh, i, winds[i as usize]));
        let order = sweep_order(places, &winds);
        Self {
            shift,
            latitude: parallel::map(n, |i| (places[i as usize].0 - shift).abs() as f32),
            path: SweepPath::new(mesh, &order, &upwind),
            upwind,
            order,
        }
    }
}

/// The vertices by longitude, in the direction in which the wind blows at each.
fn sweep_order(places: &[(f64, f64)], winds: &[(f64, f64)]) -> Vec<u32> {
    // The way along the parallel in the upper half of a number, the vertex in the lower: numbers
    // sort fast, and ties go by vertex.
    let mut keys: Vec<u64> = parallel::map(places.len(), |i| {
        let (_, lon) = places[i as usize];
        let blows_east = winds[i as usize].0 >= 0.0;
        let along = if blows_east { lon } else { -lon };
        let turn = (along + 180.0) / 360.0;
        ((turn * f64::from(u32::MAX)) as u64) << 32 | u64::from(i)
    });
    keys.par_sort_unstable();
    keys.into_iter().map(|key| key as u32).collect()
}

/// The edge opposite to vertex `i` that the wind, `u` eastward and `v` northward, comes across.
fn upwind(mesh: &SphereMesh, i: u32, (u, v): (f64, f64)) -> Upwind {
    let p = mesh.point(i);
    let (east, north) = east_north(p);
    let to = if u * u + v * v > CALM_SQUARED {
        east * u + north * v
    } else {
        east
    };
    // Seen from the vertex, the air comes from there.
    let against = -to.normalize();
    crossed_edge(mesh, i, against).unwrap_or_else(|| most_upwind_neighbour(mesh, i, against))
}

/// Where the ray from vertex `i` along the unit tangent `against` leaves its ring.
fn crossed_edge(mesh: &SphereMesh, i: u32, against: DVec3) -> Option<Upwind> {
    let p = mesh.point(i);
    let across = p.cross(against);
    let ring = mesh.ring(i);
    // Edge after edge around the vertex, which sees the ray leave through exactly one of them.
    let mut previous = ring[ring.len() - 1];
    for &j in ring {
        let (a, b) = (mesh.point(previous) - p, mesh.point(j) - p);
        let (left_a, left_b) = (a.dot(across), b.dot(across));
        // The ring runs counter-clockwise: the ray is crossed from its right to its left.
        if left_a <= 0.0 && left_b > 0.0 {
            let weight = left_a / (left_a - left_b);
            let ahead = a.dot(against);
            let distance = ahead + (b.dot(against) - ahead) * weight;
            if distance > 0.0 {
                return Some(Upwind {
                    from: [previous, j],
                    weight: weight as f32,
                    distance: distance as f32,
                });
            }
        }
        previous = j;
    }
    None
}

/// The neighbour whose direction is nearest to `against`: for rings that no ray crosses.
fn most_upwind_neighbour(mesh: &SphereMesh, i: u32, against: DVec3) -> Upwind {
    let p = mesh.point(i);
    let cosine = |j: u32| (mesh.point(j) - p).normalize_or(DVec3::ZERO).dot(against);
    let ring = mesh.ring(i).iter().copied();
    let j = ring
        .max_by(|&a, &b| cosine(a).total_cmp(&cosine(b)))
        .unwrap_or(i);
    Upwind {
        from: [j, j],
        weight: 0.0,
        distance: (mesh.point(j) - p).length() as f32,
    }
}

#[cfg(test)]
#[path = "wind_tests.rs"]
mod tests;
