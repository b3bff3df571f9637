//! Basins without an outlet: a depression whose water evaporates before it is full stays closed.
//!
//! The outlet of a depression is worn down by the river that leaves it, at most by [`incision`]. If
//! what flows in is less than what the lake behind the worn outlet would lose to the air beyond
//! what its ground would have given to the river, no river leaves: the lake shrinks to where inflow
//! and loss balance. Its bottom becomes a sink, and the depression drains there. Upstream
//! depressions are decided first: a closed one passes nothing on.

use super::flood::{Depression, NO_VERTEX, Routes};
use super::flow::earth_like;
use crate::sphere::SphereMesh;
use core::cmp::Reverse;
use pangaea_shaders::amplify::fixed::GRAINS;
use std::collections::BinaryHeap;

/// A lake without an outlet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ClosedLake {
    /// Vertices under water; the first is the sink.
    pub vertices: Vec<u32>,
    /// Level in grains.
    pub level: i32,
}

/// Incision of a sill by any river, m: depressions of the crust are not exact to less.
const LEAST_INCISION_M: f64 = 40.0;

/// Incision in m per root of the discharge in m³/s: at 40,000 m³/s it makes 840 m, the depth of the
/// gorges of the great rivers that cross mountains.
const INCISION_PER_ROOT_M3S: f64 = 4.0;

/// Deepest incision in grains, 3.9 km: deeper than any gorge, and far from the limits of an i32.
const DEEPEST_INCISION: f64 = 4e6;

/// Deepest water over the last vertex that a closed lake covers, grains: 20 m. Closed lakes are
/// shallow at their shores.
const DEEPEST_SHORE: i32 = 20 * GRAINS;

/// The number that stands for no depression.
const NO_DEPRESSION: u32 = u32::MAX;

/// How far a river has worn down a sill, in grains: 40 m and 4 m times the root of its discharge in
/// m³/s (as on an Earth-sized planet), the root of the law of stream power.
pub(super) fn incision(discharge: f64) -> i32 {
    let metres = LEAST_INCISION_M + INCISION_PER_ROOT_M3S * discharge.max(0.0).sqrt();
    (metres * f64::from(GRAINS)).min(DEEPEST_INCISION) as i32
}

/// Supply and demand of water, per vertex of the base mesh.
pub(super) struct WaterBalance<'a> {
    pub mesh: &'a SphereMesh,
    /// Radius of the planet in km.
    pub radius: f64,
    /// Ground in grains.
    pub ground: &'a [i32],
    /// Runoff in m³ per year.
    pub supply: &'a [u64],
    /// Evaporation under water beyond the rain, in m³ per year.
    pub loss: &'a [i64],
}

/// Finds closed basins and lets them drain to their sinks.
///
/// The sweep goes upstream first and adds up discharges. Vertices of a depression are contiguous in
/// the order, so when the sweep reaches the first of them all water that flows into the depression
/// is known, and whether it spills is decided before anything downstream is looked at.
pub(super) fn close_basins(balance: &WaterBalance, routes: &mut Routes) -> Vec<ClosedLake> {
    let depression_of = depressions_by_vertex(routes, balance.mesh.len());
    let mut sweep = UpstreamSweep {
        discharge: balance.supply.to_vec(),
        spills: Vec::new(),
        closed: Vec::new(),
    };
    for k in (0..routes.order.len()).rev() {
        let i = routes.order[k];
        let to = routes.receiver[i as usize];
        let d = depression_of[i as usize];
        // The sink of a planet without a sea leaves, too: to nowhere.
        let leaves = to == NO_VERTEX || depression_of[to as usize] != d;
        // Inside its depression water runs on to the saddle; what would cross it is held back.
        if d != NO_DEPRESSION && leaves {
            sweep.hold_back(i, to);
        } else {
            let amount = sweep.discharge[i as usize];
            sweep.pass_on(to, amount);
        }
        // Only the first vertex of a depression, the last to be swept, decides its fate. Turning it
        // around permutes its part of the order, which the sweep has passed.
        if d != NO_DEPRESSION && k <= routes.depressions[d as usize].range.start {
            sweep.decide(balance, routes, d as usize);
        }
    }
    // Found upstream first; profiles number lakes downstream first.
    sweep.closed.reverse();
    sweep.closed
}

/// A sweep upstream first.
struct UpstreamSweep {
    /// Water in m³ per year that has reached each vertex.
    discharge: Vec<u64>,
    /// Receivers outside of the present depression, and the m³ per year that they would get.
    spills: Vec<(u32, u64)>,
    closed: Vec<ClosedLake>,
}

impl UpstreamSweep {
    fn pass_on(&mut self, to: u32, amount: u64) {
        if to != NO_VERTEX {
            self.discharge[to as usize] += amount;
        }
    }

    /// Keeps the water of vertex `i` until it is known whether its depression spills.
    fn hold_back(&mut self, i: u32, to: u32) {
        self.spills.push((to, self.discharge[i as usize]));
    }

    /// Closes depression `d`, or lets it spill.
    fn decide(&mut self, balance: &WaterBalance, routes: &mut Routes, d: usize) {
        let depression = routes.depressions[d].clone();
        let spills = core::mem::take(&mut self.spills);
        let inflow = spills.iter().map(|(_, amount)| amount).sum();
        if balance.dries_up(&depression, routes, inflow) {
            // Its water stays: the vertices downstream never hear of it.
            let lake = balance.reroute(&depression, routes, inflow);
            self.closed.push(lake);
            return;
        }
        for (to, amount) in spills {
            self.pass_on(to, amount);
        }
    }
}

/// The depression of every vertex, by number.
fn depressions_by_vertex(routes: &Routes, vertices: usize) -> Vec<u32> {
    let mut depression_of = vec![NO_DEPRESSION; vertices];
    for (d, depression) in (0..).zip(&routes.depressions) {
        for &i in &routes.order[depression.range.clone()] {
            depression_of[i as usize] = d;
        }
    }
    depression_of
}

impl WaterBalance<'_> {
    /// Water in m³ per year that a lake over vertex `i` costs: the evaporation beyond the rain, and
    /// the runoff that its ground no longer gives.
    fn cost(&self, i: u32) -> i64 {
        self.loss[i as usize] + self.supply[i as usize] as i64
    }

    /// Whether the lake behind the worn outlet would lose more than flows in.
    fn dries_up(&self, depression: &Depression, routes: &Routes, inflow: u64) -> bool {
        // A river of all the inflow would wear the outlet down: the lake would fill only so far.
        let worn = incision(earth_like(inflow, self.radius));
        let outlet = depression.spill_elevation.saturating_sub(worn);
        let members = &routes.order[depression.range.clone()];
        let lake = members
            .iter()
            .filter(|&&i| self.ground[i as usize] < outlet);
        lake.map(|&i| self.cost(i)).sum::<i64>() > inflow as i64
    }

    /// Turns the depression around: its vertices drain to the lowest one.
    fn reroute(&self, depression: &Depression, routes: &mut Routes, inflow: u64) -> ClosedLake {
        let members = &mut routes.order[depression.range.clone()];
        let rising = self.fill(members, &mut routes.receiver);
        for (member, &(_, i)) in members.iter_mut().zip(&rising) {
            *member = i;
        }
        self.closed_lake(&rising, depression.spill_elevation, inflow)
    }

    /// The vertices of a depression as water rising from its lowest vertex covers them, each with
    /// the level at which it does; receivers lead back down to that vertex.
    fn fill(&self, members: &[u32], receiver: &mut [u32]) -> Vec<(i32, u32)> {
        let mut unreached = Unreached::new(members);
        // By the level of the water; what one level covers from the bottom up.
        let entry = |level: i32, i: u32| Reverse((level, self.ground[i as usize], i));
        let mut heap = BinaryHeap::new();
        let lowest = members
            .iter()
            .min_by_key(|&&i| (self.ground[i as usize], i));
        if let Some(&sink) = lowest {
            receiver[sink as usize] = NO_VERTEX;
            unreached.take(sink);
            heap.push(entry(self.ground[sink as usize], sink));
        }
        let mut rising = Vec::with_capacity(members.len());
        while let Some(Reverse((level, _, i))) = heap.pop() {
            rising.push((level, i));
            for &j in self.mesh.ring(i) {
                if unreached.take(j) {
                    receiver[j as usize] = i;
                    // Water stands level: behind a sill it is as high as the sill.
                    heap.push(entry(self.ground[j as usize].max(level), j));
                }
            }
        }
        rising
    }

    /// The lake that rises over as many of the vertices as it can while it loses no more than flows
    /// in; it covers the lowest at least.
    fn closed_lake(&self, rising: &[(i32, u32)], spill_elevation: i32, inflow: u64) -> ClosedLake {
        let mut vertices = Vec::new();
        let mut spent = 0;
        let mut top = i32::MIN;
        let mut shore = spill_elevation;
        for &(level, i) in rising {
            let cost = self.cost(i);
            if !vertices.is_empty() && spent + cost > inflow as i64 {
                shore = level;
                break;
            }
            // The lowest vertex is a lake even where its water would dry up: water ends there.
            spent += cost;
            top = level;
            vertices.push(i);
        }
        // Half way to the next higher ground, but shallow over the last vertex that is covered, and
        // not dry.
        let depth = ((shore.max(top) - top) / 2).min(DEEPEST_SHORE);
        ClosedLake {
            vertices,
            level: (top + depth).max(top + 1),
        }
    }
}

/// The vertices of a depression that rising water has not reached.
struct Unreached {
    /// All of them, sorted.
    members: Vec<u32>,
    is_reached: Vec<bool>,
}

impl Unreached {
    fn new(members: &[u32]) -> Self {
        let mut members = members.to_vec();
        members.sort_unstable();
        Self {
            is_reached: vec![false; members.len()],
            members,
        }
    }

    /// Takes a vertex out. False if it is outside of the depression, or was reached before.
    fn take(&mut self, i: u32) -> bool {
        match self.members.binary_search(&i) {
            Ok(place) => !core::mem::replace(&mut self.is_reached[place], true),
            Err(_) => false,
        }
    }
}

#[cfg(test)]
#[path = "sinks_tests.rs"]
mod tests;
