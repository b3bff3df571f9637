//! The long profiles of rivers: water that never runs uphill, beds that strictly descend, lakes
//! that are level.
//!
//! Two sweeps. Upstream first, every vertex learns how low it should lie for the water from above
//! to run on (the least of its ground and of what drains to it, less the gradient), but no lower
//! than its river can wear it down ([`incision`]): breaching, where it costs less than the river
//! can pay. Then, downstream first, each takes that level, or one gradient above the vertex that it
//! drains to. Where that stands well above its ground water fills the hollow: a lake, at the level
//! of its outlet. Shallow hollows are filled with sediment instead.
//!
//! Depth follows discharge as d = 0.27 Q^0.30 (Moody and Troutman 2002), Q as on an Earth-sized
//! planet.

use super::flood::{NO_VERTEX, Routes};
use super::network::RiverNetwork;
use super::sinks::{ClosedLake, incision};
use crate::math;
use crate::parallel;
use bevy::reflect::Reflect;
use pangaea_shaders::amplify::fixed::GRAINS;

/// Least fall of a river between two vertices, grains: 1 m, 2 cm per km, that of the lower Amazon.
pub(crate) const MIN_FALL: i32 = GRAINS;

/// The number that stands for no lake.
pub const NO_LAKE: u32 = u32::MAX;

/// Least depth of a hollow that holds a lake, grains: 20 m. Sediment fills shallower ones.
const LEAST_LAKE_DEPTH: i32 = 20 * GRAINS;

/// Greatest depth of a lake, grains: 400 m. Crust is too coarse to tell a valley's floor from its
/// rims, so hollows come out kilometres deep, which sediment would fill. Of the Earth's great lakes
/// only young rifts and the deepest troughs of ice are deeper (Tanganyika 1470 m, Great Slave Lake
/// 614 m); Lake Superior has 406 m, Lake Ladoga 230 m.
pub(super) const GREATEST_LAKE_DEPTH: i32 = 400 * GRAINS;

/// A lake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Reflect)]
pub struct Lake {
    /// Level of the water in grains.
    pub level: i32,
    /// The river's vertex through which it drains, at the lake's level; [`NO_VERTEX`] for a closed
    /// basin.
    pub outlet: u32,
    /// The vertex to which all of it drains, on its bottom or next to the outlet.
    pub sink: u32,
    /// Vertices under water.
    pub vertices: u32,
}

/// Levels along all rivers.
#[derive(Clone, Debug, Default, PartialEq, Eq, Reflect)]
pub struct Profile {
    /// Level of the water if there is any at the vertex, else of its ground, in grains; never rises
    /// downstream.
    pub level: Vec<i32>,
    /// River bed or lake floor in grains.
    pub bed: Vec<i32>,
    /// The lake that covers each vertex, or [`NO_LAKE`].
    pub lake: Vec<u32>,
    /// Lakes.
    pub lakes: Vec<Lake>,
}

/// Depth in grains of a river of a discharge in m³/s (Moody and Troutman 2002).
fn depth(discharge: f64) -> i32 {
    if discharge > 0.0 {
        (0.27 * math::pow(discharge, 0.3) * f64::from(GRAINS)) as i32
    } else {
        0
    }
}

/// The rivers whose profiles are sought; columns have an entry per vertex.
#[derive(Clone, Copy)]
pub(super) struct Channels<'a> {
    pub routes: &'a Routes,
    /// Ground in grains.
    pub ground: &'a [i32],
    /// Earth-like discharge in m³/s.
    pub discharge: &'a [f64],
    pub network: RiverNetwork,
}

impl Channels<'_> {
    /// Levels, beds and lakes, of which the `closed` ones are known.
    pub(super) fn profile(&self, closed: &[ClosedLake]) -> Profile {
        let mut lakes = Lakes::new(self.ground.len(), closed);
        let wanted = self.breach(&lakes.of);
        let level = self.settle_water(&wanted, &mut lakes);
        let bed = self.beds(&level, &lakes.of);
        Profile {
            level,
            bed,
            lake: lakes.of,
            lakes: lakes.all,
        }
    }

    /// The lowest level to which the river of vertex `i` can wear down its ground.
    fn deepest_breach(&self, i: usize) -> i32 {
        if self.routes.receiver[i] == NO_VERTEX {
            return self.ground[i];
        }
        match self.network {
            RiverNetwork::Drainage => self.ground[i].saturating_sub(incision(self.discharge[i])),
            // A network that does not follow the relief cuts through whatever is in its way.
            RiverNetwork::Grown => self.ground[i].min(0),
        }
    }

    /// Level in grains that every vertex should have for the water from upstream to run on, but no
    /// lower than its river can wear it down.
    fn breach(&self, lake: &[u32]) -> Vec<i32> {
        let least = parallel::map(self.ground.len(), |i| self.deepest_breach(i as usize));
        let mut wanted = self.ground.to_vec();
        for &i in self.routes.order.iter().rev() {
            let k = i as usize;
            // Vertices upstream may ask for more than the river can wear down.
            wanted[k] = wanted[k].max(least[k]);
            let to = self.routes.receiver[k];
            if to == NO_VERTEX {
                continue;
            }
            // The receiver must lie lower than everything that drains to it, or dam it up. Closed
            // lakes have their levels already: no breach leads into one or out of it.
            let r = to as usize;
            if lake[k] == NO_LAKE && lake[r] == NO_LAKE {
                wanted[r] = wanted[r].min(wanted[k] - MIN_FALL);
            }
        }
        wanted
    }

    /// The level of the water at every vertex, downstream first: at the wanted level where water
    /// can run off, in a lake where it cannot.
    fn settle_water(&self, wanted: &[i32], lakes: &mut Lakes) -> Vec<i32> {
        // Sea and coasts are in no order and keep their ground: rivers end at the coasts' 0.
        let mut level = self.ground.to_vec();
        for &i in &self.routes.order {
            let k = i as usize;
            if let Some(lake) = lakes.at(k) {
                level[k] = lake.level;
                continue;
            }
            let to = self.routes.receiver[k];
            // The sink of a planet without a sea keeps its ground.
            if to == NO_VERTEX {
                continue;
            }
            let below = level[to as usize];
            // How deep the water below would stand over the wanted level.
            let hollow = below.saturating_sub(wanted[k]);
            // Shallow hollows hold no lake: sediment fills them until the water runs off.
            level[k] = if lakes.cover(i, to, below, hollow) {
                below
            } else {
                wanted[k].max(below + MIN_FALL)
            };
        }
        level
    }

    /// Beds: the depth of the river below its level; in lakes the ground, where that is lower, or
    /// the sediment on it. At coasts the bed of the mouth.
    fn beds(&self, level: &[i32], lake: &[u32]) -> Vec<i32> {
        let mut is_land = vec![false; self.ground.len()];
        for &i in &self.routes.order {
            is_land[i as usize] = true;
        }
        parallel::map(self.ground.len(), |i| {
            let k = i as usize;
            let discharge = self.discharge[k];
            // Coasts lie at 0, and only mouths have a discharge.
            if !is_land[k] && discharge <= 0.0 {
                return self.ground[k];
            }
            let river = level[k] - depth(discharge);
            if lake[k] == NO_LAKE {
                river
            } else {
                // As deep as its ground, but no deeper than sediment leaves it, and at least as
                // deep as the river would be.
                let sediment = level[k].saturating_sub(GREATEST_LAKE_DEPTH);
                river.min(self.ground[k].max(sediment))
            }
        })
    }
}

/// The lakes found so far.
struct Lakes {
    /// The lake of every vertex, or [`NO_LAKE`].
    of: Vec<u32>,
    all: Vec<Lake>,
}

impl Lakes {
    /// The closed lakes of a mesh of so many vertices.
    fn new(vertices: usize, closed: &[ClosedLake]) -> Self {
        let mut of = vec![NO_LAKE; vertices];
        let mut all = Vec::with_capacity(closed.len());
        for basin in closed {
            for &i in &basin.vertices {
                of[i as usize] = all.len() as u32;
            }
            all.push(Lake {
                level: basin.level,
                outlet: NO_VERTEX,
                sink: basin.vertices.first().copied().unwrap_or(NO_VERTEX),
                vertices: basin.vertices.len() as u32,
            });
        }
        Self { of, all }
    }

    /// The lake over vertex `k`.
    fn at(&self, k: usize) -> Option<&Lake> {
        self.all.get(self.of[k] as usize)
    }

    /// Covers vertex `i`, a `hollow` grains deep behind its receiver, with a lake: the one that the
    /// receiver lies in, or a new one that spills over it at `level`. False where the hollow is too
    /// shallow.
    fn cover(&mut self, i: u32, receiver: u32, level: i32, hollow: i32) -> bool {
        let lake = match self.at(receiver as usize) {
            // A lake reaches as far upstream as its level does. One without an outlet does not: it
            // covers what it can hold, and no more.
            Some(lake) if lake.outlet != NO_VERTEX && hollow > 0 => self.of[receiver as usize],
            None if hollow > LEAST_LAKE_DEPTH => {
                self.all.push(Lake {
                    level,
                    outlet: receiver,
                    sink: i,
                    vertices: 0,
                });
                self.all.len() as u32 - 1
            }
            _ => return false,
        };
        self.of[i as usize] = lake;
        self.all[lake as usize].vertices += 1;
        true
    }
}

#[cfg(test)]
#[path = "profile_tests.rs"]
mod tests;
