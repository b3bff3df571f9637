//! The unit of heights: that of the band (GDAL's `unittype`), that of the vertical coordinate
//! system, or, if neither is told, the metre.

use super::keys::{self, KeyDirectory, USER_DEFINED, unknown};
use super::units;
use crate::io::dem::error::{DemError, invalid};

/// EPSG's vertical systems whose heights are not in metres, with EPSG's codes of their units. All
/// other heights of the dataset (version 12) are in metres.
const IN_FEET: [(u16, u16); 9] = [
    (5702, 9003),
    (5754, 9095),
    (6130, 9002),
    (6131, 9002),
    (6132, 9002),
    (6360, 9003),
    (8050, 9002),
    (8052, 9003),
    (8228, 9002),
];

/// EPSG's vertical systems whose numbers grow downwards.
const DEPTHS: [u16; 52] = [
    5336, 5612, 5614, 5706, 5715, 5734, 5739, 5789, 5831, 5861, 5862, 5863, 5864, 5865, 5866, 5867,
    5873, 6357, 6358, 6359, 7976, 8051, 8053, 8358, 8378, 8897, 9287, 9288, 9672, 10_150, 10_151,
    10_349, 10_364, 10_370, 10_371, 10_372, 10_373, 10_374, 10_375, 10_376, 10_377, 10_378, 10_379,
    10_547, 10_548, 10_549, 10_550, 10_551, 10_552, 10_649, 10_650, 10_678,
];

/// Codes of vertical systems: those of EPSG, and from 5001 on those of GeoTIFF 1.0.
const SYSTEMS: core::ops::RangeInclusive<u16> = 3855..=20_999;

/// Length in m of the unit of heights, if it is told; `unit` is that of the band, empty if it has
/// none.
///
/// # Errors
/// Units that are not known or contradict each other, and depths.
pub(super) fn metres_per_unit(keys: &KeyDirectory, unit: &str) -> Result<Option<f64>, DemError> {
    match (vertical_unit(keys)?, unit) {
        (Some(of_system), unit) => agreed(of_system, unit).map(Some),
        (None, "") => Ok(None),
        (None, unit) => units::named_length(unit)
            .map(Some)
            .ok_or_else(|| units::unnamed(unit)),
    }
}

/// The unit of the vertical system, if the band's has the same length or none is told.
pub(super) fn agreed(of_system: f64, unit: &str) -> Result<f64, DemError> {
    if unit.is_empty() {
        return Ok(of_system);
    }
    let metres = units::named_length(unit).ok_or_else(|| units::unnamed(unit))?;
    // Names do not always tell one foot from the other.
    if (of_system / metres - 1.0).abs() > 1e-5 {
        return Err(invalid(format!(
            "GDAL_METADATA: the unit {unit:?} contradicts {}",
            keys::VERTICAL_UNIT.name
        )));
    }
    Ok(of_system)
}

/// Length in m of the unit of the vertical system, if there is one.
fn vertical_unit(keys: &KeyDirectory) -> Result<Option<f64>, DemError> {
    let system = keys.code(keys::VERTICAL_SYSTEM);
    if let Some(code) = system.filter(|code| DEPTHS.contains(code)) {
        return Err(unknown(keys::VERTICAL_SYSTEM, format!("{code} (depths)")));
    }
    if let Some(unit) = keys.code(keys::VERTICAL_UNIT).filter(|unit| *unit != 0) {
        return units::known(keys::VERTICAL_UNIT, unit).map(Some);
    }
    match system {
        None | Some(0) => Ok(None),
        Some(USER_DEFINED) => Err(unknown(keys::VERTICAL_SYSTEM, "without a unit")),
        Some(code) => unit_of(code).map(Some),
    }
}

/// Length in m of the unit of a vertical system.
fn unit_of(code: u16) -> Result<f64, DemError> {
    if !SYSTEMS.contains(&code) {
        return Err(unknown(keys::VERTICAL_SYSTEM, code));
    }
    let unit = IN_FEET.iter().find(|(system, _)| *system == code);
    unit.map_or(Ok(1.0), |(_, unit)| {
        units::known(keys::VERTICAL_UNIT, *unit)
    })
}
