//! `pangaea bench`: how fast this machine grows planets, also in floors: how often all columns
//! could have been read and written in the same time.

mod ground;

mod steps;

mod table;

use crate::cli::BenchArgs;
use crate::error::CliError;
use crate::inputs::Inputs;
use crate::output::{check_file, json, print, say, write_file};

/// Runs the command.
///
/// # Errors
/// If a file for the timings is refused, or a planet cannot be grown.
pub fn bench(args: &BenchArgs) -> Result<(), CliError> {
    if let Some(path) = &args.json {
        check_file(path, &Inputs::new([]))?;
    }
    let mut rows = Vec::new();
    for &samples in &args.samples.0 {
        rows.push(steps::measure(samples)?);
    }
    print(&table::table(&rows))?;
    if let Some(path) = &args.json {
        write_file(path, &json(&rows)?)?;
        say(&format!("timings in {}", path.display()));
    }
    Ok(())
}
