use super::*;
use png::{BitDepth, Encoder};
use std::io::Cursor;

/// A picture whose rows are given as bytes, before it is written.
struct Picture<'a> {
    width: u32,
    color: ColorType,
    depth: BitDepth,
    /// All rows.
    data: &'a [u8],
    palette: Option<&'a [u8]>,
    trns: Option<&'a [u8]>,
}

impl Picture<'_> {
    fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        let bits = self.width as usize * self.color.samples() * self.depth as usize;
        let height = self.data.len() / bits.div_ceil(8);
        let mut encoder = Encoder::new(&mut bytes, self.width, height as u32);
        encoder.set_color(self.color);
        encoder.set_depth(self.depth);
        if let Some(palette) = self.palette {
            encoder.set_palette(palette);
        }
        if let Some(trns) = self.trns {
            encoder.set_trns(trns);
        }
        // What it says of light changes no grey.
        encoder.set_source_gamma(png::ScaledFloat::new(0.3));
        let mut writer = encoder.write_header().unwrap();
        writer.write_image_data(self.data).unwrap();
        drop(writer);
        bytes
    }

    /// Its levels, -1 for voids, and the level of white.
    fn levels(&self) -> Result<(Vec<i32>, u16), DemError> {
        levels(&self.bytes())
    }
}

fn picture(width: u32, color: ColorType, depth: BitDepth, data: &[u8]) -> Picture<'_> {
    Picture {
        width,
        color,
        depth,
        data,
        palette: None,
        trns: None,
    }
}

fn levels(bytes: &[u8]) -> Result<(Vec<i32>, u16), DemError> {
    let levels = values(bytes, |grey| f32::from(grey.level))?;
    let whites = values(bytes, |grey| f32::from(grey.white))?;
    let white = whites.into_iter().fold(0.0, f32::max) as u16;
    let level = |&value: &f32| if value.is_nan() { -1 } else { value as i32 };
    Ok((levels.iter().map(level).collect(), white))
}

/// A value of every pixel.
fn values(bytes: &[u8], value: impl Fn(Grey) -> f32) -> Result<Vec<f32>, DemError> {
    let start = |_| Ok::<_, DemError>(Vec::new());
    fold_rows(Cursor::new(bytes), start, value, |all, place, row| {
        assert_eq!(all.len(), place);
        all.extend_from_slice(row);
    })
}

#[test]
fn greys_of_all_depths_are_read() {
    use BitDepth::{Eight, Four, One, Sixteen, Two};
    for (depth, data, expected, white) in [
        (One, &[0b1010_0000, 0b0110_0000][..], [1, 0, 1, 0, 1, 1], 1),
        (Two, &[0b0001_1000, 0b1100_0100], [0, 1, 2, 3, 0, 1], 3),
        (Four, &[0x0f, 0x70, 0x12, 0x30], [0, 15, 7, 1, 2, 3], 15),
        (Eight, &[0, 255, 7, 1, 2, 3], [0, 255, 7, 1, 2, 3], 255),
        (
            Sixteen,
            &[0, 0, 0xff, 0xff, 1, 2, 0, 1, 0, 2, 0, 3],
            [0, 65_535, 258, 1, 2, 3],
            65_535,
        ),
    ] {
        let read = picture(3, ColorType::Grayscale, depth, data).levels();
        assert_eq!(read, Ok((expected.to_vec(), white)), "{depth:?}");
    }
}

#[test]
fn transparent_pixels_are_voids_and_others_are_seen() {
    let grey = [7, 255, 9, 0, 30, 128];
    let read = picture(3, ColorType::GrayscaleAlpha, BitDepth::Eight, &grey).levels();
    assert_eq!(read, Ok((vec![7, -1, 30], 255)));
    // The colour of what is not seen does not matter.
    let rgba = [7, 7, 7, 1, 90, 0, 3, 0];
    let read = picture(2, ColorType::Rgba, BitDepth::Eight, &rgba).levels();
    assert_eq!(read, Ok((vec![7, -1], 255)));
    let deep = [1, 0, 0, 0, 1, 0, 0, 1];
    let read = picture(2, ColorType::GrayscaleAlpha, BitDepth::Sixteen, &deep).levels();
    assert_eq!(read, Ok((vec![-1, 256], 65_535)));
}

#[test]
fn a_grey_or_a_colour_may_be_the_transparent_one() {
    let grey = Picture {
        trns: Some(&[0, 9]),
        ..picture(3, ColorType::Grayscale, BitDepth::Eight, &[8, 9, 10])
    };
    assert_eq!(grey.levels(), Ok((vec![8, -1, 10], 255)));
    let deep = Picture {
        trns: Some(&[1, 9]),
        ..picture(2, ColorType::Grayscale, BitDepth::Sixteen, &[0, 9, 1, 9])
    };
    assert_eq!(deep.levels(), Ok((vec![9, -1], 65_535)));
    let rgb = Picture {
        trns: Some(&[0, 255, 0, 0, 0, 255]),
        ..picture(2, ColorType::Rgb, BitDepth::Eight, &[5, 5, 5, 255, 0, 255])
    };
    assert_eq!(rgb.levels(), Ok((vec![5, -1], 255)));
}

#[test]
fn greys_may_come_as_colours() {
    let read = picture(
        2,
        ColorType::Rgb,
        BitDepth::Eight,
        &[3, 3, 3, 200, 200, 200],
    )
    .levels();
    assert_eq!(read, Ok((vec![3, 200], 255)));
    let deep = [1, 2, 1, 2, 1, 2, 0, 5, 0, 5, 0, 5];
    let read = picture(2, ColorType::Rgb, BitDepth::Sixteen, &deep).levels();
    assert_eq!(read, Ok((vec![258, 5], 65_535)));
}

/// A palette of white, black, a grey, and red.
const PALETTE: [u8; 12] = [255, 255, 255, 0, 0, 0, 100, 100, 100, 200, 0, 0];

#[test]
fn palettes_of_greys_are_read_and_their_alphas_make_voids() {
    for (depth, data) in [
        (BitDepth::Two, &[0b0001_1000][..]),
        (BitDepth::Four, &[0x01, 0x20]),
        (BitDepth::Eight, &[0, 1, 2]),
    ] {
        let mut indexed = picture(3, ColorType::Indexed, depth, data);
        indexed.palette = Some(&PALETTE);
        assert_eq!(indexed.levels(), Ok((vec![255, 0, 100], 255)), "{depth:?}");
        indexed.trns = Some(&[255, 0]);
        assert_eq!(indexed.levels(), Ok((vec![255, -1, 100], 255)), "{depth:?}");
    }
}

/// Why a picture is refused.
fn refusal(picture: &Picture) -> String {
    picture.levels().unwrap_err().to_string()
}

#[test]
fn the_first_pixel_that_is_not_grey_is_named() {
    let rgb = [3, 3, 3, 4, 4, 4, 5, 5, 5, 10, 20, 30];
    let colored = picture(2, ColorType::Rgb, BitDepth::Eight, &rgb);
    let expected = "the picture is not grey: pixel 1, 1 has the colour 10, 20, 30";
    assert_eq!(refusal(&colored), expected);
    let mut indexed = picture(2, ColorType::Indexed, BitDepth::Eight, &[1, 3]);
    indexed.palette = Some(&PALETTE);
    assert!(refusal(&indexed).contains("pixel 1, 0 has the colour 200, 0, 0"));
    indexed.data = &[1, 4];
    assert!(refusal(&indexed).contains("pixel 1, 0 has a colour that the palette lacks"));
}

/// 9 x 5 greys of 16 bits, 1000 y + x, interlaced by an encoder that is not ours.
const INTERLACED: &[u8] =
    b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x09\0\0\0\x05\x10\0\0\0\x01\x95\xafub\0\0\0\x60IDATx\
    \xda\x05\xc1\xd7\x15\x01\x01\x14E\xd1\xc3\xc5\xb5\xd6\xfbx\xfd\xff\x09\x23\x94\x20S\x82a\
    \x84\x12\xe4\x99\x12\xec\r\xd0\x87\x0e\x39\xc8\x22\xe7\xd0\xa6G\x8er\x8a\x8f\x3e\xb9\xf2\
    \xd5wh\x21\xba\x18\x97\x3e\xfb\xe2\x1b\x39\xccqNr\x86\x1ez\xea\xa5\xb7\x3e\xfa\xea\xa7Z\r\
    \xb1\x88e\xacb\x1d\x9b\xd8\xc6\x2e\xf6q\xf8\x03\xac\xb7\x1d\x89b\xdd\x3a\xcf\0\0\0\0IEND\
    \xaeB\x60\x82";

/// 9 x 5 greys of two bits, (x + y) mod 4, by the same encoder.
const INTERLACED_2_BITS: &[u8] =
    b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x09\0\0\0\x05\x02\0\0\0\x01\x8f\x8f\xb1\x80\0\0\0\x1dI\
    DATx\xdac\x60\0\x83\x05\x40\xd8\xd1\xc0P\xcep\x17\x88sr\x1c\x18\x8e\x1d\x3b\0\0F\xee\x07xs\
    Biq\0\0\0\0IEND\xaeB\x60\x82";

#[test]
fn interlaced_pictures_are_read() {
    let pixels = || (0..5).flat_map(|y| (0..9).map(move |x| (x, y)));
    let ramp: Vec<i32> = pixels().map(|(x, y)| 1000 * y + x).collect();
    assert_eq!(levels(INTERLACED), Ok((ramp, 65_535)));
    let pattern: Vec<i32> = pixels().map(|(x, y)| (x + y) % 4).collect();
    assert_eq!(levels(INTERLACED_2_BITS), Ok((pattern, 3)));
}

#[test]
fn a_short_file_that_promises_many_pixels_takes_no_memory_for_them() {
    let mut bytes = INTERLACED.to_vec();
    let side = 60_000_u32.to_be_bytes();
    bytes[16..20].copy_from_slice(&side);
    bytes[20..24].copy_from_slice(&side);
    // The right check sum of the new header.
    bytes[29..33].copy_from_slice(&[0x82, 0x2e, 0xc6, 0x4b]);
    let problem = levels(&bytes).unwrap_err().to_string();
    assert!(problem.contains("without interlacing"), "{problem}");
}
