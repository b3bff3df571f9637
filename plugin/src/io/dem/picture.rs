//! Pictures of grey: every form of PNG is read where it holds greys.
//!
//! | form | grey where | void where |
//! |---|---|---|
//! | grey of 1 to 16 bits | everywhere | it is the transparent grey (tRNS) |
//! | RGB of 8 or 16 bits | R = G = B | it is the transparent colour (tRNS) |
//! | palette of 1 to 8 bits | R = G = B in its entry | its entry has an alpha of 0 (tRNS) |
//! | grey or RGB with alpha | as without | its alpha is 0 |
//!
//! Whatever is seen in part counts like the rest. What a file says of gamma and colour spaces does
//! not change a grey: it is a number, not a light.

use super::error::{DemError, invalid};
use png::{ColorType, Decoder, Info, Limits, Reader};
use std::io::{BufRead, Seek};

/// Memory that the decoder may take besides the pixels.
const DECODER_BYTES: usize = 64 << 20;

/// Most bytes of the pixels of an interlaced picture, all of which are held: its last row comes last,
/// and the others in pieces.
const MOST_INTERLACED_BYTES: usize = 128 << 20;

/// A level of grey.
#[derive(Clone, Copy, Debug)]
pub(in crate::io) struct Grey {
    /// Steps from black.
    pub(in crate::io) level: u16,
    /// Steps from black to white: 1, 3, 15, 255 or 65,535.
    pub(in crate::io) white: u16,
}

impl Grey {
    /// The grey, unless its level is that of voids.
    pub(in crate::io) fn unless(self, void: Option<f64>) -> Option<Self> {
        (void != Some(f64::from(self.level))).then_some(self)
    }

    /// The value of this grey, where black and white have values.
    pub(in crate::io) fn between(self, black: f64, white: f64) -> f32 {
        // Multiplied first: whole numbers of steps stay whole.
        let above = (white - black) * f64::from(self.level) / f64::from(self.white);
        (black + above) as f32
    }
}

/// Reads a picture a row at a time: `start` is told its columns and rows, `take` the number of the
/// first pixel of each row and the `value` of its greys, NaN for voids; rows come from the top.
///
/// # Errors
/// Those of `start`, and [`DemError::Invalid`] if the source is not a grey picture.
pub(in crate::io) fn fold_rows<R: BufRead + Seek, T, E: From<DemError>>(
    source: R,
    start: impl FnOnce([u32; 2]) -> Result<T, E>,
    value: impl Fn(Grey) -> f32,
    take: impl Fn(&mut T, usize, &[f32]),
) -> Result<T, E> {
    let mut reader = decoder(source).read_info().map_err(refused)?;
    let [width, height] = [reader.info().width, reader.info().height];
    let mut all = start([width, height])?;
    let form = PixelForm::new(reader.info());
    let mut values = vec![0.0; width as usize];
    let mut y = 0;
    rows(&mut reader, |row| {
        for (x, place) in values.iter_mut().enumerate() {
            let grey = form.grey(row, x).map_err(|why| at([x, y], &why))?;
            *place = grey.map_or(f32::NAN, &value);
        }
        take(&mut all, y * width as usize, &values);
        y += 1;
        Ok(())
    })?;
    Ok(all)
}

fn decoder<R: BufRead + Seek>(source: R) -> Decoder<R> {
    let limits = Limits {
        bytes: DECODER_BYTES,
    };
    let mut decoder = Decoder::new_with_limits(source, limits);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    decoder
}

/// Hands on the rows of a picture from the top.
fn rows<R: BufRead + Seek>(
    reader: &mut Reader<R>,
    mut take: impl FnMut(&[u8]) -> Result<(), DemError>,
) -> Result<(), DemError> {
    if !reader.info().interlaced {
        while let Some(row) = reader.next_row().map_err(refused)? {
            take(row.data())?;
        }
        return Ok(());
    }
    let all = reader.output_buffer_size().unwrap_or(usize::MAX);
    if all > MOST_INTERLACED_BYTES {
        return Err(invalid(
            "an interlaced picture of so many pixels is not read: save it without interlacing",
        ));
    }
    let mut pixels = vec![0; all];
    let frame = reader.next_frame(&mut pixels).map_err(refused)?;
    pixels.chunks_exact(frame.line_size).try_for_each(take)
}

fn refused(error: png::DecodingError) -> DemError {
    invalid(error.to_string())
}

/// The error of a pixel, at a column and a row from the top.
fn at([column, row]: [usize; 2], why: &str) -> DemError {
    invalid(format!(
        "the picture is not grey: pixel {column}, {row} {why}"
    ))
}

/// How the pixels of a picture lie in the bytes of its rows.
struct PixelForm {
    color: ColorType,
    /// Bits of a sample.
    bits: usize,
    /// Largest sample of a grey.
    white: u16,
    /// The colour that is transparent in a picture without alpha.
    transparent: Option<[u16; 3]>,
    palette: Vec<PaletteEntry>,
}

/// A colour and an alpha.
#[derive(Clone, Copy)]
struct PaletteEntry([u16; 3], u16);

impl PixelForm {
    fn new(info: &Info) -> Self {
        let is_indexed = info.color_type == ColorType::Indexed;
        let bits = info.bit_depth as usize;
        // The entries of a palette have 8 bits, whatever its indices have.
        let white = u16::MAX >> (16 - if is_indexed { 8 } else { bits });
        let trns = info.trns.as_deref().unwrap_or_default();
        let transparent = if is_indexed {
            None
        } else {
            transparent_color(trns, bits)
        };
        Self {
            color: info.color_type,
            bits,
            white,
            transparent,
            palette: entries(info.palette.as_deref().unwrap_or_default(), trns),
        }
    }

    /// The grey of pixel `x` of a row; none if it is transparent.
    fn grey(&self, row: &[u8], x: usize) -> Result<Option<Grey>, String> {
        let PaletteEntry(color, alpha) = self.pixel(row, x)?;
        if alpha == 0 || self.transparent == Some(color) {
            return Ok(None);
        }
        match color {
            [level, g, b] if level == g && g == b => {
                let white = self.white;
                Ok(Some(Grey { level, white }))
            }
            [r, g, b] => Err(format!("has the colour {r}, {g}, {b}")),
        }
    }

    /// Colour and alpha of pixel `x` of a row.
    fn pixel(&self, row: &[u8], x: usize) -> Result<PaletteEntry, String> {
        const SEEN: u16 = u16::MAX;
        let first = x * self.color.samples();
        let sample = |k: usize| sample(row, self.bits, first + k);
        let rgb = || [0, 1, 2].map(sample);
        Ok(match self.color {
            ColorType::Grayscale => PaletteEntry([sample(0); 3], SEEN),
            ColorType::GrayscaleAlpha => PaletteEntry([sample(0); 3], sample(1)),
            ColorType::Rgb => PaletteEntry(rgb(), SEEN),
            ColorType::Rgba => PaletteEntry(rgb(), sample(3)),
            ColorType::Indexed => {
                let entry = self.palette.get(usize::from(sample(0)));
                *entry.ok_or("has a colour that the palette lacks")?
            }
        })
    }
}

/// The `k`th sample of a row of samples of so many bits.
fn sample(row: &[u8], bits: usize, k: usize) -> u16 {
    match bits {
        16 => u16::from_be_bytes([row[2 * k], row[2 * k + 1]]),
        8 => u16::from(row[k]),
        _ => {
            // The first one lies in the highest bits.
            let packed = row[k * bits / 8] >> (8 - bits - k * bits % 8);
            u16::from(packed) & ((1 << bits) - 1)
        }
    }
}

/// The colour in a tRNS chunk, of samples of so many bits; a grey has one sample.
fn transparent_color(trns: &[u8], bits: usize) -> Option<[u16; 3]> {
    // The decoder leaves a byte of each sample of up to 8 bits.
    let sample = |k: usize| sample(trns, bits.max(8), k);
    match trns.len() * 8 / bits.max(8) {
        0 => None,
        1 | 2 => Some([sample(0); 3]),
        _ => Some([0, 1, 2].map(sample)),
    }
}

/// The colours of a palette with their alphas; those without one are seen.
fn entries(colors: &[u8], alphas: &[u8]) -> Vec<PaletteEntry> {
    let alphas = alphas.iter().copied().chain(std::iter::repeat(u8::MAX));
    let (colors, _) = colors.as_chunks::<3>();
    let entry = |(color, alpha): (&[u8; 3], u8)| PaletteEntry(color.map(u16::from), alpha.into());
    colors.iter().zip(alphas).map(entry).collect()
}

#[cfg(all(test, feature = "export"))]
#[path = "picture_tests.rs"]
mod tests;
