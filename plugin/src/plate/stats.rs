//! Statistics of plates: samples, area, kinds of crust, centroids.

use super::PlateStats;
use crate::crust::{Crust, Frame, Frames};
use crate::ids::PlateId;
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

/// Ocean area in steradian below which a plate has no mean ocean age: rounding may leave a little
/// where all crust is continental.
const LEAST_OCEAN: f64 = 1e-9;

/// Sums over some samples of a frame or a plate. Areas are in steradian.
#[derive(Clone, Copy, Default)]
struct PlateSums {
    samples: u32,
    area: f64,
    /// Area of continental crust.
    continental: f64,
    /// Age in My times area, summed over oceanic crust.
    ocean_age: f64,
    /// Direction times area; of a frame in lattice coordinates, of a plate in the world's.
    moment: DVec3,
}

impl PlateSums {
    fn add_sample(&mut self, mesh: &SphereMesh, crust: &Crust, i: usize) {
        let area = mesh.areas()[i];
        self.samples += 1;
        self.area += area;
        self.moment += mesh.points()[i] * area;
        if crust.is_continental(i) {
            self.continental += area;
        } else {
            self.ocean_age += area * f64::from(crust.ocean_age[i]);
        }
    }

    fn add(&mut self, other: &Self) {
        self.samples += other.samples;
        self.area += other.area;
        self.continental += other.continental;
        self.ocean_age += other.ocean_age;
        self.moment += other.moment;
    }

    /// The sums of a frame in world coordinates.
    fn in_world(self, frame: &Frame) -> Self {
        Self {
            // Areas and ages are the same in every frame; only directions turn.
            moment: frame.to_world(self.moment),
            ..self
        }
    }

    /// Statistics on a planet of `radius` km.
    fn stats(&self, radius: f64) -> PlateStats {
        let ocean = self.area - self.continental;
        PlateStats {
            samples: self.samples,
            area: self.area * radius * radius,
            continental: ratio(self.continental, self.area, 0.0),
            ocean_age: ratio(self.ocean_age, ocean, LEAST_OCEAN),
            // Crust all round the sphere has no centroid: any direction serves.
            centroid: self.moment.try_normalize().unwrap_or(DVec3::Z),
        }
    }
}

/// A part of a whole, or 0 if the whole is no larger than `least`.
fn ratio(part: f64, whole: f64, least: f64) -> f64 {
    if whole > least { part / whole } else { 0.0 }
}

/// Statistics of a choice of plates, as pairs of plate number and statistics in the order of plate
/// numbers. A plate of several frames has one entry. `radius` is in km.
pub(crate) fn plate_stats(
    mesh: &SphereMesh,
    crust: &Crust,
    frames: &Frames,
    radius: f64,
    choice: impl Fn(PlateId) -> bool,
) -> Vec<(PlateId, PlateStats)> {
    let chosen: Vec<bool> = frames.iter().map(|frame| choice(frame.plate)).collect();
    let by_frame = sums_by_frame(mesh, crust, &chosen);
    let mut order: Vec<usize> = (0..frames.len()).filter(|&k| chosen[k]).collect();
    order.sort_by_key(|&k| (frames[k].plate, k));
    let plates = order.chunk_by(|&a, &b| frames[a].plate == frames[b].plate);
    plates
        .map(|own| {
            let mut sums = PlateSums::default();
            for &k in own {
                sums.add(&by_frame[k].in_world(&frames[k]));
            }
            (frames[own[0]].plate, sums.stats(radius))
        })
        .collect()
}

/// Sums over the samples of every frame that is `chosen`.
fn sums_by_frame(mesh: &SphereMesh, crust: &Crust, chosen: &[bool]) -> Vec<PlateSums> {
    let frame_of = |i: usize| usize::from(crust.frame[i]);
    let parts = parallel::map_chunks(crust.len(), |range| {
        let mut sums = vec![PlateSums::default(); chosen.len()];
        for i in range.filter(|&i| chosen[frame_of(i)]) {
            sums[frame_of(i)].add_sample(mesh, crust, i);
        }
        sums
    });
    // Joined in the order of chunks: the same bits on any number of threads.
    let mut by_frame = vec![PlateSums::default(); chosen.len()];
    for part in parts {
        for (sums, part) in by_frame.iter_mut().zip(&part) {
            sums.add(part);
        }
    }
    by_frame
}
