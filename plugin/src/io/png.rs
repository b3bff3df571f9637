//! Pictures: 16-bit grey for elevations, 8-bit RGB for maps.
//!
//! Grey value = (z + 12) / 24 x 65535 with z in km, clamped: 0 is -12 km, 65535 is +12 km, and one
//! step is 0.37 m.

use crate::overlay::Raster;
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};
use std::io::{self, Write};

/// Bytes of a chunk of a picture that is written as its rows come.
const CHUNK_BYTES: usize = 1 << 18;

/// Elevation of the grey value 0.
const LOWEST_KM: f32 = -12.0;
/// Difference of elevation between the greatest grey value and 0.
const RANGE_KM: f32 = 24.0;

/// The grey value of an elevation in km.
pub fn grey_of_elevation(z: f32) -> u16 {
    let level = f64::from((z - LOWEST_KM) / RANGE_KM) * 65_535.0;
    // NaN becomes 0.
    (level + 0.5).clamp(0.0, 65_535.0) as u16
}

/// The elevation in km of a grey value.
pub fn elevation_of_grey(grey: u16) -> f32 {
    f32::from(grey) / 65_535.0 * RANGE_KM + LOWEST_KM
}

/// A 16-bit grey PNG of elevations in km, `width` to a row, rows from the top.
///
/// ```
/// use bevy_pangaea::io::png::{elevation_of_grey, elevation_png, grey_of_elevation};
///
/// let file = elevation_png(2, &[-4.0, 0.0, 0.5, 8.0])?;
/// assert!(file.starts_with(b"\x89PNG"));
/// assert!((elevation_of_grey(grey_of_elevation(8.0)) - 8.0).abs() < 4e-4);
/// # Ok::<(), png::EncodingError>(())
/// ```
///
/// # Errors
/// If the elevations are not whole rows.
pub fn elevation_png(width: u32, elevation: &[f32]) -> Result<Vec<u8>, EncodingError> {
    grey_png(width, elevation.iter().map(|&z| grey_of_elevation(z)))
}

/// A 16-bit grey PNG, `width` to a row, rows from the top.
///
/// # Errors
/// If the values are not whole rows.
pub fn grey_png(width: u32, greys: impl Iterator<Item = u16>) -> Result<Vec<u8>, EncodingError> {
    let bytes: Vec<u8> = greys.flat_map(u16::to_be_bytes).collect();
    let height = (bytes.len() / 2) as u32 / width.max(1);
    encode(
        width,
        height,
        ColorType::Grayscale,
        BitDepth::Sixteen,
        &bytes,
    )
}

/// Writes a 16-bit grey PNG of so many columns and rows as they come: `rows` writes greys of two
/// bytes, big endian, rows from the top.
///
/// ```
/// use bevy_pangaea::io::png::write_grey_png;
///
/// let mut file = Vec::new();
/// write_grey_png(&mut file, [2, 1], |rows| rows.write_all(&[0, 7, 255, 255]))?;
/// assert!(file.starts_with(b"\x89PNG"));
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Those of `rows` and `out`, and if the greys are not as many as the picture has.
pub fn write_grey_png(
    out: &mut dyn Write,
    [width, height]: [u32; 2],
    rows: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut encoder = Encoder::new(out, width, height);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(BitDepth::Sixteen);
    encoder.set_compression(Compression::Fast);
    encoder.add_text_chunk("Software".into(), "Pangaea".into())?;
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer_with_size(CHUNK_BYTES)?;
    rows(&mut stream)?;
    stream.finish()?;
    Ok(writer.finish()?)
}

/// An RGB PNG.
///
/// # Errors
/// If the raster's size and content do not fit.
pub fn rgb_png(raster: &Raster) -> Result<Vec<u8>, EncodingError> {
    encode(
        raster.width,
        raster.height,
        ColorType::Rgb,
        BitDepth::Eight,
        &raster.rgb,
    )
}

fn encode(
    width: u32,
    height: u32,
    color: ColorType,
    depth: BitDepth,
    bytes: &[u8],
) -> Result<Vec<u8>, EncodingError> {
    let mut out = Vec::new();
    let mut encoder = Encoder::new(&mut out, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    encoder.set_compression(Compression::Fast);
    encoder.add_text_chunk("Software".into(), "Pangaea".into())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(bytes)?;
    writer.finish()?;
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grey_values_are_those_of_the_formula() {
        assert_eq!(grey_of_elevation(-12.0), 0);
        assert_eq!(grey_of_elevation(12.0), 65_535);
        assert_eq!(grey_of_elevation(0.0), 32_768);
        assert_eq!(grey_of_elevation(-100.0), 0);
        assert_eq!(grey_of_elevation(1e9), 65_535);
        assert_eq!(grey_of_elevation(f32::NAN), 0);
        for z in [-11.0_f32, -3.3, 0.0, 8.8] {
            assert!((elevation_of_grey(grey_of_elevation(z)) - z).abs() < 4e-4);
        }
    }

    /// Size and pixels of a picture.
    fn decoded(file: &[u8]) -> ((u32, u32), Vec<u8>) {
        let mut reader = png::Decoder::new(io::Cursor::new(file))
            .read_info()
            .unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        ((info.width, info.height), pixels)
    }

    #[test]
    fn elevations_are_read_as_written() {
        let elevation = [-11.0_f32, -5.0, 0.0, 3.0, 9.0, 12.0];
        let (size, pixels) = decoded(&elevation_png(3, &elevation).unwrap());
        assert_eq!(size, (3, 2));
        let greys = elevation.map(|z| grey_of_elevation(z).to_be_bytes());
        assert_eq!(pixels, greys.concat());
    }

    #[test]
    fn greys_that_come_in_parts_are_read_as_written() {
        let bytes: Vec<u8> = (0..=239).collect();
        let mut file = Vec::new();
        write_grey_png(&mut file, [40, 3], |out| {
            bytes.chunks(7).try_for_each(|part| out.write_all(part))
        })
        .unwrap();
        assert_eq!(decoded(&file), ((40, 3), bytes));
    }

    #[test]
    fn too_few_greys_are_refused() {
        let mut file = Vec::new();
        assert!(write_grey_png(&mut file, [2, 2], |out| out.write_all(&[0; 7])).is_err());
    }

    #[test]
    fn colours_are_read_as_written() {
        let raster = Raster {
            width: 1,
            height: 2,
            rgb: vec![1, 2, 3, 4, 5, 6],
        };
        let (size, pixels) = decoded(&rgb_png(&raster).unwrap());
        assert_eq!((size, pixels), ((1, 2), raster.rgb));
    }

    #[test]
    fn broken_rows_are_refused() {
        assert!(elevation_png(4, &[0.0; 6]).is_err());
        assert!(elevation_png(0, &[]).is_err());
        let short = Raster {
            width: 2,
            height: 2,
            rgb: vec![0; 3],
        };
        assert!(rgb_png(&short).is_err());
    }
}
