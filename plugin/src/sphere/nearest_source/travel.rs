//! The source that is reached in the least time from every sample.

use super::bucket_queue::BucketQueue;
use crate::sphere::SphereMesh;
use crate::sphere::chord::angle_of_long_chord;
use bevy::math::DVec3;

/// A point from which travel times are measured, and a sample next to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TravelSource {
    pub(crate) sample: u32,
    /// Unit direction of the source.
    pub(crate) point: DVec3,
    /// Time per radian, above 0; 1 where the time is to be the distance itself.
    pub(crate) slowness: f64,
}

impl TravelSource {
    /// Time to the unit direction `p`.
    fn time(&self, p: DVec3) -> f64 {
        self.slowness * angle_of_long_chord((p - self.point).length())
    }
}

/// The source of least travel time of every sample.
pub(crate) struct TravelTimes {
    /// Great-circle distance in radians times slowness; infinite if there is no source at all.
    pub(crate) time: Vec<f64>,
    /// Number of the source; 0 if there is no source at all.
    pub(crate) source: Vec<u32>,
}

/// Finds the source of least travel time for every sample, the first among equals.
pub(crate) fn least_travel_times(mesh: &SphereMesh, sources: &[TravelSource]) -> TravelTimes {
    let mut wave = TravelWave::new(mesh, sources);
    for (number, source) in (0..).zip(sources) {
        wave.offer(
            source.sample,
            number,
            source.time(mesh.point(source.sample)),
        );
    }
    while let Some((bucket, sample)) = wave.queue.pop() {
        let found = &wave.found;
        // A sample that found a nearer source meanwhile has handed that on already.
        if wave.bucket(found.time[sample as usize]) < bucket {
            continue;
        }
        let number = found.source[sample as usize];
        let source = sources[number as usize];
        for &j in mesh.ring(sample) {
            wave.offer(j, number, source.time(mesh.point(j)));
        }
    }
    wave.found
}

/// A search under way.
struct TravelWave {
    found: TravelTimes,
    /// Time that a bucket of the queue spans.
    width: f64,
    queue: BucketQueue<u32>,
}

impl TravelWave {
    fn new(mesh: &SphereMesh, sources: &[TravelSource]) -> Self {
        let slowness = sources.iter().map(|source| source.slowness);
        let fastest = slowness.fold(f64::INFINITY, f64::min);
        Self {
            found: TravelTimes {
                time: vec![f64::INFINITY; mesh.len()],
                source: vec![0; mesh.len()],
            },
            // The fastest source takes half a spacing per bucket.
            width: 0.5 * mesh.spacing() * fastest,
            queue: BucketQueue::new(),
        }
    }

    fn bucket(&self, time: f64) -> usize {
        (time / self.width) as usize
    }

    /// Gives a sample a source if that is nearer in time than the one it has.
    #[inline]
    fn offer(&mut self, sample: u32, source: u32, time: f64) {
        if time < self.found.time[sample as usize] {
            self.found.time[sample as usize] = time;
            self.found.source[sample as usize] = source;
            self.queue.push(self.bucket(time), sample);
        }
    }
}
