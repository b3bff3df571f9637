use super::*;
use proptest::prelude::*;
use std::io::Cursor;
use tiff::encoder::{TiffEncoder, colortype};
use tiff::tags::Tag;

/// A ramp of 40 x 30 values in m.
fn ramp() -> Vec<f32> {
    (0..1200)
        .map(|i| 100.0 + 7.0 * (i % 40) as f32 - 3.0 * (i / 40) as f32)
        .collect()
}

/// A GeoTIFF of the ramp, f32 or i16, with a void in the middle; in degrees or in UTM.
fn geotiff(float: bool, degrees: bool) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes).unwrap();
    let keys: &[u16] = if degrees {
        &[1, 1, 0, 1, 1024, 0, 1, 2]
    } else {
        &[1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, 9001]
    };
    let (scale, tie) = if degrees {
        (0.001, [0.0, 0.0, 0.0, 7.0, 46.0, 0.0])
    } else {
        (30.0, [0.0, 0.0, 0.0, 4e5, 5e6, 0.0])
    };
    macro_rules! write {
        ($color:ty, $values:expr) => {{
            let mut image = encoder.new_image::<$color>(40, 30).unwrap();
            image
                .encoder()
                .write_tag(Tag::ModelPixelScaleTag, &[scale, scale, 0.0_f64][..])
                .unwrap();
            image
                .encoder()
                .write_tag(Tag::ModelTiepointTag, &tie[..])
                .unwrap();
            image
                .encoder()
                .write_tag(Tag::GeoKeyDirectoryTag, keys)
                .unwrap();
            image.encoder().write_tag(Tag::GdalNodata, "-9999").unwrap();
            image.write_data($values).unwrap();
        }};
    }
    let mut values = ramp();
    values[615] = -9999.0;
    if float {
        write!(colortype::Gray32Float, &values);
    } else {
        let whole: Vec<i16> = values.iter().map(|&z| z as i16).collect();
        write!(colortype::GrayI16, &whole);
    }
    bytes.into_inner()
}

fn grey_png() -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 40, 30);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Sixteen);
    let data: Vec<u8> = ramp()
        .iter()
        .flat_map(|&z| (z as u16).to_be_bytes())
        .collect();
    encoder
        .write_header()
        .unwrap()
        .write_image_data(&data)
        .unwrap();
    bytes
}

#[test]
fn geotiffs_give_metres_whatever_they_count_in() {
    for float in [true, false] {
        let utm = geotiff::read(&geotiff(float, false)).unwrap();
        assert_eq!(
            (utm.grid.width, utm.grid.height, utm.voids, utm.centre),
            (40, 30, 1, None)
        );
        assert_eq!(utm.grid.pixel_m, [30.0; 2]);
        assert_eq!((utm.grid.values[0], utm.grid.row(2)[3]), (100.0, 115.0));
        // The void lies in a plane.
        assert!((utm.grid.values[615] - ramp()[615]).abs() < 1e-3);
        let degrees = geotiff::read(&geotiff(float, true)).unwrap();
        let (lat, lon) = degrees.centre.unwrap();
        assert!((lat - 45.985).abs() < 1e-9 && (lon - 7.02).abs() < 1e-9);
        let [across, down] = degrees.grid.pixel_m;
        assert!(
            (down - 111.195).abs() < 1e-3
                && (across / down - math::cos(lat.to_radians())).abs() < 1e-12
        );
    }
}

#[test]
fn a_text_that_is_longer_than_the_file_is_refused() {
    let good = geotiff(true, false);
    assert!(geotiff::read(&good).is_ok());
    // The tag of the void's value: number 42113, type 2, six letters.
    let tag: Vec<u8> = [42_113_u16, 2, 6, 0]
        .into_iter()
        .flat_map(u16::to_le_bytes)
        .collect();
    let place = good.windows(8).position(|window| window == tag).unwrap();
    let mut bad = good;
    bad[place + 4..place + 8].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(matches!(geotiff::read(&bad), Err(DemError::Invalid(_))));
}

#[test]
fn pictures_are_scaled_by_their_sidecar() {
    let feet =
        Sidecar::parse(br#"{ "metres_per_pixel": 92.6, "metres_per_unit": 0.3048 }"#).unwrap();
    let dem = grey::read(&grey_png(), &feet).unwrap();
    assert_eq!((dem.grid.pixel_m, dem.centre), ([92.6; 2], None));
    assert!((dem.grid.row(2)[3] - 115.0 * 0.3048).abs() < 1e-4);
    let range = br#"{"min_m": -100, "max_m": 65435, "metres_per_pixel": 5, "lat": 1, "lon": 2}"#;
    let dem = grey::read(&grey_png(), &Sidecar::parse(range).unwrap()).unwrap();
    assert_eq!((dem.grid.values[0], dem.centre), (0.0, Some((1.0, 2.0))));
    for bad in [
        "",
        "{}",
        "[1]",
        r#"{"metres_per_pixel": 5}"#,
        r#"{"metres_per_unit": 1}"#,
        r#"{"metres_per_pixel": "x"}"#,
    ] {
        assert!(
            matches!(Sidecar::parse(bad.as_bytes()), Err(DemError::Invalid(_))),
            "{bad}"
        );
    }
    for pixel in [0.0, -1.0, 1e9] {
        let sidecar = Sidecar {
            metres_per_pixel: pixel,
            ..feet
        };
        assert!(
            matches!(grey::read(&grey_png(), &sidecar), Err(DemError::Invalid(_))),
            "{pixel}"
        );
    }
}

#[test]
fn files_are_refused_in_one_line_that_names_them() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        path
    };
    let png = write("a.png", &grey_png());
    let tif = geotiff(true, false);
    for (path, word) in [
        (write("a.txt", b"x"), "a.txt"),
        (png, "a.json"),
        (write("N44W072.hgt", &[0; 10]), "10 bytes"),
        (write("b.tif", &tif[..tif.len() / 2]), "b.tif"),
        (write("c.tif", b"II*\0"), "c.tif"),
        (folder.path().join("missing.tif"), "missing.tif"),
    ] {
        let text = load_dem(&path).unwrap_err().to_string();
        assert!(text.contains(word) && text.lines().count() == 1, "{text}");
    }
    let names: Vec<String> = dem_files(folder.path())
        .unwrap()
        .iter()
        .map(|path| path.file_name().unwrap().to_string_lossy().into_owned())
        .collect();
    assert_eq!(names, ["N44W072.hgt", "a.png", "b.tif", "c.tif"]);
    assert!(dem_files(&folder.path().join("nowhere")).is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn damaged_files_never_panic(
        kind in 0..3_u8, changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in prop::option::of(any::<prop::sample::Index>()), header in any::<bool>(),
    ) {
        let mut bytes = match kind { 0 => grey_png(), 1 => geotiff(true, false), _ => geotiff(false, true) };
        let n = bytes.len();
        for (place, value) in changes {
            // A TIFF's tags lie behind its pixels, a PNG's header before.
            let place = match (header, kind) {
                (true, 0) => place.index(60),
                (true, _) => n - 1 - place.index(300),
                _ => place.index(n),
            };
            bytes[place] = value;
        }
        if let Some(cut) = cut {
            bytes.truncate(cut.index(n));
        }
        let sidecar = Sidecar::parse(br#"{"metres_per_pixel": 30, "metres_per_unit": 1}"#).unwrap();
        let result = if kind == 0 { grey::read(&bytes, &sidecar) } else { geotiff::read(&bytes) };
        if let Ok(dem) = result {
            prop_assert!(dem.grid.values.len() == dem.grid.width * dem.grid.height);
            prop_assert!(dem.grid.values.iter().all(|z| z.is_finite()));
        }
    }
}
