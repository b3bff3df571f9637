//! The maps of a user by the field that they replace.

use super::field::ClimateField;
use super::fields::ClimateMaps;
use super::map::{EquirectMap, MapError};

impl ClimateMaps {
    /// Refuses maps with values that their quantity cannot have.
    ///
    /// # Errors
    /// [`MapError::Range`].
    pub fn check(&self) -> Result<(), MapError> {
        for (field, map) in self.iter() {
            let [what, allowed] = field.words();
            EquirectMap::check(Some(map), what, field.range(), allowed)?;
        }
        Ok(())
    }

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
