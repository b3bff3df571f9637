//! Deltas: where a great river meets a shallow shelf, what it brings builds land into the sea.
//!
//! The fan is as wide as the base mesh tells: every vertex of the sea around the mouth becomes its
//! new coast, 50 to 60 km off on an Earth-sized planet (Mississippi 60 km, Nile 160 km, Amazon 150
//! km). From the mouth, now its apex, the river runs on in two to four distributaries, which share
//! its discharge, over the fan or to the old coast beside it.
//!
//! A shelf is shallow where it falls less than 1 in 500 from the mouth. Radii of deltas go by
//! Q^0.4, and so does the depth that a river fills: a river of more than [`SHELF_DISCHARGE`] has a
//! delta on so much steeper shelves. Elsewhere the sea drowns the mouth, an estuary.

use super::coast::ShoreClass;
use super::drainage::Drainage;
use super::profile::MIN_FALL;
use crate::math;
use crate::sphere::SphereMesh;
use core::iter;
use pangaea_shaders::amplify::fixed::GRAINS;
use pangaea_shaders::amplify::seed::{draw, pcg};

/// Least discharge of a river with a delta, m³/s as on an Earth-sized planet.
const LEAST_DISCHARGE: f64 = 500.0;

/// Discharges from which on there is a third distributary, and a fourth; m³/s.
const MORE_ARMS: [f64; 2] = [2_000.0, 10_000.0];

/// Most fall of a shelf under a delta.
const SHELF_FALL: f64 = 1.0 / 500.0;

/// Discharge from which on the fall of the shelf counts less, m³/s.
const SHELF_DISCHARGE: f64 = 5_000.0;

/// Exponent of the radius of a delta over its discharge.
const RADIUS_EXPONENT: f64 = 0.4;

/// A delta.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Delta {
    /// The river's mouth before it had one.
    pub apex: u32,
    /// The new coast.
    pub shore: Vec<u32>,
    /// Vertices of the coast to which distributaries run, with their shares of the discharge, which
    /// sum to 1; the main one first.
    pub arms: Vec<(u32, f64)>,
}

/// The deltas at some mouths of rivers, in the order of their discharge. None touches another.
pub(crate) fn deltas(mesh: &SphereMesh, drainage: &Drainage, mouths: &[u32]) -> Vec<Delta> {
    let mut ranked = mouths.to_vec();
    ranked.sort_unstable_by_key(|&m| (std::cmp::Reverse(drainage.discharge[m as usize]), m));
    ranked.dedup();
    let mut taken = vec![false; mesh.len()];
    for &mouth in &ranked {
        taken[mouth as usize] = true;
    }
    let mut found = Vec::new();
    for mouth in ranked {
        let Some(delta) = delta_at(mesh, drainage, mouth, &taken) else {
            continue;
        };
        let arms = delta.arms.iter().map(|&(arm, _)| arm);
        for s in delta.shore.iter().copied().chain(arms) {
            taken[s as usize] = true;
            for &t in mesh.ring(s) {
                taken[t as usize] = true;
            }
        }
        found.push(delta);
    }
    found
}

/// The delta at a mouth, if it has one and none of its sea is `taken`.
fn delta_at(mesh: &SphereMesh, drainage: &Drainage, mouth: u32, taken: &[bool]) -> Option<Delta> {
    let discharge = drainage.earth_like_discharge(mouth as usize);
    let shore: Vec<u32> = around(mesh, drainage, mouth, ShoreClass::Sea).collect();
    let is_taken = |&s: &u32| taken[s as usize];
    if discharge < LEAST_DISCHARGE || shore.is_empty() || shore.iter().any(is_taken) {
        return None;
    }
    let greatness = (discharge / SHELF_DISCHARGE).max(1.0);
    let most_fall = SHELF_FALL * math::pow(greatness, RADIUS_EXPONENT);
    if !runs_in(mesh, drainage, mouth) || shelf_fall(mesh, drainage, mouth, &shore) > most_fall {
        return None;
    }
    let old_coast = around(mesh, drainage, mouth, ShoreClass::Coast);
    let old_coast = old_coast.filter(|s| !is_taken(s));
    let mut arms = ends_of_arms(mesh, drainage, mouth, &shore, old_coast);
    arms.truncate(2 + MORE_ARMS.iter().filter(|&&least| discharge > least).count());
    (arms.len() > 1).then(|| Delta {
        apex: mouth,
        arms: shares(mouth, &arms),
        shore,
    })
}

/// The vertices of a class around another vertex.
fn around(
    mesh: &SphereMesh,
    drainage: &Drainage,
    vertex: u32,
    class: ShoreClass,
) -> impl Iterator<Item = u32> {
    let ring = mesh.ring(vertex).iter().copied();
    ring.filter(move |&j| drainage.shore[j as usize] == class)
}

/// Where arms of a mouth may end: on its new shore, or on the old coast beside it, with sea before
/// them. In the order of their draw, those of the shore first.
fn ends_of_arms(
    mesh: &SphereMesh,
    drainage: &Drainage,
    mouth: u32,
    shore: &[u32],
    old_coast: impl Iterator<Item = u32>,
) -> Vec<u32> {
    let stays_sea = |j: &u32| drainage.shore[*j as usize] == ShoreClass::Sea && !shore.contains(j);
    let has_sea = |&s: &u32| mesh.ring(s).iter().any(stays_sea);
    let mut ends: Vec<u32> = shore
        .iter()
        .copied()
        .chain(old_coast)
        .filter(has_sea)
        .collect();
    ends.sort_unstable_by_key(|&s| (!shore.contains(&s), pcg(mouth ^ pcg(s))));
    ends
}

/// Whether all rivers that end at a mouth come from so high that their water runs on over a delta.
fn runs_in(mesh: &SphereMesh, drainage: &Drainage, mouth: u32) -> bool {
    let mut ring = mesh.ring(mouth).iter().map(|&j| j as usize);
    ring.all(|j| drainage.routes.receiver[j] != mouth || drainage.profile.level[j] >= MIN_FALL)
}

/// Mean fall of the sea floor from a mouth to the sea around it.
fn shelf_fall(mesh: &SphereMesh, drainage: &Drainage, mouth: u32, shore: &[u32]) -> f64 {
    let falls = shore.iter().map(|&s| {
        let way = math::angle_between(mesh.point(mouth), mesh.point(s)) * drainage.radius * 1000.0;
        -f64::from(drainage.ground[s as usize]) / f64::from(GRAINS) / way
    });
    falls.sum::<f64>() / shore.len() as f64
}

/// The arms of a mouth with their shares of its discharge, by chance: weights of 2 to 3 for the
/// first, of 0.5 to 1.5 for the others.
fn shares(mouth: u32, arms: &[u32]) -> Vec<(u32, f64)> {
    let bases = iter::once(2.0).chain(iter::repeat(0.5));
    let weights: Vec<f64> = bases
        .zip(arms)
        .map(|(base, &arm)| chance(mouth, arm) + base)
        .collect();
    let sum: f64 = weights.iter().sum();
    let share = |weight: f64| weight / sum;
    arms.iter()
        .copied()
        .zip(weights.into_iter().map(share))
        .collect()
}

/// A random number of 0 to 1 for an arm of a mouth.
fn chance(mouth: u32, arm: u32) -> f64 {
    f64::from(draw(pcg(mouth) ^ arm, 1) >> 16) / 65_536.0
}

#[cfg(test)]
#[path = "delta_tests.rs"]
mod tests;
