//! Priority-flood: which way water leaves every place on land (Barnes, Lehman and Mulla 2014).
//!
//! The flood rises from the coasts. A vertex is reached from the lowest neighbour already under
//! water, so on its way to the sea water passes the lowest saddles. A vertex below the level at
//! which it is reached lies in a *depression*. A depression is flooded at once, lowest vertex
//! first: water in it runs along its floor, and its vertices are contiguous in the order. Elsewhere
//! water takes the steepest way down.
//!
//! Policies. Equal levels go by vertex number. A planet without a sea is flooded from its lowest
//! vertex, its only sink.

use super::coast::ShoreClass;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::reflect::Reflect;
use core::cmp::Reverse;
use core::ops::Range;
use std::collections::BinaryHeap;

/// The number that stands for no vertex: the receiver of a sink, the outlet of a closed lake.
pub const NO_VERTEX: u32 = u32::MAX;

/// Level of vertices that the flood has not reached, grains.
const DRY: i32 = i32::MAX;

/// Level of vertices in the sea, grains: nothing drains to them but through a coast.
const SEA: i32 = i32::MIN;

/// Vertices below the saddle over which their water must leave.
#[derive(Clone, Debug, PartialEq, Eq, Reflect)]
pub struct Depression {
    /// Its part of [`Routes::order`].
    pub range: Range<usize>,
    /// Spill elevation: the level of the saddle in grains.
    pub spill_elevation: i32,
}

/// The way of the water from every vertex on land.
#[derive(Clone, Debug, Default, PartialEq, Eq, Reflect)]
pub struct Routes {
    /// Land in an order in which every vertex comes after the one that it drains to.
    pub order: Vec<u32>,
    /// The vertex that each drains to; [`NO_VERTEX`] for sinks, coasts and the sea.
    pub receiver: Vec<u32>,
    /// Depressions, in the order of their ranges.
    pub depressions: Vec<Depression>,
}

/// Vertices in the order of their levels, and of their numbers at one level.
#[derive(Default)]
struct RisingQueue(BinaryHeap<Reverse<u64>>);

impl RisingQueue {
    /// Flipping the sign bit orders signed levels as unsigned numbers.
    const SIGN: u32 = 0x8000_0000;

    fn push(&mut self, level: i32, vertex: u32) {
        let high = u64::from(level as u32 ^ Self::SIGN);
        self.0.push(Reverse(high << 32 | u64::from(vertex)));
    }

    /// Takes the lowest vertex out, with its level.
    fn pop(&mut self) -> Option<(i32, u32)> {
        let Reverse(key) = self.0.pop()?;
        Some((((key >> 32) as u32 ^ Self::SIGN) as i32, key as u32))
    }
}

/// Floods the land of `mesh` whose ground, in grains, is given.
pub(super) fn priority_flood(mesh: &SphereMesh, shore: &[ShoreClass], ground: &[i32]) -> Routes {
    let mut flood = Flood::new(mesh, ground);
    flood.seed_coasts(shore);
    if flood.shoreline.0.is_empty() {
        flood.seed_lowest(shore);
    }
    flood.rise(shore);
    flood.steepen()
}

struct Flood<'a> {
    mesh: &'a SphereMesh,
    ground: &'a [i32],
    /// Level at which each vertex was reached, or [`DRY`].
    level: Vec<i32>,
    /// Vertices that the flood has reached and not yet gone on from.
    shoreline: RisingQueue,
    routes: Routes,
}

impl<'a> Flood<'a> {
    fn new(mesh: &'a SphereMesh, ground: &'a [i32]) -> Self {
        Self {
            mesh,
            ground,
            level: vec![DRY; mesh.len()],
            shoreline: RisingQueue::default(),
            routes: Routes {
                receiver: vec![NO_VERTEX; mesh.len()],
                ..Routes::default()
            },
        }
    }

    /// Begins the flood at all coasts with land beside them.
    fn seed_coasts(&mut self, shore: &[ShoreClass]) {
        let is_land = |j: &u32| shore[*j as usize] == ShoreClass::Land;
        for i in 0..self.mesh.len() as u32 {
            match shore[i as usize] {
                ShoreClass::Sea => self.level[i as usize] = SEA,
                ShoreClass::Coast => {
                    self.level[i as usize] = 0;
                    if self.mesh.ring(i).iter().any(is_land) {
                        self.shoreline.push(0, i);
                    }
                }
                ShoreClass::Land => {}
            }
        }
    }

    /// Begins the flood at the lowest vertex on land.
    fn seed_lowest(&mut self, shore: &[ShoreClass]) {
        let land = (0..self.mesh.len() as u32).filter(|&i| shore[i as usize] == ShoreClass::Land);
        if let Some(lowest) = land.min_by_key(|&i| (self.ground[i as usize], i)) {
            let z = self.ground[lowest as usize];
            self.level[lowest as usize] = z;
            self.shoreline.push(z, lowest);
        }
    }

    /// Lets the flood rise until all land is reached.
    fn rise(&mut self, shore: &[ShoreClass]) {
        // The lowest vertex of the shoreline first: whatever it reaches drains over the lowest
        // saddle there is.
        while let Some((level, i)) = self.shoreline.pop() {
            if shore[i as usize] == ShoreClass::Land {
                self.routes.order.push(i);
            }
            for &j in self.mesh.ring(i) {
                if self.level[j as usize] != DRY {
                    continue;
                }
                self.routes.receiver[j as usize] = i;
                let z = self.ground[j as usize];
                // Lower than the water that reaches it: the water would have to rise again to
                // leave.
                if z < level {
                    self.fill_depression(j, level);
                } else {
                    self.level[j as usize] = z;
                    self.shoreline.push(z, j);
                }
            }
        }
    }

    /// Floods the depression that begins at `first` up to its spill elevation.
    fn fill_depression(&mut self, first: u32, spill_elevation: i32) {
        let start = self.routes.order.len();
        // The water runs in over the saddle and fills the lowest ground that it can reach first, so
        // receivers lead along the floor.
        let mut pit = RisingQueue::default();
        self.level[first as usize] = spill_elevation;
        pit.push(self.ground[first as usize], first);
        while let Some((_, i)) = pit.pop() {
            self.routes.order.push(i);
            for &j in self.mesh.ring(i) {
                if self.level[j as usize] != DRY {
                    continue;
                }
                let z = self.ground[j as usize];
                self.routes.receiver[j as usize] = i;
                // Marked as it enters the queue, so that no vertex enters twice.
                self.level[j as usize] = z.max(spill_elevation);
                // Higher ground around the depression waits until the flood has risen to it.
                if z <= spill_elevation {
                    pit.push(z, j);
                } else {
                    self.shoreline.push(z, j);
                }
            }
        }
        self.routes.depressions.push(Depression {
            range: start..self.routes.order.len(),
            spill_elevation,
        });
    }

    /// Lets vertices outside of depressions drain the steepest way down the flooded ground.
    fn steepen(mut self) -> Routes {
        let mut in_depression = vec![false; self.mesh.len()];
        for depression in &self.routes.depressions {
            for &i in &self.routes.order[depression.range.clone()] {
                in_depression[i as usize] = true;
            }
        }
        // The order stays true: lower levels were reached earlier.
        let receiver = parallel::map(self.mesh.len(), |i| {
            // In a depression the flooded ground is level: there the way of the flood is the only
            // one.
            let flooded_from = self.routes.receiver[i as usize];
            if flooded_from == NO_VERTEX || in_depression[i as usize] {
                flooded_from
            } else {
                self.steepest_descent(i).unwrap_or(flooded_from)
            }
        });
        self.routes.receiver = receiver;
        self.routes
    }

    /// The neighbour to which the flooded ground falls most steeply from vertex `i`.
    fn steepest_descent(&self, i: u32) -> Option<u32> {
        let p = self.mesh.point(i);
        let z = i64::from(self.ground[i as usize]);
        let mut steepest = 0.0;
        let mut receiver = None;
        for &j in self.mesh.ring(i) {
            let level = self.level[j as usize];
            let drop = z - i64::from(level);
            // The sea is entered only through a coast, whose level is 0.
            if drop <= 0 || level == SEA {
                continue;
            }
            // Squares spare the root: the steepest stays the steepest.
            let drop = drop as f64;
            let steepness = drop * drop / (self.mesh.point(j) - p).length_squared();
            if steepness > steepest {
                steepest = steepness;
                receiver = Some(j);
            }
        }
        receiver
    }
}

#[cfg(test)]
#[path = "flood_tests.rs"]
mod tests;
