//! A measurement of one planet: steps, and the ground at their end.

use super::ground::{GroundTimings, ground_timings};
use crate::error::CliError;
use crate::headless::{Headless, initial_planet};
use crate::progress;
use bevy_pangaea::authoring::{Inbox, TectonicCommand, apply_now};
use bevy_pangaea::io::{Timings, stats::peak_rss_mb};
use bevy_pangaea::planet::PlanetRecipe;
use bevy_pangaea::schedule::{Stage, StageTimings};
use std::time::Instant;

/// Steps per measurement: 128 My, with several resamplings.
pub(super) const STEPS: u64 = 64;
/// Steps after which the largest plate that can break is rifted.
const RIFT_STEPS: [u64; 3] = [16, 32, 48];
/// A step after which a resampling is asked for, so that there is one on the slowest planet, too.
const RESAMPLE_STEP: u64 = 40;

/// The measurements at one number of samples; also an entry of the JSON file.
#[derive(serde::Serialize)]
pub(super) struct BenchRow {
    pub(super) samples: u32,
    pub(super) plates: u32,
    pub(super) steps: u64,
    pub(super) timings_ms: Timings,
    /// Mean of each stage in a step.
    pub(super) stages_ms: Vec<(&'static str, f64)>,
    pub(super) peak_rss_mb: Option<f64>,
    /// Climate, rivers and the amplified ground; `None` for a planet too small or too large for it.
    pub(super) ground: Option<GroundTimings>,
}

/// Grows a planet of so many samples, and measures it.
///
/// # Errors
/// If the planet is refused, or cannot be baked.
pub(super) fn measure(samples: u32) -> Result<BenchRow, CliError> {
    let defaults = PlanetRecipe::default();
    let plate_count = defaults.plate_count.min(samples / 10);
    let recipe = PlanetRecipe {
        samples,
        plate_count,
        ..defaults
    };
    forget_peak();
    let start = Instant::now();
    let (state, mesh_ms) = initial_planet(&recipe)?;
    let mut headless = Headless::new(state);
    take_steps(&mut headless, samples)?;
    let total_ms = start.elapsed().as_secs_f64() * 1e3;
    // Before the floor and the ground take memory of their own.
    let peak_rss_mb = peak_rss_mb();
    let timings_ms = headless.timings(mesh_ms, total_ms)?;
    let stages_ms = stage_means(headless.get::<StageTimings>()?);
    headless.project();
    Ok(BenchRow {
        samples,
        plates: plate_count,
        steps: STEPS,
        timings_ms,
        stages_ms,
        peak_rss_mb,
        ground: ground_timings(&headless)?,
    })
}

/// Grows a planet by all steps, with a progress bar.
fn take_steps(headless: &mut Headless, samples: u32) -> Result<(), CliError> {
    let bar = progress::bar(STEPS, "steps", &format!("{samples} samples"));
    for step in 0..STEPS {
        if RIFT_STEPS.contains(&step) {
            rift_largest(headless);
        }
        if step == RESAMPLE_STEP {
            ask_for_resample(headless);
        }
        headless.step()?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(())
}

/// Breaks the largest plate that can break.
fn rift_largest(headless: &mut Headless) {
    let mut plates = headless.plates().rows().to_vec();
    plates.sort_by(|a, b| b.stats.area.total_cmp(&a.stats.area));
    let planet = headless.planet;
    for row in plates {
        let command = TectonicCommand::RiftPlate {
            plate: row.id,
            line: Vec::new(),
            fragments: 2,
        };
        // Some plates are too small or too narrow to break; the next largest is tried then.
        if apply_now(headless.app.world_mut(), planet, &command).is_ok() {
            return;
        }
    }
}

fn ask_for_resample(headless: &mut Headless) {
    let planet = headless.planet;
    if let Some(mut inbox) = headless.app.world_mut().get_mut::<Inbox>(planet) {
        inbox.0.push(TectonicCommand::Resample);
    }
}

/// Mean milliseconds of each stage in a step, resamplings and riftings spread over all steps.
fn stage_means(stages: &StageTimings) -> Vec<(&'static str, f64)> {
    let steps = stages.steps.max(1) as f64;
    Stage::ALL
        .map(|stage| (stage.name(), stages.total_ms[stage as usize] / steps))
        .to_vec()
}

/// Lets the system forget the highest memory use so far, where it can, so that each row has its
/// own.
fn forget_peak() {
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}
