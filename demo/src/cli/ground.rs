//! Options of the commands about the ground of a planet file: `export`, `relief`, `query`.

use super::climate::ClimateArgs;
use super::height_field::HeightFieldArgs;
use crate::values::{
    BoxSpec, PixelsSpec, PlaceSpec, RangeSpec, RegionSpec, TilesSpec, degree_box, height_range,
    level, pixels, place, region, sites, tiles,
};
use bevy_pangaea::io::planet_files;
use clap::{ArgGroup, Args};
use std::path::PathBuf;

/// The planet whose ground is asked for.
#[derive(Args, Debug)]
pub struct GroundArgs {
    /// A planet file: a save *.pangaea, or maps, *.terrain.ron or the elevation as .tif or .png
    ///
    /// A terrain file names the maps that a planet is made of, in RON: (elevation: "earth.tif",
    /// unit: metres, radius: 6370, seed: 0, rain: "rain.tif"). All but the elevation may be left
    /// out; others are age (of the last orogeny, in My), plateaus and hills (0 to 1), temperature
    /// and wetness. Names of files count from its folder. The elevation is in metres unless the
    /// unit is kilometres, 0 at the sea, and has no voids. A map in its place is the elevation in
    /// metres; a grey .png without a sidecar NAME.json {"min", "max"} reaches from -12 to 12 km.
    #[arg(value_name = "PLANET.pangaea")]
    pub planet: PathBuf,
    /// Maps that replace fields of the climate.
    #[command(flatten)]
    pub climate: ClimateArgs,
}

impl GroundArgs {
    /// The files of the planet and its maps.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        planet_files(&self.planet)
            .into_iter()
            .chain(self.climate.files())
    }
}

/// Options of `export`.
#[derive(Args, Debug)]
#[command(group(ArgGroup::new("area").required(true).args(["region", "degrees"])))]
pub struct ExportArgs {
    /// The planet.
    #[command(flatten)]
    pub ground: GroundArgs,
    /// Heights of the user's own at a place.
    #[command(flatten)]
    pub field: HeightFieldArgs,
    /// Middle of the square in degrees, and its side in km; with --tiles, the side of one tile
    ///
    /// The square is azimuthal equidistant about its middle, north up; values are those of the
    /// centres of pixels.
    #[arg(long, value_name = "LAT,LON,SIZE_KM", allow_hyphen_values = true, value_parser = region)]
    pub region: Option<RegionSpec>,
    /// A box in degrees instead of a square: equally many degrees to every pixel
    ///
    /// Where WEST is greater than EAST, it goes across the date line; -90,-180,90,180 is the whole
    /// planet. Not for .glb.
    #[arg(
        long = "box",
        id = "degrees",
        value_name = "SOUTH,WEST,NORTH,EAST",
        allow_hyphen_values = true,
        value_parser = degree_box
    )]
    pub degrees: Option<BoxSpec>,
    /// Pixels to a side, 2 to 16384; 8192 for .glb. Of a box, columns, or COLUMNSxROWS
    #[arg(
        long,
        value_name = "N",
        default_value = "1024",
        allow_hyphen_values = true,
        value_parser = pixels
    )]
    pub pixels: PixelsSpec,
    /// Tiles that share their edges, as game engines join them: a block with its middle in that of
    /// --region, in one projection
    ///
    /// Written are TILE_COLUMN_ROW.EXT, counted from 0 in the north west, each with --pixels
    /// vertices to a side (2^n+1 for Unity; 505, 1009, 2017 for Unreal), the outer ones on its
    /// edges; and TILE.json, which tells ranges, sea level, and the place and scale of every tile
    /// in Unreal, Unity, Godot and Blender.
    #[arg(
        long,
        value_name = "COLUMNSxROWS",
        allow_hyphen_values = true,
        value_parser = tiles,
        conflicts_with = "degrees"
    )]
    pub tiles: Option<TilesSpec>,
    /// Heights in m of black and white in .png, .r16 and .raw [default: lowest and highest of all
    /// that is exported]
    ///
    /// Higher and lower ground is cut off, which is said.
    #[arg(
        long,
        value_name = "LOW,HIGH",
        allow_hyphen_values = true,
        value_parser = height_range
    )]
    pub range: Option<RangeSpec>,
    /// Level of detail, 0 (edges of about 52 km) to 17 (0.4 m) [default: the one whose edges fit
    /// the pixels]
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = level)]
    pub level: Option<u8>,
    /// The file; its extension says in which format
    ///
    /// .tif: one band of f32 in metres, georeferenced. .exr: f32 in metres. .png, .r16, .raw:
    /// 16-bit grey, the latter two little endian without a header, with a .json of the same name to
    /// decode it: min_m, max_m, metres_per_pixel, lat, lon. .glb: a mesh in metres, +x east, +y up,
    /// -z north.
    #[arg(long, value_name = "TILE.png|.tif|.exr|.r16|.raw|.glb")]
    pub out: PathBuf,
}

/// Options of `relief`.
#[derive(Args, Debug)]
pub struct ReliefArgs {
    /// The planet.
    #[command(flatten)]
    pub ground: GroundArgs,
    /// Folder of tiles of real ground to compare with
    ///
    /// Files are .hgt, as they are or in .hgt.zip and .hgt.gz, GeoTIFF, or grey PNG with a sidecar
    /// NAME.json {metres_per_pixel, metres_per_unit}, or min_m and max_m for black and white. Others,
    /// such as previews and tiles of voids, are passed over with a warning. Tiles of more than 16
    /// million pixels count by the means of their blocks, which is said.
    #[arg(long, value_name = "DIR")]
    pub dem: Option<PathBuf>,
    /// Most sites of a class, 1 to 20
    #[arg(long, value_name = "N", default_value = "20", value_parser = sites)]
    pub sites: usize,
    /// Write the figures to a JSON file, too
    #[arg(long, value_name = "F")]
    pub json: Option<PathBuf>,
}

/// Options of `query`.
#[derive(Args, Debug)]
pub struct QueryArgs {
    /// The planet.
    #[command(flatten)]
    pub ground: GroundArgs,
    /// Heights of the user's own at a place.
    #[command(flatten)]
    pub field: HeightFieldArgs,
    /// The point in degrees; without it, lines "lat,lon" are read from the standard input
    ///
    /// Printed are comma separated values with a header, in the order of the input. Lines are
    /// answered as they come, and up to the first wrong one, which ends the command. The normal is
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
        value_parser = level
    )]
    pub level: u8,
}
