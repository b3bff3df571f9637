//! Nearest sources within a reach, over links that are open.
//!
//! A search may go on from what an earlier one has left in a [`SourceField`], and several may work
//! on one field at a time as long as they reach different samples.

use super::bucket_queue::BucketQueue;
use super::field::{NOTHING, SourceField, UNREACHED, pack};
use crate::math;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::reflect::Reflect;

/// Longest reach in radians. Beyond it the angle of a chord is not exact enough.
const MAX_REACH: f64 = 2.0;

/// The samples that a search has reached, each with its nearest source and the distance to it.
#[derive(Clone, Debug, Default, Reflect)]
pub struct ReachedSamples {
    /// Samples in the order in which they were first reached.
    pub samples: Vec<u32>,
    /// Number of the nearest source of each.
    pub source: Vec<u32>,
    /// Distance to it in radians.
    pub distance: Vec<f32>,
}

/// Scratch memory of [`nearest_sources`], to be used again.
#[derive(Clone, Debug, Default)]
pub struct SourceScratch(SourceField);

/// Finds the nearest source of all samples within `reach` radians (at most 2).
///
/// Each of `sources` has a sample where it begins and a position. It is handed on along those links
/// (from, to) between neighbours that are `open`. Of equal distances the source with the lower
/// number wins.
///
/// ```
/// # use bevy_pangaea::{math, sphere::{SphereMesh, nearest_source::*}};
/// let mesh = SphereMesh::fibonacci(2000)?;
/// let sources = [0.0, 20.0].map(|lon| math::direction(0.0, lon)).map(|p| (mesh.nearest(p), p));
/// let mut scratch = SourceScratch::default();
/// let north = |_: u32, to: u32| mesh.point(to).z > -0.1;
/// let found = nearest_sources(&mesh, &mut scratch, &sources, 0.5, north);
/// for (k, &i) in found.samples.iter().enumerate() {
///     let angle = math::angle_between(mesh.point(i), sources[found.source[k] as usize].1);
///     assert!((angle - f64::from(found.distance[k])).abs() < 1e-5 && angle < 0.501);
/// }
/// # Ok::<(), bevy_pangaea::sphere::SphereError>(())
/// ```
pub fn nearest_sources(
    mesh: &SphereMesh,
    scratch: &mut SourceScratch,
    sources: &[(u32, DVec3)],
    reach: f64,
    open: impl Fn(u32, u32) -> bool,
) -> ReachedSamples {
    if scratch.0.len() != mesh.len() {
        scratch.0 = SourceField::new(mesh.len());
    }
    let field = &scratch.0;
    let start: Vec<(u32, u32)> = sources.iter().map(|source| source.0).zip(0..).collect();
    let position = |source: u32| sources[source as usize].1;
    let samples = extend_nearest_sources(mesh, field, &start, reach, position, open);
    let found = |&i: &u32| field.nearest(i).unwrap_or((UNREACHED, f32::INFINITY));
    let (source, distance) = samples.iter().map(found).unzip();
    // The field is clean again for the next search, at the cost of this one alone.
    samples.iter().for_each(|&i| field.reset(i));
    ReachedSamples {
        samples,
        source,
        distance,
    }
}

/// The same as [`nearest_sources`] on a field that may hold something already.
///
/// `start` holds pairs of a sample and a source, tried in their order: a source that begins at the
/// sample, or one that the sample knows already and from which the search goes on. `position` gives
/// the unit direction of a source. Returns the samples that were reached for the first time.
pub fn extend_nearest_sources(
    mesh: &SphereMesh,
    field: &SourceField,
    start: &[(u32, u32)],
    reach: f64,
    position: impl Fn(u32) -> DVec3,
    open: impl Fn(u32, u32) -> bool,
) -> Vec<u32> {
    let mut wave = Wavefront::new(mesh, field, reach);
    for &(sample, source) in start {
        let d = mesh.point(sample).distance_squared(position(source)) as f32;
        // A sample that holds this very source hands it on once more.
        if pack(d, source) <= field.get(sample) {
            wave.offer(sample, source, d);
        }
    }
    while let Some((_, (sample, source))) = wave.queue.pop() {
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
            if pack(d, source) < old {
                wave.offer(neighbour, source, d);
            }
        }
    }
    wave.fresh
}

/// A search under way.
struct Wavefront<'a> {
    field: &'a SourceField,
    /// Largest squared chord within reach.
    limit2: f32,
    buckets_per_chord: f32,
    /// Samples with the sources that they hand on.
    queue: BucketQueue<(u32, u32)>,
    /// Samples that nothing had reached before.
    fresh: Vec<u32>,
}

impl<'a> Wavefront<'a> {
    fn new(mesh: &SphereMesh, field: &'a SourceField, reach: f64) -> Self {
        let limit = 2.0 * math::sin(0.5 * reach.min(MAX_REACH));
        Self {
            field,
            limit2: (limit * limit) as f32,
            // Half a spacing: fine enough that few samples are improved after they have handed a
            // source on.
            buckets_per_chord: (2.0 / mesh.spacing()) as f32,
            queue: BucketQueue::new(),
            fresh: Vec::new(),
        }
    }

    /// Gives a sample a nearer source, unless that is out of reach.
    #[inline]
    fn offer(&mut self, sample: u32, source: u32, chord2: f32) {
        if chord2 > self.limit2 {
            return;
        }
        if self.field.get(sample) == NOTHING {
            self.fresh.push(sample);
        }
        self.field.put(sample, pack(chord2, source));
        // A neighbour may lie nearer to the source than the sample that hands it on: the queue puts
        // it into the present bucket then.
        let bucket = (chord2.sqrt() * self.buckets_per_chord) as usize;
        self.queue.push(bucket, (sample, source));
    }
}
