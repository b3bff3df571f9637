//! Options of the commands about whole planets: `generate`, `bench`, `info`.

use super::climate::ClimateArgs;
use super::recipe::{GrowthArgs, ThreadsArgs};
use crate::values::{SampleCounts, sample_counts};
use clap::Args;
use std::path::PathBuf;

/// Options of `generate`.
#[derive(Args, Debug)]
pub struct GenerateArgs {
    /// How to grow the planet.
    #[command(flatten)]
    pub growth: GrowthArgs,
    /// Maps that replace fields of the climate.
    #[command(flatten)]
    pub climate: ClimateArgs,
    /// Folder for the files; it is made if it does not exist
    #[arg(long, value_name = "DIR", default_value = "pangaea-out")]
    pub out: PathBuf,
}

/// Options of `bench`.
#[derive(Args, Debug)]
pub struct BenchArgs {
    /// Numbers of samples, separated by commas
    #[arg(
        long,
        value_name = "N,N,..",
        default_value = "60000,100000,250000,500000",
        allow_hyphen_values = true,
        value_parser = sample_counts
    )]
    pub samples: SampleCounts,
    /// Write the timings to a JSON file, too
    #[arg(long, value_name = "F")]
    pub json: Option<PathBuf>,
    /// Threads to measure.
    #[command(flatten)]
    pub threads: ThreadsArgs,
}

/// Options of `info`.
#[derive(Args, Debug)]
pub struct InfoArgs {
    /// A planet file, *.pangaea
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
}
