//! The command line.

use crate::climate::ClimateArgs;
use crate::error::CliError;
pub use crate::values::{CameraSpec, PlaceSpec, RegionSpec};
use crate::values::{Counts, camera, counts, integer, number, overlay, place, region, size};
use bevy_pangaea::io::load_preset;
use bevy_pangaea::overlay::Overlay;
use bevy_pangaea::planet::PlanetRecipe;
use clap::{Args, Parser, Subcommand};
use std::path::PathBuf;

/// Grows planets: plates drift, collide, subduct, rift and make new ocean floor.
///
/// Without a command the explorer opens in a window.
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
    #[arg(long, hide = true, value_name = "N", value_parser = |s: &str| integer(s, 1, 1_000_000))]
    pub frames: Option<u64>,
    /// Write a picture of the last of those frames
    #[arg(long, hide = true, value_name = "F.png", requires = "frames")]
    pub capture: Option<PathBuf>,
    /// What to do.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// What the explorer opens with.
#[derive(Args, Debug, Default, Clone)]
pub struct StartArgs {
    /// A planet file to open instead of growing a planet
    #[arg(long, value_name = "PLANET.pangaea", conflicts_with_all = ["seed", "samples", "plates", "land", "preset"])]
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
    /// Render a picture of the globe
    Render(RenderArgs),
    /// Render the globe from eight sides, as `demo/run` does where there is no display
    Views(ViewsArgs),
    /// Measure how fast this machine grows planets
    Bench(BenchArgs),
    /// Print the facts of a planet file
    Info(InfoArgs),
    /// Write the height of a square of the ground: GeoTIFF, 16-bit PNG or a mesh
    Export(ExportArgs),
    /// Print relief statistics by what built the relief, beside those of real ground
    Relief(ReliefArgs),
    /// Print height, water, normal and surface of points of the ground
    Query(QueryArgs),
}

/// The planet at time 0. An option given here replaces what the preset says.
#[derive(Args, Debug, Default, Clone)]
pub struct RecipeArgs {
    /// Seed of everything random [default: 1]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = |s: &str| integer(s, 0, u64::MAX))]
    pub seed: Option<u64>,
    /// Number of samples of the sphere, 100 to 2,000,000 [default: 60000]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = |s: &str| integer(s, 100, 2_000_000))]
    pub samples: Option<u64>,
    /// Number of initial plates, 2 to 1000 [default: 40]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = |s: &str| integer(s, 2, 1000))]
    pub plates: Option<u64>,
    /// Share of land, 0 to 0.9 [default: 0.3]
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true, value_parser = |s: &str| number(s, 0.0, 0.9))]
    pub land: Option<f64>,
    /// Recipe of the planet, *.planet.ron
    #[arg(long, value_name = "FILE")]
    pub preset: Option<PathBuf>,
}

impl RecipeArgs {
    /// The recipe that preset and options make together, checked.
    ///
    /// # Errors
    /// A preset that cannot be read, or a number that is refused.
    pub fn checked(&self) -> Result<PlanetRecipe, CliError> {
        let mut recipe = match &self.preset {
            Some(path) => load_preset(path)?,
            None => PlanetRecipe::default(),
        };
        if let Some(seed) = self.seed {
            recipe.seed = seed;
        }
        if let Some(samples) = self.samples {
            recipe.samples = samples as u32;
        }
        if let Some(plates) = self.plates {
            if !recipe.plates.is_empty() {
                return Err(CliError::input(
                    "--plates cannot be used with a preset that lists its plates",
                ));
            }
            recipe.plate_count = plates as u32;
        }
        if let Some(land) = self.land {
            if !recipe.continents.is_empty() {
                return Err(CliError::input(
                    "--land cannot be used with a preset that lists its continents",
                ));
            }
            recipe.land = land;
        }
        recipe.validate()?;
        Ok(recipe)
    }
}

/// How to grow a planet.
#[derive(Args, Debug, Default, Clone)]
pub struct GrowthArgs {
    /// The planet at time 0.
    #[command(flatten)]
    pub recipe: RecipeArgs,
    /// Geological time to simulate in My, rounded up to whole steps [default: 250]
    #[arg(long, value_name = "MY", allow_hyphen_values = true, value_parser = |s: &str| number(s, 0.1, 10_000.0))]
    pub until: Option<f64>,
    /// Commands to carry out while the planet grows, *.scenario.ron
    #[arg(long, value_name = "FILE")]
    pub scenario: Option<PathBuf>,
    /// Number of threads [default: one per core]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = |s: &str| integer(s, 1, 1024))]
    pub threads: Option<u64>,
}

impl GrowthArgs {
    /// Geological time to simulate in My where `--until` is not given.
    pub const UNTIL: f64 = 250.0;

    /// Geological time to simulate in My.
    pub fn until(&self) -> f64 {
        self.until.unwrap_or(Self::UNTIL)
    }
}

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

/// Options of `render`.
#[derive(Args, Debug)]
pub struct RenderArgs {
    /// A planet file; without one a planet is grown by the options below
    #[arg(
        value_name = "PLANET.pangaea",
        conflicts_with_all = ["seed", "samples", "plates", "land", "until", "preset", "scenario"]
    )]
    pub planet: Option<PathBuf>,
    /// How to grow the planet.
    #[command(flatten)]
    pub growth: GrowthArgs,
    /// Where the camera stands and looks: degrees, degrees, metres above the sea; heading and pitch
    /// in degrees
    ///
    /// Without heading and pitch it looks straight down, north up. Heading 90 is east, pitch 0 the
    /// horizon, pitch -90 straight down.
    #[arg(
        long,
        value_name = "LAT,LON,ALTITUDE_M[,HEADING,PITCH]",
        default_value = "20,0,20000000",
        allow_hyphen_values = true,
        value_parser = camera
    )]
    pub camera: CameraSpec,
    /// Overlay: elevation, plates, crust_type, ocean_age, thickness, orogeny_type, orogeny_age,
    /// fold_direction, ridge_direction, velocity, slope, laplacian, vector_noise, mesh,
    /// temperature, rain, wetness, drainage (discharge in m³/s), rivers (by order), basins or lakes
    #[arg(long, value_name = "NAME", default_value = "elevation", value_parser = overlay)]
    pub overlay: Overlay,
    /// Size of the picture in pixels, each side 16 to 8192
    #[arg(long, value_name = "WxH", default_value = "1280x720", allow_hyphen_values = true, value_parser = size)]
    pub size: (u32, u32),
    /// The picture, a PNG file
    #[arg(long, value_name = "F.png")]
    pub out: PathBuf,
}

/// Options of `views`.
#[derive(Args, Debug)]
pub struct ViewsArgs {
    /// How to grow the planet.
    #[command(flatten)]
    pub growth: GrowthArgs,
    /// Folder for the pictures; it is made if it does not exist
    #[arg(long, value_name = "DIR", default_value = "pangaea-views")]
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
        value_parser = counts
    )]
    pub samples: Counts,
    /// Write the timings to a JSON file, too
    #[arg(long, value_name = "F")]
    pub json: Option<PathBuf>,
    /// Number of threads [default: one per core]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = |s: &str| integer(s, 1, 1024))]
    pub threads: Option<u64>,
}

/// Options of `info`.
#[derive(Args, Debug)]
pub struct InfoArgs {
    /// A planet file, *.pangaea
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
}

/// Options of `export`.
#[derive(Args, Debug)]
pub struct ExportArgs {
    /// A planet file, *.pangaea
    #[arg(value_name = "PLANET.pangaea")]
    pub planet: PathBuf,
    /// Maps that replace fields of the climate.
    #[command(flatten)]
    pub climate: ClimateArgs,
    /// Middle of the square in degrees, and its side in km
    ///
    /// The square is azimuthal equidistant about its middle, north up; values are those of the
    /// centres of pixels.
    #[arg(long, value_name = "LAT,LON,SIZE_KM", allow_hyphen_values = true, value_parser = region)]
    pub region: RegionSpec,
    /// Pixels to a side, 2 to 16384; 8192 for .glb
    #[arg(
        long,
        value_name = "N",
        default_value = "1024",
        allow_hyphen_values = true,
        value_parser = |s: &str| integer(s, 2, 16_384)
    )]
    pub pixels: u64,
    /// Level of detail, 0 (edges of about 52 km) to 17 (0.4 m) [default: the one whose edges fit
    /// the pixels]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = |s: &str| integer(s, 0, 17))]
    pub level: Option<u64>,
    /// The file; its extension says in which format
    ///
    /// .tif: one band of f32 in metres, georeferenced. .png: 16-bit grey, with a .json of the same
    /// name to decode it: min_m, max_m, metres_per_pixel, lat, lon. .glb: a mesh in metres, +x
    /// east, +y up, -z north.
    #[arg(long, value_name = "TILE.png|TILE.tif|TILE.glb")]
    pub out: PathBuf,
}

/// Options of `relief`.
#[derive(Args, Debug)]
pub struct ReliefArgs {
    /// A planet file, *.pangaea
    #[arg(value_name = "PLANET.pangaea")]
    pub planet: PathBuf,
    /// Maps that replace fields of the climate.
    #[command(flatten)]
    pub climate: ClimateArgs,
    /// Folder of tiles of real ground to compare with
    ///
    /// Files are .hgt, GeoTIFF, or 16-bit PNG with a sidecar NAME.json {metres_per_pixel,
    /// metres_per_unit}.
    #[arg(long, value_name = "DIR")]
    pub dem: Option<PathBuf>,
    /// Most sites of a class, 1 to 20
    #[arg(long, value_name = "N", default_value = "20", value_parser = |s: &str| integer(s, 1, 20))]
    pub sites: u64,
    /// Write the figures to a JSON file, too
    #[arg(long, value_name = "F")]
    pub json: Option<PathBuf>,
}

/// Options of `query`.
#[derive(Args, Debug)]
pub struct QueryArgs {
    /// A planet file, *.pangaea
    #[arg(value_name = "PLANET.pangaea")]
    pub planet: PathBuf,
    /// Maps that replace fields of the climate.
    #[command(flatten)]
    pub climate: ClimateArgs,
    /// The point in degrees; without it, lines "lat,lon" are read from the standard input
    ///
    /// Printed are comma separated values with a header, in the order of the input. The normal is
    /// given in the planet's axes: +z is the north pole, +x is 0° N 0° E. Where it is dry, water_m
    /// is height_m.
    #[arg(long, value_name = "LAT,LON", allow_hyphen_values = true, value_parser = place)]
    pub at: Option<PlaceSpec>,
    /// Level of detail, 0 (edges of about 52 km) to 17 (0.4 m)
    #[arg(
        long,
        value_name = "N",
        default_value = "17",
        allow_hyphen_values = true,
        value_parser = |s: &str| integer(s, 0, 17)
    )]
    pub level: u64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn the_explorer_and_the_commands_take_the_same_recipe() {
        let options = [
            "--seed",
            "7",
            "--samples",
            "500",
            "--plates",
            "9",
            "--land",
            "0.5",
        ];
        let started = Cli::try_parse_from(["pangaea"].into_iter().chain(options))
            .unwrap()
            .start;
        let line = ["pangaea", "generate", "--until", "20"]
            .into_iter()
            .chain(options);
        let Some(Command::Generate(args)) = Cli::try_parse_from(line).unwrap().command else {
            panic!()
        };
        let recipe = args.growth.recipe.checked().unwrap();
        assert_eq!(
            (recipe.seed, recipe.samples, recipe.plate_count, recipe.land),
            (7, 500, 9, 0.5)
        );
        assert_eq!(
            (started.recipe.checked().unwrap(), args.growth.until()),
            (recipe, 20.0)
        );
        assert!(Cli::try_parse_from(["pangaea", "--open", "a.pangaea", "--seed", "7"]).is_err());
    }

    #[test]
    fn negative_coordinates_are_accepted() {
        for line in [
            ["--camera=-33,-70,1e6", "--out=a.png"],
            ["--out=a.png", "--camera=-33,-70,1e6"],
        ] {
            assert!(Cli::try_parse_from(["pangaea", "render"].into_iter().chain(line)).is_ok());
        }
        let line = [
            "pangaea",
            "render",
            "--camera",
            "-33,-70,1000000,90,-10",
            "--out",
            "a.png",
        ];
        let Some(Command::Render(args)) = Cli::try_parse_from(line).unwrap().command else {
            panic!()
        };
        assert_eq!((args.camera.lat, args.camera.lon), (-33.0, -70.0));
    }

    #[test]
    fn places_in_the_south_and_west_are_accepted_in_both_forms() {
        let south = PlaceSpec {
            lat: -33.0,
            lon: -70.0,
        };
        for at in [&["--at=-33,-70"][..], &["--at", "-33,-70"]] {
            let line = [&["pangaea", "query", "a.pangaea"], at].concat();
            let Some(Command::Query(args)) = Cli::try_parse_from(line).unwrap().command else {
                panic!()
            };
            assert_eq!((args.at, args.level), (Some(south), 17));
        }
        for region in [&["--region=-33,-70,12"][..], &["--region", "-33,-70,12"]] {
            let line = [
                &["pangaea", "export", "a.pangaea", "--out", "a.tif"],
                region,
            ]
            .concat();
            let Some(Command::Export(args)) = Cli::try_parse_from(line).unwrap().command else {
                panic!()
            };
            assert_eq!(
                (args.region.middle, args.region.size_km, args.pixels),
                (south, 12.0, 1024)
            );
        }
    }

    #[test]
    fn the_help_names_every_overlay_and_the_true_defaults() {
        let mut help = Cli::command();
        let render = help
            .find_subcommand_mut("render")
            .unwrap()
            .render_long_help()
            .to_string();
        assert!(
            Overlay::ALL
                .iter()
                .all(|overlay| render.contains(overlay.name())),
            "{render}"
        );
        let recipe = PlanetRecipe::default();
        for text in [
            format!("[default: {}]", recipe.seed),
            format!("[default: {}]", recipe.samples),
            format!("[default: {}]", recipe.plate_count),
            format!("[default: {}]", recipe.land),
            format!("[default: {}]", GrowthArgs::UNTIL),
        ] {
            assert!(render.contains(&text), "{text}");
        }
    }
}
