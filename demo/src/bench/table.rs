//! The tables of `pangaea bench`.

use super::ground::GroundTimings;
use super::steps::{BenchRow, STEPS};
use std::fmt::Write;

/// All tables: steps, stages, ground.
pub(super) fn table(rows: &[BenchRow]) -> String {
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
        text += &step_line(row);
    }
    text + &stage_table(rows) + &ground_tables(rows)
}

fn step_line(row: &BenchRow) -> String {
    let timings = &row.timings_ms;
    format!(
        "{:>9} {:>8} {:>16} {:>16} {:>16} {:>16} {:>9} {:>9}\n",
        row.samples,
        rounded(timings.mesh.map(|ms| ms * 1e-3), 2),
        with_floors(timings.step_mean, timings.floor),
        with_floors(timings.step_max, timings.floor),
        with_floors(timings.resample_mean, timings.floor),
        with_floors(timings.rift_mean, timings.floor),
        rounded(timings.floor, 3),
        rounded(row.peak_rss_mb, 0),
    )
}

/// Mean milliseconds of each stage per step.
fn stage_table(rows: &[BenchRow]) -> String {
    let mut text = String::from("\nmean per step, ms\n");
    let _ = write!(text, "{:<12}", "stage");
    for row in rows {
        let _ = write!(text, " {:>16}", row.samples);
    }
    text.push('\n');
    let stages = rows.first().map_or(&[][..], |row| &row.stages_ms);
    for (k, (name, _)) in stages.iter().enumerate() {
        let _ = write!(text, "{name:<12}");
        for row in rows {
            let cell = with_floors(Some(row.stages_ms[k].1), row.timings_ms.floor);
            let _ = write!(text, " {cell:>16}");
        }
        text.push('\n');
    }
    text
}

/// The head of a column, the digits of its figures, and their value.
type GroundColumn = (&'static str, usize, fn(&GroundTimings) -> f64);

/// Parts that are made before a height can be asked for.
const BAKE_COLUMNS: [GroundColumn; 10] = [
    ("base ms", 0, |ground| ground.base_mesh_ms),
    ("frame ms", 0, |ground| ground.frame_ms),
    ("terrain ms", 1, |ground| ground.terrain_ms),
    ("climate ms", 1, |ground| ground.climate_ms),
    ("drainage ms", 1, |ground| ground.drainage_ms),
    ("control ms", 1, |ground| ground.control_ms),
    ("bake ms", 0, |ground| ground.bake_ms),
    ("ground ms", 0, |ground| ground.ground_ms),
    ("wait ms", 0, |ground| ground.wait_ms),
    ("first wait ms", 0, |ground| ground.first_wait_ms),
];

/// Costs of heights.
const QUERY_COLUMNS: [GroundColumn; 4] = [
    ("vertices", 0, |ground| ground.vertices as f64),
    ("fresh us", 1, |ground| ground.fresh_us),
    ("near us", 1, |ground| ground.near_us),
    ("collider ms", 1, |ground| ground.collider_ms),
];

/// Two tables with a line for each row that has a ground.
fn ground_tables(rows: &[BenchRow]) -> String {
    ground_table(rows, &BAKE_COLUMNS) + &ground_table(rows, &QUERY_COLUMNS)
}

fn ground_table(rows: &[BenchRow], columns: &[GroundColumn]) -> String {
    let mut text = format!("\n{:>9}", "samples");
    for (head, ..) in columns {
        let _ = write!(text, " {head:>14}");
    }
    text.push('\n');
    for row in rows {
        let Some(ground) = &row.ground else { continue };
        let _ = write!(text, "{:>9}", row.samples);
        for &(_, digits, value) in columns {
            let _ = write!(text, " {:>14.digits$}", value(ground));
        }
        text.push('\n');
    }
    text
}

/// A number with so many digits, or a dash where there is none.
fn rounded(value: Option<f64>, digits: usize) -> String {
    value.map_or("-".into(), |value| format!("{value:.digits$}"))
}

/// Milliseconds, and how many floors they are.
fn with_floors(ms: Option<f64>, floor: Option<f64>) -> String {
    match (ms, floor.filter(|&floor| floor > 0.0)) {
        (Some(ms), Some(floor)) => format!("{ms:.2} ({:.1})", ms / floor),
        (Some(ms), None) => format!("{ms:.2}"),
        (None, _) => "-".into(),
    }
}
