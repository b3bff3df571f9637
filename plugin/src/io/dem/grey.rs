//! A 16-bit grey PNG whose scale is in a sidecar NAME.json: `{"metres_per_pixel",
//! "metres_per_unit"}` for real ground, or `{"metres_per_pixel", "min_m", "max_m"}` as `export`
//! writes it.

use super::{Dem, DemError, check_size, filled};
use png::{ColorType, Decoder, Limits};
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
            Self {
                metres_per_unit: Some(unit),
                ..
            } => [0.0, unit],
            Self {
                min_m: Some(min),
                max_m: Some(max),
                ..
            } => [min, (max - min) / 65_535.0],
            _ => {
                return Err(DemError::Invalid(
                    "the sidecar has neither metres_per_unit nor min_m and max_m".into(),
                ));
            }
        };
        if scale.iter().all(|x| x.is_finite()) && self.metres_per_pixel.is_finite() {
            Ok(scale)
        } else {
            Err(DemError::Invalid(
                "the sidecar's numbers are not finite".into(),
            ))
        }
    }
}

/// A picture of grey.
pub(in crate::io) struct Greys {
    /// Pixels to a row, and rows.
    pub(in crate::io) size: [u32; 2],
    /// Bits of a pixel in the file, 8 or 16.
    pub(in crate::io) depth: u8,
    /// Greys from black, 0, to white, 65,535, whatever the depth; rows from the top.
    pub(in crate::io) values: Vec<u16>,
}

impl Greys {
    /// Reads a picture, unless `check` refuses its size.
    pub(in crate::io) fn read<E: From<DemError>>(
        bytes: &[u8],
        check: impl FnOnce(u32, u32) -> Result<(), E>,
    ) -> Result<Self, E> {
        let refused = |error: png::DecodingError| DemError::Invalid(error.to_string());
        let limits = Limits { bytes: 64 << 20 };
        let mut reader = Decoder::new_with_limits(Cursor::new(bytes), limits)
            .read_info()
            .map_err(refused)?;
        let info = reader.info();
        let (size, depth) = ([info.width, info.height], info.bit_depth as u8);
        check(size[0], size[1])?;
        if info.color_type != ColorType::Grayscale || depth < 8 {
            return Err(
                DemError::Invalid("the picture is not of 8-bit or 16-bit grey".into()).into(),
            );
        }
        if info.interlaced {
            return Err(DemError::Invalid("interlaced pictures are not read".into()).into());
        }
        // Row by row: a picture that is cut short never takes the memory that its header asks for.
        let mut values = Vec::new();
        while let Some(row) = reader.next_row().map_err(refused)? {
            match depth {
                8 => values.extend(row.data().iter().map(|&grey| u16::from_be_bytes([grey; 2]))),
                _ => {
                    let pairs = row.data().chunks_exact(2);
                    values.extend(pairs.map(|pair| u16::from_be_bytes([pair[0], pair[1]])));
                }
            }
        }
        Ok(Self {
            size,
            depth,
            values,
        })
    }
}

/// Reads a picture of heights.
pub(super) fn read(bytes: &[u8], sidecar: &Sidecar) -> Result<Dem, DemError> {
    let [black, step] = sidecar.scale()?;
    let Greys {
        size: [width, height],
        depth,
        values,
    } = Greys::read(bytes, check_size)?;
    if depth != 16 {
        return Err(DemError::Invalid(
            "the picture is not of 16-bit grey".into(),
        ));
    }
    let heights = values
        .iter()
        .map(|&grey| (black + step * f64::from(grey)) as f32)
        .collect();
    filled(
        width,
        height,
        heights,
        [sidecar.metres_per_pixel; 2],
        sidecar.lat.zip(sidecar.lon),
    )
}
