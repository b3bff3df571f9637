use super::*;
use crate::math;
use std::fs;
use std::io::Cursor;
use std::path::PathBuf;
use tempfile::TempDir;
use tiff::TiffResult;
use tiff::encoder::colortype::{self, ColorType};
use tiff::encoder::{TiffEncoder, TiffValue};
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
    let written = if float {
        geotiff_of::<colortype::Gray32Float>(&values, lon)
    } else {
        geotiff_of::<colortype::GrayI16>(&values.map(|value| value as i16), lon)
    };
    written.unwrap()
}

fn geotiff_of<C>(values: &[C::Inner], lon: Option<f64>) -> TiffResult<Vec<u8>>
where
    C: ColorType,
    [C::Inner]: TiffValue,
{
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes)?;
    let mut image = encoder.new_image::<C>(4, 2)?;
    if let Some(lon) = lon {
        let tie = [0.0, 0.0, 0.0, lon, 90.0, 0.0];
        let keys = [1_u16, 1, 0, 1, 1024, 0, 1, 2];
        let tags = image.encoder();
        tags.write_tag(Tag::ModelPixelScaleTag, &[90.0, 90.0, 0.0][..])?;
        tags.write_tag(Tag::ModelTiepointTag, &tie[..])?;
        tags.write_tag(Tag::GeoKeyDirectoryTag, &keys[..])?;
    }
    image.write_data(values)?;
    Ok(bytes.into_inner())
}

/// The value in the middle of pixel (`x`, `y`) of a map of 4 x 2.
fn at(map: &EquirectMap, x: u32, y: u32) -> f32 {
    value_at(map, x, y).unwrap()
}

/// The same, none in a void.
fn value_at(map: &EquirectMap, x: u32, y: u32) -> Option<f32> {
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
fn maps_from_another_meridian_are_turned() {
    let folder = TempDir::new().unwrap();
    let values = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];
    for (west, row) in [
        (0.0, [2.0, 3.0, 0.0, 1.0]),
        (90.0, [1.0, 2.0, 3.0, 0.0]),
        (-360.0, [2.0, 3.0, 0.0, 1.0]),
    ] {
        let bytes = geotiff(values, true, Some(west));
        let map = load_map(&file(&folder, "a.tif", &bytes), None).unwrap();
        assert_eq!([0, 1, 2, 3].map(|x| at(&map, x, 0)), row, "from {west}");
        assert_eq!(at(&map, 0, 1), row[0] + 4.0);
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
fn nodata_and_transparent_pixels_are_voids() {
    let folder = TempDir::new().unwrap();
    let land_only = geotiff(
        [1.0, 2.0, f32::NAN, 4.0, 5.0, 6.0, 7.0, f32::NAN],
        true,
        None,
    );
    let mut grey_and_alpha = Vec::new();
    let mut encoder = png::Encoder::new(&mut grey_and_alpha, 4, 2);
    encoder.set_color(png::ColorType::GrayscaleAlpha);
    let data = [1, 255, 2, 255, 3, 0, 4, 255, 5, 255, 6, 255, 7, 9, 8, 0];
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&data).unwrap();
    drop(writer);
    for (name, bytes) in [("a.tif", land_only), ("a.PNG", grey_and_alpha)] {
        let map = load_map(&file(&folder, name, &bytes), Some([0.0, 255.0])).unwrap();
        assert_eq!(map.voids(), 2);
        let row = |y| [0, 1, 2, 3].map(|x| value_at(&map, x, y));
        assert_eq!(row(0), [Some(1.0), Some(2.0), None, Some(4.0)]);
        assert_eq!(row(1), [Some(5.0), Some(6.0), Some(7.0), None]);
    }
}

#[test]
fn greys_of_any_depth_lie_between_black_and_white() {
    let folder = TempDir::new().unwrap();
    let path = file(
        &folder,
        "a.png",
        &png(4, png::BitDepth::Two, &[0b0001_1011; 2]),
    );
    let map = load_map(&path, Some([0.0, 30.0])).unwrap();
    let row = [0, 1, 2, 3].map(|x| at(&map, x, 0));
    assert_eq!(row, [0.0, 10.0, 20.0, 30.0]);
}

#[test]
fn sidecars_may_begin_with_a_byte_order_mark() {
    let folder = TempDir::new().unwrap();
    let path = file(&folder, "A.PNG", &png(4, png::BitDepth::Eight, &[255; 8]));
    file(
        &folder,
        "A.JSON",
        b"\xef\xbb\xbf{\"min\": 0,\r\n\"max\": 40}\r\n",
    );
    assert_eq!(at(&load_map(&path, None).unwrap(), 1, 1), 40.0);
}

/// Why a file of that name and content is refused, in one line that names it.
fn refusal(name: &str, bytes: &[u8], grey: Option<[f32; 2]>) -> String {
    let folder = TempDir::new().unwrap();
    let error = load_map(&file(&folder, name, bytes), grey).unwrap_err();
    let text = error.to_string();
    assert!(text.contains(name) && !text.contains('\n'), "{text}");
    text
}

#[test]
fn rasters_that_are_no_maps_are_refused() {
    let good = geotiff([1.0; 8], true, None);
    let voids = geotiff([f32::NAN; 8], true, None);
    assert!(refusal("a.jpg", &good, None).contains(".tif, .tiff or .png"));
    assert!(refusal("a.tif", b"nonsense", None).contains("no TIFF"));
    refusal("a.tif", &good[..good.len() / 2], None);
    assert!(refusal("a.tif", &voids, None).contains("only voids"));
}

#[test]
fn pictures_that_are_no_maps_are_refused() {
    let scale = Some([0.0, 1.0]);
    let good = png(4, png::BitDepth::Eight, &[7; 8]);
    let square = png(4, png::BitDepth::Eight, &[7; 12]);
    assert!(refusal("a.png", &square, scale).contains("not twice as wide as high"));
    refusal("a.png", &good[..good.len() - 14], scale);
    refusal("a.png", b"nonsense", scale);
    assert!(refusal("a.png", &good, None).contains("a.json"));
}

#[test]
fn sidecars_without_two_numbers_are_refused() {
    let folder = TempDir::new().unwrap();
    let path = file(&folder, "a.png", &png(4, png::BitDepth::Eight, &[7; 8]));
    for bad in [
        "{}",
        "[]",
        r#"{"min": 1, "max": 1}"#,
        r#"{"min": 0, "max": 1e99}"#,
        r#"{"min": 0, "peak": 1}"#,
    ] {
        file(&folder, "a.json", bad.as_bytes());
        let error = load_map(&path, Some([0.0, 1.0])).unwrap_err().to_string();
        let named = error.contains("a.json") && error.contains("finite numbers");
        assert!(named, "{bad}: {error}");
    }
}

#[test]
fn a_missing_file_cannot_be_read() {
    let folder = TempDir::new().unwrap();
    let missing = load_map(&folder.path().join("missing.tif"), None);
    assert!(matches!(missing, Err(IoError::Read { .. })));
}

/// A GeoTIFF of 4 x 2 values with the metadata of a unit.
fn in_unit(values: [f32; 8], unit: &str) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes).unwrap();
    let mut image = encoder.new_image::<colortype::Gray32Float>(4, 2).unwrap();
    let role = "<Item name=\"UNITTYPE\" sample=\"0\" role=\"unittype\">";
    let text = format!("<GDALMetadata>{role}{unit}</Item></GDALMetadata>");
    let tag = Tag::Unknown(42_112);
    image.encoder().write_tag(tag, text.as_str()).unwrap();
    image.write_data(&values).unwrap();
    bytes.into_inner()
}

#[test]
fn values_in_a_known_unit_are_converted_and_others_refused() {
    let folder = TempDir::new().unwrap();
    let load = |bytes: &[u8], quantity| load_map_of(&file(&folder, "a.tif", bytes), quantity, None);
    let kelvin = load(&in_unit([288.15; 8], "K"), MapQuantity::Temperature).unwrap();
    assert!((at(&kelvin.map, 0, 0) - 15.0).abs() < 1e-4);
    let flux = load(&in_unit([2.0; 8], "mm/day"), MapQuantity::Rain).unwrap();
    assert!((at(&flux.map, 0, 0) - 730.485).abs() < 1e-3);
    let feet = load(&in_unit([1000.0; 8], "ft"), MapQuantity::Elevation(1.0)).unwrap();
    assert!((at(&feet.map, 0, 0) - 304.8).abs() < 1e-3);
    let metres = load(&in_unit([1000.0; 8], "m"), MapQuantity::Elevation(1000.0)).unwrap();
    assert_eq!(at(&metres.map, 0, 0), 1.0, "the file knows better");
    for loaded in [kelvin, flux, feet, metres] {
        assert!(loaded.warnings.is_empty());
    }
    let odd = load(&in_unit([1.0; 8], "bananas"), MapQuantity::Rain)
        .unwrap_err()
        .to_string();
    assert!(
        odd.contains("bananas") && odd.contains("a.tif") && !odd.contains('\n'),
        "{odd}"
    );
}

#[test]
fn values_that_look_like_another_unit_are_doubted() {
    let folder = TempDir::new().unwrap();
    let path = file(&folder, "a.tif", &geotiff([288.0; 8], true, None));
    let loaded = load_map_of(&path, MapQuantity::Temperature, None).unwrap();
    assert!(
        loaded.warnings[0].contains("kelvin"),
        "{:?}",
        loaded.warnings
    );
}

/// GDAL's side file that tells something of a raster's band.
fn pam(content: &str) -> Vec<u8> {
    let band = format!("<PAMRasterBand>{content}</PAMRasterBand>");
    format!("<PAMDataset>{band}</PAMDataset>").into()
}

#[test]
fn world_files_turn_pictures_and_other_side_files_are_named() {
    let folder = TempDir::new().unwrap();
    let path = file(
        &folder,
        "a.png",
        &png(4, png::BitDepth::Eight, &[0, 1, 2, 3, 4, 5, 6, 7]),
    );
    file(&folder, "a.pgw", b"90\n0\n0\n-90\n45\n45\n");
    let map = load_map(&path, Some([0.0, 255.0])).unwrap();
    assert_eq!([0, 1, 2, 3].map(|x| at(&map, x, 0)), [2.0, 3.0, 0.0, 1.0]);
    let range = Some([0.0, 255.0]);
    file(
        &folder,
        "a.png.aux.xml",
        &pam("<NoDataValue>5</NoDataValue>"),
    );
    assert_eq!(load_map(&path, range).unwrap().voids(), 1);
    file(&folder, "a.png.aux.xml", &pam("<Scale>0.1</Scale>"));
    let problem = load_map(&path, range).unwrap_err().to_string();
    assert!(
        problem.contains("a.png.aux.xml") && problem.contains("Scale"),
        "{problem}"
    );
}

/// A sidecar as `export --box` writes it, of these edges.
fn of_box(west: f64, east: f64) -> String {
    format!(
        r#"{{"generator": "Pangaea", "min_m": -100, "max_m": 155, "metres_per_pixel": 9,
        "lat": 0, "lon": 0, "south": -90, "west": {west}, "north": 90, "east": {east}}}"#
    )
}

/// The map a.png of a folder with this sidecar.
fn map_with(folder: &TempDir, sidecar: &str) -> Result<EquirectMap, String> {
    file(folder, "a.json", sidecar.as_bytes());
    load_map(&folder.path().join("a.png"), None).map_err(|error| error.to_string())
}

#[test]
fn sidecars_of_exported_boxes_are_read() {
    let folder = TempDir::new().unwrap();
    let greys = [0, 1, 2, 3, 100, 101, 102, 255];
    file(&folder, "a.png", &png(4, png::BitDepth::Eight, &greys));
    let map = |sidecar: &str| map_with(&folder, sidecar);
    let whole = map(&of_box(-180.0, 180.0)).unwrap();
    assert_eq!([0, 3].map(|x| at(&whole, x, 1)), [0.0, 155.0]);
    // From Greenwich on.
    let turned = map(&of_box(0.0, 360.0)).unwrap();
    assert_eq!(
        [0, 1, 2, 3].map(|x| at(&turned, x, 0)),
        [-98.0, -97.0, -100.0, -99.0]
    );
    assert!(
        map(&of_box(10.0, 20.0))
            .unwrap_err()
            .contains("from 10 to 20")
    );
    let square = r#"{"min_m": 0, "max_m": 1, "metres_per_pixel": 9, "lat": 4, "lon": 5}"#;
    let problem = map(square).unwrap_err();
    assert!(
        problem.contains("a.json") && problem.contains("square"),
        "{problem}"
    );
    assert!(map(r#"{"max_m": 1}"#).is_err());
}
