//! Wall-clock time of the stages.

use super::stage::{Stage, TectonicSystems};
use bevy::prelude::*;
use core::time::Duration;

/// Wall-clock time of each stage.
#[derive(Component, Clone, Debug, Default, Reflect)]
#[reflect(Component, Default)]
pub struct StageTimings {
    /// Time of each stage in the last step in ms, in the order of [`Stage::ALL`]; time slices are
    /// summed.
    pub last_ms: [f64; Stage::COUNT],
    /// Sum over all steps in ms.
    pub total_ms: [f64; Stage::COUNT],
    /// Largest time of a step in ms, without resampling, rifting and projecting the surface.
    pub step_max_ms: f64,
    /// Steps measured.
    pub steps: u64,
    /// Resamplings done, and their time in ms.
    pub resample: (u32, f64),
    /// Riftings done, and their time in ms.
    pub rift: (u32, f64),
}

impl StageTimings {
    /// Time of the last step in ms, without resampling, rifting and projecting the surface.
    pub fn last_step_ms(&self) -> f64 {
        without_events(&self.last_ms)
    }

    /// Mean time of a step in ms, without resampling, rifting and projecting the surface.
    pub fn step_mean_ms(&self) -> f64 {
        without_events(&self.total_ms) / self.steps.max(1) as f64
    }

    /// Adds the time of one set to its stage, whose time is complete with its second set.
    pub(super) fn take(&mut self, set: TectonicSystems, spent: Duration) {
        let ms = spent.as_secs_f64() * 1e3;
        match set {
            TectonicSystems::Process(stage) => self.last_ms[stage as usize] = ms,
            TectonicSystems::After(stage) => {
                self.last_ms[stage as usize] += ms;
                self.total_ms[stage as usize] += self.last_ms[stage as usize];
            }
        }
    }

    /// Counts a step whose stages have all been taken.
    pub(super) fn end_step(&mut self) {
        self.steps += 1;
        self.step_max_ms = self.step_max_ms.max(self.last_step_ms());
    }
}

/// The sum over the stages that every step has.
fn without_events(ms: &[f64; Stage::COUNT]) -> f64 {
    let events = [Stage::Resample, Stage::Rifting, Stage::Projection];
    ms.iter().sum::<f64>() - events.map(|stage| ms[stage as usize]).iter().sum::<f64>()
}
