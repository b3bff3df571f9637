//! Basins without an outlet: a depression whose water evaporates before it is full stays closed.
//!
//! The outlet of a depression is worn down by the river that leaves it, at most by [`incision`]. If
//! what flows in is less than what the lake behind the worn outlet would lose to the air beyond
//! what its ground would have given to the river, no river leaves: the lake shrinks to where inflow
//! and loss balance. Its bottom becomes a sink, and the depression drains there. Upstream
//! depressions are decided first: a closed one passes nothing on.

use super::flood::{Depression, NONE, Routes};
use super::flow::earth_like;
use crate::sphere::SphereMesh;
use core::cmp::Reverse;
use std::collections::BinaryHeap;

/// A lake without an outlet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Closed {
    /// Vertices under water; the first is the sink.
    pub vertices: Vec<u32>,
    /// Level in grains.
    pub level: i32,
}

/// How far a river has worn down a sill, in grains: 40 m and 4 m times the root of its discharge in
/// m³/s (as on an Earth-sized planet). The law of stream power has that root; at 40,000 m³/s it
/// makes 840 m, the depth of the gorges of the great rivers that cross mountains.
pub fn incision(discharge: f64) -> i32 {
    ((40.0 + 4.0 * discharge.max(0.0).sqrt()) * 1024.0).min(4e6) as i32
}

/// What the decision is made from.
pub(super) struct Balance<'a> {
    pub mesh: &'a SphereMesh,
    pub radius: f64,
    pub ground: &'a [i32],
    /// Runoff of each vertex in m³ per year.
    pub supply: &'a [u64],
    /// What each vertex would lose under water beyond its rain, in m³ per year.
    pub loss: &'a [i64],
}

/// Finds closed basins and lets them drain to their sinks.
pub(super) fn close_basins(balance: &Balance, routes: &mut Routes) -> Vec<Closed> {
    let mut block = vec![NONE; balance.mesh.len()];
    for (d, depression) in routes.depressions.iter().enumerate() {
        routes.order[depression.range.clone()]
            .iter()
            .for_each(|&i| block[i as usize] = d as u32);
    }
    let mut flow = balance.supply.to_vec();
    let mut closed = Vec::new();
    let mut exits: Vec<(u32, u64)> = Vec::new();
    let mut k = routes.order.len();
    while k > 0 {
        k -= 1;
        let i = routes.order[k];
        let to = routes.receiver[i as usize];
        let d = block[i as usize];
        if d != NONE && (to == NONE || block[to as usize] != d) {
            exits.push((to, flow[i as usize]));
        } else if to != NONE {
            flow[to as usize] += flow[i as usize];
        }
        if d == NONE || routes.depressions[d as usize].range.start < k {
            continue;
        }
        let depression = routes.depressions[d as usize].clone();
        let inflow = exits.iter().map(|e| e.1).sum();
        if balance.dries_up(&depression, routes, inflow) {
            closed.push(balance.reroute(&depression, routes, inflow));
            exits.clear();
        }
        for (to, amount) in exits.drain(..) {
            if to != NONE {
                flow[to as usize] += amount;
            }
        }
    }
    closed.reverse();
    closed
}

impl Balance<'_> {
    /// Loss of a lake's vertex: what evaporates beyond the rain, and the runoff that its ground no
    /// longer gives.
    fn cost(&self, i: u32) -> i64 {
        self.loss[i as usize] + self.supply[i as usize] as i64
    }

    fn dries_up(&self, depression: &Depression, routes: &Routes, inflow: u64) -> bool {
        let worn = depression
            .level
            .saturating_sub(incision(earth_like(inflow, self.radius)));
        let members = &routes.order[depression.range.clone()];
        let lake = members.iter().filter(|&&i| self.ground[i as usize] < worn);
        let cost: i64 = lake.map(|&i| self.cost(i)).sum();
        cost > inflow as i64
    }

    /// Turns the depression around: its vertices drain to the lowest one.
    fn reroute(&self, depression: &Depression, routes: &mut Routes, inflow: u64) -> Closed {
        let members = &mut routes.order[depression.range.clone()];
        let mut inside: Vec<u32> = members.to_vec();
        inside.sort_unstable();
        let is_member = |j: u32| inside.binary_search(&j);
        let mut reached = vec![false; inside.len()];
        let sink = members
            .iter()
            .copied()
            .min_by_key(|&i| (self.ground[i as usize], i))
            .unwrap_or(NONE);
        // By the level of the water; what one level covers from the bottom up.
        let entry = |level: i32, i: u32| Reverse((level, self.ground[i as usize], i));
        let mut heap = BinaryHeap::from([entry(self.ground[sink as usize], sink)]);
        let mut order = Vec::with_capacity(inside.len());
        routes.receiver[sink as usize] = NONE;
        if let Ok(place) = is_member(sink) {
            reached[place] = true;
        }
        let (mut lake, mut shore) = (Vec::new(), None);
        let (mut spent, mut top) = (0, i32::MIN);
        while let Some(Reverse((level, _, i))) = heap.pop() {
            order.push(i);
            if shore.is_none() {
                if lake.is_empty() || (spent + self.cost(i) <= inflow as i64 && level > top - 1) {
                    spent += self.cost(i);
                    top = top.max(level);
                    lake.push(i);
                } else {
                    shore = Some(level);
                }
            }
            for &j in self.mesh.ring(i) {
                let Ok(place) = is_member(j) else { continue };
                if !reached[place] {
                    reached[place] = true;
                    routes.receiver[j as usize] = i;
                    heap.push(entry(self.ground[j as usize].max(level), j));
                }
            }
        }
        // Half way to the next higher ground, and not more than 20 m deep over the last that is
        // covered.
        let rim = shore.unwrap_or(depression.level).max(top);
        let level = (top + ((rim - top) / 2).min(20 * 1024)).max(top + 1);
        members.copy_from_slice(&order);
        Closed {
            vertices: lake,
            level,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hydrology::coast::Site;
    use crate::hydrology::flood::flood;
    use crate::hydrology::flow::accumulate;
    use crate::math;

    /// Land north of the equator with a bowl 1.3 km deep, its rim 0.25 rad wide; sea in the south.
    fn bowl() -> (SphereMesh, Vec<Site>, Vec<i32>) {
        let mesh = SphereMesh::fibonacci(5000).unwrap();
        let centre = math::direction(50.0, 20.0);
        let ground: Vec<i32> = (0..5000)
            .map(|i| {
                let p = mesh.points()[i];
                if p.z < 0.0 {
                    return -1_000_000;
                }
                let r = math::angle_between(p, centre) / 0.25;
                ((1.2 + p.z + if r < 1.0 { -1.5 * (1.0 - r * r) } else { 0.0 }) * 1_024_000.0)
                    as i32
            })
            .collect();
        let mut ground = ground;
        let sites = crate::hydrology::coast::regularise(&mesh, &mut ground);
        (mesh, sites, ground)
    }

    fn run(
        loss: i64,
    ) -> (
        SphereMesh,
        Vec<Site>,
        Vec<i32>,
        Routes,
        Vec<Closed>,
        Vec<u64>,
    ) {
        let (mesh, sites, ground) = bowl();
        let mut routes = flood(&mesh, &sites, &ground);
        let supply: Vec<u64> = sites
            .iter()
            .map(|s| if *s == Site::Land { 1_000_000 } else { 0 })
            .collect();
        let losses = vec![loss; mesh.len()];
        let balance = Balance {
            mesh: &mesh,
            radius: 6370.0,
            ground: &ground,
            supply: &supply,
            loss: &losses,
        };
        let closed = close_basins(&balance, &mut routes);
        let discharge = accumulate(&routes, &supply);
        (mesh, sites, ground, routes, closed, discharge)
    }

    #[test]
    fn a_wet_basin_spills() {
        let (_, _, _, routes, closed, discharge) = run(-900_000);
        assert!(closed.is_empty());
        let to_sea: u64 = routes
            .receiver
            .iter()
            .zip(&discharge)
            .filter(|(r, _)| **r == NONE)
            .map(|(_, d)| d)
            .sum();
        assert_eq!(to_sea, routes.order.len() as u64 * 1_000_000);
    }

    #[test]
    fn a_dry_basin_holds_a_lake_that_balances() {
        let (mesh, _, ground, routes, closed, discharge) = run(20_000_000);
        assert_eq!(closed.len(), 1, "{closed:?} {:?}", routes.depressions);
        let lake = &closed[0];
        let sink = lake.vertices[0];
        assert_eq!(routes.receiver[sink as usize], NONE);
        let inflow = discharge[sink as usize];
        let cost = lake.vertices.len() as u64 * 21_000_000;
        assert!(
            cost <= inflow && inflow < cost + 21_000_000,
            "{cost} {inflow}"
        );
        assert!(
            lake.vertices
                .iter()
                .all(|&i| ground[i as usize] < lake.level)
        );
        // The order still leads downstream first.
        let mut rank = vec![0; mesh.len()];
        routes
            .order
            .iter()
            .enumerate()
            .for_each(|(k, &i)| rank[i as usize] = k);
        for &i in &routes.order {
            let to = routes.receiver[i as usize];
            assert!(
                to == NONE
                    || routes.receiver[to as usize] == NONE
                    || rank[to as usize] < rank[i as usize]
            );
        }
    }
}
