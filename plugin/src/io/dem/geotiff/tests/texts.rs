//! Texts: the value of voids, scale and offset, units of height.

use super::writer::Values;
use super::{SideFiles, fields, plain, read, refusal, short, values, with};
use crate::io::dem::error::DemError;
use std::io::Cursor;

/// A file of one row of f32 with a text for its voids.
fn row(numbers: [f32; 3], nodata: &'static str) -> Vec<u8> {
    let tags = with(fields([3, 1], 32, 3, 1), [(42_113, Values::Text(nodata))]);
    plain(tags, numbers.map(f32::to_le_bytes).concat())
}

#[test]
fn voids_are_told_as_c_libraries_write_numbers() {
    for (text, void) in [
        ("-9999", -9999.0),
        (" -9999\n", -9999.0),
        ("-9.999e3", -9999.0),
        ("-9999.0 m", -9999.0),
        ("1,5", 1.5),
        ("-3.4028234663852886e+38", f32::MIN),
        ("-3.40282347e+38", f32::MIN),
        ("inf", f32::INFINITY),
        ("-1.#INF", f32::NEG_INFINITY),
        ("0x10", 0.0),
    ] {
        let values = values(&row([1.0, void, 2.0], text)).unwrap();
        assert!(values[1].is_nan(), "{text:?}");
        assert_eq!((values[0], values[2]), (1.0, 2.0), "{text:?}");
    }
}

#[test]
fn nan_marks_nothing_but_itself() {
    for text in ["nan", "-nan", "NaN", "-1.#IND", "1.#QNAN", " "] {
        let values = values(&row([0.0, f32::NAN, -9999.0], text)).unwrap();
        assert!(values[1].is_nan(), "{text:?}");
        assert_eq!((values[0], values[2]), (0.0, -9999.0), "{text:?}");
    }
    assert!(refusal(&row([0.0; 3], "none")).contains("GDAL_NODATA \"none\""));
}

#[test]
fn a_void_out_of_the_range_of_samples_marks_nothing() {
    let tags = with(fields([3, 1], 8, 1, 1), [(42_113, Values::Text("-9999"))]);
    assert_eq!(
        values(&plain(tags, vec![0, 241, 255])),
        Ok(vec![0.0, 241.0, 255.0])
    );
}

/// Without a text, -32768 is a void of signed numbers of 16 bits alone.
#[test]
fn srtms_void_needs_no_text() {
    let block = [-32_768_i16, 5].map(i16::to_le_bytes).concat();
    let values_of = |format| values(&plain(fields([2, 1], 16, format, 1), block.clone())).unwrap();
    assert!(values_of(2)[0].is_nan());
    assert_eq!(values_of(1), [32_768.0, 5.0]);
}

const SCALED: &str = "<GDALMetadata>
  <Item name=\"OFFSET\" sample=\"0\" role=\"offset\">-10</Item>
  <Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.1</Item>
  <Item name=\"SCALE\" sample=\"1\" role=\"scale\">7</Item>
  <Item name=\"scale_factor\">3</Item>
</GDALMetadata>";

#[test]
fn numbers_are_scaled_and_voids_are_not() {
    let tags = [
        (42_112, Values::Text(SCALED)),
        (42_113, Values::Text("8000")),
    ];
    let file = plain(
        with(fields([2, 1], 16, 1, 1), tags),
        [900_u16, 8000].map(u16::to_le_bytes).concat(),
    );
    let values = values(&file).unwrap();
    assert!(values[0] == 80.0 && values[1].is_nan());
    let torn = with(
        fields([2, 1], 8, 1, 1),
        [(42_112, Values::Text("<GDALMetadata>"))],
    );
    assert!(refusal(&plain(torn, vec![1, 2])).contains("GDAL_METADATA"));
}

/// A tile of 100 units with more keys, and metadata.
fn tile(more: &[u16], metadata: &'static str) -> Result<f32, DemError> {
    let keys = [&[1, 1, 0, 0, 1024, 0, 1, 1, 3072, 0, 1, 32_633], more].concat();
    let tags = [
        (33_550, Values::Double(vec![30.0, 30.0, 0.0])),
        (33_922, Values::Double(vec![0.0, 0.0, 0.0, 5e5, 5e6, 0.0])),
        (34_735, Values::Short(keys)),
        (42_112, Values::Text(metadata)),
        (257, short(2)),
        (278, short(2)),
    ];
    let file = plain(with(fields([2, 2], 8, 1, 1), tags), vec![100; 4]);
    read(Cursor::new(file), SideFiles::default()).map(|dem| dem.grid.values[0])
}

/// Metadata that name a unit.
macro_rules! unit {
    ($unit:literal) => {
        concat!(
            "<GDALMetadata><Item name=\"UNITTYPE\" sample=\"0\" role=\"unittype\">",
            $unit,
            "</Item></GDALMetadata>"
        )
    };
}

#[test]
fn heights_come_out_in_metres() {
    const SURVEY: f32 = 30.480_06;
    for (keys, metadata, height) in [
        (&[][..], "", 100.0),
        (&[4096, 0, 1, 5703][..], "", 100.0),
        (&[4096, 0, 1, 5702], "", SURVEY),
        (&[4096, 0, 1, 6360], "", SURVEY),
        (&[4096, 0, 1, 8228], "", 30.48),
        (&[4096, 0, 1, 5703, 4099, 0, 1, 9002], "", 30.48),
        (&[4099, 0, 1, 9003], "", SURVEY),
        (&[4099, 0, 1, 9036], "", 1e5),
        (&[], unit!("ft"), 30.48),
        (&[], unit!("US survey foot"), SURVEY),
        (&[], unit!("metre"), 100.0),
        (&[4096, 0, 1, 6360], unit!("US survey foot"), SURVEY),
    ] {
        let found = tile(keys, metadata).unwrap();
        assert!(
            (found / height - 1.0).abs() < 1e-6,
            "{keys:?} {metadata}: {found}"
        );
    }
}

#[test]
fn heights_in_unknown_units_are_refused() {
    for (keys, metadata, word) in [
        (
            &[4096, 0, 1, 5715][..],
            "",
            "VerticalCSTypeGeoKey 5715 (depths)",
        ),
        (&[4096, 0, 1, 32_767], "", "VerticalCSTypeGeoKey"),
        (&[4096, 0, 1, 99], "", "VerticalCSTypeGeoKey 99"),
        (&[4099, 0, 1, 9999], "", "VerticalUnitsGeoKey 9999"),
        (&[], unit!("degC"), "GDAL_METADATA"),
        (&[4096, 0, 1, 6360], unit!("m"), "VerticalUnitsGeoKey"),
    ] {
        let text = tile(keys, metadata).unwrap_err().to_string();
        assert!(text.contains(word), "{word}: {text}");
    }
}
