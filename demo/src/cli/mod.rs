//! The command line.
//!
//! ```text
//! recipe     a planet at time 0, how it grows, on how many threads
//! climate    maps that replace fields of the climate
//! ground     export, relief, query
//! planets    generate, maps, bench, info
//! pictures   render, views
//! ```

mod recipe;

mod climate;

mod height_field;

mod ground;

mod planets;

mod pictures;

pub use ground::{ExportArgs, QueryArgs, ReliefArgs};
pub use pictures::{RenderArgs, ViewsArgs};
pub use planets::{BenchArgs, GenerateArgs, InfoArgs, MapsArgs};
pub use recipe::GrowthArgs;

use self::recipe::RecipeArgs;
use crate::values::frames;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Grows planets: plates drift, collide, subduct, rift and make new ocean floor.
///
/// Without a command the explorer opens in a window.
///
/// Whether files can be written is tried before the work begins, and all files of a command are
/// written or none. A file that an option names replaces an older one, which keeps its mode; links
/// stay links. Files whose names follow from it, in a folder or beside it, replace only what Pangaea
/// made: any other file of such a name is refused. So is a file that the command reads.
#[derive(Parser, Debug)]
#[command(
    name = "pangaea",
    version,
    max_term_width = 100,
    args_conflicts_with_subcommands = true
)]
pub struct Cli {
    /// How the explorer starts.
    #[command(flatten)]
    pub start: StartArgs,
    /// Open the explorer for this many frames only
    #[arg(long, hide = true, value_name = "N", value_parser = frames)]
    pub frames: Option<u32>,
    /// Write a picture of the last of those frames
    #[arg(long, hide = true, value_name = "F.png", requires = "frames")]
    pub capture: Option<PathBuf>,
    /// The command; without one the explorer opens.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// The planet that the explorer opens with.
#[derive(Args, Debug, Default, Clone)]
pub struct StartArgs {
    /// A planet file to open instead of growing a planet, or maps, as `pangaea maps` takes them
    #[arg(
        long,
        value_name = "PLANET.pangaea",
        conflicts_with_all = ["seed", "samples", "plates", "land", "preset"]
    )]
    pub open: Option<PathBuf>,
    /// The planet to grow.
    #[command(flatten)]
    pub recipe: RecipeArgs,
}

/// The commands.
#[derive(Subcommand, Debug)]
pub enum Command {
    /// Grow a planet and write it, its maps and its figures into a folder
    Generate(GenerateArgs),
    /// Draw equirectangular maps of a planet file: what `generate` draws, in any size
    Maps(MapsArgs),
    /// Render a picture of the globe
    Render(RenderArgs),
    /// Render the globe from eight sides, as `demo/run` does where there is no display
    Views(ViewsArgs),
    /// Measure how fast this machine grows planets
    Bench(BenchArgs),
    /// Print the facts of a planet file, or write its commands as a scenario
    Info(InfoArgs),
    /// Write the ground of a square, of tiles or of a box of degrees: GeoTIFF, EXR, 16-bit greys,
    /// mesh
    Export(ExportArgs),
    /// Print relief statistics by what built the relief, beside those of real ground
    ///
    /// Three tables, whose figures are medians over the sites of a class. Relief: range of the
    /// elevation in windows of 10 km, slope that a tenth of the ground exceeds, exponent of the
    /// power spectrum. Fabric: coherence of the gradient in windows of 5.93 km, 0 to 1, and its
    /// 90th percentile; exponent of slope ~ area^-x; cells lower than all their neighbours; the
    /// tile of --dem whose forms are most alike, by Jensen-Shannon distance, 0 to 1. Forms: mean
    /// shares of the ten geomorphons, 20 cells around, 1 degree. Fabric and forms are those of
    /// cells of 92.6 m; a dash stands for a figure that the ground does not have.
    Relief(ReliefArgs),
    /// Print height, water, normal and surface of points of the ground
    Query(QueryArgs),
}

impl Command {
    /// Number of threads that is asked for.
    pub fn threads(&self) -> Option<usize> {
        match self {
            Self::Generate(args) => args.growth.threads.threads,
            Self::Render(args) => args.growth.threads.threads,
            Self::Views(args) => args.growth.threads.threads,
            Self::Bench(args) => args.threads.threads,
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests;
