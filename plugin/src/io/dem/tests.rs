use super::*;
use crate::math;
use proptest::prelude::*;
use std::io::Cursor;
use tiff::TiffResult;
use tiff::encoder::{TiffEncoder, colortype};
use tiff::tags::Tag;

/// A ramp of 40 x 30 values in m.
fn ramp() -> Vec<f32> {
    (0..1200)
        .map(|i| 100.0 + 7.0 * (i % 40) as f32 - 3.0 * (i / 40) as f32)
        .collect()
}

/// The tags that say where a raster is.
struct GeoReference {
    scale: f64,
    tie: [f64; 6],
    keys: &'static [u16],
}

const IN_DEGREES: GeoReference = GeoReference {
    scale: 0.001,
    tie: [0.0, 0.0, 0.0, 7.0, 46.0, 0.0],
    keys: &[1, 1, 0, 1, 1024, 0, 1, 2],
};

const IN_UTM: GeoReference = GeoReference {
    scale: 30.0,
    tie: [0.0, 0.0, 0.0, 4e5, 5e6, 0.0],
    keys: &[1, 1, 0, 2, 1024, 0, 1, 1, 3076, 0, 1, 9001],
};

/// A GeoTIFF of the ramp in a type of values, with a void in the middle.
fn geotiff_of<C>(tags: &GeoReference, value: fn(f32) -> C::Inner) -> TiffResult<Vec<u8>>
where
    C: colortype::ColorType,
    [C::Inner]: tiff::encoder::TiffValue,
{
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes)?;
    let mut image = encoder.new_image::<C>(40, 30)?;
    let scale = [tags.scale, tags.scale, 0.0];
    let directory = image.encoder();
    directory.write_tag(Tag::ModelPixelScaleTag, &scale[..])?;
    directory.write_tag(Tag::ModelTiepointTag, &tags.tie[..])?;
    directory.write_tag(Tag::GeoKeyDirectoryTag, tags.keys)?;
    directory.write_tag(Tag::GdalNodata, "-9999")?;
    let mut values = ramp();
    values[615] = -9999.0;
    let values: Vec<_> = values.into_iter().map(value).collect();
    image.write_data(&values)?;
    Ok(bytes.into_inner())
}

fn floats(tags: &GeoReference) -> Vec<u8> {
    geotiff_of::<colortype::Gray32Float>(tags, |z| z).unwrap()
}

fn integers(tags: &GeoReference) -> Vec<u8> {
    geotiff_of::<colortype::GrayI16>(tags, |z| z as i16).unwrap()
}

fn grey_png() -> Vec<u8> {
    crate::io::png::grey_png(40, ramp().into_iter().map(|z| z as u16)).unwrap()
}

#[test]
fn geotiffs_in_metres_are_read_whatever_they_count_in() {
    for bytes in [floats(&IN_UTM), integers(&IN_UTM)] {
        let dem = geotiff::read(Cursor::new(&bytes), SideFiles::default()).unwrap();
        assert_eq!((dem.grid.width, dem.grid.height), (40, 30));
        assert_eq!((dem.voids, dem.centre), (1, None));
        assert_eq!(dem.grid.pixel_m, [30.0; 2]);
        assert_eq!((dem.grid.values[0], dem.grid.row(2)[3]), (100.0, 115.0));
        // The void lies in a plane.
        assert!((dem.grid.values[615] - ramp()[615]).abs() < 1e-3);
    }
}

#[test]
fn geotiffs_in_degrees_have_pixels_in_metres() {
    for bytes in [floats(&IN_DEGREES), integers(&IN_DEGREES)] {
        let dem = geotiff::read(Cursor::new(&bytes), SideFiles::default()).unwrap();
        let (lat, lon) = dem.centre.unwrap();
        assert!((lat - 45.985).abs() < 1e-9 && (lon - 7.02).abs() < 1e-9);
        let [across, down] = dem.grid.pixel_m;
        assert!((down - 111.195).abs() < 1e-3);
        assert!((across / down - math::cos(lat.to_radians())).abs() < 1e-12);
    }
}

#[test]
fn a_text_that_is_longer_than_the_file_is_refused() {
    let good = floats(&IN_UTM);
    assert!(geotiff::read(Cursor::new(&good), SideFiles::default()).is_ok());
    // The tag of the void's value: number 42113, type 2, six letters.
    let tag: Vec<u8> = [42_113_u16, 2, 6, 0]
        .into_iter()
        .flat_map(u16::to_le_bytes)
        .collect();
    let place = good.windows(8).position(|window| window == tag).unwrap();
    let mut bad = good;
    bad[place + 4..place + 8].copy_from_slice(&u32::MAX.to_le_bytes());
    assert!(matches!(
        geotiff::read(Cursor::new(&bad), SideFiles::default()),
        Err(DemError::Invalid(_))
    ));
}

#[test]
fn pictures_are_scaled_by_their_sidecar() {
    let feet = br#"{ "metres_per_pixel": 92.6, "metres_per_unit": 0.3048 }"#;
    let dem = grey::read(
        Cursor::new(grey_png()),
        &grey::parse_sidecar(feet).unwrap(),
        None,
    )
    .unwrap();
    assert_eq!((dem.grid.pixel_m, dem.centre), ([92.6; 2], None));
    assert!((dem.grid.row(2)[3] - 115.0 * 0.3048).abs() < 1e-4);
    let range = br#"{"min_m": -100, "max_m": 65435, "metres_per_pixel": 5, "lat": 1, "lon": 2}"#;
    let dem = grey::read(
        Cursor::new(grey_png()),
        &grey::parse_sidecar(range).unwrap(),
        None,
    )
    .unwrap();
    assert_eq!((dem.grid.values[0], dem.centre), (0.0, Some((1.0, 2.0))));
}

/// A grey picture of 2 x 2 pixels of 8 bits.
fn shallow_png(greys: [u8; 4]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let encoder = png::Encoder::new(&mut bytes, 2, 2);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&greys).unwrap();
    drop(writer);
    bytes
}

#[test]
fn pictures_of_8_bits_are_scaled_by_their_sidecar() {
    let picture = shallow_png([0, 51, 102, 255]);
    for (scale, heights) in [
        (r#""metres_per_unit": 10"#, [0.0, 510.0, 1020.0, 2550.0]),
        (
            r#""min_m": -500, "max_m": 4600"#,
            [-500.0, 520.0, 1540.0, 4600.0],
        ),
        (r#""min": 100, "max": 355"#, [100.0, 151.0, 202.0, 355.0]),
    ] {
        let sidecar = format!(r#"{{"metres_per_pixel": 90, {scale}}}"#);
        let sidecar = grey::parse_sidecar(sidecar.as_bytes()).unwrap();
        let dem = grey::read(Cursor::new(&picture), &sidecar, None).unwrap();
        assert_eq!(dem.grid.values, heights, "{scale}");
    }
}

#[test]
fn sidecars_may_begin_with_a_byte_order_mark() {
    let text = b"\xef\xbb\xbf{\r\n\"metres_per_pixel\": 30,\r\n\"metres_per_unit\": 2\r\n}\r\n";
    let sidecar = grey::parse_sidecar(text).unwrap();
    assert_eq!(
        (sidecar.metres_per_pixel, sidecar.metres_per_unit),
        (30.0, Some(2.0))
    );
}

#[test]
fn sidecars_without_a_scale_are_refused() {
    for bad in [
        "",
        "{}",
        "[1]",
        r#"{"metres_per_pixel": 5}"#,
        r#"{"metres_per_unit": 1}"#,
        r#"{"metres_per_pixel": "x"}"#,
    ] {
        let refused = grey::parse_sidecar(bad.as_bytes());
        assert!(matches!(refused, Err(DemError::Invalid(_))), "{bad}");
    }
    for pixel in ["0", "-1", "1e9"] {
        let text = format!(r#"{{"metres_per_pixel": {pixel}, "metres_per_unit": 1}}"#);
        let sidecar = grey::parse_sidecar(text.as_bytes()).unwrap();
        let refused = grey::read(Cursor::new(grey_png()), &sidecar, None);
        assert!(matches!(refused, Err(DemError::Invalid(_))), "{pixel}");
    }
}

/// A folder of files that make no elevation model.
fn folder_of_bad_files() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let tif = floats(&IN_UTM);
    for (name, bytes) in [
        ("a.txt", &b"x"[..]),
        ("a.png", &grey_png()),
        ("N44W072.hgt", &[0; 10]),
        ("b.tif", &tif[..tif.len() / 2]),
        ("c.tif", b"II*\0"),
        ("a.hgt.zip", b"PK"),
        ("a.tif.zip", b"PK"),
    ] {
        fs::write(folder.path().join(name), bytes).unwrap();
    }
    folder
}

#[test]
fn files_are_refused_in_one_line_that_names_them() {
    let folder = folder_of_bad_files();
    for (name, word) in [
        ("a.txt", "a.txt"),
        ("a.png", "a.json"),
        ("N44W072.hgt", "10 bytes"),
        ("b.tif", "b.tif"),
        ("c.tif", "c.tif"),
        ("missing.tif", "missing.tif"),
        ("a.hgt.zip", "damaged archive"),
        ("a.tif.zip", "unpack"),
    ] {
        let error = load_dem(&folder.path().join(name)).unwrap_err();
        let text = error.to_string();
        assert!(text.contains(word) && text.lines().count() == 1, "{text}");
    }
}

/// A folder of empty files of such names.
fn folder_of(names: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in names {
        fs::write(folder.path().join(name), "").unwrap();
    }
    folder
}

#[test]
fn folders_list_elevation_models_by_name() {
    let models = [
        "A.PNG",
        "N44W072 (1).hgt",
        "N44W072.HGT",
        "N44W072.SRTMGL1.hgt",
        "N44W072.hgt (1)",
        "N44W072.hgt.1",
        "N44W072.hgt.zip",
        "b.tif",
        "c.Tiff",
    ];
    let others = [
        ".DS_Store",
        "A.PNG.aux.xml",
        "N44W072",
        "N44W072.hgt2",
        "N44W072.zip",
        "a.json",
        "read me.txt",
        "tif",
    ];
    let folder = folder_of(&[&models[..], &others].concat());
    fs::create_dir(folder.path().join("old.tif")).unwrap();
    let files = dem_files(folder.path()).unwrap();
    let names: Vec<_> = files.iter().filter_map(|path| path.file_name()).collect();
    assert_eq!(names, models);
    assert!(dem_files(&folder.path().join("nowhere")).is_err());
}

#[test]
fn names_may_be_in_upper_case_and_numbered() {
    let folder = folder_of(&[]);
    for (picture, sidecar) in [("A.PNG", "A.JSON"), ("b.png (1)", "b.json")] {
        let picture = folder.path().join(picture);
        fs::write(&picture, grey_png()).unwrap();
        let scale = r#"{"metres_per_pixel": 30, "metres_per_unit": 1}"#;
        fs::write(folder.path().join(sidecar), scale).unwrap();
        assert_eq!(load_dem(&picture).unwrap().grid.pixel_m, [30.0; 2]);
    }
    let copy = folder.path().join("n44w072.hgt (2)");
    fs::write(&copy, vec![1; 2 * 1201 * 1201]).unwrap();
    assert_eq!(load_dem(&copy).unwrap().centre, Some((44.5, -71.5)));
}

/// A good file of one of three kinds.
fn good_file(kind: u8) -> Vec<u8> {
    match kind {
        0 => grey_png(),
        1 => floats(&IN_UTM),
        _ => integers(&IN_DEGREES),
    }
}

/// Reads a file of one of three kinds.
fn read_kind(kind: u8, bytes: &[u8]) -> Result<Dem, DemError> {
    if kind > 0 {
        return geotiff::read(Cursor::new(bytes), SideFiles::default());
    }
    let sidecar = br#"{"metres_per_pixel": 30, "metres_per_unit": 1}"#;
    grey::read(Cursor::new(bytes), &grey::parse_sidecar(sidecar)?, None)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn damaged_files_never_panic(
        kind in 0..3_u8,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        cut in prop::option::of(any::<prop::sample::Index>()),
        header in any::<bool>(),
    ) {
        let mut bytes = good_file(kind);
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
        if let Ok(dem) = read_kind(kind, &bytes) {
            prop_assert!(dem.grid.values.len() == dem.grid.width * dem.grid.height);
            prop_assert!(dem.grid.values.iter().all(|z| z.is_finite()));
        }
    }
}
