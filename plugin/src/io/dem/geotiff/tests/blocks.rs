//! Compressions, predictors, types of samples, blocks, masks.

use super::writer::{Image, PLAIN, Style, Values, tiff};
use super::{fields, plain, refusal, short, values, with};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::io::Write;
use weezl::BitOrder;
use weezl::encode::Encoder;

const UNSIGNED: u16 = 1;
const SIGNED: u16 = 2;
const FLOAT: u16 = 3;

fn lzw(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = Encoder::with_tiff_size_switch(BitOrder::Msb, 8);
    encoder.encode(bytes).unwrap()
}

fn deflate(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// A frame of one block as it is, and one of a byte that repeats (RFC 8878, 3.1.1).
fn zstd(bytes: &[u8], byte: u8, count: u8) -> Vec<u8> {
    let size = bytes.len() as u8 + count;
    let head = [0x28, 0xb5, 0x2f, 0xfd, 0x20, size];
    let raw = (bytes.len() as u32) << 3;
    let rle = u32::from(count) << 3 | 2 | 1;
    let [raw, rle] = [raw, rle].map(u32::to_le_bytes);
    [&head, &raw[..3], bytes, &rle[..3], &[byte]].concat()
}

#[test]
fn lzw_needs_no_end() {
    let bytes: Vec<u8> = (0..200_u32).map(|i| (i * i % 251) as u8).collect();
    let right: Vec<f32> = bytes.iter().map(|&byte| f32::from(byte)).collect();
    let whole = lzw(&bytes);
    // The code for the end has nine bits.
    let cut = whole[..whole.len() - 1].to_vec();
    let longer = lzw(&[bytes.clone(), vec![7; 50]].concat());
    for block in [whole, cut, longer] {
        let file = plain(fields([20, 10], 8, UNSIGNED, 5), block);
        assert_eq!(values(&file), Ok(right.clone()));
    }
    let short = plain(fields([20, 10], 8, UNSIGNED, 5), lzw(&bytes[..150]));
    assert!(refusal(&short).contains("cut short"));
}

#[test]
fn pixels_of_one_byte_are_read_from_long_lzw_words() {
    let file = plain(fields([1, 5000], 8, UNSIGNED, 5), lzw(&[9; 5000]));
    assert_eq!(values(&file), Ok(vec![9.0; 5000]));
}

#[test]
fn deflate_has_two_numbers() {
    for number in [8, 32_946] {
        let file = plain(
            fields([2, 2], 8, UNSIGNED, number),
            deflate(&[1, 2, 3, 255]),
        );
        assert_eq!(values(&file), Ok(vec![1.0, 2.0, 3.0, 255.0]));
    }
}

/// The example of Apple's Technical Note 1023.
#[test]
fn packbits_are_runs() {
    let packed: [i16; 15] = [
        -2, 0xaa, 2, 0x80, 0, 0x2a, -3, 0xaa, 3, 0x80, 0, 0x2a, 0x22, -9, 0xaa,
    ];
    let block = packed.map(|byte| byte as u8).to_vec();
    let file = plain(fields([24, 1], 8, UNSIGNED, 32_773), block);
    let right = [
        [0xaa, 0xaa, 0xaa, 0x80, 0, 0x2a, 0xaa, 0xaa],
        [0xaa, 0xaa, 0x80, 0, 0x2a, 0x22, 0xaa, 0xaa],
        [0xaa; 8],
    ];
    let right: Vec<f32> = right
        .concat()
        .into_iter()
        .map(|byte: u8| f32::from(byte))
        .collect();
    assert_eq!(values(&file), Ok(right));
}

#[test]
fn zstandard_is_read() {
    let file = plain(fields([3, 2], 8, UNSIGNED, 50_000), zstd(&[5, 6], 7, 4));
    assert_eq!(values(&file), Ok(vec![5.0, 6.0, 7.0, 7.0, 7.0, 7.0]));
}

/// A block of GDAL's, of 3 x 2 pixels without loss.
const LERC: [u8; 103] = [
    76, 101, 114, 99, 50, 32, 4, 0, 0, 0, 78, 176, 255, 62, 2, 0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, 6,
    0, 0, 0, 8, 0, 0, 0, 103, 0, 0, 0, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2,
    192, 0, 0, 0, 0, 0, 192, 114, 64, 0, 0, 0, 0, 0, 0, 16, 192, 0, 0, 150, 67, 1, 0, 0, 192, 63,
    0, 0, 16, 192, 0, 0, 150, 67, 0, 0, 128, 64, 0, 0, 176, 64, 111, 18, 131, 58,
];

#[test]
fn lerc_is_read() {
    let right = vec![1.5, -2.25, 300.0, 4.0, 5.5, 1e-3];
    let zstd = zstd(&LERC, 0, 0);
    for (wrapping, block) in [(0, LERC.to_vec()), (1, deflate(&LERC)), (2, zstd)] {
        let parameters = Values::Long(vec![4, wrapping]);
        let tags = with(fields([3, 2], 32, FLOAT, 34_887), [(50_674, parameters)]);
        assert_eq!(values(&plain(tags, block)), Ok(right.clone()), "{wrapping}");
    }
    let other = plain(fields([3, 2], 16, SIGNED, 34_887), LERC.to_vec());
    assert!(refusal(&other).contains("another type"));
}

#[test]
fn predictors_are_undone() {
    // 1000, 1003, 999 and 5, 5, 6 as differences.
    let rows: Vec<u8> = [1000_i16, 3, -4, 5, 0, 1].map(i16::to_le_bytes).concat();
    let tags = with(fields([3, 2], 16, SIGNED, 8), [(317, short(2))]);
    let right = vec![1000.0, 1003.0, 999.0, 5.0, 5.0, 6.0];
    assert_eq!(values(&plain(tags, deflate(&rows))), Ok(right));
    // 1.0 is 3f80_0000 and 2.5 is 4020_0000: bytes by rank, then their differences.
    let apart = [0x3f, 0x01, 0x40, 0xa0, 0xe0, 0, 0, 0];
    let tags = with(fields([2, 1], 32, FLOAT, 8), [(317, short(3))]);
    assert_eq!(values(&plain(tags, deflate(&apart))), Ok(vec![1.0, 2.5]));
    let tags = with(fields([2, 1], 32, FLOAT, 8), [(317, short(9))]);
    assert!(refusal(&plain(tags, deflate(&apart))).contains("Predictor 9"));
}

/// Bits, format and bytes of two samples, and their values.
fn typed_samples() -> [(u16, u16, Vec<u8>, [f32; 2]); 11] {
    [
        (8, UNSIGNED, vec![200, 3], [200.0, 3.0]),
        (8, SIGNED, vec![200, 3], [-56.0, 3.0]),
        (16, UNSIGNED, vec![0, 0x80, 1, 0], [32_768.0, 1.0]),
        (16, SIGNED, vec![0xff, 0xff, 1, 0], [-1.0, 1.0]),
        (
            32,
            UNSIGNED,
            [3_000_000_000_u32, 1].map(u32::to_le_bytes).concat(),
            [3e9, 1.0],
        ),
        (
            32,
            SIGNED,
            [-5_i32, 1].map(i32::to_le_bytes).concat(),
            [-5.0, 1.0],
        ),
        (
            64,
            SIGNED,
            [-5_i64, 1].map(i64::to_le_bytes).concat(),
            [-5.0, 1.0],
        ),
        (16, FLOAT, vec![0, 0x3e, 0, 0xc0], [1.5, -2.0]),
        (
            64,
            FLOAT,
            [0.5_f64, -1e3].map(f64::to_le_bytes).concat(),
            [0.5, -1e3],
        ),
        (4, UNSIGNED, vec![0x5c], [5.0, 12.0]),
        (12, UNSIGNED, vec![0xab, 0xc1, 0x23], [2748.0, 291.0]),
    ]
}

#[test]
fn samples_have_many_types() {
    for (bits, format, block, right) in typed_samples() {
        let file = plain(fields([2, 1], bits, format, 1), block);
        assert_eq!(
            values(&file),
            Ok(right.to_vec()),
            "{bits} bits of format {format}"
        );
    }
}

#[test]
fn both_byte_orders_and_big_tiffs_are_read() {
    for (is_big_endian, is_big_tiff) in [(false, true), (true, false), (true, true)] {
        let style = Style {
            is_big_endian,
            is_big_tiff,
        };
        let bytes = if is_big_endian {
            [1, 2, 0xff, 0xfe]
        } else {
            [2, 1, 0xfe, 0xff]
        };
        let fields = fields([2, 1], 16, SIGNED, 1);
        let blocks = vec![bytes.to_vec()];
        let file = tiff(style, vec![Image { fields, blocks }]);
        assert_eq!(values(&file), Ok(vec![258.0, -2.0]));
    }
}

/// 3 x 2 pixels in tiles of 2 x 2, of which the second is left out.
fn tiles(nodata: Option<&'static str>) -> Vec<u8> {
    let mut tags = with(
        fields([3, 2], 8, UNSIGNED, 1),
        [(322, short(2)), (323, short(2))],
    );
    tags.retain(|(tag, _)| *tag != 278);
    tags.extend(nodata.map(|text| (42_113, Values::Text(text))));
    let blocks = vec![vec![1, 2, 4, 5], vec![]];
    tiff(
        PLAIN,
        vec![Image {
            fields: tags,
            blocks,
        }],
    )
}

#[test]
fn tiles_that_are_left_out_hold_the_void_or_zero() {
    let zero = vec![1.0, 2.0, 0.0, 4.0, 5.0, 0.0];
    assert_eq!(values(&tiles(None)), Ok(zero));
    let void = values(&tiles(Some("9"))).unwrap();
    assert!(void[2].is_nan() && void[5].is_nan());
    assert_eq!((void[1], void[4]), (2.0, 5.0));
}

/// An image of 9 x 1 pixels, one of less resolution, and a mask of a bit to a pixel that lets every
/// other pixel through.
#[test]
fn internal_masks_make_voids() {
    let kind = |number| (254, Values::Long(vec![number]));
    let overview = with(fields([4, 1], 8, UNSIGNED, 1), [kind(1)]);
    let mask = with(fields([9, 1], 1, UNSIGNED, 1), [kind(4), (262, short(4))]);
    let images = [
        (fields([9, 1], 8, UNSIGNED, 1), vec![7; 9]),
        (overview, vec![1; 4]),
        (mask, vec![0b1010_1010, 0b1000_0000]),
    ];
    let images = images.map(|(fields, block)| {
        let blocks = vec![block];
        Image { fields, blocks }
    });
    let values = values(&tiff(PLAIN, images.into())).unwrap();
    for (x, value) in values.iter().enumerate() {
        assert_eq!(value.is_nan(), x % 2 == 1, "{x}");
    }
}

/// The pixels of one block, row by row.
fn pixels_of(
    [x0, y0]: [usize; 2],
    [across, down]: [usize; 2],
    pixel: impl Fn(usize, usize) -> u8,
) -> Vec<u8> {
    let pixel = &pixel;
    let rows = y0..y0 + down;
    rows.flat_map(|y| (x0..x0 + across).map(move |x| pixel(x, y)))
        .collect()
}

/// Blocks of 8 x 6 pixels, of so many columns and rows, and the tags that tell them.
fn cut(
    block: [usize; 2],
    pixel: impl Fn(usize, usize) -> u8,
) -> (Vec<(u16, Values)>, Vec<Vec<u8>>) {
    let [across, down] = block;
    let starts = (0..6)
        .step_by(down)
        .flat_map(|y| (0..8).step_by(across).map(move |x| [x, y]));
    let blocks = starts
        .map(|start| pixels_of(start, block, &pixel))
        .collect();
    let tags = fields([8, 6], 8, UNSIGNED, 1);
    let [columns, rows] = block.map(|side| short(side as u16));
    if across == 8 {
        return (with(tags, [(278, rows)]), blocks);
    }
    let mut tags = with(tags, [(322, columns), (323, rows)]);
    tags.retain(|(tag, _)| *tag != 278);
    (tags, blocks)
}

#[test]
fn masks_may_lie_in_other_blocks_than_their_images() {
    let is_void = |x: usize, y: usize| (x + 3 * y).is_multiple_of(5);
    let forms = [[8, 6], [8, 2], [8, 1], [4, 2], [4, 3], [2, 6]];
    for (of_image, of_mask) in forms.into_iter().flat_map(|a| forms.map(|b| (a, b))) {
        let (image, pixels) = cut(of_image, |x, y| (8 * y + x) as u8);
        let (mask, valid) = cut(of_mask, |x, y| u8::from(!is_void(x, y)));
        let mask = with(mask, [(254, Values::Long(vec![4])), (262, short(4))]);
        let [image, mask] =
            [(image, pixels), (mask, valid)].map(|(fields, blocks)| Image { fields, blocks });
        let values = values(&tiff(PLAIN, vec![image, mask])).unwrap();
        for (i, value) in values.iter().enumerate() {
            let right = (!is_void(i % 8, i / 8)).then_some(i as f32);
            let read = (!value.is_nan()).then_some(*value);
            assert_eq!(read, right, "pixel {i}: {of_image:?}, {of_mask:?}");
        }
    }
}

#[test]
fn a_second_sample_tells_how_opaque_a_pixel_is() {
    for (planar, blocks) in [
        (1, vec![vec![5, 255, 6, 0]]),
        (2, vec![vec![5, 6], vec![255, 0]]),
    ] {
        let tags = [(277, short(2)), (284, short(planar)), (338, short(2))];
        let fields = with(fields([2, 1], 8, UNSIGNED, 1), tags);
        let values = values(&tiff(PLAIN, vec![Image { fields, blocks }])).unwrap();
        assert!(values[0] == 5.0 && values[1].is_nan());
    }
}

#[test]
fn numbers_stay_as_they_are_where_the_least_is_white() {
    let tags = with(fields([2, 1], 8, UNSIGNED, 1), [(262, short(0))]);
    assert_eq!(values(&plain(tags, vec![1, 200])), Ok(vec![1.0, 200.0]));
}

#[test]
fn what_is_not_read_is_refused_by_its_tag() {
    for (tag, value, words) in [
        (259, 7, "Compression 7 (JPEG)"),
        (259, 34_925, "Compression 34925 (LZMA)"),
        (259, 50_001, "Compression 50001 (WebP)"),
        (259, 99, "Compression 99"),
        (339, 6, "SampleFormat 6"),
        (258, 48, "BitsPerSample 48"),
        (262, 3, "PhotometricInterpretation 3"),
        (266, 2, "FillOrder 2"),
        (277, 3, "SamplesPerPixel 3"),
        (277, 2, "SamplesPerPixel 2"),
        (278, 0, "RowsPerStrip"),
        (257, 0, "ImageLength"),
        (257, 60_000, "StripOffsets"),
    ] {
        let mut tags = with(fields([2, 1], 8, UNSIGNED, 1), [(tag, short(value))]);
        if value == 60_000 {
            tags = with(tags, [(278, short(1))]);
        }
        let text = refusal(&plain(tags, vec![1; 64]));
        assert!(
            text.contains(words) && !text.contains('\n'),
            "{words}: {text}"
        );
    }
}
