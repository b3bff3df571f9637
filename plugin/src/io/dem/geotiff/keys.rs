//! GeoKeys (OGC 19-008r4, section 7.1.2): numbers by which a raster names its coordinate system.

use super::structure::{Directory, TiffFile};
use super::tag;
use crate::io::dem::error::{DemError, invalid};
use std::io::{Read, Seek};

/// A key of the GeoKeyDirectory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Key {
    pub(super) number: u16,
    pub(super) name: &'static str,
}

/// Constants of keys.
macro_rules! keys {
    ($($constant:ident = $number:literal $name:literal;)*) => {
        $(pub(super) const $constant: Key = Key { number: $number, name: $name };)*
    };
}

keys! {
    MODEL_TYPE = 1024 "GTModelTypeGeoKey";
    RASTER_TYPE = 1025 "GTRasterTypeGeoKey";
    CITATION = 1026 "GTCitationGeoKey";
    GEODETIC_SYSTEM = 2048 "GeographicTypeGeoKey";
    ANGULAR_UNIT = 2054 "GeogAngularUnitsGeoKey";
    ANGULAR_UNIT_SIZE = 2055 "GeogAngularUnitSizeGeoKey";
    SEMI_MAJOR_AXIS = 2057 "GeogSemiMajorAxisGeoKey";
    SEMI_MINOR_AXIS = 2058 "GeogSemiMinorAxisGeoKey";
    INVERSE_FLATTENING = 2059 "GeogInvFlatteningGeoKey";
    PRIME_MERIDIAN = 2061 "GeogPrimeMeridianLongGeoKey";
    PROJECTED_SYSTEM = 3072 "ProjectedCSTypeGeoKey";
    PROJECTED_CITATION = 3073 "PCSCitationGeoKey";
    PROJECTION = 3074 "ProjectionGeoKey";
    PROJECTION_METHOD = 3075 "ProjCoordTransGeoKey";
    LINEAR_UNIT = 3076 "ProjLinearUnitsGeoKey";
    LINEAR_UNIT_SIZE = 3077 "ProjLinearUnitSizeGeoKey";
    VERTICAL_SYSTEM = 4096 "VerticalCSTypeGeoKey";
    VERTICAL_UNIT = 4099 "VerticalUnitsGeoKey";
}

/// The value of a key that stands for a definition by other keys.
pub(super) const USER_DEFINED: u16 = 32_767;

/// The keys of a file.
#[derive(Default)]
pub(super) struct KeyDirectory {
    /// Key, where its value is (0: here), count, value.
    keys: Vec<[u16; 4]>,
    doubles: Vec<f64>,
    texts: Vec<u8>,
}

impl KeyDirectory {
    /// Reads the keys of an image; there may be none.
    pub(super) fn read<R: Read + Seek>(
        file: &TiffFile<R>,
        directory: &Directory,
    ) -> Result<Self, DemError> {
        let numbers = file.numbers(directory, tag::GEO_KEY_DIRECTORY)?;
        let words: Vec<u16> = numbers.into_iter().map(|word| word as u16).collect();
        let (rows, _) = words.as_chunks::<4>();
        // The first is a header.
        let keys = rows.iter().skip(1).copied().collect();
        // Nothing follows from a damaged text.
        let texts = file.text(directory, tag::GEO_ASCII_PARAMS).ok().flatten();
        Ok(Self {
            keys,
            texts: texts.unwrap_or_default().into_bytes(),
            doubles: file.reals(directory, tag::GEO_DOUBLE_PARAMS)?,
        })
    }

    /// The value of a key that is a code.
    pub(super) fn code(&self, key: Key) -> Option<u16> {
        let row = self.keys.iter().find(|row| row[0] == key.number)?;
        (row[1] == 0).then_some(row[3])
    }

    /// The value of a key that is the code of a definition: neither 0 nor that of a user's own.
    pub(super) fn definition(&self, key: Key) -> Option<u16> {
        self.code(key)
            .filter(|code| ![0, USER_DEFINED].contains(code))
    }

    /// The value of a key that is a text.
    pub(super) fn text(&self, key: Key) -> Option<String> {
        let row = self.keys.iter().find(|row| row[0] == key.number)?;
        let [_, _, count, start] = row.map(usize::from);
        let is_text = row[1] == tag::GEO_ASCII_PARAMS.number;
        let text = self.texts.get(start..start + count).filter(|_| is_text)?;
        Some(String::from_utf8_lossy(text).into_owned())
    }

    /// The value of a key that is a measure.
    pub(super) fn measure(&self, key: u16) -> Option<f64> {
        let row = self.keys.iter().find(|row| row[0] == key)?;
        match row[1] {
            0 => Some(f64::from(row[3])),
            place if place == tag::GEO_DOUBLE_PARAMS.number => {
                self.doubles.get(usize::from(row[3])).copied()
            }
            _ => None,
        }
    }

    /// The size of a user's own unit.
    pub(super) fn own_unit(&self, key: Key) -> Result<f64, DemError> {
        self.measure(key.number)
            .filter(|size| size.is_finite() && *size > 0.0)
            .ok_or_else(|| invalid(format!("a unit without a sound {}", key.name)))
    }
}

/// The error of a key's value that is not read.
pub(super) fn unknown(key: Key, value: impl core::fmt::Display) -> DemError {
    invalid(format!("{} {value} is not read", key.name))
}
