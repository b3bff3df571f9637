//! `pangaea query`: the ground at points, as comma separated values.
//!
//! Points are answered as they come: one that comes alone at once, those that are waiting in blocks.
//! The command ends soon after its reader has gone.

mod pace;

pub mod places;

use crate::cli::QueryArgs;
use crate::error::CliError;
use crate::ground::{bake_planet, ground};
use crate::output::{has_reader, print_to};
use crate::source::load_planet;
use crate::values::PlaceSpec;
use bevy_pangaea::query::{FieldGround, Ground, Sample, direction_at};
use pace::Pace;
use places::PlaceQueue;
use std::io::{self, Write};
use std::time::Duration;

const HEADER: &str = "lat,lon,height_m,water_m,normal_x,normal_y,normal_z,surface";

/// How long a line is waited for until it is asked again whether somebody still reads the answers.
const WAIT: Duration = Duration::from_millis(250);

/// Runs the command.
///
/// # Errors
/// If the planet, or a line of the input, is refused; the lines before it are answered.
pub fn query(args: &QueryArgs) -> Result<(), CliError> {
    // Lines are read while the planet is loaded.
    let places = match args.at {
        Some(place) => PlaceQueue::from(place),
        None => PlaceQueue::read(|| io::stdin().lock()),
    };
    let climate = args.ground.climate.load()?;
    let planet = load_planet(&args.ground.planet)?;
    let field = args.field.load(1000.0 * planet.planet.radius)?;
    let ground = ground(&bake_planet(planet, climate)?)?;
    match field {
        Some(field) => {
            let ground = FieldGround::new(ground, field);
            answer(places, &ground, args.level, io::stdout(), has_reader)
        }
        None => answer(places, &ground, args.level, io::stdout(), has_reader),
    }
}

/// Prints a header, and a line for each place, until the places end or nobody reads any more.
fn answer(
    mut places: PlaceQueue,
    ground: &impl Ground,
    level: u8,
    mut out: impl Write,
    is_read: impl Fn() -> bool,
) -> Result<(), CliError> {
    let mut pace = Pace::default();
    // Who talks with the command may wait for the header before the first line, which may be wrong.
    let mut is_open = is_read() && print_to(&mut out, &format!("{HEADER}\n"))?;
    while is_open && is_read() {
        is_open = places.wait(WAIT)?;
        let block = places.arrived(pace.points());
        let text = pace.measure(block.len(), || table(ground, &block, level))?;
        if !text.is_empty() && !print_to(&mut out, &text)? {
            break;
        }
    }
    Ok(())
}

/// A line for each place, in their order.
fn table(ground: &impl Ground, places: &[PlaceSpec], level: u8) -> Result<String, CliError> {
    let directions: Result<Vec<_>, _> = places
        .iter()
        .map(|at| direction_at(at.lat, at.lon))
        .collect();
    let found = ground.samples(&directions?, level)?;
    Ok(places
        .iter()
        .zip(&found)
        .map(|(place, found)| line(place, found))
        .collect())
}

fn line(place: &PlaceSpec, found: &Sample) -> String {
    let Sample {
        height_m,
        water_m,
        normal,
        surface,
    } = found;
    format!(
        "{},{},{height_m:.3},{water_m:.3},{:.6},{:.6},{:.6},{}\n",
        place.lat,
        place.lon,
        normal.x,
        normal.y,
        normal.z,
        surface.name()
    )
}

#[cfg(test)]
mod tests;
