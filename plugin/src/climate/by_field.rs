//! The maps of a user by the field that they replace.

use super::fields::ClimateMaps;
use super::map::EquirectMap;
use crate::named::named_enum;

named_enum! {
    /// A field of the climate that a map can replace. Its name is that of options and files.
    pub enum ClimateField {
        /// Temperature at the ground in °C.
        Temperature = "temperature",
        /// Rain in mm per year.
        Rain = "rain",
        /// Wetness W, 0..=1.
        Wetness = "wetness",
    }
}

impl ClimateMaps {
    /// The map that replaces a field.
    pub fn get(&self, field: ClimateField) -> Option<&EquirectMap> {
        match field {
            ClimateField::Temperature => self.temperature.as_ref(),
            ClimateField::Rain => self.rain.as_ref(),
            ClimateField::Wetness => self.wetness.as_ref(),
        }
    }

    /// Replaces a field by a map from now on.
    pub fn set(&mut self, field: ClimateField, map: EquirectMap) {
        let place = match field {
            ClimateField::Temperature => &mut self.temperature,
            ClimateField::Rain => &mut self.rain,
            ClimateField::Wetness => &mut self.wetness,
        };
        *place = Some(map);
    }

    /// The maps that there are, in the order of [`ClimateField::ALL`].
    ///
    /// ```
    /// use bevy_pangaea::climate::{ClimateField, ClimateMaps, EquirectMap};
    ///
    /// let mut maps = ClimateMaps::default();
    /// assert_eq!(maps.iter().count(), 0);
    /// maps.set(ClimateField::Rain, EquirectMap::from_fn(4, |_, _| 900.0)?);
    /// let fields: Vec<&str> = maps.iter().map(|(field, _)| field.name()).collect();
    /// assert_eq!(fields, ["rain"]);
    /// # Ok::<(), bevy_pangaea::climate::MapError>(())
    /// ```
    pub fn iter(&self) -> impl Iterator<Item = (ClimateField, &EquirectMap)> {
        ClimateField::ALL
            .into_iter()
            .filter_map(|field| Some((field, self.get(field)?)))
    }
}
