use super::*;
use crate::math;
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;
use tempfile::TempDir;
use tiff::encoder::{TiffEncoder, colortype};
use tiff::tags::Tag;

/// Writes `bytes` to a file of that name.
fn file(folder: &TempDir, name: &str, bytes: &[u8]) -> PathBuf {
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    path
}

/// A grey picture of `depth` bits.
fn png(width: u32, depth: png::BitDepth, data: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let height = (data.len() * 8 / depth as usize) as u32 / width;
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(depth);
    encoder
        .write_header()
        .unwrap()
        .write_image_data(data)
        .unwrap();
    bytes
}

/// A GeoTIFF of 4 x 2 pixels of 90 degrees, whose north west corner lies at `lon` and 90° N.
fn geotiff(values: [f32; 8], float: bool, lon: Option<f64>) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes).unwrap();
    macro_rules! write {
        ($color:ty, $values:expr) => {{
            let mut image = encoder.new_image::<$color>(4, 2).unwrap();
            if let Some(lon) = lon {
                let tags = image.encoder();
                tags.write_tag(Tag::ModelPixelScaleTag, &[90.0, 90.0, 0.0][..])
                    .unwrap();
                tags.write_tag(Tag::ModelTiepointTag, &[0.0, 0.0, 0.0, lon, 90.0, 0.0][..])
                    .unwrap();
                tags.write_tag(
                    Tag::GeoKeyDirectoryTag,
                    &[1_u16, 1, 0, 1, 1024, 0, 1, 2][..],
                )
                .unwrap();
            }
            image.write_data($values).unwrap();
        }};
    }
    if float {
        write!(colortype::Gray32Float, &values);
    } else {
        write!(colortype::GrayI16, &values.map(|value| value as i16));
    }
    bytes.into_inner()
}

/// The value in the middle of pixel (`x`, `y`) of a map of 4 x 2.
fn at(map: &EquirectMap, x: u32, y: u32) -> f32 {
    map.at(math::direction(
        45.0 - 90.0 * f64::from(y),
        90.0 * f64::from(x) - 135.0,
    ))
}

#[test]
fn geotiffs_hold_values() {
    let folder = TempDir::new().unwrap();
    let values = [0.0, 250.0, 500.0, 750.0, 1000.0, 2000.0, 3000.0, -4000.0];
    for (float, lon) in [
        (true, None),
        (false, None),
        (true, Some(-180.0)),
        (false, Some(-180.0)),
    ] {
        let map = load_map(&file(&folder, "a.tif", &geotiff(values, float, lon)), None).unwrap();
        assert_eq!(map.size(), [4, 2]);
        for i in 0..8 {
            assert_eq!(at(&map, i % 4, i / 4), values[i as usize]);
        }
    }
}

#[test]
fn greys_lie_between_the_values_of_black_and_white() {
    let folder = TempDir::new().unwrap();
    let eight = png(
        4,
        png::BitDepth::Eight,
        &[0, 51, 102, 153, 204, 255, 0, 255],
    );
    let sixteen: Vec<u8> = [0_u16, 13_107, 26_214, 39_321, 52_428, 65_535, 0, 65_535]
        .into_iter()
        .flat_map(u16::to_be_bytes)
        .collect();
    for bytes in [eight, png(4, png::BitDepth::Sixteen, &sixteen)] {
        let path = file(&folder, "a.png", &bytes);
        let map = load_map(&path, Some([-50.0, 50.0])).unwrap();
        let row: Vec<f32> = (0..4).map(|x| at(&map, x, 0)).collect();
        assert_eq!(
            (row, at(&map, 1, 1)),
            (vec![-50.0, -30.0, -10.0, 10.0], 50.0)
        );
        // A sidecar knows better, and white may stand for less than black.
        let sidecar = file(&folder, "a.json", br#"{"min": 1000, "max": 0}"#);
        assert_eq!(
            at(&load_map(&path, Some([-50.0, 50.0])).unwrap(), 1, 0),
            800.0
        );
        fs::remove_file(sidecar).unwrap();
    }
}

#[test]
fn what_is_no_map_is_refused_in_one_line_that_names_the_file() {
    let folder = TempDir::new().unwrap();
    let refused = |name: &str, bytes: &[u8], grey: Option<[f32; 2]>, word: &str| {
        let path = file(&folder, name, bytes);
        let problem = load_map(&path, grey).unwrap_err().to_string();
        assert!(
            problem.contains(name) && problem.contains(word),
            "{problem}"
        );
        assert!(!problem.contains('\n'), "{problem}");
    };
    let good = geotiff([1.0; 8], true, None);
    refused("a.jpg", &good, None, ".tif, .tiff or .png");
    refused("a.tif", b"nonsense", None, "no TIFF");
    refused("a.tif", &good[..good.len() / 2], None, "");
    refused(
        "a.tif",
        &geotiff([1.0, 2.0, f32::NAN, 4.0, 5.0, 6.0, 7.0, 8.0], true, None),
        None,
        "pixel 2",
    );
    refused(
        "a.tif",
        &geotiff([1.0; 8], true, Some(0.0)),
        None,
        "from 0 to 360 °E",
    );
    let wide = png(4, png::BitDepth::Eight, &[7; 12]);
    refused(
        "a.png",
        &wide,
        Some([0.0, 1.0]),
        "not twice as wide as high",
    );
    let whole = png(4, png::BitDepth::Eight, &[7; 8]);
    refused("a.png", &whole[..whole.len() - 14], Some([0.0, 1.0]), "");
    refused("a.png", b"nonsense", Some([0.0, 1.0]), "");
    refused(
        "a.png",
        &png(8, png::BitDepth::Four, &[7; 16]),
        Some([0.0, 1.0]),
        "8-bit or 16-bit grey",
    );
    refused("a.png", &whole, None, "a.json");
    for bad in [
        "{}",
        "[]",
        r#"{"min": 1, "max": 1}"#,
        r#"{"min": 0, "max": 1e99}"#,
        r#"{"min": 0, "peak": 1}"#,
    ] {
        let sidecar = file(&folder, "a.json", bad.as_bytes());
        let problem = load_map(&folder.path().join("a.png"), Some([0.0, 1.0]))
            .unwrap_err()
            .to_string();
        assert!(
            problem.contains("a.json") && problem.contains("finite numbers"),
            "{bad}: {problem}"
        );
        fs::remove_file(sidecar).unwrap();
    }
    let missing = load_map(&folder.path().join("missing.tif"), None).unwrap_err();
    assert!(matches!(missing, IoError::Read { .. }));
}
