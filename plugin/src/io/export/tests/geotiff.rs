//! GeoTIFF, as another reader finds it.

use super::*;
use crate::io::load_dem;
use std::io::Cursor;
use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::Tag;

/// The tags of a GeoTIFF.
pub(super) struct WrittenTags {
    pub(super) scale: Vec<f64>,
    pub(super) tie: Vec<f64>,
    pub(super) keys: Vec<[u16; 4]>,
    doubles: Vec<f64>,
    text: String,
}

impl WrittenTags {
    pub(super) fn read(decoder: &mut Decoder<Cursor<&Vec<u8>>>) -> Self {
        let directory = decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap();
        Self {
            scale: decoder.get_tag_f64_vec(Tag::ModelPixelScaleTag).unwrap(),
            tie: decoder.get_tag_f64_vec(Tag::ModelTiepointTag).unwrap(),
            keys: directory.as_chunks().0.to_vec(),
            doubles: decoder.get_tag_f64_vec(Tag::GeoDoubleParamsTag).unwrap(),
            text: decoder
                .get_tag_ascii_string(Tag::GeoAsciiParamsTag)
                .unwrap(),
        }
    }

    /// The value of a key that points to the doubles.
    pub(super) fn double(&self, key: u16) -> f64 {
        let entry = self.keys.iter().find(|entry| entry[0] == key).unwrap();
        assert_eq!(entry[1..3], [34_736, 1]);
        self.doubles[usize::from(entry[3])]
    }
}

#[test]
fn a_geotiff_says_where_it_is() {
    let (_folder, files) = exported("a.tif", 100);
    let bytes = fs::read(&files[0]).unwrap();
    let mut decoder = Decoder::new(Cursor::new(&bytes)).unwrap();
    let tags = WrittenTags::read(&mut decoder);
    assert_eq!(tags.scale, [400.0, 400.0, 0.0]);
    assert_eq!(tags.tie, [0.0, 0.0, 0.0, -20_000.0, 20_000.0, 0.0]);
    assert_eq!((tags.double(2057), tags.double(2058)), (R, R));
    assert_eq!((tags.double(3088), tags.double(3089)), (20.0, -10.0));
    let shorts = [
        (1024, 1),
        (1025, 1),
        (3072, 32_767),
        (3075, 12),
        (3076, 9001),
    ];
    for (key, value) in shorts {
        assert!(tags.keys.contains(&[key, 0, 1, value]), "{key}");
    }
}

#[test]
fn the_keys_of_a_geotiff_ascend_and_their_texts_end() {
    let (_folder, files) = exported("a.tif", 100);
    let bytes = fs::read(&files[0]).unwrap();
    let mut decoder = Decoder::new(Cursor::new(&bytes)).unwrap();
    let tags = WrittenTags::read(&mut decoder);
    let (head, keys) = tags.keys.split_first().unwrap();
    assert_eq!(*head, [1, 1, 0, keys.len() as u16]);
    assert!(keys.is_sorted_by(|a, b| a[0] < b[0]));
    for &[_, _, length, start] in keys.iter().filter(|key| key[1] == 34_737) {
        let text = &tags.text[usize::from(start)..usize::from(start + length)];
        assert!(text.ends_with('|'), "{text}");
    }
}

#[test]
fn a_geotiff_holds_metres() {
    let (_folder, files) = exported("a.tif", 100);
    let bytes = fs::read(&files[0]).unwrap();
    let mut decoder = Decoder::new(Cursor::new(&bytes)).unwrap();
    assert_eq!(decoder.dimensions().unwrap(), (100, 100));
    assert_eq!(decoder.colortype().unwrap(), tiff::ColorType::Gray(32));
    let DecodingResult::F32(values) = decoder.read_image().unwrap() else {
        panic!("f32")
    };
    // Row 10, column 30 is 7800 m to the west and 15,800 m to the north.
    assert!((values[10 * 100 + 30] - height(-7800.0, 15_800.0)).abs() < 1e-3);
    // It is read again as ground, too.
    let dem = load_dem(&files[0]).unwrap();
    assert_eq!((dem.grid.pixel_m, dem.grid.values), ([400.0; 2], values));
}

/// Tags and values of a GeoTIFF.
pub(super) fn read(path: &Path) -> (WrittenTags, (u32, u32), Vec<f32>) {
    let bytes = fs::read(path).unwrap();
    let mut decoder = Decoder::new(Cursor::new(&bytes)).unwrap();
    let tags = WrittenTags::read(&mut decoder);
    let size = decoder.dimensions().unwrap();
    let DecodingResult::F32(values) = decoder.read_image().unwrap() else {
        panic!("f32")
    };
    (tags, size, values)
}

#[test]
fn strips_lie_end_to_end_up_to_the_end_of_the_file() {
    // Rows of 400 bytes: 655 of them fill a strip of 256 KiB.
    let degrees = crate::query::DegreeBox::new([0.0, 0.0, 10.0, 1.0], R, [100, 1000]).unwrap();
    let (_folder, files) = written("a.tif", degrees, None);
    let bytes = fs::read(&files[0]).unwrap();
    let mut decoder = Decoder::new(Cursor::new(&bytes)).unwrap();
    let offsets = decoder.get_tag_u32_vec(Tag::StripOffsets).unwrap();
    let counts = decoder.get_tag_u32_vec(Tag::StripByteCounts).unwrap();
    assert_eq!(counts, [655 * 400, 345 * 400]);
    assert_eq!(offsets[1], offsets[0] + counts[0]);
    assert_eq!((offsets[1] + counts[1]) as usize, bytes.len());
}
