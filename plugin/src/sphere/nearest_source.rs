//! Distances to the nearest of many sources, spread over the mesh.
//!
//! Sources hand their own position on from sample to sample in order of distance, so that every
//! sample holds the straight distance to a source, exact wherever the sources' regions of influence
//! are connected within the domain. Where the domain is not convex the path still bends around its
//! border while the distance is straight: short by what the detour adds.
//!
//! A spread may go on from what an earlier one has left in a [`SourceField`], and several may work
//! on one field at a time as long as they reach different samples.

use super::SphereMesh;
use bevy::math::DVec3;
use core::sync::atomic::{AtomicU64, Ordering::Relaxed};
use rayon::prelude::*;

/// Source number of a sample that nothing has reached.
pub const UNREACHED: u32 = u32::MAX;

/// Distance and source of a sample that nothing has reached.
const NOTHING: u64 = pack(f32::INFINITY, UNREACHED);

/// What a spread found out: for each sample that was reached, the nearest source and its distance.
#[derive(Clone, Debug, Default)]
pub struct Reached {
    /// Samples in the order in which they were first reached.
    pub samples: Vec<u32>,
    /// Number of the nearest source of each.
    pub source: Vec<u32>,
    /// Distance to it in radians.
    pub distance: Vec<f32>,
}

/// The nearest source of every sample, and the squared chord to it.
///
/// Both are packed into one word, the chord in the upper half: the smaller word is the nearer
/// source, of equally near ones that with the lower number.
#[derive(Debug, Default)]
pub struct SourceField(Vec<AtomicU64>);

impl Clone for SourceField {
    fn clone(&self) -> Self {
        Self(
            self.0
                .iter()
                .map(|word| AtomicU64::new(word.load(Relaxed)))
                .collect(),
        )
    }
}

#[inline]
const fn pack(chord2: f32, source: u32) -> u64 {
    (chord2.to_bits() as u64) << 32 | source as u64
}

#[inline]
fn chord2(word: u64) -> f32 {
    f32::from_bits((word >> 32) as u32)
}

impl SourceField {
    /// The field of `n` samples that nothing has reached.
    pub fn new(n: usize) -> Self {
        Self((0..n).map(|_| AtomicU64::new(NOTHING)).collect())
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are no samples.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The source nearest to sample `i`, or [`UNREACHED`].
    #[inline]
    pub fn source(&self, i: u32) -> u32 {
        self.get(i) as u32
    }

    /// Source and distance in radians of sample `i`, if it was reached.
    #[inline]
    pub fn nearest(&self, i: u32) -> Option<(u32, f32)> {
        let word = self.get(i);
        let reached = word as u32 != UNREACHED;
        reached.then(|| {
            (
                word as u32,
                angle_of_chord(f64::from(chord2(word)).sqrt()) as f32,
            )
        })
    }

    /// Says that sample `i` is nearest to `source`, at the squared chord `chord2`.
    pub fn set(&self, i: u32, source: u32, chord2: f32) {
        self.put(i, pack(chord2, source));
    }

    /// Forgets sample `i`.
    pub fn reset(&self, i: u32) {
        self.put(i, NOTHING);
    }

    /// Forgets all samples.
    pub fn clear(&mut self) {
        self.0
            .par_iter_mut()
            .with_min_len(1 << 14)
            .for_each(|word| *word.get_mut() = NOTHING);
    }

    // Words are independent of each other, and no spread reads what another one writes: no order is
    // needed.
    #[inline]
    fn get(&self, i: u32) -> u64 {
        self.0[i as usize].load(Relaxed)
    }

    #[inline]
    fn put(&self, i: u32, word: u64) {
        self.0[i as usize].store(word, Relaxed);
    }
}

/// Scratch memory of [`spread`], to be used again.
#[derive(Clone, Debug, Default)]
pub struct Scratch(SourceField);

/// Great-circle angle of a chord in radians, for angles up to a radian or so (error below 1e-6).
#[inline]
pub fn angle_of_chord(chord: f64) -> f64 {
    let x = 0.5 * chord;
    let x2 = x * x;
    2.0 * x
        * (1.0 + x2 * (1.0 / 6.0 + x2 * (3.0 / 40.0 + x2 * (15.0 / 336.0 + x2 * (105.0 / 3456.0)))))
}

/// Spreads from `seeds` (sample, position of the source), up to `reach` radians (at most 2), along
/// those links (from, to) between neighbours that are `open`. Of equal distances the source with
/// the lower number wins.
pub fn spread(
    mesh: &SphereMesh,
    scratch: &mut Scratch,
    seeds: &[(u32, DVec3)],
    reach: f64,
    open: impl Fn(u32, u32) -> bool,
) -> Reached {
    if scratch.0.len() != mesh.len() {
        scratch.0 = SourceField::new(mesh.len());
    }
    let field = &scratch.0;
    let start: Vec<_> = seeds
        .iter()
        .zip(0..)
        .map(|(seed, number)| (seed.0, number))
        .collect();
    let samples = spread_on(
        mesh,
        field,
        &start,
        reach,
        |source| seeds[source as usize].1,
        open,
    );
    let found = |&i: &u32| field.nearest(i).unwrap_or((UNREACHED, f32::INFINITY));
    let (source, distance) = samples.iter().map(found).unzip();
    samples.iter().for_each(|&i| field.reset(i));
    Reached {
        samples,
        source,
        distance,
    }
}

/// Spreads on a field that may hold something already. `start` are pairs of samples and sources, in
/// the order in which they are taken: sources that lie at a sample, and samples from which what
/// they hold goes on. `position` is that of a source. Returns the samples that were reached for the
/// first time.
pub fn spread_on(
    mesh: &SphereMesh,
    field: &SourceField,
    start: &[(u32, u32)],
    reach: f64,
    position: impl Fn(u32) -> DVec3,
    open: impl Fn(u32, u32) -> bool,
) -> Vec<u32> {
    let limit = 2.0 * crate::math::sin(0.5 * reach.min(2.0));
    let limit2 = (limit * limit) as f32;
    // Half a spacing: fine enough that few samples are improved after they have handed a source on.
    let per_bucket = (2.0 / mesh.spacing()) as f32;
    let bucket_of = |chord2: f32| (chord2.sqrt() * per_bucket) as usize;
    let mut buckets: Vec<Vec<(u32, u32)>> = vec![Vec::new(); bucket_of(limit2) + 1];
    let mut fresh = Vec::new();
    for &(sample, source) in start {
        let d = mesh.point(sample).distance_squared(position(source)) as f32;
        let (old, new) = (field.get(sample), pack(d, source));
        if d > limit2 || new > old {
            continue;
        }
        if old == NOTHING {
            fresh.push(sample);
        }
        field.put(sample, new);
        buckets[bucket_of(d)].push((sample, source));
    }
    for bucket in 0..buckets.len() {
        let mut k = 0;
        while let Some(&(sample, source)) = buckets[bucket].get(k) {
            k += 1;
            // A sample that found a nearer source meanwhile is in a bucket once more.
            if field.source(sample) != source {
                continue;
            }
            let from = position(source);
            for &neighbour in mesh.ring(sample) {
                let old = field.get(neighbour);
                if old as u32 == source || !open(sample, neighbour) {
                    continue;
                }
                let d = mesh.point(neighbour).distance_squared(from) as f32;
                let new = pack(d, source);
                if d > limit2 || new >= old {
                    continue;
                }
                if old == NOTHING {
                    fresh.push(neighbour);
                }
                field.put(neighbour, new);
                // A neighbour may lie nearer to the source than the sample that hands it on: it
                // goes into the present bucket then.
                buckets[bucket_of(d).max(bucket)].push((neighbour, source));
            }
        }
        buckets[bucket] = Vec::new();
    }
    fresh
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
                let nearest = seeds
                    .iter()
                    .map(|s| crate::math::angle_between(p, s.1))
                    .fold(9.0, f64::min);
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
        let reached = spread(&mesh, &mut Scratch::default(), &seeds, 1.0, |_, to| {
            north(to)
        });
        assert!(reached.samples.iter().all(|&i| north(i)));
        assert!(reached.samples.len() > 200);
    }
}
