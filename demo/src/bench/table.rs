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
    text + &stage_table(rows) + &ground_table(rows)
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

/// A line for each row that has a ground.
fn ground_table(rows: &[BenchRow]) -> String {
    let mut text = format!(
        "\n{:>9} {:>9} {:>10} {:>10} {:>11} {:>8} {:>9} {:>9} {:>9} {:>12}\n",
        "samples",
        "vertices",
        "base ms",
        "climate ms",
        "drainage ms",
        "bake ms",
        "ground ms",
        "fresh us",
        "near us",
        "collider ms"
    );
    for row in rows {
        if let Some(ground) = &row.ground {
            text += &ground_line(row.samples, ground);
        }
    }
    text
}

fn ground_line(samples: u32, ground: &GroundTimings) -> String {
    format!(
        "{samples:>9} {:>9} {:>10.0} {:>10.1} {:>11.1} {:>8.0} {:>9.0} {:>9.1} {:>9.1} {:>12.1}\n",
        ground.vertices,
        ground.base_mesh_ms,
        ground.climate_ms,
        ground.drainage_ms,
        ground.bake_ms,
        ground.ground_ms,
        ground.fresh_us,
        ground.near_us,
        ground.collider_ms,
    )
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
