//! Grey PNGs of 8 or 16 bits; pictures of heights have 16, and their scale in a sidecar.

use super::error::{DemError, invalid};
use super::tile::{Dem, check_size};
use crate::io::sidecar::Sidecar;
use png::{BitDepth, ColorType, Decoder, Limits, Reader};
use std::io::Cursor;

/// Memory that the decoder may take besides the pixels.
const DECODER_BYTES: usize = 64 << 20;

/// Reads the sidecar of a picture of heights.
///
/// # Errors
/// [`DemError::Invalid`] for JSON that tells no finite scale.
pub(super) fn parse_sidecar(text: &[u8]) -> Result<Sidecar, DemError> {
    let sidecar = serde_json::from_slice(text).map_err(|error| invalid(error.to_string()))?;
    GreyScale::of(&sidecar)?;
    Ok(sidecar)
}

/// The heights that greys stand for.
struct GreyScale {
    /// Height of black in m.
    black: f64,
    /// Height of one step of grey in m.
    step: f64,
}

impl GreyScale {
    fn of(sidecar: &Sidecar) -> Result<Self, DemError> {
        let scale = match (sidecar.metres_per_unit, sidecar.min_m, sidecar.max_m) {
            (Some(step), ..) => Self { black: 0.0, step },
            (None, Some(min), Some(max)) => Self {
                black: min,
                step: (max - min) / 65_535.0,
            },
            _ => {
                return Err(invalid(
                    "the sidecar has neither metres_per_unit nor min_m and max_m",
                ));
            }
        };
        let numbers = [scale.black, scale.step, sidecar.metres_per_pixel];
        if numbers.into_iter().all(f64::is_finite) {
            Ok(scale)
        } else {
            Err(invalid("the sidecar's numbers are not finite"))
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
        let limits = Limits {
            bytes: DECODER_BYTES,
        };
        let mut reader = Decoder::new_with_limits(Cursor::new(bytes), limits)
            .read_info()
            .map_err(refused)?;
        let info = reader.info();
        let (size, depth) = ([info.width, info.height], info.bit_depth);
        check(size[0], size[1])?;
        if info.color_type != ColorType::Grayscale || (depth as u8) < 8 {
            return Err(invalid("the picture is not of 8-bit or 16-bit grey").into());
        }
        if info.interlaced {
            return Err(invalid("interlaced pictures are not read").into());
        }
        let values = read_rows(&mut reader, depth)?;
        Ok(Self {
            size,
            depth: depth as u8,
            values,
        })
    }
}

/// Reads greys row by row: a picture that is cut short never takes the memory that its header asks
/// for.
fn read_rows(reader: &mut Reader<Cursor<&[u8]>>, depth: BitDepth) -> Result<Vec<u16>, DemError> {
    let mut values = Vec::new();
    while let Some(row) = reader.next_row().map_err(refused)? {
        if depth == BitDepth::Eight {
            // 255 times 257 is 65,535: white stays white.
            values.extend(row.data().iter().map(|&grey| u16::from_be_bytes([grey; 2])));
        } else {
            let (pairs, _) = row.data().as_chunks();
            values.extend(pairs.iter().map(|&pair| u16::from_be_bytes(pair)));
        }
    }
    Ok(values)
}

fn refused(error: png::DecodingError) -> DemError {
    invalid(error.to_string())
}

/// Reads a picture of heights.
pub(super) fn read(bytes: &[u8], sidecar: &Sidecar) -> Result<Dem, DemError> {
    let GreyScale { black, step } = GreyScale::of(sidecar)?;
    let picture = Greys::read(bytes, check_size)?;
    if picture.depth != 16 {
        return Err(invalid("the picture is not of 16-bit grey"));
    }
    let height = |&grey: &u16| (black + step * f64::from(grey)) as f32;
    let heights = picture.values.iter().map(height).collect();
    let pixel_m = [sidecar.metres_per_pixel; 2];
    Dem::new(picture.size, heights, pixel_m, sidecar.lat.zip(sidecar.lon))
}
