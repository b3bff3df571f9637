//! Options of the commands that draw globes: `render` and `views`.

use super::climate::ClimateArgs;
use super::recipe::GrowthArgs;
use crate::values::{CameraSpec, camera, colours, edge_pixels, overlay, size};
use bevy_pangaea::amplification::GroundColours;
use bevy_pangaea::overlay::Overlay;
use clap::Args;
use std::path::PathBuf;

/// Options of `render`.
#[derive(Args, Debug)]
pub struct RenderArgs {
    /// A planet file, or maps, as `pangaea maps` takes them; without one a planet is grown by the
    /// options below
    #[arg(
        value_name = "PLANET.pangaea",
        conflicts_with_all = ["seed", "samples", "plates", "land", "until", "preset", "scenario"]
    )]
    pub planet: Option<PathBuf>,
    /// How to grow the planet.
    #[command(flatten)]
    pub growth: GrowthArgs,
    /// Maps that replace fields of the climate.
    #[command(flatten)]
    pub climate: ClimateArgs,
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
    /// Overlay of the globe, elevation unless given: elevation, plates, crust_type, ocean_age, thickness, orogeny_type, orogeny_age,
    /// fold_direction, ridge_direction, velocity, slope, laplacian, vector_noise, mesh,
    /// temperature, rain, wetness, drainage (discharge in m³/s), rivers (by order), basins or lakes
    ///
    /// Without an overlay a camera below 1000 km sees the amplified ground, down to half a metre.
    #[arg(long, value_name = "NAME", value_parser = overlay)]
    pub overlay: Option<Overlay>,
    /// Colours of the ground: natural, level (blue where coarse, red where fine) or kind (sea, coast,
    /// river, lake, gully)
    #[arg(
        long,
        value_name = "NAME",
        default_value = "natural",
        conflicts_with = "overlay",
        value_parser = colours
    )]
    pub colours: GroundColours,
    /// Draws the edges of the ground's triangles
    #[arg(long, conflicts_with = "overlay")]
    pub wireframe: bool,
    /// Edges of the ground's triangles in pixels, 1 to 64; in large pictures no finer than 2.5 million
    /// triangles allow
    #[arg(
        long,
        value_name = "N",
        default_value = "4",
        conflicts_with = "overlay",
        value_parser = edge_pixels
    )]
    pub pixels: f32,
    /// Size of the picture in pixels, each side 16 to 8192
    #[arg(
        long,
        value_name = "WxH",
        default_value = "1280x720",
        allow_hyphen_values = true,
        value_parser = size
    )]
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
    ///
    /// They are orbit-1.png to orbit-6.png, orbit-7-north.png and orbit-8-south.png.
    #[arg(long, value_name = "DIR", default_value = "pangaea-views")]
    pub out: PathBuf,
}
