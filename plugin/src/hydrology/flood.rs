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

use super::coast::Site;
use crate::parallel;
use crate::sphere::SphereMesh;
use core::cmp::Reverse;
use core::ops::Range;
use std::collections::BinaryHeap;

/// No vertex.
pub const NONE: u32 = u32::MAX;

/// Vertices below the saddle over which their water must leave.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Depression {
    /// Its part of [`Routes::order`].
    pub range: Range<usize>,
    /// Level of the saddle in grains.
    pub level: i32,
}

/// The way of the water from every vertex on land.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Routes {
    /// Land in an order in which every vertex comes after the one that it drains to.
    pub order: Vec<u32>,
    /// The vertex that each drains to; [`NONE`] for sinks, coasts and the sea.
    pub receiver: Vec<u32>,
    /// Depressions, in the order of their ranges.
    pub depressions: Vec<Depression>,
}

/// A vertex at a level in grains; the order of the numbers is that of (level, vertex).
fn entry(level: i32, vertex: u32) -> Reverse<u64> {
    Reverse(u64::from(level as u32 ^ 0x8000_0000) << 32 | u64::from(vertex))
}

fn parts(Reverse(key): Reverse<u64>) -> (i32, u32) {
    (((key >> 32) as u32 ^ 0x8000_0000) as i32, key as u32)
}

/// Floods the land of `mesh` whose ground, in grains, is given.
pub fn flood(mesh: &SphereMesh, sites: &[Site], ground: &[i32]) -> Routes {
    let mut run = Flood {
        mesh,
        ground,
        level: vec![i32::MAX; mesh.len()],
        heap: BinaryHeap::new(),
        pit: BinaryHeap::new(),
        routes: Routes {
            receiver: vec![NONE; mesh.len()],
            ..Routes::default()
        },
    };
    run.seed(sites);
    while let Some((level, i)) = run.heap.pop().map(parts) {
        if sites[i as usize] == Site::Land {
            run.routes.order.push(i);
        }
        for &j in mesh.ring(i) {
            if run.level[j as usize] != i32::MAX {
                continue;
            }
            run.routes.receiver[j as usize] = i;
            if ground[j as usize] < level {
                run.sink(j, level);
            } else {
                run.level[j as usize] = ground[j as usize];
                run.heap.push(entry(ground[j as usize], j));
            }
        }
    }
    let Flood {
        level, mut routes, ..
    } = run;
    steepen(mesh, ground, &level, &mut routes);
    routes
}

struct Flood<'a> {
    mesh: &'a SphereMesh,
    ground: &'a [i32],
    /// Level at which each vertex was reached; `i32::MAX` before.
    level: Vec<i32>,
    heap: BinaryHeap<Reverse<u64>>,
    pit: BinaryHeap<Reverse<u64>>,
    routes: Routes,
}

impl Flood<'_> {
    fn seed(&mut self, sites: &[Site]) {
        for i in 0..self.mesh.len() as u32 {
            match sites[i as usize] {
                Site::Sea => self.level[i as usize] = i32::MIN,
                Site::Coast => {
                    self.level[i as usize] = 0;
                    if self
                        .mesh
                        .ring(i)
                        .iter()
                        .any(|&j| sites[j as usize] == Site::Land)
                    {
                        self.heap.push(entry(0, i));
                    }
                }
                Site::Land => {}
            }
        }
        if self.heap.is_empty()
            && let Some(lowest) = (0..self.mesh.len() as u32)
                .filter(|&i| sites[i as usize] == Site::Land)
                .min_by_key(|&i| (self.ground[i as usize], i))
        {
            self.level[lowest as usize] = self.ground[lowest as usize];
            self.heap.push(entry(self.ground[lowest as usize], lowest));
        }
    }

    /// Floods the depression that begins at `first` up to `level`.
    fn sink(&mut self, first: u32, level: i32) {
        let start = self.routes.order.len();
        self.level[first as usize] = level;
        self.pit.push(entry(self.ground[first as usize], first));
        while let Some((_, i)) = self.pit.pop().map(parts) {
            self.routes.order.push(i);
            for &j in self.mesh.ring(i) {
                if self.level[j as usize] != i32::MAX {
                    continue;
                }
                let z = self.ground[j as usize];
                self.routes.receiver[j as usize] = i;
                self.level[j as usize] = z.max(level);
                let heap = if z <= level {
                    &mut self.pit
                } else {
                    &mut self.heap
                };
                heap.push(entry(z, j));
            }
        }
        self.routes.depressions.push(Depression {
            range: start..self.routes.order.len(),
            level,
        });
    }
}

/// Lets vertices outside of depressions drain the steepest way down the flooded ground.
fn steepen(mesh: &SphereMesh, ground: &[i32], level: &[i32], routes: &mut Routes) {
    let mut sunk = vec![false; mesh.len()];
    for depression in &routes.depressions {
        routes.order[depression.range.clone()]
            .iter()
            .for_each(|&i| sunk[i as usize] = true);
    }
    let old = core::mem::take(&mut routes.receiver);
    routes.receiver = parallel::map(mesh.len(), |i| {
        let k = i as usize;
        if old[k] == NONE || sunk[k] {
            return old[k];
        }
        let p = mesh.point(i);
        let mut best = (0.0, old[k]);
        for &j in mesh.ring(i) {
            let drop = i64::from(ground[k]) - i64::from(level[j as usize]);
            // The sea is not entered but at a coast, whose level is 0.
            if drop <= 0 || level[j as usize] == i32::MIN {
                continue;
            }
            let drop = drop as f64;
            let steepness = drop * drop / (mesh.point(j) - p).length_squared();
            if steepness > best.0 {
                best = (steepness, j);
            }
        }
        best.1
    });
}

#[cfg(test)]
#[path = "flood_tests.rs"]
mod tests;
