//! A 16-bit grey PNG whose scale is in a sidecar NAME.json: `{"metres_per_pixel", "metres_per_unit"}` for real
//! ground, or `{"metres_per_pixel", "min_m", "max_m"}` as `export` writes it.

use super::{Dem, DemError, check_size, filled};
use png::{BitDepth, ColorType, Decoder, Limits};
use std::io::Cursor;

/// Scale and position of a picture of heights. A value v is `min_m + v / 65535 (max_m - min_m)`, or
/// `v metres_per_unit`.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Sidecar {
    /// Height of black in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min_m: Option<f64>,
    /// Height of white in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_m: Option<f64>,
    /// Height of one step of grey in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub metres_per_unit: Option<f64>,
    /// Side of a pixel in m.
    pub metres_per_pixel: f64,
    /// Latitude of the middle in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lat: Option<f64>,
    /// Longitude of the middle in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lon: Option<f64>,
}

impl Sidecar {
    /// Reads a sidecar.
    ///
    /// # Errors
    /// [`DemError::Invalid`] for what is no such JSON.
    pub fn parse(text: &[u8]) -> Result<Self, DemError> {
        let sidecar: Self =
            serde_json::from_slice(text).map_err(|error| DemError::Invalid(error.to_string()))?;
        sidecar.scale()?;
        Ok(sidecar)
    }

    /// Height of black and of one step of grey in m.
    fn scale(&self) -> Result<[f64; 2], DemError> {
        let scale = match *self {
            Self { metres_per_unit: Some(unit), .. } => [0.0, unit],
            Self { min_m: Some(min), max_m: Some(max), .. } => [min, (max - min) / 65_535.0],
            _ => {
                return Err(DemError::Invalid(
                    "the sidecar has neither metres_per_unit nor min_m and max_m".into(),
                ));
            }
        };
        if scale.iter().all(|x| x.is_finite()) && self.metres_per_pixel.is_finite() {
            Ok(scale)
        } else {
            Err(DemError::Invalid("the sidecar's numbers are not finite".into()))
        }
    }
}

/// Reads a picture.
pub(super) fn read(bytes: &[u8], sidecar: &Sidecar) -> Result<Dem, DemError> {
    let refused = |error: png::DecodingError| DemError::Invalid(error.to_string());
    let [black, step] = sidecar.scale()?;
    let limits = Limits { bytes: 64 << 20 };
    let mut reader = Decoder::new_with_limits(Cursor::new(bytes), limits).read_info().map_err(refused)?;
    let (width, height) = (reader.info().width, reader.info().height);
    check_size(width, height)?;
    if (reader.info().color_type, reader.info().bit_depth) != (ColorType::Grayscale, BitDepth::Sixteen) {
        return Err(DemError::Invalid("the picture is not of 16-bit grey".into()));
    }
    if reader.info().interlaced {
        return Err(DemError::Invalid("interlaced pictures are not read".into()));
    }
    // Row by row: a picture that is cut short never takes the memory that its header asks for.
    let mut values = Vec::new();
    while let Some(row) = reader.next_row().map_err(refused)? {
        let grey = |pair: &[u8]| (black + step * f64::from(u16::from_be_bytes([pair[0], pair[1]]))) as f32;
        values.extend(row.data().chunks_exact(2).map(grey));
    }
    filled(width, height, values, [sidecar.metres_per_pixel; 2], sidecar.lat.zip(sidecar.lon))
}
