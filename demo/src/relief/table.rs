//! The figures as three tables: relief, fabric, and shares of geomorphons.

use super::figures::ReliefFigures;
use bevy_pangaea::relief_stats::Geomorphon;
use std::fmt::Write;

/// Width of a geomorphon's column: the longest names are cut.
const FORM_WIDTH: usize = 5;

/// The tables, with an empty line between them.
pub(super) fn tables(classes: &[ReliefFigures], tiles: &[ReliefFigures]) -> String {
    let rows: Vec<&ReliefFigures> = classes.iter().chain(tiles).collect();
    [relief_table(&rows), fabric_table(&rows), form_table(&rows)].join("\n")
}

fn relief_table(rows: &[&ReliefFigures]) -> String {
    let mut text = format!(
        "{:<24} {:>5} {:>18} {:>14} {:>18}\n",
        "", "sites", "relief in 10 km, m", "slope p90, deg", "spectral exponent"
    );
    for row in rows {
        let _ = writeln!(
            text,
            "{:<24} {:>5} {:>18} {:>14} {:>18}",
            row.name,
            row.sites,
            cell(row.relief10_median_m, 0),
            cell(row.slope_p90_deg, 1),
            cell(row.spectral_exponent, 2)
        );
    }
    text
}

/// Figures of the fabric, and the distance to the tile whose geomorphons are most alike.
fn fabric_table(rows: &[&ReliefFigures]) -> String {
    let mut text = format!(
        "{:<24} {:>9} {:>5} {:>10} {:>7}  distance, nearest tile\n",
        "", "coherence", "p90", "slope-area", "pits, %"
    );
    for row in rows {
        let _ = writeln!(
            text,
            "{:<24} {:>9} {:>5} {:>10} {:>7}  {}",
            row.name,
            cell(row.coherence_median, 2),
            cell(row.coherence_p90, 2),
            cell(row.slope_area_exponent, 2),
            cell(row.pits_percent, 2),
            nearest(row)
        );
    }
    text
}

/// Shares of the geomorphons in %.
fn form_table(rows: &[&ReliefFigures]) -> String {
    let mut text = format!("{:<24}", "geomorphons, %");
    for form in Geomorphon::ALL {
        let _ = write!(text, " {:>FORM_WIDTH$.FORM_WIDTH$}", form.name());
    }
    text.push('\n');
    for row in rows {
        let _ = write!(text, "{:<24}", row.name);
        for form in Geomorphon::ALL {
            let percent = row.geomorphons.map(|shares| 100.0 * shares.share(form));
            let _ = write!(text, " {:>FORM_WIDTH$}", cell(percent, 1));
        }
        text.push('\n');
    }
    text
}

fn nearest(row: &ReliefFigures) -> String {
    row.nearest.as_ref().map_or("-".into(), |nearest| {
        format!("{:.3} {}", nearest.distance, nearest.name)
    })
}

/// A figure with so many digits, or a dash where there is none.
fn cell(value: Option<f64>, digits: usize) -> String {
    value.map_or("-".into(), |value| format!("{value:.digits$}"))
}
