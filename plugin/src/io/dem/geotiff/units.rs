//! Units of length and angle by their EPSG codes, and units of height by their names.

use super::keys::{self, Key, KeyDirectory, USER_DEFINED, unknown};
use crate::io::dem::error::{DemError, invalid};
use crate::math::PI;

/// EPSG code and length in m of the units of length.
const LENGTHS: [(u16, f64); 47] = [
    // Millimetre.
    (1025, 0.001),
    // Centimetre.
    (1033, 0.01),
    // Metre.
    (9001, 1.0),
    // Foot.
    (9002, 0.3048),
    // US survey foot.
    (9003, 1200.0 / 3937.0),
    // Clarke's foot.
    (9005, 0.304_797_265_4),
    // Fathom.
    (9014, 1.8288),
    // Nautical mile.
    (9030, 1852.0),
    // German legal metre.
    (9031, 1.000_013_596_5),
    // US survey chain.
    (9033, 66.0 * 1200.0 / 3937.0),
    // US survey link.
    (9034, 0.66 * 1200.0 / 3937.0),
    // US survey mile.
    (9035, 5280.0 * 1200.0 / 3937.0),
    // Kilometre.
    (9036, 1000.0),
    // Clarke's yard.
    (9037, 3.0 * 0.304_797_265_4),
    // Clarke's chain.
    (9038, 66.0 * 0.304_797_265_4),
    // Clarke's link.
    (9039, 0.66 * 0.304_797_265_4),
    // British yard (Sears 1922).
    (9040, 36.0 / 39.370_147),
    // British foot (Sears 1922).
    (9041, 12.0 / 39.370_147),
    // British chain (Sears 1922).
    (9042, 792.0 / 39.370_147),
    // British link (Sears 1922).
    (9043, 7.92 / 39.370_147),
    // British yard (Benoit 1895 A).
    (9050, 0.914_399_2),
    // British foot (Benoit 1895 A).
    (9051, 0.914_399_2 / 3.0),
    // British chain (Benoit 1895 A).
    (9052, 22.0 * 0.914_399_2),
    // British link (Benoit 1895 A).
    (9053, 0.22 * 0.914_399_2),
    // British yard (Benoit 1895 B).
    (9060, 36.0 / 39.370_113),
    // British foot (Benoit 1895 B).
    (9061, 12.0 / 39.370_113),
    // British chain (Benoit 1895 B).
    (9062, 792.0 / 39.370_113),
    // British link (Benoit 1895 B).
    (9063, 7.92 / 39.370_113),
    // British foot (1865).
    (9070, 0.914_402_5 / 3.0),
    // Indian foot.
    (9080, 12.0 / 39.370_142),
    // Indian foot (1937).
    (9081, 0.304_798_41),
    // Indian foot (1962).
    (9082, 0.304_799_6),
    // Indian foot (1975).
    (9083, 0.304_799_5),
    // Indian yard.
    (9084, 36.0 / 39.370_142),
    // Indian yard (1937).
    (9085, 3.0 * 0.304_798_41),
    // Indian yard (1962).
    (9086, 3.0 * 0.304_799_6),
    // Indian yard (1975).
    (9087, 3.0 * 0.304_799_5),
    // Statute mile.
    (9093, 1609.344),
    // Gold Coast foot.
    (9094, 0.304_799_710_181_508_8),
    // British foot (1936).
    (9095, 0.304_800_749_1),
    // Yard.
    (9096, 0.9144),
    // Chain.
    (9097, 20.1168),
    // Link.
    (9098, 0.201_168),
    // British yard (Sears 1922 truncated).
    (9099, 0.914_398),
    // British foot (Sears 1922 truncated).
    (9300, 0.914_398 / 3.0),
    // British chain (Sears 1922 truncated).
    (9301, 22.0 * 0.914_398),
    // British link (Sears 1922 truncated).
    (9302, 0.22 * 0.914_398),
];

/// Names of units of height, as they stand in files.
const NAMES: [(&[&str], f64); 8] = [
    (&["m", "metre", "metres", "meter", "meters", "1"], 1.0),
    (
        &["km", "kilometre", "kilometres", "kilometer", "kilometers"],
        1000.0,
    ),
    (
        &["dm", "decimetre", "decimetres", "decimeter", "decimeters"],
        0.1,
    ),
    (
        &[
            "cm",
            "centimetre",
            "centimetres",
            "centimeter",
            "centimeters",
        ],
        0.01,
    ),
    (
        &[
            "mm",
            "millimetre",
            "millimetres",
            "millimeter",
            "millimeters",
        ],
        0.001,
    ),
    (
        &[
            "ft",
            "foot",
            "feet",
            "international foot",
            "international feet",
        ],
        0.3048,
    ),
    (
        &[
            "us survey foot",
            "us survey feet",
            "us_survey_foot",
            "us-ft",
            "us ft",
            "ftus",
            "foot_us",
        ],
        1200.0 / 3937.0,
    ),
    (&["fathom", "fathoms"], 1.8288),
];

/// Length in m of the unit with a code.
pub(super) fn length(code: u16) -> Option<f64> {
    let (_, metres) = LENGTHS.iter().find(|(known, _)| *known == code)?;
    Some(*metres)
}

/// Length in m of the unit of height with a name.
pub(super) fn named_length(name: &str) -> Option<f64> {
    let name = name.to_ascii_lowercase();
    let (_, metres) = NAMES
        .iter()
        .find(|(names, _)| names.contains(&name.as_str()))?;
    Some(*metres)
}

/// Length in m of the unit of projected coordinates, if the file tells.
pub(super) fn linear(keys: &KeyDirectory) -> Result<Option<f64>, DemError> {
    match keys.code(keys::LINEAR_UNIT) {
        None | Some(0) => Ok(None),
        // Files that only say that the unit is theirs count in metres.
        Some(USER_DEFINED) if keys.measure(keys::LINEAR_UNIT_SIZE.number).is_none() => Ok(None),
        Some(USER_DEFINED) => keys.own_unit(keys::LINEAR_UNIT_SIZE).map(Some),
        Some(code) => known(keys::LINEAR_UNIT, code).map(Some),
    }
}

/// Length in m of the unit with a code, or the refusal of its key.
pub(super) fn known(key: Key, code: u16) -> Result<f64, DemError> {
    length(code).ok_or_else(|| unknown(key, code))
}

/// Size in degrees of the unit of latitudes and longitudes, if the file tells.
pub(super) fn angular(keys: &KeyDirectory) -> Result<Option<f64>, DemError> {
    let degrees = match keys.code(keys::ANGULAR_UNIT) {
        None | Some(0) => return Ok(None),
        // Radian, degree, minute, second, grad under both of its names, and degree again.
        Some(9101) => 180.0 / PI,
        Some(9102 | 9122) => 1.0,
        Some(9103) => 1.0 / 60.0,
        Some(9104) => 1.0 / 3600.0,
        Some(9105 | 9106) => 0.9,
        Some(USER_DEFINED) => keys.own_unit(keys::ANGULAR_UNIT_SIZE)? * 180.0 / PI,
        Some(code) => return Err(unknown(keys::ANGULAR_UNIT, code)),
    };
    Ok(Some(degrees))
}

/// The error of heights in a unit of an unknown name.
pub(super) fn unnamed(unit: &str) -> DemError {
    let unit: String = unit.chars().take(40).collect();
    invalid(format!(
        "GDAL_METADATA: heights in the unit {unit:?} are not read"
    ))
}
