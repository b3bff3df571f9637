//! `pangaea export`: a square of the ground as a file.

use crate::cli::ExportArgs;
use crate::error::CliError;
use crate::ground::open_ground;
use crate::output::{check_file, say};
use bevy_pangaea::io::export::{self as squares, Format};
use bevy_pangaea::query::{AzimuthalEquidistant, Ground, Square};

/// Runs the command.
pub fn export(args: &ExportArgs) -> Result<(), CliError> {
    // Refused before a planet is loaded: a wrong name, and a place where no file can be.
    let format = Format::of(&args.out)?;
    format.check(args.pixels as usize)?;
    check_file(&args.out)?;
    if format == Format::Grey {
        check_file(&args.out.with_extension("json"))?;
    }
    let ground = open_ground(&args.planet)?;
    let middle = args.region.middle;
    let projection = AzimuthalEquidistant::new(middle.lat, middle.lon, ground.radius_m())?;
    let square = Square::new(projection, 1000.0 * args.region.size_km, args.pixels as usize)?;
    for path in squares::export(&ground, &square, &args.out)? {
        say(&path.display().to_string());
    }
    Ok(())
}
