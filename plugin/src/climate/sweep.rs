//! A mesh as the wind sweeps over it: vertices, neighbours and ways by their *places* in the order
//! of the sweep.
//!
//! A sweep reads the water of neighbours. By number these lie all over the memory, for the order
//! goes by longitude, and vertices are numbered along a curve; by place they lie a thousand places
//! away at most, or at the other end. So all is laid out by place, once per mesh, and a sweep reads
//! its memory from front to back.

use super::scale::EARTH_RADIUS;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::reflect::Reflect;

/// Way within which eddies mix columns, km.
const MIXING_KM: f32 = 300.0;

/// The point upwind of a vertex, on the edge between two of its neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Reflect)]
pub struct Upwind {
    /// The edge's ends.
    pub from: [u32; 2],
    /// Weight of the second end.
    pub weight: f32,
    /// Distance in radians.
    pub distance: f32,
}

/// The order of the wind on a mesh, and what a sweep reads, a value per place.
#[derive(Clone, Debug, PartialEq, Reflect)]
pub struct SweepPath {
    /// Places of the ends of the edge that the air crosses upwind.
    from: Vec<[u32; 2]>,
    /// Weight of the second end.
    weight: Vec<f32>,
    /// The way from there, km; at least 1.
    way: Vec<f32>,
    /// Share of the air that comes from all around.
    mixed: Vec<f32>,
    /// Where the neighbours of each place begin, and where the last ones end.
    starts: Vec<u32>,
    /// Places of the neighbours, in the order of the rings.
    around: Vec<u32>,
}

impl SweepPath {
    /// The path over a mesh in an order of its vertices; `upwind` goes by vertex.
    pub(super) fn new(mesh: &SphereMesh, order: &[u32], upwind: &[Upwind]) -> Self {
        let mut place_of = vec![0; order.len()];
        for (place, &i) in (0..).zip(order) {
            place_of[i as usize] = place;
        }
        let place = |i: u32| place_of[i as usize];
        let upwind = |k: u32| upwind[order[k as usize] as usize];
        let way = parallel::map(order.len(), |k| way(upwind(k)));
        let (starts, around) = rings(mesh, order, place);
        Self {
            from: parallel::map(order.len(), |k| upwind(k).from.map(place)),
            weight: parallel::map(order.len(), |k| upwind(k).weight),
            // The longer the way the more time eddies have had.
            mixed: parallel::map(order.len(), |k| {
                way[k as usize] / (MIXING_KM + way[k as usize])
            }),
            way,
            starts,
            around,
        }
    }

    /// Carries water over all places, in place and in order: one sweep carries it around the planet.
    /// `pass` takes a place, the water that arrives there and its way in km, and returns what is
    /// left.
    #[inline]
    pub(super) fn sweep(&self, water: &mut [f32], mut pass: impl FnMut(usize, f32, f32) -> f32) {
        for k in 0..self.way.len() {
            let arriving = self.arriving(water, k);
            water[k] = pass(k, arriving, self.way[k]);
        }
    }

    /// Water that arrives at place `k`: from upwind, and what eddies have mixed from all around.
    #[inline]
    fn arriving(&self, water: &[f32], k: usize) -> f32 {
        let [a, b] = self.from[k].map(|j| water[j as usize]);
        let ring = &self.around[self.starts[k] as usize..self.starts[k + 1] as usize];
        let around = ring.iter().map(|&j| water[j as usize]).sum::<f32>() / ring.len() as f32;
        let carried = a + (b - a) * self.weight[k];
        carried + (around - carried) * self.mixed[k]
    }
}

/// The way from the point upwind in km. At least a kilometre: rain is divided by it.
fn way(upwind: Upwind) -> f32 {
    (upwind.distance * EARTH_RADIUS as f32).max(1.0)
}

/// Where the neighbours of each place begin, and all of them by `place`.
fn rings(mesh: &SphereMesh, order: &[u32], place: impl Fn(u32) -> u32) -> (Vec<u32>, Vec<u32>) {
    let mut starts = Vec::with_capacity(order.len() + 1);
    let mut around = Vec::with_capacity(6 * order.len());
    starts.push(0);
    for &i in order {
        around.extend(mesh.ring(i).iter().map(|&j| place(j)));
        starts.push(around.len() as u32);
    }
    (starts, around)
}
