//! What plates are made of.

use super::PlateStats;
use crate::crust::{Crust, Frames};
use crate::parallel;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;

#[derive(Clone, Copy, Default)]
struct Sums {
    samples: u32,
    area: f64,
    continental: f64,
    ocean_age: f64,
    moment: DVec3,
}

/// Statistics of a choice of plates, as pairs of plate number and statistics in the order of plate
/// numbers. A plate of several frames has one entry. `radius` is in km.
pub fn plate_stats(
    mesh: &SphereMesh,
    crust: &Crust,
    frames: &Frames,
    radius: f64,
    choice: impl Fn(super::PlateId) -> bool,
) -> Vec<(super::PlateId, PlateStats)> {
    let counted: Vec<bool> = frames.iter().map(|frame| choice(frame.plate)).collect();
    let parts = parallel::map_chunks(crust.len(), |range| {
        let mut sums = vec![Sums::default(); frames.len()];
        for i in range.filter(|&i| counted[usize::from(crust.frame[i])]) {
            let sum = &mut sums[usize::from(crust.frame[i])];
            let area = mesh.areas()[i];
            sum.samples += 1;
            sum.area += area;
            sum.moment += mesh.points()[i] * area;
            if crust.is_continental(i) {
                sum.continental += area;
            } else {
                sum.ocean_age += area * f64::from(crust.ocean_age[i]);
            }
        }
        sums
    });
    let mut by_frame = vec![Sums::default(); frames.len()];
    for part in parts {
        for (sum, part) in by_frame.iter_mut().zip(part) {
            sum.samples += part.samples;
            sum.area += part.area;
            sum.continental += part.continental;
            sum.ocean_age += part.ocean_age;
            sum.moment += part.moment;
        }
    }
    let mut order: Vec<usize> = (0..frames.len()).filter(|&k| counted[k]).collect();
    order.sort_by_key(|&k| (frames[k].plate, k));
    let mut out: Vec<(super::PlateId, Sums)> = Vec::new();
    for k in order {
        let (frame, part) = (&frames[k], by_frame[k]);
        if out.last().is_none_or(|last| last.0 != frame.plate) {
            out.push((frame.plate, Sums::default()));
        }
        if let Some((_, sum)) = out.last_mut() {
            sum.samples += part.samples;
            sum.area += part.area;
            sum.continental += part.continental;
            sum.ocean_age += part.ocean_age;
            sum.moment += frame.to_world(part.moment);
        }
    }
    out.into_iter()
        .map(|(id, sum)| (id, finish(sum, radius)))
        .collect()
}

fn finish(sum: Sums, radius: f64) -> PlateStats {
    let ocean = sum.area - sum.continental;
    PlateStats {
        samples: sum.samples,
        area: sum.area * radius * radius,
        continental: if sum.area > 0.0 {
            sum.continental / sum.area
        } else {
            0.0
        },
        ocean_age: if ocean > 1e-9 {
            sum.ocean_age / ocean
        } else {
            0.0
        },
        centroid: sum.moment.try_normalize().unwrap_or(DVec3::Z),
    }
}
