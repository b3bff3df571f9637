//! The paper's own network: rivers that grow from the coasts into the land (paper 002 §4), as a
//! preset.
//!
//! The text gives the idea; constants are those of the authors' program. A mouth is a coast vertex
//! between land and sea with no other mouth beside it. The network grows by rounds: of its tips and
//! its other vertices an eighth (eight at least) takes a step each, lowest crust first. A step goes
//! along the edge of least cost
//!
//! ```text
//! 100 (0.1 + 0.38 ξ + |f · e|) (0.05 + P) (1 - 0.99 smoothstep(-0.2 .. 0.1 km, ΔC))
//! ```
//!
//! which turns away from fold directions and plateaus and wants rising crust, and within about 78°
//! of the way so far. A vertex that is no tip branches with the probability sqrt(l / L), l its way
//! to the mouth and L = 1.6 R, at less than 90°. Growth stops at 0.7 km or half of the crust's
//! elevation, whichever is higher, and at l > L.
//!
//! Departs from the paper: land that no river reaches drains to the nearest river or coast by
//! edges, so that all land has a way to the sea and the rain decides the flow; beds follow from
//! that by the same profile as those of the drainage, but cut through whatever is in their way: the
//! grown network does not follow the relief.

use super::base::BaseMesh;
use super::coast::ShoreClass;
use super::flood::{NO_VERTEX, Routes};
use super::terrain::Terrain;
use crate::math;
use crate::random::{Purpose, Stream, mix};
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use pangaea_shaders::amplify::fixed::GRAINS;
use std::collections::VecDeque;

/// L: longest way of a river in radians (as all constants here, from the authors' program).
const LONGEST_RAD: f64 = 1.6;

/// Most rounds of growth; rivers are shorter than that.
const MAX_ROUNDS: u64 = 2000;

/// Fewest vertices that take a step in a round.
const FEWEST_PER_ROUND: usize = 8;

/// Number of front vertices of which one takes a step in a round.
const FRONT_PER_ROUND: usize = 8;

/// Elevation of the crust in km at which, and above which, a vertex takes its step last.
const LAST_CRUST_KM: f64 = 10.0;

/// Edges from the mouth within which a river does not branch.
const UNBRANCHED_EDGES: u16 = 2;

/// Edges from the mouth within which a river does not end on high ground.
const UNENDED_EDGES: u16 = 3;

/// Elevation of the ground in km at which growth stops, unless half the crust's elevation is
/// higher.
const GROWTH_STOPS_KM: f64 = 0.7;

/// Chance that a vertex that did not branch leaves the front in a round.
const CHANCE_TO_REST: f64 = 0.02;

/// Least cosine between a tip's step and the way so far: 78°.
const TIP_BEND_COSINE: f64 = 0.2;

/// Least cosine between a branch's first step and the way so far: 90°.
const BRANCH_BEND_COSINE: f64 = 0.0;

/// Purpose of a vertex's random number in a round: when it takes its step.
const DRAW_RANK: u64 = 0;

/// Purpose of a vertex's random number in a round: whether it branches.
const DRAW_BRANCH: u64 = 1;

/// Purpose of a vertex's random number in a round: whether it leaves the front.
const DRAW_REST: u64 = 2;

/// Grows the network of the base mesh.
pub(super) fn grow(
    base: &BaseMesh,
    shore: &[ShoreClass],
    ground: &[i32],
    terrain: &Terrain,
) -> Routes {
    let mut growth = Growth {
        mesh: &base.mesh,
        shore,
        terrain,
        stream: Stream::new(base.seed, Purpose::RiverGrowth, 0),
        receiver: vec![NO_VERTEX; base.mesh.len()],
        length: vec![0.0; base.mesh.len()],
        edges: vec![0; base.mesh.len()],
        is_tip: vec![false; base.mesh.len()],
        front: Vec::new(),
    };
    growth.open_mouths(ground);
    for round in 0..MAX_ROUNDS {
        growth.advance(round);
        growth.retire(round);
        if growth.front.is_empty() {
            break;
        }
    }
    growth.finish()
}

struct Growth<'a> {
    mesh: &'a SphereMesh,
    shore: &'a [ShoreClass],
    terrain: &'a Terrain,
    stream: Stream,
    receiver: Vec<u32>,
    /// Way to the mouth in radians.
    length: Vec<f64>,
    /// Edges to the mouth; 0 outside of rivers.
    edges: Vec<u16>,
    is_tip: Vec<bool>,
    /// River vertices that may still grow.
    front: Vec<u32>,
}

impl Growth<'_> {
    fn is_land(&self, i: u32) -> bool {
        self.shore[i as usize] == ShoreClass::Land
    }

    /// Whether vertex `i` is land without a river.
    fn is_free(&self, i: u32) -> bool {
        self.is_land(i) && self.receiver[i as usize] == NO_VERTEX
    }

    fn is_river(&self, i: u32) -> bool {
        self.edges[i as usize] > 0
    }

    /// Elevation of the crust in km.
    fn crust_km(&self, i: u32) -> f64 {
        km(self.terrain.crust[i as usize])
    }

    /// A random share for a vertex, a round and a purpose.
    fn draw(&self, i: u32, round: u64, purpose: u64) -> f64 {
        self.stream.unit(mix(u64::from(i) << 32 | round) ^ purpose)
    }

    /// Opens mouths along the coasts, each with its first vertex on land.
    fn open_mouths(&mut self, ground: &[i32]) {
        // Coasts at a mouth or beside one.
        let mut taken = vec![false; self.mesh.len()];
        for i in 0..self.mesh.len() as u32 {
            let ring = self.mesh.ring(i);
            let is_mouth = self.shore[i as usize] == ShoreClass::Coast
                && ring
                    .iter()
                    .any(|&j| self.shore[j as usize] == ShoreClass::Sea)
                && !ring.iter().any(|&j| taken[j as usize]);
            if !is_mouth {
                continue;
            }
            // The river enters by the lowest way.
            let free = ring.iter().copied().filter(|&j| self.is_free(j));
            if let Some(first) = free.min_by_key(|&j| (ground[j as usize], j)) {
                taken[i as usize] = true;
                for &j in ring {
                    taken[j as usize] |= self.shore[j as usize] == ShoreClass::Coast;
                }
                self.join(first, i);
            }
        }
    }

    /// Makes `i` a river that runs into `to`.
    fn join(&mut self, i: u32, to: u32) {
        let way = (self.mesh.point(i) - self.mesh.point(to)).length();
        self.receiver[i as usize] = to;
        self.length[i as usize] = self.length[to as usize] + way;
        // A coast has 0 edges, so its first vertex on land has 1: rivers are told by that.
        self.edges[i as usize] = self.edges[to as usize] + 1;
        self.is_tip[i as usize] = true;
        self.is_tip[to as usize] = false;
        self.front.push(i);
    }

    /// Lets a part of the front take a step each.
    fn advance(&mut self, round: u64) {
        for i in self.next_to_grow(round) {
            let draw = self.draw(i, round, DRAW_BRANCH);
            if !self.is_tip[i as usize] && !self.branches(i, draw) {
                continue;
            }
            // A tip that cannot go on becomes a spring; it may still branch.
            match self.best_step(i, round) {
                Some(j) => self.join(j, i),
                None => self.is_tip[i as usize] = false,
            }
        }
    }

    /// The part of the front that takes a step: low crust first, with some chance.
    fn next_to_grow(&self, round: u64) -> Vec<u32> {
        let ranks = self.front.iter().map(|&i| (self.rank(i, round), i));
        let mut ranked: Vec<(u64, u32)> = ranks.collect();
        ranked.sort_unstable();
        ranked.truncate(FEWEST_PER_ROUND.max(ranked.len() / FRONT_PER_ROUND));
        ranked.into_iter().map(|(_, i)| i).collect()
    }

    /// How late vertex `i` takes its step, in billionths.
    fn rank(&self, i: u32, round: u64) -> u64 {
        let lowness = (1.0 - self.crust_km(i) / LAST_CRUST_KM).clamp(0.0, 1.0);
        // Whole numbers: they sort without question, and ties go by vertex number.
        ((1.0 - self.draw(i, round, DRAW_RANK) * lowness) * 1e9) as u64
    }

    /// Takes ended rivers out of the front. A vertex that did not branch mostly stays, until its
    /// neighbours are taken.
    fn retire(&mut self, round: u64) {
        let mut front = core::mem::take(&mut self.front);
        front.retain(|&i| {
            !self.has_ended(i)
                && (self.is_tip[i as usize] || self.draw(i, round, DRAW_REST) > CHANCE_TO_REST)
        });
        self.front = front;
    }

    /// Whether the river of vertex `i` is too long, has nowhere to go, or has reached high ground.
    fn has_ended(&self, i: u32) -> bool {
        let k = i as usize;
        let is_walled = !self.mesh.ring(i).iter().any(|&j| self.is_free(j));
        let stops_km = (0.5 * self.crust_km(i)).max(GROWTH_STOPS_KM);
        let is_high = km(self.terrain.ground[k]) > stops_km;
        self.length[k] > LONGEST_RAD || is_walled || (is_high && self.edges[k] > UNENDED_EDGES)
    }

    fn branches(&self, i: u32, draw: f64) -> bool {
        let k = i as usize;
        self.edges[k] > UNBRANCHED_EDGES && draw < (self.length[k] / LONGEST_RAD).sqrt()
    }

    /// The neighbour that the river of vertex `i` grows to.
    fn best_step(&self, i: u32, round: u64) -> Option<u32> {
        let p = self.mesh.point(i);
        let downstream = self.mesh.point(self.receiver[i as usize]);
        let along = (p - downstream).normalize_or_zero();
        // Equal costs go by vertex number, so the order around the ring does not matter.
        let mut best: Option<(f64, u32)> = None;
        for &j in self.mesh.ring(i) {
            let edge = (self.mesh.point(j) - p).normalize_or_zero();
            if !self.may_grow(i, j, edge.dot(along)) {
                continue;
            }
            let cost = self.cost(i, j, edge, round);
            let is_better = best
                .is_none_or(|(least, other)| cost.total_cmp(&least).then(j.cmp(&other)).is_lt());
            if is_better {
                best = Some((cost, j));
            }
        }
        best.map(|(_, j)| j)
    }

    /// Whether the river of vertex `i` may grow to its neighbour `j`, at this cosine from its way
    /// so far: to free land that touches no other river.
    fn may_grow(&self, i: u32, j: u32, cosine: f64) -> bool {
        let least = if self.is_tip[i as usize] {
            TIP_BEND_COSINE
        } else {
            BRANCH_BEND_COSINE
        };
        let own = [i, self.receiver[i as usize]];
        let touches_river = |n: &u32| !own.contains(n) && self.is_river(*n);
        self.is_free(j) && cosine >= least && !self.mesh.ring(j).iter().any(touches_river)
    }

    /// The cost of a step along a unit `edge`; see the header.
    fn cost(&self, i: u32, j: u32, edge: DVec3, round: u64) -> f64 {
        let k = j as usize;
        let chance = self
            .stream
            .unit(mix(u64::from(i) << 32 | u64::from(j)) ^ round);
        // The factor 100 of the header is left out: it changes no order.
        let fold = self.terrain.fold[k].as_dvec3().dot(edge).abs();
        let rise = math::smoothstep((self.crust_km(j) - self.crust_km(i) + 0.2) / 0.3);
        let plateau = 0.05 + f64::from(self.terrain.plateau[k]);
        (0.1 + 0.38 * chance + fold) * plateau * (1.0 - 0.99 * rise)
    }

    /// Lets all other land drain to the nearest river or coast, and puts the land in order.
    fn finish(mut self) -> Routes {
        let all = 0..self.mesh.len() as u32;
        // Rivers first, mouths before springs.
        let mut order: Vec<u32> = all.clone().filter(|&i| self.is_river(i)).collect();
        order.sort_by_key(|&i| (self.edges[i as usize], i));
        let mut sources = order.clone();
        let is_coast = |i: &u32| self.shore[*i as usize] == ShoreClass::Coast;
        sources.extend(all.clone().filter(is_coast));
        if sources.is_empty() {
            // A planet without a sea drains to its first vertex.
            sources.extend(all.clone().find(|&i| self.is_land(i)));
            order.extend(&sources);
        }
        self.drain_to(&sources, &mut order);
        Routes {
            order,
            receiver: self.receiver,
            depressions: Vec::new(),
        }
    }

    /// Lets land that is in no order drain to the nearest source by edges.
    fn drain_to(&mut self, sources: &[u32], order: &mut Vec<u32>) {
        let mut is_known: Vec<bool> = (0..self.mesh.len() as u32)
            .map(|i| self.is_river(i) || !self.is_land(i))
            .collect();
        order.iter().for_each(|&i| is_known[i as usize] = true);
        // Breadth first from all sources at once: land drains over the fewest edges.
        let mut queue: VecDeque<u32> = sources.iter().copied().collect();
        while let Some(i) = queue.pop_front() {
            for &j in self.mesh.ring(i) {
                if !is_known[j as usize] {
                    is_known[j as usize] = true;
                    self.receiver[j as usize] = i;
                    order.push(j);
                    queue.push_back(j);
                }
            }
        }
    }
}

/// A height in grains as km.
fn km(grains: i32) -> f64 {
    f64::from(grains) / f64::from(1000 * GRAINS)
}

#[cfg(test)]
#[path = "growth_tests.rs"]
mod tests;
