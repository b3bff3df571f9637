//! GeoTIFF (OGC 19-008r4): one band of heights, with the size of a pixel in degrees or in a
//! projection's unit.
//!
//! Heights are in m. What is not read: rotated rasters, the tables of coordinate systems. A
//! projected raster is taken for true to scale, so its position is not told.

use super::{Dem, DemError, check_size, degrees_to_metres, filled};
use std::io::Cursor;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError};

/// Keys of the GeoKeyDirectory.
const MODEL_TYPE: u16 = 1024;
const LINEAR_UNITS: u16 = 3076;

/// Model types.
const PROJECTED: u16 = 1;
const GEOGRAPHIC: u16 = 2;

/// No compression that is read shrinks zeroes more than so many times: a small file never takes
/// much memory.
const MOST_SHRUNK: u64 = 4096;

/// The one band of a file.
pub(in crate::io) struct Band<'a> {
    decoder: Decoder<Cursor<&'a [u8]>>,
    /// Pixels to a row, and rows.
    pub(in crate::io) size: [u32; 2],
    /// Values with not-a-number for voids, rows from the top.
    pub(in crate::io) values: Vec<f32>,
}

impl<'a> Band<'a> {
    /// Reads a file, unless `check` refuses its size.
    pub(in crate::io) fn read<E: From<DemError>>(
        bytes: &'a [u8],
        check: impl FnOnce(u32, u32) -> Result<(), E>,
    ) -> Result<Self, E> {
        let invalid = |problem: &str| DemError::Invalid(problem.into());
        if !texts_fit(bytes).unwrap_or(false) {
            return Err(invalid("the file is cut short, or no TIFF").into());
        }
        let mut decoder = Decoder::new(Cursor::new(bytes)).map_err(refused)?;
        let (width, height) = decoder.dimensions().map_err(refused)?;
        check(width, height)?;
        let size = u64::from(width) * u64::from(height) * 8;
        if size > (bytes.len() as u64).saturating_mul(MOST_SHRUNK) {
            return Err(invalid("the file is too short for so many pixels").into());
        }
        let mut limits = Limits::default();
        limits.decoding_buffer_size = 1 << 30;
        let mut decoder = decoder.with_limits(limits);
        if !matches!(decoder.colortype().map_err(refused)?, ColorType::Gray(_)) {
            return Err(invalid("the file has more than one band").into());
        }
        let void = void(&mut decoder);
        let values = values(decoder.read_image().map_err(refused)?, void)?;
        Ok(Self {
            decoder,
            size: [width, height],
            values,
        })
    }

    /// Degrees that the file reaches over: from west, to east, from south, to north; `None` where
    /// it does not tell.
    pub(in crate::io) fn extent_deg(&mut self) -> Option<[f64; 4]> {
        let keys = self.decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).ok()?;
        let scale = self.decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag).ok()?;
        let tie = self.decoder.get_tag_f64_vec(Tag::ModelTiepointTag).ok()?;
        let (&[across, down, ..], &[column, row, _, lon, lat, ..]) =
            (scale.as_slice(), tie.as_slice())
        else {
            return None;
        };
        let (west, north) = (lon - column * across, lat + row * down);
        let [width, height] = self.size.map(f64::from);
        let extent = [west, west + width * across, north - height * down, north];
        (short_key(&keys, MODEL_TYPE) == Some(GEOGRAPHIC)).then_some(extent)
    }
}

/// Reads a file of heights.
pub(super) fn read(bytes: &[u8]) -> Result<Dem, DemError> {
    let Band {
        mut decoder,
        size,
        values,
    } = Band::read(bytes, check_size)?;
    let (pixel_m, centre) = georeference(&mut decoder, size)?;
    filled(size[0], size[1], values, pixel_m, centre)
}

/// Is no text among the tags of the first image longer than the file? The decoder makes room for
/// texts before it reads them, and prints a line of its own when one is too long. `None` of what is
/// no TIFF.
fn texts_fit(bytes: &[u8]) -> Option<bool> {
    const ASCII: u64 = 2;
    let little = bytes.starts_with(b"II");
    let number = |at: u64, size: usize| -> Option<u64> {
        let at = usize::try_from(at).ok()?;
        let digits = bytes.get(at..at.checked_add(size)?)?;
        let push = |n: u64, digit: &u8| n << 8 | u64::from(*digit);
        Some(if little {
            digits.iter().rev().fold(0, push)
        } else {
            digits.iter().fold(0, push)
        })
    };
    // Size of an offset, of the number of tags, and of a tag; a BigTIFF's are larger.
    let (first, offset, counter, tag) = if number(2, 2)? == 43 {
        (8, 8, 8, 20)
    } else {
        (4, 4, 2, 12)
    };
    let directory = number(first, offset)?;
    // Tags that are not there end the search with `None`.
    for i in 0..number(directory, counter)? {
        let entry = directory
            .checked_add(counter as u64)?
            .checked_add(i.checked_mul(tag)?)?;
        if number(entry.checked_add(2)?, 2)? == ASCII
            && number(entry + 4, offset)? > bytes.len() as u64
        {
            return Some(false);
        }
    }
    Some(true)
}

fn refused(error: TiffError) -> DemError {
    DemError::Invalid(error.to_string())
}

/// Size of a pixel in m, and latitude and longitude of the middle, if they are told.
fn georeference(
    decoder: &mut Decoder<Cursor<&[u8]>>,
    size: [u32; 2],
) -> Result<([f64; 2], Option<(f64, f64)>), DemError> {
    let numbers = |decoder: &mut Decoder<_>, tag| decoder.get_tag_f64_vec(tag).ok();
    let scale = numbers(decoder, Tag::ModelPixelScaleTag).unwrap_or_default();
    let &[across, down, ..] = scale.as_slice() else {
        return Err(DemError::Invalid("the file has no ModelPixelScale".into()));
    };
    let pixel = [across.abs(), down.abs()];
    let keys = decoder
        .get_tag_u16_vec(Tag::GeoKeyDirectoryTag)
        .unwrap_or_default();
    match short_key(&keys, MODEL_TYPE) {
        Some(GEOGRAPHIC) => {
            let tie = numbers(decoder, Tag::ModelTiepointTag).unwrap_or_default();
            let &[column, row, _, lon, lat, ..] = tie.as_slice() else {
                return Err(DemError::Invalid("the file has no ModelTiepoint".into()));
            };
            let middle = |size: u32, tied: f64| 0.5 * f64::from(size) - tied;
            let lat = lat - middle(size[1], row) * pixel[1];
            let lon = lon + middle(size[0], column) * pixel[0];
            Ok((
                degrees_to_metres(pixel, lat)?,
                lon.is_finite().then_some((lat, lon)),
            ))
        }
        Some(PROJECTED) | None => {
            let unit = match short_key(&keys, LINEAR_UNITS) {
                None | Some(9001 | 32_767) => 1.0,
                Some(9002) => 0.3048,
                Some(9003) => 1200.0 / 3937.0,
                Some(other) => {
                    return Err(DemError::Invalid(format!("unknown unit of length {other}")));
                }
            };
            Ok((pixel.map(|side| side * unit), None))
        }
        Some(other) => Err(DemError::Invalid(format!(
            "coordinates of model type {other} are not read"
        ))),
    }
}

/// The value of a key that is a plain number.
fn short_key(keys: &[u16], id: u16) -> Option<u16> {
    // After four words of header: key, where its value is (0: here), count, value.
    keys.chunks_exact(4)
        .skip(1)
        .find(|key| key[0] == id && key[1] == 0)
        .map(|key| key[3])
}

/// The value that GDAL marks voids with; SRTM's where none is told.
fn void(decoder: &mut Decoder<Cursor<&[u8]>>) -> f64 {
    let text = decoder
        .get_tag_ascii_string(Tag::GdalNodata)
        .unwrap_or_default();
    text.trim_matches(['\0', ' ']).parse().unwrap_or(-32_768.0)
}

fn values(image: DecodingResult, void: f64) -> Result<Vec<f32>, DemError> {
    fn all<T: Copy + Into<f64>>(values: &[T], void: f64) -> Vec<f32> {
        let number = |&value: &T| {
            let z: f64 = value.into();
            if z == void { f32::NAN } else { z as f32 }
        };
        values.iter().map(number).collect()
    }
    match image {
        DecodingResult::I16(values) => Ok(all(&values, void)),
        DecodingResult::U16(values) => Ok(all(&values, void)),
        DecodingResult::I32(values) => Ok(all(&values, void)),
        // A void of -3.4e38 was rounded to an f32 before it was written out.
        DecodingResult::F32(values) => Ok(all(&values, f64::from(void as f32))),
        DecodingResult::F64(values) => Ok(all(&values, void)),
        _ => Err(DemError::Invalid(
            "values must be i16, u16, i32, f32 or f64".into(),
        )),
    }
}
