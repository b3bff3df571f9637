//! The map of the elevation of a planet, in whatever unit, to km.

use crate::climate::{EquirectMap, MapError};
use crate::hydrology::TerrainMaps;
use crate::io::IoError;
use crate::io::maps::{MapFileError, MapQuantity, load_map_of, reduced};
use std::path::Path;

/// The unit of the values of a map of elevations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum HeightUnit {
    /// Metres, as nearly all archives have them.
    #[default]
    Metres,
    /// Kilometres.
    Kilometres,
}

/// Heights in km of black and white of a picture without a sidecar.
const GREY_KM: [f32; 2] = [-12.0, 12.0];

impl HeightUnit {
    fn per_km(self) -> f32 {
        match self {
            Self::Metres => 1000.0,
            Self::Kilometres => 1.0,
        }
    }

    /// The range of a map in words; whoever has mistaken the unit knows it by them.
    fn allowed(self) -> &'static str {
        match self {
            Self::Metres => "from -15000 to 15000 m",
            Self::Kilometres => "from -15 to 15 km: the values look like metres",
        }
    }

    /// Reads a map in this unit, as elevations in km.
    ///
    /// # Errors
    /// [`IoError::Read`], and [`IoError::Map`] for a file that is no map, has voids, or heights that
    /// no planet has.
    pub(super) fn load(self, path: &Path) -> Result<EquirectMap, IoError> {
        let greys = GREY_KM.map(|km| km * self.per_km());
        let metres = 1000.0 / f64::from(self.per_km());
        let quantity = MapQuantity::Elevation(metres);
        let map = load_map_of(path, quantity, Some(greys))?.map;
        let refused = |problem: MapFileError| IoError::map(path, problem);
        self.check(&map).map_err(refused)?;
        self.in_km(&map).map_err(|error| refused(error.into()))
    }

    fn check(self, map: &EquirectMap) -> Result<(), MapFileError> {
        let subject = "the elevation";
        let most = TerrainMaps::HIGHEST_KM * self.per_km();
        EquirectMap::check(Some(map), subject, -most..=most, self.allowed())?;
        map.check_whole(subject)?;
        // A planet flatter than a house is a map of kilometres.
        let as_in_km = |value: &f32| value.abs() <= TerrainMaps::HIGHEST_KM;
        let is_flat = map.values().iter().all(as_in_km);
        if self == Self::Metres && is_flat {
            return Err(MapFileError::Flat);
        }
        Ok(())
    }

    fn in_km(self, map: &EquirectMap) -> Result<EquirectMap, MapError> {
        let small = reduced(map)?;
        let km = small.values().iter().map(|value| value / self.per_km());
        let [width, height] = small.size();
        EquirectMap::new(width, height, km.collect())
    }
}
