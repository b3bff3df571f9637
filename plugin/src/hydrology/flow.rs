//! Discharge: the runoff of all that lies upstream, in whole cubic metres per year, so that not a
//! unit is lost.

use super::flood::{NO_VERTEX, Routes};
use crate::climate::{Climate, EARTH_RADIUS};
use crate::sphere::SphereMesh;
use crate::{math, parallel};

/// Seconds in a Julian year of 365.25 days.
const SECONDS_PER_YEAR: f64 = 31_557_600.0;

/// Discharge in m³/s of a number of m³ per year.
pub(super) fn per_second(discharge: u64) -> f64 {
    discharge as f64 / SECONDS_PER_YEAR
}

/// Discharge in m³/s of the same rain on an Earth-sized planet: laws of rivers go by that, so that
/// small planets have rivers, too.
pub(super) fn earth_like(discharge: u64, radius: f64) -> f64 {
    let scale = EARTH_RADIUS / radius;
    per_second(discharge) * scale * scale
}

/// Water in m³ per year that a depth in mm per year makes on the cell of every vertex.
pub(super) fn volumes(mesh: &SphereMesh, radius: f64, depth: &[f32]) -> Vec<i64> {
    // A millimetre on a square kilometre is 1000 m³.
    let unit = 1000.0 * radius * radius;
    parallel::map(mesh.len(), |i| {
        let depth = depth.get(i as usize).copied().unwrap_or(0.0);
        math::nearest(f64::from(depth) * mesh.area(i) * unit)
    })
}

/// Runoff of every vertex on land, in m³ per year; 0 elsewhere.
pub(super) fn supply(
    mesh: &SphereMesh,
    radius: f64,
    climate: &Climate,
    routes: &Routes,
) -> Vec<u64> {
    let all = volumes(mesh, radius, &climate.runoff);
    // Coasts and sea are not in the order: their rain is of no river.
    let mut supply = vec![0; mesh.len()];
    for &i in &routes.order {
        supply[i as usize] = all[i as usize].max(0) as u64;
    }
    supply
}

/// Discharge of every vertex: its own supply and all from upstream. Coasts hold what reaches them.
pub(super) fn accumulate(routes: &Routes, supply: &[u64]) -> Vec<u64> {
    let mut discharge = supply.to_vec();
    // Upstream first: a vertex has all its water before it passes it on.
    for &i in routes.order.iter().rev() {
        let to = routes.receiver[i as usize];
        if to != NO_VERTEX {
            discharge[to as usize] += discharge[i as usize];
        }
    }
    discharge
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn not_a_unit_is_lost_at_confluences() {
        // 1 and 2 meet in 3, which with 4 runs to the coast 0; 5 is a sink.
        let routes = Routes {
            order: vec![3, 4, 1, 2, 5],
            receiver: vec![NO_VERTEX, 3, 3, 0, 0, NO_VERTEX],
            depressions: vec![],
        };
        let supply = [0, 7, 11, 13, 17, 19];
        assert_eq!(accumulate(&routes, &supply), [48, 7, 11, 31, 17, 19]);
    }

    #[test]
    fn rivers_of_small_planets_count_as_those_of_large_ones() {
        let mesh = SphereMesh::fibonacci(1000).unwrap();
        let [earth, small] = [6370.0, 200.0].map(|radius| {
            let half_a_metre: i64 = volumes(&mesh, radius, &[500.0; 1000]).iter().sum();
            earth_like(half_a_metre as u64, radius)
        });
        assert!((earth / small - 1.0).abs() < 1e-3);
        // 4πr² times half a metre.
        assert!((earth - 0.5 * 5.099e14 / SECONDS_PER_YEAR).abs() < 1e4);
    }
}
