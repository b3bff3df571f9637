//! Options of the commands about whole planets: `generate`, `maps`, `bench`, `info`.

use super::climate::ClimateArgs;
use super::ground::GroundArgs;
use super::recipe::{GrowthArgs, ThreadsArgs};
use crate::values::{SampleCounts, map_width, overlay, sample_counts};
use bevy_pangaea::overlay::Overlay;
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
    ///
    /// planet.pangaea: the planet with the maps of its climate that were given here. elevation.png
    /// and a picture of every overlay: maps, as `pangaea maps` draws them, 2048 pixels wide.
    /// stats.json: its figures.
    #[arg(long, value_name = "DIR", default_value = "pangaea-out")]
    pub out: PathBuf,
    /// Write the commands that were carried out as a scenario, too
    ///
    /// Played on the same recipe for as long, and with the same maps of the climate, it gives the
    /// same planet to the last bit.
    #[arg(long, value_name = "FILE.scenario.ron")]
    pub scenario_out: Option<PathBuf>,
}

/// Options of `maps`.
#[derive(Args, Debug)]
pub struct MapsArgs {
    /// The planet.
    #[command(flatten)]
    pub ground: GroundArgs,
    /// Folder for the maps; it is made if it does not exist
    ///
    /// elevation.png: heights in 16 bits of grey, 0 at -12 km, 65535 at +12 km. OVERLAY.png:
    /// colours; those of the elevation are elevation_color.png. All are equirectangular, north up,
    /// 180° W at the left edge.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// Width of the maps in pixels, even, 16 to 8192; they are half as high
    #[arg(
        long,
        value_name = "W",
        default_value = "2048",
        allow_hyphen_values = true,
        value_parser = map_width
    )]
    pub size: u32,
    /// Overlays to draw, separated by commas [default: all of them]
    ///
    /// Names are those of `render --overlay`. elevation.png is always written.
    #[arg(long, value_name = "NAME,..", value_delimiter = ',', value_parser = overlay)]
    pub overlay: Vec<Overlay>,
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
    /// A planet file: a save *.pangaea, or maps, as `pangaea maps` takes them
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Write all commands of the planet, carried out and to come, as a scenario, too
    ///
    /// Played on the recipe of the planet for as long, and with the same maps of the climate, it
    /// gives the same planet to the last bit.
    #[arg(long, value_name = "FILE.scenario.ron")]
    pub scenario_out: Option<PathBuf>,
}
