//! `pangaea export`: a square of the ground as a file.

use crate::cli::ExportArgs;
use crate::error::CliError;
use crate::ground::{bake_planet, ground};
use crate::interrupt;
use crate::output::say;
use crate::progress;
use bevy_pangaea::io::export::{ExportFormat, encode, outputs};
use bevy_pangaea::io::{check_outputs, load, write_all};
use bevy_pangaea::query::{AzimuthalEquidistant, Ground, GroundError, HeightGrid, MapSquare};

/// Runs the command.
///
/// # Errors
/// If an option or the planet is refused, or the user interrupts it; nothing is written then.
pub fn export(args: &ExportArgs) -> Result<(), CliError> {
    interrupt::watch();
    check_output(args)?;
    let climate = args.ground.climate.load()?;
    let state = load(&args.ground.planet)?;
    let square = square(args, 1000.0 * state.planet.radius)?;
    let ground = ground(&bake_planet(state, climate)?)?;
    say(&format!(
        "level {}, {:.3} m to a pixel",
        square.level(),
        square.pixel_m()
    ));
    let files = encode(&square, &heights(&ground, &square)?, &args.out)?;
    interrupt::check()?;
    write_all(&outputs(&args.out)?, |k, out| out.write_all(&files[k].1))?;
    for (path, _) in files {
        say(&path.display().to_string());
    }
    Ok(())
}

/// Refuses a name without a format and a place where no file can be, before a planet is loaded.
fn check_output(args: &ExportArgs) -> Result<(), CliError> {
    ExportFormat::of(&args.out)?.check(args.pixels)?;
    Ok(check_outputs(&outputs(&args.out)?)?)
}

/// The heights of the square, with a progress bar.
fn heights(ground: &impl Ground, square: &MapSquare) -> Result<HeightGrid, CliError> {
    let bar = progress::bar(square.pixels() as u64, "rows", "amplifying");
    let heights = square.heights_while(ground, square.level(), |pixels| {
        bar.set_position((pixels / square.pixels()) as u64);
        interrupt::check().is_ok()
    });
    bar.finish_and_clear();
    interrupt::check()?;
    Ok(heights?)
}

/// The square that is asked for, on a planet of `radius_m`.
fn square(args: &ExportArgs, radius_m: f64) -> Result<MapSquare, CliError> {
    let middle = args.region.middle;
    let projection = AzimuthalEquidistant::new(middle.lat, middle.lon, radius_m)?;
    let square = MapSquare::new(projection, 1000.0 * args.region.size_km, args.pixels)
        .map_err(|error| in_options(args, error))?;
    match args.level {
        Some(level) => Ok(square.at_level(level)?),
        None => Ok(square),
    }
}

/// Says a refused length in the terms of the options.
fn in_options(args: &ExportArgs, error: GroundError) -> CliError {
    match error {
        GroundError::Length { min, max, .. } => CliError::input(format!(
            "--region: with {} pixels SIZE_KM is {} to {:.0}, not {}",
            args.pixels,
            1e-3 * min,
            1e-3 * max,
            args.region.size_km
        )),
        error => error.into(),
    }
}
