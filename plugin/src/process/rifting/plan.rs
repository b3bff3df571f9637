//! The effect of a line of fracture on a plate, before anything changes.

use super::shape::RiftShape;
use super::{RiftError, RiftTrial};
use crate::crust::{Crust, Frame, Frames};
use crate::parallel;
use crate::plate::{PlateMotion, PlateRow};
use crate::view::PlanetView;
use bevy::math::DVec3;

/// Samples of the coarse look at a random shape: most shapes are refused, and so many are enough to
/// see it.
const COARSE_SAMPLES: usize = 400;

/// Most samples that are left out between two of the coarse look.
const WIDEST_STRIDE: usize = 64;

/// The state that a plan reads.
pub(super) struct RiftInput<'a> {
    /// Samples, parameters, size.
    pub planet: PlanetView<'a>,
    /// The crust in its frames.
    pub crust: &'a Crust,
    /// Frames.
    pub frames: &'a Frames,
    /// The plate that breaks.
    pub row: PlateRow,
}

/// A sample of a plate that breaks.
pub(super) struct PlateSample {
    /// Number of the sample.
    pub sample: u32,
    /// The fragment that takes it.
    pub fragment: u8,
    /// Distance from the fracture in radians.
    pub distance: f32,
    /// Direction in world coordinates.
    world: DVec3,
}

/// The fragments of a plate: who takes which sample, and how they move.
pub(super) struct RiftPlan {
    /// All samples of the plate, in order.
    pub samples: Vec<PlateSample>,
    /// The motion of every fragment.
    pub motions: Vec<PlateMotion>,
}

impl RiftPlan {
    /// The plan of a trial.
    ///
    /// # Errors
    /// [`RiftError`] if a fragment would be too small, or if no motion opens the line.
    pub(super) fn new(input: &RiftInput, trial: &RiftTrial) -> Result<Self, RiftError> {
        let stride = (input.row.stats.samples as usize / COARSE_SAMPLES).clamp(1, WIDEST_STRIDE);
        if trial.smallest_share > 0.0 && stride > 1 {
            // A coarse look first refuses most shapes at a fraction of the cost.
            openings(input, trial, &split(input, &trial.shape, stride))?;
        }
        let samples = split(input, &trial.shape, 1);
        let openings = openings(input, trial, &samples)?;
        Ok(Self {
            samples,
            motions: fragment_motions(input, &openings),
        })
    }
}

/// Splits every `stride`-th sample of the plate. A distance beyond the rift's width is not exact,
/// but lies beyond it.
fn split(input: &RiftInput, shape: &RiftShape, stride: usize) -> Vec<PlateSample> {
    let &RiftInput { planet, crust, .. } = input;
    let width = planet.params.rift_width / planet.radius;
    let is_own = |frame: &Frame| frame.plate == input.row.id;
    let own: Vec<bool> = input.frames.iter().map(is_own).collect();
    let parts = parallel::map_chunks(crust.len(), |range| {
        range
            .step_by(stride)
            .filter(|&i| own[usize::from(crust.frame[i])])
            .map(|i| split_sample(input, shape, width, i))
            .collect::<Vec<_>>()
    });
    parts.into_iter().flatten().collect()
}

/// The fragment of sample `i`, and its distance from the fracture if that is below `width` radians.
fn split_sample(input: &RiftInput, shape: &RiftShape, width: f64, i: usize) -> PlateSample {
    let frame = &input.frames[usize::from(input.crust.frame[i])];
    let world = frame.to_world(input.planet.mesh.points()[i]);
    let (fragment, distance) = shape.split(world, width);
    PlateSample {
        sample: i as u32,
        fragment: fragment as u8,
        distance: distance as f32,
        world,
    }
}

/// Angular velocities that open the line, one for every fragment.
fn openings(
    input: &RiftInput,
    trial: &RiftTrial,
    samples: &[PlateSample],
) -> Result<Vec<DVec3>, RiftError> {
    check_shares(samples, trial)?;
    let params = input.planet.params;
    let speed = params.rift_speed.min(params.max_speed) / input.planet.radius;
    let plate: Vec<DVec3> = samples.iter().map(|sample| sample.world).collect();
    trial
        .shape
        .motions(&plate, speed, trial.far_end)
        .ok_or(RiftError::NoShape)
}

/// Refuses a shape that leaves a fragment less than its share of the samples, or none.
fn check_shares(samples: &[PlateSample], trial: &RiftTrial) -> Result<(), RiftError> {
    let mut count = vec![0_usize; trial.shape.fragments()];
    for sample in samples {
        count[usize::from(sample.fragment)] += 1;
    }
    let fewest = ((trial.smallest_share * samples.len() as f64) as usize).max(1);
    if count.iter().all(|&count| count >= fewest) {
        Ok(())
    } else {
        Err(RiftError::Misses)
    }
}

/// The parent's motion and the opening, together. The parent's is held back so that no fragment
/// exceeds the highest speed.
fn fragment_motions(input: &RiftInput, openings: &[DVec3]) -> Vec<PlateMotion> {
    let limit = input.planet.params.max_speed / input.planet.radius;
    let fastest = openings
        .iter()
        .map(|omega| omega.length())
        .fold(0.0, f64::max);
    let parent = input
        .row
        .motion
        .limited((limit - fastest).max(0.0))
        .angular_velocity();
    openings
        .iter()
        .map(|&opening| PlateMotion::from_angular_velocity(parent + opening))
        .collect()
}
