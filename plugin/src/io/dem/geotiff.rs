//! GeoTIFF (OGC 19-008r4): one band of heights, with the size of a pixel in degrees or in a
//! projection's unit.
//!
//! Heights are in m. Rotated rasters and the tables of coordinate systems are not read. A projected
//! raster is taken for true to scale, so its position is not told.

use super::error::{DemError, invalid};
use super::tile::{Dem, check_size, degrees_to_metres};
use std::io::Cursor;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError};

/// Keys of the GeoKeyDirectory.
const GT_MODEL_TYPE: u16 = 1024;
const PROJ_LINEAR_UNITS: u16 = 3076;

/// Model types.
const PROJECTED: u16 = 1;
const GEOGRAPHIC: u16 = 2;

/// No compression that is read shrinks zeroes more than so many times: a small file never takes
/// much memory.
const MAX_COMPRESSION: u64 = 4096;

/// The one band of a file.
pub(in crate::io) struct RasterBand<'a> {
    decoder: Decoder<Cursor<&'a [u8]>>,
    /// Pixels to a row, and rows.
    pub(in crate::io) size: [u32; 2],
    /// Values with NaN for voids, rows from the top.
    pub(in crate::io) values: Vec<f32>,
}

impl<'a> RasterBand<'a> {
    /// Reads a file, unless `check` refuses its size.
    pub(in crate::io) fn read<E: From<DemError>>(
        bytes: &'a [u8],
        check: impl FnOnce(u32, u32) -> Result<(), E>,
    ) -> Result<Self, E> {
        if !texts_fit(bytes).unwrap_or(false) {
            return Err(invalid("the file is cut short, or no TIFF").into());
        }
        let mut decoder = Decoder::new(Cursor::new(bytes)).map_err(refused)?;
        let (width, height) = decoder.dimensions().map_err(refused)?;
        check(width, height)?;
        // Refused before the decoder makes room for what its header promises.
        let most = (bytes.len() as u64).saturating_mul(MAX_COMPRESSION);
        if u64::from(width) * u64::from(height) * 8 > most {
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

    /// Degrees that the file reaches over: from west, to east, from south, to north; `None` if it
    /// does not tell.
    pub(in crate::io) fn extent_deg(&mut self) -> Option<[f64; 4]> {
        let keys = self.decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).ok()?;
        let scale = self.decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag).ok()?;
        let tie = self.decoder.get_tag_f64_vec(Tag::ModelTiepointTag).ok()?;
        let &[across, down, ..] = scale.as_slice() else {
            return None;
        };
        let &[column, row, _, lon, lat, ..] = tie.as_slice() else {
            return None;
        };
        // The tie point need not be a corner.
        let (west, north) = (lon - column * across, lat + row * down);
        let [width, height] = self.size.map(f64::from);
        let extent = [west, west + width * across, north - height * down, north];
        (short_key(&keys, GT_MODEL_TYPE) == Some(GEOGRAPHIC)).then_some(extent)
    }
}

/// Reads a file of heights.
pub(super) fn read(bytes: &[u8]) -> Result<Dem, DemError> {
    let mut band = RasterBand::read(bytes, check_size)?;
    let (pixel_m, centre) = georeference(&mut band.decoder, band.size)?;
    Dem::new(band.size, band.values, pixel_m, centre)
}

/// Is no text among the tags of the first image longer than the file? The decoder makes room for
/// texts before it reads them, and prints a line of its own when one is too long. `None` if the
/// bytes are no TIFF.
fn texts_fit(bytes: &[u8]) -> Option<bool> {
    const ASCII: u64 = 2;
    const BIG_TIFF: u64 = 43;
    // Where the directory's offset is; bytes of an offset, of the number of tags, and of a tag.
    let (first, offset, counter, tag) = match number(bytes, 2, 2)? {
        BIG_TIFF => (8, 8, 8, 20),
        _ => (4, 4, 2, 12),
    };
    let directory = number(bytes, first, offset)?;
    // Tags that are not there end the search with `None`.
    for i in 0..number(bytes, directory, counter)? {
        let entry = directory
            .checked_add(counter as u64)?
            .checked_add(i.checked_mul(tag)?)?;
        let kind = number(bytes, entry.checked_add(2)?, 2)?;
        if kind == ASCII && number(bytes, entry + 4, offset)? > bytes.len() as u64 {
            return Some(false);
        }
    }
    Some(true)
}

/// The number of `size` bytes at a place, in the byte order of the file.
fn number(bytes: &[u8], at: u64, size: usize) -> Option<u64> {
    let at = usize::try_from(at).ok()?;
    let digits = bytes.get(at..at.checked_add(size)?)?;
    let push = |n: u64, digit: &u8| n << 8 | u64::from(*digit);
    Some(if bytes.starts_with(b"II") {
        digits.iter().rev().fold(0, push)
    } else {
        digits.iter().fold(0, push)
    })
}

fn refused(error: TiffError) -> DemError {
    invalid(error.to_string())
}

/// Size of a pixel in m, and latitude and longitude of the middle, if they are told.
fn georeference(
    decoder: &mut Decoder<Cursor<&[u8]>>,
    size: [u32; 2],
) -> Result<([f64; 2], Option<(f64, f64)>), DemError> {
    let scale = numbers(decoder, Tag::ModelPixelScaleTag);
    let &[across, down, ..] = scale.as_slice() else {
        return Err(invalid("the file has no ModelPixelScale"));
    };
    let pixel = [across.abs(), down.abs()];
    let keys = decoder
        .get_tag_u16_vec(Tag::GeoKeyDirectoryTag)
        .unwrap_or_default();
    match short_key(&keys, GT_MODEL_TYPE) {
        Some(GEOGRAPHIC) => {
            let (lat, lon) = middle(decoder, size, pixel)?;
            let centre = lon.is_finite().then_some((lat, lon));
            Ok((degrees_to_metres(pixel, lat)?, centre))
        }
        Some(PROJECTED) | None => {
            let unit_m = linear_unit(&keys)?;
            Ok((pixel.map(|side| side * unit_m), None))
        }
        Some(other) => Err(invalid(format!(
            "coordinates of model type {other} are not read"
        ))),
    }
}

fn numbers(decoder: &mut Decoder<Cursor<&[u8]>>, tag: Tag) -> Vec<f64> {
    decoder.get_tag_f64_vec(tag).unwrap_or_default()
}

/// Latitude and longitude of the middle of a raster in degrees.
fn middle(
    decoder: &mut Decoder<Cursor<&[u8]>>,
    [width, height]: [u32; 2],
    [across, down]: [f64; 2],
) -> Result<(f64, f64), DemError> {
    let tie = numbers(decoder, Tag::ModelTiepointTag);
    let &[column, row, _, lon, lat, ..] = tie.as_slice() else {
        return Err(invalid("the file has no ModelTiepoint"));
    };
    // From the tie point to the middle.
    let lat = lat - (0.5 * f64::from(height) - row) * down;
    let lon = lon + (0.5 * f64::from(width) - column) * across;
    Ok((lat, lon))
}

/// Length in m of the unit of a projection.
fn linear_unit(keys: &[u16]) -> Result<f64, DemError> {
    match short_key(keys, PROJ_LINEAR_UNITS) {
        // Metre, or user-defined.
        None | Some(9001 | 32_767) => Ok(1.0),
        // Foot, and US survey foot.
        Some(9002) => Ok(0.3048),
        Some(9003) => Ok(1200.0 / 3937.0),
        Some(other) => Err(invalid(format!("unknown unit of length {other}"))),
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

/// The value that GDAL marks voids with; by default that of SRTM.
fn void(decoder: &mut Decoder<Cursor<&[u8]>>) -> f64 {
    let text = decoder
        .get_tag_ascii_string(Tag::GdalNodata)
        .unwrap_or_default();
    text.trim_matches(['\0', ' ']).parse().unwrap_or(-32_768.0)
}

/// The values of a raster with NaN for voids.
fn values(image: DecodingResult, void: f64) -> Result<Vec<f32>, DemError> {
    match image {
        DecodingResult::I16(values) => Ok(without_voids(&values, void)),
        DecodingResult::U16(values) => Ok(without_voids(&values, void)),
        DecodingResult::I32(values) => Ok(without_voids(&values, void)),
        // A void of -3.4e38 was rounded to an f32 before it was written out.
        DecodingResult::F32(values) => Ok(without_voids(&values, f64::from(void as f32))),
        DecodingResult::F64(values) => Ok(without_voids(&values, void)),
        _ => Err(invalid("values must be i16, u16, i32, f32 or f64")),
    }
}

fn without_voids<T: Copy + Into<f64>>(values: &[T], void: f64) -> Vec<f32> {
    values
        .iter()
        .map(|&value| value.into())
        .map(|z: f64| if z == void { f32::NAN } else { z as f32 })
        .collect()
}
