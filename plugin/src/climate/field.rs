//! The fields that a user can give, and the values that they may have.

use crate::named::named_enum;
use core::ops::RangeInclusive;

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

impl ClimateField {
    /// Values that a map of it may have: temperatures wide enough for worlds without life, though
    /// not in kelvin.
    pub(crate) const fn range(self) -> RangeInclusive<f32> {
        match self {
            Self::Temperature => -150.0..=150.0,
            Self::Rain => 0.0..=f32::MAX,
            Self::Wetness => 0.0..=1.0,
        }
    }

    /// The field and its range in words.
    pub(super) const fn words(self) -> [&'static str; 2] {
        match self {
            Self::Temperature => [
                "the temperature",
                "from -150 to 150 °C (does the map count in kelvin, or in tenths?)",
            ],
            Self::Rain => ["the rain", "at least 0 mm per year"],
            Self::Wetness => ["the wetness", "from 0 to 1"],
        }
    }
}
