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
//! Departs from the paper: what no river reaches drains to the nearest river or coast by edges, so
//! that all land has a way to the sea and the rain decides the flow; beds follow from that by the
//! same profile as those of the drainage, but cut through whatever is in their way: the grown
//! network does not follow the relief.

use super::base::BaseMesh;
use super::coast::Site;
use super::flood::{NONE, Routes};
use super::terrain::Terrain;
use crate::math;
use crate::random::{Purpose, Stream};
use crate::sphere::SphereMesh;

/// How the network of rivers is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RiverNetwork {
    /// Water runs down the relief.
    #[default]
    Drainage,
    /// Rivers grow from the coasts, as in paper 002.
    Grown,
}

/// L: longest way of a river in radians.
const LONGEST: f64 = 1.6;

/// Most rounds of growth; rivers are shorter than that.
const ROUNDS: u64 = 2000;

/// Grains in a km.
const KM: f64 = 1_024_000.0;

/// Grows the network of the base mesh.
pub(super) fn grow(base: &BaseMesh, sites: &[Site], ground: &[i32], terrain: &Terrain) -> Routes {
    let mut growth = Growth {
        mesh: &base.mesh,
        sites,
        terrain,
        stream: Stream::new(base.seed, Purpose::RiverGrowth, 0),
        receiver: vec![NONE; base.mesh.len()],
        length: vec![0.0; base.mesh.len()],
        steps: vec![0; base.mesh.len()],
        is_tip: vec![false; base.mesh.len()],
        front: Vec::new(),
    };
    growth.open_mouths(ground);
    for round in 0..ROUNDS {
        if !growth.round(round) {
            break;
        }
    }
    growth.finish()
}

struct Growth<'a> {
    mesh: &'a SphereMesh,
    sites: &'a [Site],
    terrain: &'a Terrain,
    stream: Stream,
    receiver: Vec<u32>,
    /// Way to the mouth in radians.
    length: Vec<f64>,
    /// Edges to the mouth; 0 for what is no river.
    steps: Vec<u16>,
    is_tip: Vec<bool>,
    /// River vertices that may still grow.
    front: Vec<u32>,
}

impl Growth<'_> {
    fn is_land(&self, i: u32) -> bool {
        self.sites[i as usize] == Site::Land
    }

    /// Opens mouths along the coasts, each with its first vertex on land.
    fn open_mouths(&mut self, ground: &[i32]) {
        let mut taken = vec![false; self.mesh.len()];
        for i in 0..self.mesh.len() as u32 {
            let ring = self.mesh.ring(i);
            let is_mouth = self.sites[i as usize] == Site::Coast
                && ring.iter().any(|&j| self.sites[j as usize] == Site::Sea)
                && !ring.iter().any(|&j| taken[j as usize]);
            let lowest = ring
                .iter()
                .copied()
                .filter(|&j| self.is_land(j) && self.receiver[j as usize] == NONE)
                .min_by_key(|&j| (ground[j as usize], j));
            if let Some(first) = lowest
                && is_mouth
            {
                taken[i as usize] = true;
                ring.iter()
                    .for_each(|&j| taken[j as usize] |= self.sites[j as usize] == Site::Coast);
                self.join(first, i);
            }
        }
    }

    /// Makes `i` a river that runs into `to`.
    fn join(&mut self, i: u32, to: u32) {
        let way = (self.mesh.point(i) - self.mesh.point(to)).length();
        self.receiver[i as usize] = to;
        self.length[i as usize] = self.length[to as usize] + way;
        self.steps[i as usize] = self.steps[to as usize] + 1;
        self.is_tip[i as usize] = true;
        self.is_tip[to as usize] = false;
        self.front.push(i);
    }

    /// One round. Returns whether anything can still grow.
    fn round(&mut self, round: u64) -> bool {
        let terrain = self.terrain;
        let crust = |i: u32| f64::from(terrain.crust[i as usize]) / KM;
        let stream = self.stream;
        let draw = |i: u32, k: u64| stream.unit(crate::random::mix(u64::from(i) << 32 | round) ^ k);
        // Low crust first, with some chance.
        let mut ranked: Vec<(u64, u32)> = self
            .front
            .iter()
            .map(|&i| {
                (
                    ((1.0 - draw(i, 0) * (1.0 - crust(i) / 10.0).clamp(0.0, 1.0)) * 1e9) as u64,
                    i,
                )
            })
            .collect();
        ranked.sort_unstable();
        ranked.truncate(8.max(ranked.len() / 8));
        for &(_, i) in &ranked {
            if self.is_tip[i as usize] || self.branches(i, draw(i, 1)) {
                match self.best_step(i, round) {
                    Some(j) => self.join(j, i),
                    None => self.is_tip[i as usize] = false,
                }
            }
        }
        let mut front = core::mem::take(&mut self.front);
        let ended = |i: u32| {
            let k = i as usize;
            let high = f64::from(self.terrain.ground[k]) / KM > (0.5 * crust(i)).max(0.7);
            let walled = !self
                .mesh
                .ring(i)
                .iter()
                .any(|&j| self.is_land(j) && self.receiver[j as usize] == NONE);
            self.length[k] > LONGEST || walled || (high && self.steps[k] > 3)
        };
        // What was looked at and did not branch is looked at again, until its neighbours are taken.
        front.retain(|&i| !ended(i) && (self.is_tip[i as usize] || draw(i, 2) > 0.02));
        self.front = front;
        !self.front.is_empty()
    }

    fn branches(&self, i: u32, draw: f64) -> bool {
        self.steps[i as usize] > 2 && draw < (self.length[i as usize] / LONGEST).sqrt()
    }

    /// The neighbour that the river of vertex `i` grows to.
    fn best_step(&self, i: u32, round: u64) -> Option<u32> {
        let (p, to) = (self.mesh.point(i), self.receiver[i as usize]);
        let along = (p - self.mesh.point(to)).normalize_or_zero();
        let crust = |j: u32| f64::from(self.terrain.crust[j as usize]) / KM;
        // A branch may leave at up to 90 degrees.
        let bend = if self.is_tip[i as usize] { 0.2 } else { 0.0 };
        let cost = |j: u32| {
            let k = j as usize;
            let edge = (self.mesh.point(j) - p).normalize_or_zero();
            let near_river = self
                .mesh
                .ring(j)
                .iter()
                .any(|&n| n != i && self.steps[n as usize] > 0 && n != to);
            if !self.is_land(j) || self.receiver[k] != NONE || edge.dot(along) < bend || near_river
            {
                return None;
            }
            let chance = self
                .stream
                .unit(crate::random::mix(u64::from(i) << 32 | u64::from(j)) ^ round);
            let fold = self.terrain.fold[k].as_dvec3().dot(edge).abs();
            let rise = math::smoothstep((crust(j) - crust(i) + 0.2) / 0.3);
            let plateau = 0.05 + f64::from(self.terrain.plateau[k]);
            Some((0.1 + 0.38 * chance + fold) * plateau * (1.0 - 0.99 * rise))
        };
        let costs = self
            .mesh
            .ring(i)
            .iter()
            .filter_map(|&j| Some((cost(j)?, j)));
        costs
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
            .map(|(_, j)| j)
    }

    /// Lets all other land drain to the nearest river or coast, and puts the land in order.
    fn finish(mut self) -> Routes {
        let n = self.mesh.len();
        let mut order: Vec<u32> = Vec::new();
        // Rivers first, mouths before springs.
        let mut rivers: Vec<u32> = (0..n as u32)
            .filter(|&i| self.steps[i as usize] > 0)
            .collect();
        rivers.sort_by_key(|&i| (self.steps[i as usize], i));
        let mut queue: std::collections::VecDeque<u32> = rivers.iter().copied().collect();
        order.extend(rivers);
        queue.extend((0..n as u32).filter(|&i| self.sites[i as usize] == Site::Coast));
        if queue.is_empty() {
            queue.extend((0..n as u32).find(|&i| self.is_land(i)));
            order.extend(queue.iter());
        }
        let mut known: Vec<bool> = (0..n)
            .map(|i| self.steps[i] > 0 || self.sites[i] != Site::Land)
            .collect();
        order.iter().for_each(|&i| known[i as usize] = true);
        while let Some(i) = queue.pop_front() {
            for &j in self.mesh.ring(i) {
                if !known[j as usize] {
                    known[j as usize] = true;
                    self.receiver[j as usize] = i;
                    order.push(j);
                    queue.push_back(j);
                }
            }
        }
        Routes {
            order,
            receiver: self.receiver,
            depressions: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::climate::{Climate, ClimateMaps, EquirectMap};
    use crate::hydrology::{Drainage, TerrainMaps};

    #[test]
    fn grown_rivers_cover_the_land_and_reach_the_sea() {
        let base = BaseMesh::new(3, 0.015).unwrap();
        let crust =
            EquirectMap::from_fn(64, |lat, _| (1.0 - lat.abs() / 30.0) as f32 * 2.0).unwrap();
        let maps = TerrainMaps {
            crust,
            age: None,
            plateau: None,
            hills: None,
        };
        let terrain = Terrain::from_maps(&base, &maps);
        let climate = Climate::new(
            &base.mesh,
            &base.winds,
            &terrain.elevation_km(),
            &ClimateMaps::default(),
        );
        let drainage = Drainage::new(&base, 6370.0, &terrain, &climate, RiverNetwork::Grown);
        let mut rank = vec![usize::MAX; base.mesh.len()];
        drainage
            .routes
            .order
            .iter()
            .enumerate()
            .for_each(|(k, &i)| rank[i as usize] = k);
        for i in 0..base.mesh.len() {
            if drainage.sites[i] != Site::Land {
                continue;
            }
            let to = drainage.routes.receiver[i] as usize;
            assert!(drainage.sites[to] == Site::Coast || rank[to] < rank[i]);
            assert!(drainage.profile.level[i] >= drainage.profile.level[to]);
            assert!(!drainage.is_endorheic(i));
        }
        assert!(drainage.strahler.iter().max() >= Some(&3));
        assert_eq!(
            drainage,
            Drainage::new(&base, 6370.0, &terrain, &climate, RiverNetwork::Grown)
        );
    }
}
