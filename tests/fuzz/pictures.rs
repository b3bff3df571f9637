//! Good pictures of both kinds that are read, as small as they come.

use std::io::{Cursor, Seek, Write};
use tiff::TiffResult;
use tiff::encoder::colortype::{ColorType, Gray32Float, GrayI16};
use tiff::encoder::{Compression, DirectoryEncoder, TiffEncoder, TiffKind, TiffValue};
use tiff::tags::Tag;

/// Bytes of a PNG before its first chunk, and of a chunk's head.
const SIGNATURE: usize = 8;
const HEAD: usize = 8;

/// Words of TIFF: both byte orders, BigTIFF, tags and types as little-endian numbers.
pub(super) const TIFF_WORDS: &[&str] = &[
    "II*\0",
    "MM\0*",
    "II+\0",
    "\0\u{1}",
    "\u{1}\u{1}",
    "\u{2}\u{1}",
    "\u{3}\u{1}",
    "\u{11}\u{1}",
    "\u{16}\u{1}",
    "\u{17}\u{1}",
    "\u{2}\0",
    "\u{3}\0",
    "\u{4}\0",
    "\u{5}\0",
    "\u{c}\0",
    "-9999\0",
    "nan\0",
    "\0\0\0\0",
];

/// Words of PNG.
pub(super) const PNG_WORDS: &[&str] = &[
    "IHDR", "IDAT", "IEND", "PLTE", "tRNS", "gAMA", "iCCP", "tEXt", "zTXt", "acTL", "fcTL", "\0",
];

/// Words of sidecars.
pub(super) const JSON_WORDS: &[&str] = &[
    "{",
    "}",
    "[",
    "]",
    ":",
    ",",
    "\"",
    "null",
    "true",
    "-",
    "1e400",
    "1e308",
    "\\u0000",
    "\"min\"",
    "\"max_m\"",
    "\"metres_per_unit\"",
];

/// Place of a raster on the globe: size of a pixel and north west corner, and whether in degrees.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// Side of a pixel, degrees or m.
    pub pixel: f64,
    /// Longitude and latitude, or east and north, of the corner.
    pub corner: [f64; 2],
    /// Degrees instead of metres.
    pub is_geographic: bool,
}

/// A ramp of values.
fn ramp(size: [u32; 2]) -> Vec<f32> {
    (0..size[0] * size[1])
        .map(|i| 100.0 + 7.0 * i as f32)
        .collect()
}

/// GeoTIFFs of one band in whole numbers and in others, with each compression that is read.
pub(super) fn geotiffs(size: [u32; 2], place: Place) -> Vec<Vec<u8>> {
    let compressions = [
        Compression::Uncompressed,
        Compression::Lzw,
        Compression::Deflate(Default::default()),
    ];
    let values = ramp(size);
    let whole: Vec<i16> = values.iter().map(|&value| value as i16).collect();
    let mut files = Vec::new();
    for compression in compressions {
        files.push(geotiff::<Gray32Float>(
            size,
            Some(place),
            &values,
            compression,
        ));
        files.push(geotiff::<GrayI16>(size, Some(place), &whole, compression));
    }
    files
}

/// A TIFF that tells no place.
pub(super) fn placeless(size: [u32; 2]) -> Vec<u8> {
    geotiff::<Gray32Float>(size, None, &ramp(size), Compression::Uncompressed)
}

fn geotiff<C>(
    [width, height]: [u32; 2],
    place: Option<Place>,
    values: &[C::Inner],
    compression: Compression,
) -> Vec<u8>
where
    C: ColorType,
    [C::Inner]: TiffValue,
{
    let mut bytes = Cursor::new(Vec::new());
    let encoder = TiffEncoder::new(&mut bytes).expect("memory can be written");
    let mut encoder = encoder.with_compression(compression);
    let mut image = encoder
        .new_image::<C>(width, height)
        .expect("a size that there is");
    if let Some(place) = place {
        place.write(image.encoder()).expect("memory can be written");
    }
    image.write_data(values).expect("memory can be written");
    bytes.into_inner()
}

impl Place {
    fn write<W: Write + Seek, K: TiffKind>(
        self,
        tags: &mut DirectoryEncoder<'_, W, K>,
    ) -> TiffResult<()> {
        let [x, y] = self.corner;
        let model = if self.is_geographic { 2 } else { 1 };
        let keys = [1_u16, 1, 0, 1, 1024, 0, 1, model];
        tags.write_tag(Tag::ModelPixelScaleTag, &[self.pixel, self.pixel, 0.0][..])?;
        tags.write_tag(Tag::ModelTiepointTag, &[0.0, 0.0, 0.0, x, y, 0.0][..])?;
        tags.write_tag(Tag::GeoKeyDirectoryTag, &keys[..])?;
        tags.write_tag(Tag::GdalNodata, "-9999")
    }
}

/// PNGs of grey: of 16 and of 8 bits, as colours, with alpha, of a palette, and one that says it is
/// interlaced.
pub(super) fn pngs(size: [u32; 2]) -> Vec<Vec<u8>> {
    use png::BitDepth::{Eight, Sixteen};
    use png::ColorType::{Grayscale, GrayscaleAlpha, Indexed, Rgb, Rgba};
    let greys = ramp(size);
    let two: Vec<u8> = greys
        .iter()
        .flat_map(|&grey| (grey as u16).to_be_bytes())
        .collect();
    let deep = png(size, (Grayscale, Sixteen), &two);
    let kinds = [Grayscale, GrayscaleAlpha, Rgb, Rgba, Indexed];
    let shallow = kinds.map(|kind| {
        let pixel = |&grey: &f32| vec![grey as u8; kind.samples()];
        png(
            size,
            (kind, Eight),
            &greys.iter().flat_map(pixel).collect::<Vec<_>>(),
        )
    });
    let interlaced = interlaced(&shallow[0]);
    [&[deep, interlaced][..], &shallow].concat()
}

fn png(
    [width, height]: [u32; 2],
    (color, depth): (png::ColorType, png::BitDepth),
    data: &[u8],
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == png::ColorType::Indexed {
        let greys: Vec<u8> = (0..=u8::MAX).flat_map(|grey| [grey; 3]).collect();
        encoder.set_palette(greys);
        encoder.set_trns(&[255, 0, 128][..]);
    }
    let mut writer = encoder.write_header().expect("memory can be written");
    writer
        .write_image_data(data)
        .expect("rows of the right length");
    drop(writer);
    bytes
}

/// The picture with a header that says that its rows come in seven passes.
fn interlaced(picture: &[u8]) -> Vec<u8> {
    // Behind size, depth, colour, compression and filter.
    const INTERLACE: usize = SIGNATURE + HEAD + 12;
    let mut bytes = picture.to_vec();
    bytes[INTERLACE] = 1;
    mended(&bytes)
}

/// The picture with the right check sum in every chunk, so that damage gets past them.
pub(super) fn mended(picture: &[u8]) -> Vec<u8> {
    let mut bytes = picture.to_vec();
    let mut at = SIGNATURE;
    while let Some(length) = bytes.get(at..).and_then(|rest| rest.first_chunk::<4>()) {
        let end = at + HEAD + u32::from_be_bytes(*length) as usize;
        let Some(content) = bytes.get(at + 4..end) else {
            break;
        };
        let mut sum = flate2::Crc::new();
        sum.update(content);
        if let Some(place) = bytes.get_mut(end..end + 4) {
            place.copy_from_slice(&sum.sum().to_be_bytes());
        }
        at = end + 4;
    }
    bytes
}
