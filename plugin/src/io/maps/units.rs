//! Units of the quantities that maps show, as files name them; UDUNITS' names among others.

use crate::climate::ClimateField;
use crate::hydrology::TerrainMaps;
use core::ops::RangeInclusive;

/// The quantity that a map shows, in the unit that its values come out in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MapQuantity {
    /// Numbers whose unit is not looked at.
    Number,
    /// Temperature in °C.
    Temperature,
    /// Rain in mm a year.
    Rain,
    /// A share from 0 to 1.
    Share,
    /// Age in My.
    Age,
    /// Elevation in a unit of so many metres.
    Elevation(f64),
}

/// By how much a value is multiplied, and what is added then.
pub(super) type Conversion = [f64; 2];

/// Days and seconds of a mean year of the Gregorian calendar.
const DAYS: f64 = 365.2425;
const SECONDS: f64 = 86_400.0 * DAYS;

/// Names of temperatures, without blanks and signs between.
const TEMPERATURES: [(&[&str], Conversion); 3] = [
    (
        &[
            "degc",
            "c",
            "celsius",
            "degcelsius",
            "degreecelsius",
            "degreescelsius",
            "degreesc",
        ],
        [1.0, 0.0],
    ),
    (
        &["k", "kelvin", "degk", "kelvins", "degreeskelvin"],
        [1.0, -273.15],
    ),
    (
        &[
            "degf",
            "f",
            "fahrenheit",
            "degreefahrenheit",
            "degreesfahrenheit",
            "degreesf",
        ],
        [5.0 / 9.0, -160.0 / 9.0],
    ),
];

/// Names of amounts of rain, in mm.
const AMOUNTS: [(&[&str], f64); 5] = [
    (
        &[
            "mm",
            "millimetre",
            "millimetres",
            "millimeter",
            "millimeters",
            "kg m-2",
        ],
        1.0,
    ),
    (&["cm", "centimetre", "centimetres"], 10.0),
    (&["dm"], 100.0),
    (
        &[
            "m",
            "metre",
            "metres",
            "meter",
            "meters",
            "m of water equivalent",
        ],
        1000.0,
    ),
    (&["in", "inch", "inches"], 25.4),
];

/// Names of times, by how often they pass in a year.
const TIMES: [(&[&str], f64); 5] = [
    (&["s", "sec", "second"], SECONDS),
    (&["h", "hr", "hour"], 24.0 * DAYS),
    (&["d", "day"], DAYS),
    (&["mon", "month"], 12.0),
    (&["a", "y", "yr", "year", "annum"], 1.0),
];

const SHARES: [(&[&str], f64); 2] = [
    (
        &["1", "-", "fraction", "unitless", "dimensionless", "m3 m-3"],
        1.0,
    ),
    (&["%", "percent", "per cent"], 0.01),
];

const AGES: [(&[&str], f64); 3] = [
    (&["my", "myr", "ma", "million years", "megayears"], 1.0),
    (&["ky", "kyr", "ka"], 1e-3),
    (&["a", "y", "yr", "year", "years"], 1e-6),
];

impl MapQuantity {
    /// The quantity of a field of the climate.
    pub fn of(field: ClimateField) -> Self {
        match field {
            ClimateField::Temperature => Self::Temperature,
            ClimateField::Rain => Self::Rain,
            ClimateField::Wetness => Self::Share,
        }
    }

    /// Values of black and white in a picture that has no sidecar, where they are plain.
    pub fn greys(self) -> Option<[f32; 2]> {
        (self == Self::Share).then_some([0.0, 1.0])
    }

    /// Values that it can have.
    pub(super) fn possible(self) -> RangeInclusive<f32> {
        match self {
            Self::Number => f32::NEG_INFINITY..=f32::INFINITY,
            Self::Temperature => ClimateField::Temperature.range(),
            Self::Rain => ClimateField::Rain.range(),
            Self::Age => 0.0..=f32::MAX,
            Self::Share => 0.0..=1.0,
            Self::Elevation(metres) => {
                let most = (1000.0 * f64::from(TerrainMaps::HIGHEST_KM) / metres) as f32;
                -most..=most
            }
        }
    }

    /// How values in a unit become those of the quantity; `None` for a unit that is not known.
    pub(super) fn conversion(self, unit: &str) -> Option<Conversion> {
        let unit = unit.trim().to_lowercase();
        let (factor, unit) = split_factor(&unit);
        let [scale, summand] = match self {
            Self::Temperature => temperature(unit)?,
            Self::Rain => [rain(unit)?, 0.0],
            Self::Share => [of(&SHARES, &powers(unit))?, 0.0],
            Self::Age => [of(&AGES, unit)?, 0.0],
            Self::Number | Self::Elevation(_) => return None,
        };
        Some([factor * scale, summand])
    }
}

/// A number that a unit begins with, as `0.1 degC` does, and the rest.
fn split_factor(unit: &str) -> (f64, &str) {
    let Some((number, rest)) = unit.split_once([' ', '*']) else {
        return (1.0, unit);
    };
    match number.parse::<f64>() {
        Ok(factor) if factor.is_finite() && factor > 0.0 => (factor, rest.trim()),
        _ => (1.0, unit),
    }
}

fn of(table: &[(&[&str], f64)], name: &str) -> Option<f64> {
    let (_, value) = table.iter().find(|(names, _)| names.contains(&name))?;
    Some(*value)
}

fn temperature(unit: &str) -> Option<Conversion> {
    let name = unit.replace('°', "deg").replace([' ', '_', '.'], "");
    let (_, found) = TEMPERATURES
        .iter()
        .find(|(names, _)| names.contains(&name.as_str()))?;
    Some(*found)
}

/// Millimetres a year of a unit of rain; one without a time is that of a year.
fn rain(unit: &str) -> Option<f64> {
    let unit = powers(unit);
    if let Some(amount) = of(&AMOUNTS, &unit) {
        return Some(amount);
    }
    let (amount, time) = match unit.split_once('/') {
        Some((amount, time)) => (amount, time.trim()),
        None => unit.strip_suffix("-1")?.rsplit_once(' ')?,
    };
    Some(of(&AMOUNTS, amount.trim())? * of(&TIMES, time)?)
}

/// A unit with its powers written as in `kg m-2 s-1`.
fn powers(unit: &str) -> String {
    let unit = unit
        .replace("**", "")
        .replace(['^', '·', '.'], " ")
        .replace("kg/m2", "kg m-2");
    let unit = unit
        .replace("m -", "m-")
        .replace("s -1", "s-1")
        .replace("kg/m²", "kg m-2");
    unit.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The value that a number in a unit stands for.
    fn value(quantity: MapQuantity, number: f64, unit: &str) -> Option<f64> {
        let [factor, summand] = quantity.conversion(unit)?;
        Some(factor * number + summand)
    }

    #[test]
    fn temperatures_become_degrees_celsius() {
        for (number, unit, celsius) in [
            (15.0, "°C", 15.0),
            (15.0, "degrees_Celsius", 15.0),
            (150.0, "0.1 degC", 15.0),
            (288.15, "K", 15.0),
            (288.15, "kelvin", 15.0),
            (2881.5, "0.1*K", 15.0),
            (59.0, "degF", 15.0),
            (-40.0, "Fahrenheit", -40.0),
        ] {
            let found = value(MapQuantity::Temperature, number, unit).unwrap();
            assert!((found - celsius).abs() < 1e-9, "{unit}: {found}");
        }
    }

    #[test]
    fn rain_becomes_millimetres_a_year() {
        for (number, unit, millimetres) in [
            (800.0, "mm", 800.0),
            (800.0, "mm/year", 800.0),
            (800.0, "mm yr-1", 800.0),
            (800.0, "kg m-2", 800.0),
            (0.8, "m", 800.0),
            (10.0, "in/yr", 254.0),
            (100.0, "mm/month", 1200.0),
            (2.0, "mm/day", 730.485),
            (2.0, "mm d-1", 730.485),
            (2.0, "kg m**-2 day**-1", 730.485),
            (1e-5, "kg m-2 s-1", 315.569_52),
            (1e-5, "kg m^-2 s^-1", 315.569_52),
            (1e-5, "kg/m2/s", 315.569_52),
            (1e-8, "m s-1", 315.569_52),
        ] {
            let found = value(MapQuantity::Rain, number, unit).unwrap();
            assert!((found / millimetres - 1.0).abs() < 1e-9, "{unit}: {found}");
        }
    }

    #[test]
    fn shares_and_ages_are_known() {
        assert_eq!(value(MapQuantity::Share, 50.0, "%"), Some(0.5));
        assert_eq!(value(MapQuantity::Share, 0.5, "1"), Some(0.5));
        assert_eq!(value(MapQuantity::Share, 0.5, "m3 m-3"), Some(0.5));
        assert_eq!(value(MapQuantity::Age, 30.0, "Ma"), Some(30.0));
        assert_eq!(value(MapQuantity::Age, 3e7, "years"), Some(30.0));
    }

    #[test]
    fn other_units_are_not_known() {
        for (quantity, unit) in [
            (MapQuantity::Temperature, "mm"),
            (MapQuantity::Temperature, "degrees"),
            (MapQuantity::Rain, "K"),
            (MapQuantity::Rain, "mm/fortnight"),
            (MapQuantity::Rain, "kg s-1"),
            (MapQuantity::Share, "mm"),
            (MapQuantity::Age, "m"),
        ] {
            assert_eq!(quantity.conversion(unit), None, "{unit}");
        }
    }
}
