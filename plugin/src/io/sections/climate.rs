//! Maps that replace fields of the climate. The section is there only where the planet has maps.

use super::maps::{self, refused};
use crate::climate::{ClimateField, ClimateMaps};
use crate::io::SaveError;
use crate::io::codec::invalid;

pub(super) fn write(climate: &ClimateMaps) -> Vec<u8> {
    maps::write(climate.iter().map(|(field, map)| (field.name(), map)))
}

pub(super) fn read(bytes: &[u8]) -> Result<ClimateMaps, SaveError> {
    let mut climate = ClimateMaps::default();
    maps::read(bytes, |name, map| {
        let field = ClimateField::from_name(name)
            .ok_or_else(|| SaveError::unknown("map of the climate", name))?;
        if climate.get(field).is_some() {
            return Err(invalid(format!("it has two maps of {name}")));
        }
        climate.set(field, map);
        Ok(())
    })?;
    climate.check().map_err(refused)?;
    Ok(climate)
}
