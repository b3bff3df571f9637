//! `pangaea query`: the ground at points, as comma separated values.

use crate::cli::{PlaceSpec, QueryArgs};
use crate::error::CliError;
use crate::ground::ground_of;
use crate::output::print;
use crate::values::place;
use bevy_pangaea::io::load;
use bevy_pangaea::query::{Ground, Sample, direction_at};
use std::io::{self, BufRead};

const HEADER: &str = "lat,lon,height_m,water_m,normal_x,normal_y,normal_z,surface";

/// Longest line of the input in bytes.
const MAX_LINE: usize = 1000;

/// Points whose lines are printed at once.
const BLOCK: usize = 4096;

/// Runs the command.
pub fn query(args: &QueryArgs) -> Result<(), CliError> {
    // A wrong line is told before a planet is loaded.
    let places = match args.at {
        Some(place) => vec![place],
        None => read_places(io::stdin().lock())?,
    };
    let climate = args.climate.load()?;
    let ground = ground_of(load(&args.planet)?, climate)?;
    print(&format!("{HEADER}\n"))?;
    places
        .chunks(BLOCK)
        .try_for_each(|places| print(&table(&ground, places, args.level as u8)?))
}

/// Reads lines "lat,lon"; empty lines are passed over.
fn read_places(mut input: impl BufRead) -> Result<Vec<PlaceSpec>, CliError> {
    let mut places = Vec::new();
    let mut line = Vec::new();
    for number in 1.. {
        line.clear();
        let read = io::Read::take(&mut input, MAX_LINE as u64 + 1).read_until(b'\n', &mut line);
        if read
            .map_err(|error| CliError::input(format!("cannot read the standard input: {error}")))?
            == 0
        {
            break;
        }
        let refused =
            |problem: &str| CliError::input(format!("line {number} of the input: {problem}"));
        if line.len() > MAX_LINE {
            return Err(refused("it is too long"));
        }
        let text = str::from_utf8(&line).map_err(|_| refused("it is no text"))?;
        // Spreadsheets begin their files with a byte order mark.
        let text = text.trim_start_matches('\u{feff}').trim();
        if !text.is_empty() {
            places.push(place(text).map_err(|problem| refused(&format!("`{text}`: {problem}")))?);
        }
    }
    Ok(places)
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
    struct Slope;

    impl Ground for Slope {
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
        let text = table(&Slope, &places, 17).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines[0].starts_with("10,20,1000.000,1000.000,"), "{text}");
        assert!(
            lines[1].starts_with("-33,-70.5,-3300.000,0.000,") && lines[1].ends_with(",sea_floor"),
            "{text}"
        );
        assert!(lines[2].starts_with("0,360,") && lines.len() == 3);
        let columns = HEADER.split(',').count();
        assert!(lines.iter().all(|line| line.split(',').count() == columns));
        assert_eq!(table(&Slope, &[], 17).unwrap(), "");
    }

    #[test]
    fn the_first_bad_line_is_named() {
        for (bad, words) in [
            ("1,2\n3\n", ["line 2", "LAT,LON"]),
            ("91,2\n", ["line 1", "latitude"]),
            ("1,2\n1,2\n\n5,NaN\n", ["line 4", "longitude"]),
            (
                "lat,lon\n1,2\n",
                ["line 1 of the input: `lat,lon`", "latitude"],
            ),
            ("1,2,3\n", ["line 1", "LAT,LON"]),
        ] {
            let problem = read_places(bad.as_bytes()).unwrap_err().to_string();
            assert!(words.iter().all(|word| problem.contains(word)), "{problem}");
        }
        assert!(read_places([0xff, 0xfe, b'\n'].as_slice()).is_err());
        assert!(
            read_places(vec![b'1'; 5000].as_slice())
                .unwrap_err()
                .to_string()
                .contains("too long")
        );
    }
}
