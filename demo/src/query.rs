//! `pangaea query`: the ground at points, as comma separated values.

use crate::cli::QueryArgs;
use crate::error::CliError;
use crate::ground::{bake_planet, ground};
use crate::output::print;
use crate::values::{PlaceSpec, place};
use bevy_pangaea::io::load;
use bevy_pangaea::query::{Ground, Sample, direction_at};
use std::io::{self, BufRead};

const HEADER: &str = "lat,lon,height_m,water_m,normal_x,normal_y,normal_z,surface";

/// Longest line of the input in bytes.
const MAX_LINE_BYTES: u64 = 1000;

/// Points whose lines are printed at once.
const POINTS_PER_BLOCK: usize = 4096;

/// Runs the command.
///
/// # Errors
/// If the planet, or a line of the input, is refused.
pub fn query(args: &QueryArgs) -> Result<(), CliError> {
    // A wrong line is refused before a planet is loaded.
    let places = match args.at {
        Some(place) => vec![place],
        None => read_places(io::stdin().lock())?,
    };
    let climate = args.ground.climate.load()?;
    let ground = ground(&bake_planet(load(&args.ground.planet)?, climate)?)?;
    print(&format!("{HEADER}\n"))?;
    places
        .chunks(POINTS_PER_BLOCK)
        .try_for_each(|places| print(&table(&ground, places, args.level)?))
}

/// Reads lines "lat,lon"; empty lines are passed over.
pub fn read_places(mut input: impl BufRead) -> Result<Vec<PlaceSpec>, CliError> {
    let mut places = Vec::new();
    for number in 1.. {
        let Some(line) = read_line(&mut input)? else {
            break;
        };
        let place = place_in(&line)
            .map_err(|problem| CliError::input(format!("line {number} of the input: {problem}")))?;
        places.extend(place);
    }
    Ok(places)
}

/// The next line with what ends it, at most one byte longer than [`MAX_LINE_BYTES`]; `None` at the end of
/// the input.
fn read_line(input: &mut impl BufRead) -> Result<Option<Vec<u8>>, CliError> {
    let mut line = Vec::new();
    let read = io::Read::take(input, MAX_LINE_BYTES + 1)
        .read_until(b'\n', &mut line)
        .map_err(|error| CliError::input(format!("cannot read the standard input: {error}")))?;
    Ok((read > 0).then_some(line))
}

/// The place in a line of the input, `None` in an empty one.
fn place_in(line: &[u8]) -> Result<Option<PlaceSpec>, String> {
    if line.len() as u64 > MAX_LINE_BYTES {
        return Err("it is too long".into());
    }
    if line.starts_with(b"\xff\xfe") || line.starts_with(b"\xfe\xff") {
        return Err("it is in UTF-16, and only UTF-8 is read".into());
    }
    let text = str::from_utf8(line).map_err(|_| "it is no text")?;
    // Spreadsheets begin their files with a byte order mark.
    let text = text.trim_start_matches('\u{feff}').trim();
    if text.is_empty() {
        return Ok(None);
    }
    place(text)
        .map(Some)
        .map_err(|problem| format!("`{text}`: {problem}"))
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
mod tests {
    use super::*;
    use bevy::math::DVec3;
    use bevy_pangaea::query::GroundError;

    /// Height = 100 m per degree of latitude.
    struct SlopingGround;

    impl Ground for SlopingGround {
        fn radius_m(&self) -> f64 {
            1e6
        }

        fn height(&self, direction: DVec3, _: u8) -> Result<f32, GroundError> {
            Ok((100.0 * bevy_pangaea::math::lat_lon(direction).0) as f32)
        }
    }

    #[test]
    fn lines_come_in_the_order_of_the_input() {
        let input = "\u{feff}10,20\n\n -33 , -70.5\r\n0,360";
        let places = read_places(input.as_bytes()).unwrap();
        let text = table(&SlopingGround, &places, 17).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines[0].starts_with("10,20,1000.000,1000.000,"), "{text}");
        assert!(
            lines[1].starts_with("-33,-70.5,-3300.000,0.000,") && lines[1].ends_with(",sea_floor"),
            "{text}"
        );
        assert!(lines[2].starts_with("0,360,") && lines.len() == 3);
        let columns = HEADER.split(',').count();
        assert!(lines.iter().all(|line| line.split(',').count() == columns));
        assert_eq!(table(&SlopingGround, &[], 17).unwrap(), "");
    }

    #[test]
    fn the_first_bad_line_is_named() {
        let titles = ["line 1 of the input: `lat,lon`", "latitude"];
        for (bad, words) in [
            ("1,2\n3\n", ["line 2", "LAT,LON"]),
            ("91,2\n", ["line 1", "latitude"]),
            ("1,2\n1,2\n\n5,NaN\n", ["line 4", "longitude"]),
            ("lat,lon\n1,2\n", titles),
            ("1,2,3\n", ["line 1", "LAT,LON"]),
        ] {
            let problem = read_places(bad.as_bytes()).unwrap_err().to_string();
            assert!(words.iter().all(|word| problem.contains(word)), "{problem}");
        }
        let utf16: Vec<u8> = "\u{feff}1,2\n"
            .encode_utf16()
            .flat_map(u16::to_le_bytes)
            .collect();
        let utf16 = read_places(utf16.as_slice()).unwrap_err();
        assert!(utf16.to_string().contains("UTF-16"), "{utf16}");
        assert!(read_places([0xfe, b'\n'].as_slice()).is_err());
        let problem = read_places([b'1'; 5000].as_slice()).unwrap_err();
        assert!(problem.to_string().contains("too long"), "{problem}");
    }
}
