//! Maps that a planet is made of. The section is there only where it was not grown.

use super::maps::{self, put, refused};
use crate::hydrology::TerrainMaps;
use crate::io::SaveError;
use crate::io::codec::invalid;

pub(super) fn read(bytes: &[u8]) -> Result<TerrainMaps, SaveError> {
    let (mut crust, mut age) = (None, None);
    let (mut plateau, mut hills) = (None, None);
    maps::read(bytes, |name, map| match name {
        "elevation" => put(&mut crust, name, map),
        "age" => put(&mut age, name, map),
        "plateaus" => put(&mut plateau, name, map),
        "hills" => put(&mut hills, name, map),
        other => Err(SaveError::unknown("map of the terrain", other)),
    })?;
    let terrain = TerrainMaps {
        crust: crust.ok_or_else(|| invalid("it has no map of the elevation".into()))?,
        age,
        plateau,
        hills,
    };
    terrain.check().map_err(refused)?;
    Ok(terrain)
}
