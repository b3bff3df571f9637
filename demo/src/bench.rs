//! `pangaea bench`: how fast this machine grows planets, also in floors: how often all columns
//! could have been read and written in the same time.

pub mod floor;
mod ground;

use crate::cli::BenchArgs;
use crate::error::CliError;
use crate::headless::{Headless, set_threads, sprout};
use crate::output::{check_file, print, say, write_file};
use crate::progress;
use bevy_pangaea::authoring::{Inbox, TectonicCommand, apply::apply};
use bevy_pangaea::crust::Crust;
use bevy_pangaea::io::{Timings, stats::peak_rss_mb};
use bevy_pangaea::planet::PlanetRecipe;
use bevy_pangaea::schedule::{Stage, StageTimings};
use std::fmt::Write;
use std::time::Instant;

/// Steps per measurement: 128 My, with several resamplings.
const STEPS: u64 = 64;
/// Steps after which the largest plate that can break is torn apart.
const RIFTS: [u64; 3] = [16, 32, 48];
/// A step after which a resampling is asked for, so that there is one on the slowest planet, too.
const RESAMPLE: u64 = 40;

/// What was measured at one number of samples; also an entry of the JSON file.
#[derive(serde::Serialize)]
struct Row {
    samples: u32,
    plates: u32,
    steps: u64,
    timings_ms: Timings,
    /// Mean of each stage in a step.
    stages_ms: Vec<(&'static str, f64)>,
    peak_rss_mb: Option<f64>,
    /// Climate, rivers and the amplified ground; none for a planet too small or too large for it.
    ground: Option<ground::GroundRow>,
}

/// Runs the command.
pub fn bench(args: &BenchArgs) -> Result<(), CliError> {
    set_threads(args.threads)?;
    if let Some(path) = &args.json {
        check_file(path)?;
    }
    let mut rows = Vec::new();
    for &samples in &args.samples.0 {
        rows.push(measure(samples)?);
    }
    print(&table(&rows))?;
    if let Some(path) = &args.json {
        let mut json = serde_json::to_string_pretty(&rows)
            .map_err(|error| CliError::Failed(error.to_string()))?;
        json.push('\n');
        write_file(path, json.as_bytes())?;
        say(&format!("timings in {}", path.display()));
    }
    Ok(())
}

fn measure(samples: u32) -> Result<Row, CliError> {
    let defaults = PlanetRecipe::default();
    let plate_count = defaults.plate_count.min(samples / 10);
    let recipe = PlanetRecipe {
        samples,
        plate_count,
        ..defaults
    };
    forget_peak();
    let start = Instant::now();
    let (state, mesh) = sprout(&recipe)?;
    let mut headless = Headless::new(state);
    let bar = progress::bar(STEPS, "steps", &format!("{samples} samples"));
    for step in 0..STEPS {
        if RIFTS.contains(&step) {
            tear_largest(&mut headless);
        }
        if step == RESAMPLE {
            ask_for_resample(&mut headless);
        }
        headless.step()?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    let total = start.elapsed().as_secs_f64() * 1e3;
    let peak_rss_mb = peak_rss_mb();
    let stages = headless.get::<StageTimings>()?;
    let timings_ms = Timings {
        mesh: Some(mesh),
        total: Some(total),
        floor: Some(floor::memory_floor_ms(headless.get::<Crust>()?)),
        ..Timings::of_stages(stages)
    };
    let steps = stages.steps.max(1) as f64;
    let stages_ms = Stage::ALL
        .map(|stage| (stage.name(), stages.total_ms[stage as usize] / steps))
        .to_vec();
    headless.look();
    let ground = ground::measure(&headless)?;
    Ok(Row {
        samples,
        plates: plate_count,
        steps: STEPS,
        timings_ms,
        stages_ms,
        peak_rss_mb,
        ground,
    })
}

/// Breaks the largest plate that can break.
fn tear_largest(headless: &mut Headless) {
    let mut plates = headless.plates().rows().to_vec();
    plates.sort_by(|a, b| b.stats.area.total_cmp(&a.stats.area));
    let planet = headless.planet;
    for row in plates {
        let command = TectonicCommand::RiftPlate {
            plate: row.id,
            line: Vec::new(),
            fragments: 2,
        };
        if apply(headless.app.world_mut(), planet, &command).is_ok() {
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

/// Lets the system forget the highest memory use so far, where it can, so that each row has its
/// own.
fn forget_peak() {
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

fn table(rows: &[Row]) -> String {
    let threads = rayon::current_num_threads();
    let mut text =
        format!("{threads} threads, {STEPS} steps; (in brackets: multiples of the floor)\n\n");
    let _ = writeln!(
        text,
        "{:>9} {:>8} {:>16} {:>16} {:>16} {:>16} {:>9} {:>9}",
        "samples",
        "mesh s",
        "step mean ms",
        "step max ms",
        "resample ms",
        "rift ms",
        "floor ms",
        "peak MB"
    );
    for row in rows {
        let t = &row.timings_ms;
        let cell = |ms: Option<f64>| with_floors(ms, t.floor);
        let plain = |x: Option<f64>, scale: f64, digits: usize| match x {
            Some(x) => format!("{:.digits$}", x * scale),
            None => "-".into(),
        };
        let _ = writeln!(
            text,
            "{:>9} {:>8} {:>16} {:>16} {:>16} {:>16} {:>9} {:>9}",
            row.samples,
            plain(t.mesh, 1e-3, 2),
            cell(t.step_mean),
            cell(t.step_max),
            cell(t.resample_mean),
            cell(t.rift_mean),
            plain(t.floor, 1.0, 3),
            plain(row.peak_rss_mb, 1.0, 0),
        );
    }
    let grounds = rows
        .iter()
        .filter_map(|row| row.ground.as_ref().map(|ground| (row.samples, ground)));
    text + &stage_table(rows) + &ground::table(grounds)
}

/// Mean milliseconds of each stage per step, resamplings and riftings spread over all steps.
fn stage_table(rows: &[Row]) -> String {
    let mut text = String::from("\nmean per step, ms\n");
    let _ = write!(text, "{:<12}", "stage");
    for row in rows {
        let _ = write!(text, " {:>16}", row.samples);
    }
    text.push('\n');
    for (k, stage) in Stage::ALL.iter().enumerate() {
        let _ = write!(text, "{:<12}", stage.name());
        for row in rows {
            let _ = write!(
                text,
                " {:>16}",
                with_floors(Some(row.stages_ms[k].1), row.timings_ms.floor)
            );
        }
        text.push('\n');
    }
    text
}

fn with_floors(ms: Option<f64>, floor: Option<f64>) -> String {
    match (ms, floor.filter(|&floor| floor > 0.0)) {
        (Some(ms), Some(floor)) => format!("{ms:.2} ({:.1})", ms / floor),
        (Some(ms), None) => format!("{ms:.2}"),
        (None, _) => "-".into(),
    }
}
