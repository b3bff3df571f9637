//! Distance of every sample to the nearest of a set of points, the coast, or the shortest time to
//! reach it, from the ridges.
//!
//! Each sample learns its nearest point from a neighbour and measures the chord to it. So distances
//! are not sums over edges, and their isolines show nothing of the lattice. Samples wait in buckets
//! of cost (Dial 1969), so that hardly any is visited twice.

use crate::plate::continents::field::arc;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

/// A point from which distances are measured, and a sample next to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source {
    pub(super) sample: u32,
    pub(super) point: DVec3,
    /// Cost of a rad of distance, above 0.
    pub(super) slowness: f64,
}

impl Source {
    fn cost(&self, p: DVec3) -> f64 {
        self.slowness * arc((p - self.point).length())
    }
}

/// The nearest source of every sample.
pub(super) struct Nearest {
    /// Great-circle distance in rad times slowness; infinite where there is no source at all.
    pub(super) cost: Vec<f64>,
    /// Number of the source; meaningless where there is none.
    pub(super) source: Vec<u32>,
}

/// Finds the source of least cost for every sample, the first among equals.
pub(super) fn nearest(mesh: &SphereMesh, sources: &[Source]) -> Nearest {
    let mut cost = vec![f64::INFINITY; mesh.len()];
    let mut source = vec![0; mesh.len()];
    let fastest = sources
        .iter()
        .map(|s| s.slowness)
        .fold(f64::INFINITY, f64::min);
    let width = 0.5 * mesh.spacing() * fastest;
    let bucket = |cost: f64| (cost / width) as usize;
    let mut buckets: Vec<Vec<u32>> = Vec::new();
    let push = |buckets: &mut Vec<Vec<u32>>, bucket: usize, sample: u32| {
        if buckets.len() <= bucket {
            buckets.resize(bucket + 1, Vec::new());
        }
        buckets[bucket].push(sample);
    };
    for (number, from) in sources.iter().enumerate() {
        let c = from.cost(mesh.point(from.sample));
        if c < cost[from.sample as usize] {
            cost[from.sample as usize] = c;
            source[from.sample as usize] = number as u32;
            push(&mut buckets, bucket(c), from.sample);
        }
    }
    let mut current = 0;
    while current < buckets.len() {
        let mut next = 0;
        while let Some(&sample) = buckets[current].get(next) {
            next += 1;
            if bucket(cost[sample as usize]) < current {
                continue;
            }
            let number = source[sample as usize];
            let from = sources[number as usize];
            for &j in mesh.ring(sample) {
                let c = from.cost(mesh.point(j));
                if c < cost[j as usize] {
                    cost[j as usize] = c;
                    source[j as usize] = number;
                    push(&mut buckets, bucket(c).max(current), j);
                }
            }
        }
        buckets[current] = Vec::new();
        current += 1;
    }
    Nearest { cost, source }
}
