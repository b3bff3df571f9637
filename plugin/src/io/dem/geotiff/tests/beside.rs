//! Files beside a raster: GDAL's side file, an external mask, world files.

use super::writer::Values;
use super::{fields, plain, short};
use crate::io::{load_dem, load_map};
use std::fs;
use std::path::PathBuf;
use tempfile::TempDir;

/// A folder with a.tif, 4 x 2 pixels of 0 to 7 with more tags, and files beside it.
fn folder(tags: Vec<(u16, Values)>, beside: &[(&str, &[u8])]) -> (TempDir, PathBuf) {
    let folder = TempDir::new().unwrap();
    let mut all = fields([4, 2], 8, 1, 1);
    all.extend(tags);
    let path = folder.path().join("a.tif");
    fs::write(&path, plain(all, (0..8).collect())).unwrap();
    for (name, content) in beside {
        fs::write(folder.path().join(name), content).unwrap();
    }
    (folder, path)
}

/// A place by tags: pixels of 90 degrees from the corner of a map on.
fn whole_planet() -> Vec<(u16, Values)> {
    vec![
        (33_550, Values::Double(vec![90.0, 90.0, 0.0])),
        (
            33_922,
            Values::Double(vec![0.0, 0.0, 0.0, -180.0, 90.0, 0.0]),
        ),
        (34_735, Values::Short(vec![1, 1, 0, 1, 1024, 0, 1, 2])),
    ]
}

/// The values of the map a.tif with these tags and files beside it.
fn map(tags: Vec<(u16, Values)>, beside: &[(&str, &[u8])]) -> Vec<f32> {
    let (_folder, path) = folder(tags, beside);
    load_map(&path, None).unwrap().values().to_vec()
}

#[test]
fn what_a_side_file_tells_comes_first() {
    let pam = br#"<PAMDataset>
      <GeoTransform> 0.0, 90.0, 0.0, 90.0, 0.0, -90.0</GeoTransform>
      <PAMRasterBand band="1">
        <NoDataValue le_hex_equiv="0000000000001440">5</NoDataValue>
        <Scale>2</Scale><Offset>-1</Offset>
        <Metadata><MDI key="STATISTICS_MEAN">900</MDI></Metadata>
      </PAMRasterBand>
    </PAMDataset>"#;
    let values = map(whole_planet(), &[("a.tif.aux.xml", pam)]);
    // From Greenwich on, not from the date line as the tags say.
    assert_eq!(values[..4], [3.0, 5.0, -1.0, 1.0]);
    assert_eq!(values[4..7], [11.0, 13.0, 7.0]);
    assert!(values[7].is_nan());
}

#[test]
fn side_files_without_numbers_change_nothing() {
    let plain = map(whole_planet(), &[]);
    let statistics = br#"<PAMDataset><PAMRasterBand band="1"><Histograms/></PAMRasterBand>
      <PAMRasterBand band="2"><Scale>9</Scale></PAMRasterBand></PAMDataset>"#;
    for content in [&statistics[..], b"<metadata xml:lang=\"en\"/>"] {
        assert_eq!(map(whole_planet(), &[("a.tif.aux.xml", content)]), plain);
    }
}

#[test]
fn masks_beside_a_raster_make_voids() {
    let mask = plain(
        fields([4, 2], 8, 1, 1),
        vec![255, 0, 255, 255, 255, 255, 255, 0],
    );
    let values = map(whole_planet(), &[("a.tif.msk", &mask)]);
    let voids: Vec<usize> = (0..8).filter(|&i| values[i].is_nan()).collect();
    assert_eq!(voids, [1, 7]);
}

#[test]
fn world_files_place_what_has_no_place() {
    // Pixels of 90 degrees, the middle of the first at 45 E 45 N.
    let world = b"90\n0.0\n0\n-90\n45\n45\n";
    for name in ["a.tfw", "a.TFW", "a.tifw", "a.wld"] {
        assert_eq!(
            map(Vec::new(), &[(name, world)])[..4],
            [2.0, 3.0, 0.0, 1.0],
            "{name}"
        );
    }
    assert_eq!(
        map(whole_planet(), &[("a.tfw", world)])[..4],
        [0.0, 1.0, 2.0, 3.0]
    );
}

/// A side file with the system of UTM zone 33 and pixels of 30 m, as GDAL writes it.
const UTM: &str = r#"<PAMDataset><SRS dataAxisToSRSAxisMapping="1,2">COMPD_CS["x",PROJCS["UTM 33",
    GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],
    PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],
    PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",15],
    PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],
    PARAMETER["false_northing",0],UNIT["metre",1],AXIS["Easting",EAST]],
    VERT_CS["h",VERT_DATUM["d",2005],UNIT["foot",0.3048],AXIS["Up",UP]]]</SRS>
    <GeoTransform>500000,30,0,5000060,0,-30</GeoTransform></PAMDataset>"#;

#[test]
fn systems_of_side_files_are_read() {
    let (_folder, path) = folder(whole_planet(), &[("a.tif.aux.xml", UTM.as_bytes())]);
    let tile = load_dem(&path).unwrap();
    assert_eq!(tile.grid.pixel_m, [30.0; 2]);
    assert_eq!(tile.grid.values[7], 7.0 * 0.3048);
    let (lat, lon) = tile.centre.unwrap();
    assert!(
        (lat - 45.153).abs() < 0.01 && (lon - 15.0008).abs() < 1e-3,
        "{lat} {lon}"
    );
    let degrees = br#"<PAMDataset><SRS>GEOGCS["m",DATUM["m",SPHEROID["m",1737400,0]],
      UNIT["degree",0.0174532925199433]]</SRS>
      <GeoTransform>0,0.001,0,0.001,0,-0.001</GeoTransform></PAMDataset>"#;
    let (_folder, path) = folder(Vec::new(), &[("a.tif.aux.xml", degrees)]);
    let [_, down] = load_dem(&path).unwrap().grid.pixel_m;
    assert!((down - 30.323_35).abs() < 1e-4, "{down}");
}

#[test]
fn side_files_that_make_no_sense_are_named() {
    let pam = |content: &str| format!("<PAMDataset>{content}</PAMDataset>").into_bytes();
    let odd = r#"<SRS>PROJCS["odd",GEOGCS["g"],PROJECTION["Nobody"]]</SRS>"#;
    let bent = "<GeoTransform>0,90,9,90,0,-90</GeoTransform>";
    let small = plain(fields([2, 2], 8, 1, 1), vec![255; 4]);
    for (name, content, word) in [
        ("a.tif.aux.xml", b"<PAMDataset>".to_vec(), "a.tif.aux.xml"),
        ("a.tif.aux.xml", pam(odd), "odd"),
        (
            "a.tif.aux.xml",
            pam("<GeoTransform>1,2</GeoTransform>"),
            "GeoTransform",
        ),
        ("a.tif.aux.xml", pam(bent), "turns or shears"),
        ("a.tif.msk", b"nonsense".to_vec(), "a.tif.msk"),
        ("a.tif.msk", small, ".msk"),
        ("a.tfw", b"90 0 0".to_vec(), "a.tfw"),
    ] {
        let (_folder, path) = folder(Vec::new(), &[(name, &content)]);
        let problem = load_map(&path, None).unwrap_err().to_string();
        assert!(
            problem.contains(word) && !problem.contains('\n'),
            "{word}: {problem}"
        );
    }
}

#[test]
fn control_points_alone_are_no_place() {
    let points = [
        [0.0, 0.0, 0.0, 7.0, 46.0, 0.0],
        [4.0, 2.0, 0.0, 8.0, 45.0, 0.0],
    ];
    let tags = vec![(33_922, Values::Double(points.concat())), (1025, short(1))];
    let (_folder, path) = folder(tags, &[]);
    let problem = load_dem(&path).unwrap_err().to_string();
    assert!(problem.contains("ground control points"), "{problem}");
}
