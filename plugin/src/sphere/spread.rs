//! Distances to the nearest of many sources, spread over the mesh.
//!
//! Sources hand their own position on from sample to sample in order of distance, so that every sample
//! holds the straight distance to a source, exact wherever the sources' regions of influence are
//! connected within the domain. Where the domain is not convex the path still bends around its border
//! while the distance is straight: short by what the detour adds.

use super::SphereMesh;
use bevy::math::DVec3;

/// Source number of a sample that nothing has reached.
pub const UNREACHED: u32 = u32::MAX;

/// What a spread found out: for each sample that was reached, the nearest source and its distance.
#[derive(Clone, Debug, Default)]
pub struct Reached {
    /// Samples in the order in which they were settled.
    pub samples: Vec<u32>,
    /// Number of the nearest source of each.
    pub source: Vec<u32>,
    /// Distance to it in radians.
    pub distance: Vec<f32>,
}

/// Scratch memory of [`spread`], to be used again.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    chord2: Vec<f32>,
    source: Vec<u32>,
    settled: Vec<bool>,
    buckets: Vec<Vec<u32>>,
}

/// Great-circle angle of a chord in radians, for angles up to a radian or so (error below 1e-6).
#[inline]
pub fn angle_of_chord(chord: f64) -> f64 {
    let x = 0.5 * chord;
    let x2 = x * x;
    2.0 * x * (1.0 + x2 * (1.0 / 6.0 + x2 * (3.0 / 40.0 + x2 * (15.0 / 336.0 + x2 * (105.0 / 3456.0)))))
}

/// Spreads from `seeds` (sample, position of the source), up to `reach` radians (at most 2), along those
/// links (from, to) between neighbours that are `open`. Of equal distances the source with the lower number wins.
pub fn spread(
    mesh: &SphereMesh,
    scratch: &mut Scratch,
    seeds: &[(u32, DVec3)],
    reach: f64,
    open: impl Fn(u32, u32) -> bool,
) -> Reached {
    let n = mesh.len();
    scratch.chord2.resize(n, f32::INFINITY);
    scratch.source.resize(n, UNREACHED);
    scratch.settled.resize(n, false);
    let limit = 2.0 * crate::math::sin(0.5 * reach.min(2.0));
    // Half a spacing: fine enough that few samples are improved after they were settled.
    let width = 0.5 * mesh.spacing();
    let bucket_of = |chord2: f32| (f64::from(chord2).sqrt() / width) as usize;
    let count = (limit / width) as usize + 2;
    if scratch.buckets.len() < count {
        scratch.buckets.resize(count, Vec::new());
    }
    let mut touched = Vec::new();
    let mut out = Reached::default();
    let limit2 = (limit * limit) as f32;
    for (number, &(sample, position)) in seeds.iter().enumerate() {
        let d = mesh.point(sample).distance_squared(position) as f32;
        let i = sample as usize;
        if d <= limit2 && d < scratch.chord2[i] {
            if scratch.source[i] == UNREACHED {
                touched.push(sample);
            }
            scratch.chord2[i] = d;
            scratch.source[i] = number as u32;
            scratch.buckets[bucket_of(d)].push(sample);
        }
    }
    for bucket in 0..count {
        let mut k = 0;
        while k < scratch.buckets[bucket].len() {
            let sample = scratch.buckets[bucket][k];
            k += 1;
            let i = sample as usize;
            if scratch.settled[i] {
                continue;
            }
            scratch.settled[i] = true;
            let source = scratch.source[i];
            let position = seeds[source as usize].1;
            for &neighbour in mesh.ring(sample) {
                let j = neighbour as usize;
                let old = scratch.chord2[j];
                if scratch.source[j] == source || !open(sample, neighbour) {
                    continue;
                }
                let d = mesh.point(neighbour).distance_squared(position) as f32;
                if d > limit2 || d > old || (d == old && source >= scratch.source[j]) {
                    continue;
                }
                if scratch.source[j] == UNREACHED {
                    touched.push(neighbour);
                }
                scratch.chord2[j] = d;
                scratch.source[j] = source;
                // A neighbour may lie nearer to the source than the sample that hands it on: it goes
                // into the present bucket then, and hands the better source on once more.
                scratch.settled[j] = false;
                scratch.buckets[bucket_of(d).max(bucket)].push(neighbour);
            }
        }
    }
    for bucket in &mut scratch.buckets {
        bucket.clear();
    }
    out.samples.reserve(touched.len());
    for sample in touched {
        let i = sample as usize;
        out.samples.push(sample);
        out.source.push(scratch.source[i]);
        out.distance.push(angle_of_chord(f64::from(scratch.chord2[i]).sqrt()) as f32);
        scratch.chord2[i] = f32::INFINITY;
        scratch.source[i] = UNREACHED;
        scratch.settled[i] = false;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Purpose, Stream};

    #[test]
    fn equals_brute_force_on_the_whole_sphere() {
        let mesh = SphereMesh::fibonacci(5000).unwrap();
        let stream = Stream::new(5, Purpose::PlateCentroids, 0);
        let seeds: Vec<_> = (0..60)
            .map(|k| {
                let p = stream.direction(k);
                (mesh.nearest(p), p)
            })
            .collect();
        let mut scratch = Scratch::default();
        for _ in 0..2 {
            let reached = spread(&mesh, &mut scratch, &seeds, 0.4, |_, _| true);
            let mut distance = vec![f64::INFINITY; mesh.len()];
            for (k, &i) in reached.samples.iter().enumerate() {
                distance[i as usize] = f64::from(reached.distance[k]);
                let source = seeds[reached.source[k] as usize].1;
                let angle = crate::math::angle_between(mesh.point(i), source);
                assert!((angle - f64::from(reached.distance[k])).abs() < 1e-6);
            }
            let mut wrong = 0;
            for (i, &p) in mesh.points().iter().enumerate() {
                let nearest = seeds.iter().map(|s| crate::math::angle_between(p, s.1)).fold(9.0, f64::min);
                if nearest < 0.399 && (distance[i] - nearest).abs() > 1e-5 {
                    wrong += 1;
                    // A source cut off by others may be missed by a sample's width, no more.
                    assert!(distance[i] - nearest < 0.3 * mesh.spacing());
                }
                if nearest > 0.401 {
                    assert_eq!(distance[i], f64::INFINITY);
                }
            }
            assert!(wrong < 5, "{wrong}");
        }
    }

    #[test]
    fn stays_inside() {
        let mesh = SphereMesh::fibonacci(2000).unwrap();
        let seeds = [(mesh.nearest(DVec3::X), DVec3::X)];
        let north = |i: u32| mesh.point(i).z > -0.1;
        let reached = spread(&mesh, &mut Scratch::default(), &seeds, 1.0, |_, to| north(to));
        assert!(reached.samples.iter().all(|&i| north(i)));
        assert!(reached.samples.len() > 200);
    }
}
