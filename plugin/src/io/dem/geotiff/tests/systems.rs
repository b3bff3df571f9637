//! Coordinate systems as text, without a code of EPSG's: WKT 2 in side files, Esri's in .prj files.

use super::{fields, plain};
use crate::io::{Dem, load_dem};
use std::fs;
use tempfile::TempDir;

/// The model of 4 x 2 pixels with these files beside it.
fn tile(beside: &[(&str, &str)]) -> Result<Dem, String> {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.tif");
    fs::write(&path, plain(fields([4, 2], 8, 1, 1), (0..8).collect())).unwrap();
    for (name, content) in beside {
        fs::write(folder.path().join(name), content).unwrap();
    }
    load_dem(&path).map_err(|error| error.to_string())
}

/// The model whose side file has this system, and pixels of 100 m about a point of the map.
fn in_system(system: &str, [x, y]: [f64; 2]) -> Result<Dem, String> {
    let (west, north) = (x - 200.0, y + 100.0);
    let pam = format!(
        "<PAMDataset><SRS>{system}</SRS>\
         <GeoTransform>{west},100,0,{north},0,-100</GeoTransform></PAMDataset>"
    );
    tile(&[("a.tif.aux.xml", &pam)])
}

fn assert_near(found: [f64; 2], expected: [f64; 2], within: f64) {
    let is_near = found
        .iter()
        .zip(expected)
        .all(|(found, right)| (found - right).abs() < within);
    assert!(is_near, "{found:?}, not {expected:?}");
}

fn base(ellipsoid: &str) -> String {
    format!(r#"BASEGEOGCRS["g",DATUM["d",ELLIPSOID[{ellipsoid},LENGTHUNIT["metre",1]]]]"#)
}

const DEGREE: &str = r#"ANGLEUNIT["degree",0.0174532925199433]"#;

#[test]
fn transverse_mercators_of_wkt_2_are_read() {
    // UTM, the unit only on its axes.
    let base = base(r#""WGS 84",6378137,298.257223563"#);
    let system = format!(
        r#"PROJCRS["mine",{base},CONVERSION["UTM zone 33N",METHOD["Transverse Mercator"],
        PARAMETER["Latitude of natural origin",0,{DEGREE}],
        PARAMETER["Longitude of natural origin",15,{DEGREE}],
        PARAMETER["Scale factor at natural origin",0.9996,SCALEUNIT["unity",1]],
        PARAMETER["False easting",500,LENGTHUNIT["kilometre",1000]],
        PARAMETER["False northing",0,LENGTHUNIT["metre",1]]],CS[Cartesian,2],
        AXIS["(E)",east,ORDER[1],LENGTHUNIT["metre",1]],
        AXIS["(N)",north,ORDER[2],LENGTHUNIT["metre",1]]]"#
    );
    let tile = in_system(&system, [500_000.0, 5_000_000.0]).unwrap();
    assert_eq!(tile.grid.pixel_m, [100.0; 2]);
    let (lat, lon) = tile.centre.unwrap();
    assert_near([lat, lon], [45.153, 15.0], 1e-3);
}

/// On a sphere the scale of a polar stereographic map of true scale at 70° is
/// (1 + sin 70°) / (1 + sin φ), and a parallel has the radius R (1 + sin 70°) tan((90° - φ) / 2).
#[test]
fn polar_stereographic_maps_are_read() {
    let base = base(r#""sphere",6371000,0"#);
    let wkt2 = format!(
        r#"PROJCRS["ice",{base},CONVERSION["c",METHOD["Polar Stereographic (variant B)"],
        PARAMETER["Latitude of standard parallel",70,{DEGREE}],
        PARAMETER["Longitude of origin",-45,{DEGREE}],
        PARAMETER["False easting",0],PARAMETER["False northing",0]],
        CS[Cartesian,2],AXIS["x",south],AXIS["y",south],LENGTHUNIT["metre",1]]"#
    );
    let esri = r#"PROJCS["ice",GEOGCS["g",DATUM["d",SPHEROID["s",6371000.0,0.0]],
        PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],
        PROJECTION["Stereographic_North_Pole"],PARAMETER["False_Easting",0.0],
        PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",-45.0],
        PARAMETER["Standard_Parallel_1",70.0],UNIT["Meter",1.0]]"#;
    for system in [wkt2.as_str(), esri] {
        // 80° N, straight down the meridian of 45° W.
        let tile = in_system(system, [0.0, -1_081_165.8]).unwrap();
        assert_near(tile.grid.pixel_m, [102.3259; 2], 1e-2);
        let (lat, lon) = tile.centre.unwrap();
        assert_near([lat, lon], [80.0, -45.0], 1e-4);
    }
}

/// Esri's Web Mercator at 60° N, where a step of the map is twice as long as on the ground.
const WEB_MERCATOR: &str = r#"PROJCS["WGS_1984_Web_Mercator_Auxiliary_Sphere",
    GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,298.257223563]],
    PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]],
    PROJECTION["Mercator_Auxiliary_Sphere"],PARAMETER["False_Easting",0.0],
    PARAMETER["False_Northing",0.0],PARAMETER["Central_Meridian",0.0],
    PARAMETER["Standard_Parallel_1",0.0],PARAMETER["Auxiliary_Sphere_Type",0.0],
    UNIT["Meter",1.0]]"#;

#[test]
fn a_prj_file_tells_the_system_of_a_world_file() {
    // The middle of the first pixel.
    let world = "100\n0\n0\n-100\n-150\n8399787.89\n";
    let tile = |prj: &str| tile(&[("a.tfw", world), ("a.prj", prj)]);
    let of_map = tile(WEB_MERCATOR).unwrap();
    assert_near(of_map.grid.pixel_m, [50.0; 2], 0.01);
    let (lat, _) = of_map.centre.unwrap();
    assert!((lat - 60.0).abs() < 1e-4, "{lat}");
    let odd = WEB_MERCATOR.replace("Mercator_Auxiliary_Sphere", "Nobody");
    let problem = tile(&odd).unwrap_err();
    assert!(
        problem.contains("a.prj") && problem.contains("is not read"),
        "{problem}"
    );
}

#[test]
fn a_code_comes_before_the_name_of_a_method() {
    // As GDAL writes Web Mercator in WKT 1: by the method of another Mercator.
    let system = r#"PROJCS["WGS 84 / Pseudo-Mercator",GEOGCS["WGS 84",DATUM["WGS_1984",
        SPHEROID["WGS 84",6378137,298.257223563]],UNIT["degree",0.0174532925199433]],
        PROJECTION["Mercator_1SP"],PARAMETER["central_meridian",0],PARAMETER["scale_factor",1],
        PARAMETER["false_easting",0],PARAMETER["false_northing",0],UNIT["metre",1],
        AUTHORITY["EPSG","3857"]]"#;
    let tile = in_system(system, [0.0, 8_399_737.89]).unwrap();
    assert!((tile.centre.unwrap().0 - 60.0).abs() < 1e-4);
}

/// WGS 84 and its ellipsoid's heights, or a map of it, with a third axis.
fn in_three(axis: &str) -> [String; 2] {
    let base = base(r#""WGS 84",6378137,298.257223563"#);
    let utm = format!(
        r#"PROJCRS["mine",{base},CONVERSION["c",METHOD["Transverse Mercator"],
        PARAMETER["Longitude of natural origin",15,{DEGREE}],
        PARAMETER["Scale factor at natural origin",0.9996],
        PARAMETER["False easting",500000]],CS[Cartesian,3],
        AXIS["(E)",east,LENGTHUNIT["metre",1]],AXIS["(N)",north,LENGTHUNIT["metre",1]],{axis}]"#
    );
    let degrees = format!(
        r#"GEOGCRS["g",DATUM["d",ELLIPSOID["e",6378137,298.257223563]],CS[ellipsoidal,3],
        AXIS["latitude",north,{DEGREE}],AXIS["longitude",east,{DEGREE}],{axis}]"#
    );
    [utm, degrees]
}

/// The model in degrees or on a map, about 45° N 15° E, and a system of three axes.
fn heights_in(axis: &str) -> [Result<f32, String>; 2] {
    let [utm, degrees] = in_three(axis);
    let place = "<GeoTransform>15,0.001,0,45,0,-0.001</GeoTransform>";
    let pam = format!("<PAMDataset><SRS>{degrees}</SRS>{place}</PAMDataset>");
    let both = [
        in_system(&utm, [500_000.0, 5_000_000.0]),
        tile(&[("a.tif.aux.xml", &pam)]),
    ];
    both.map(|tile| tile.map(|tile| tile.grid.values[7]))
}

#[test]
fn a_third_axis_has_the_unit_of_heights() {
    let feet = r#"AXIS["ellipsoidal height (h)",up,LENGTHUNIT["foot",0.3048]]"#;
    assert_eq!(heights_in(feet), [Ok(7.0 * 0.3048), Ok(7.0 * 0.3048)]);
    let metres = r#"AXIS["ellipsoidal height (h)",up,LENGTHUNIT["metre",1]]"#;
    assert_eq!(heights_in(metres), [Ok(7.0), Ok(7.0)]);
    let depth = r#"AXIS["depth (D)",down,LENGTHUNIT["metre",1]]"#;
    for refused in heights_in(depth) {
        assert!(refused.unwrap_err().contains("depths"));
    }
}

#[test]
fn a_prj_file_tells_the_unit_of_heights() {
    let vertical = r#"VERTCS["v",VDATUM["v"],PARAMETER["Direction",1.0],UNIT["Foot",0.3048]]"#;
    let world = "100\n0\n0\n-100\n-150\n8399787.89\n";
    let prj = format!("{WEB_MERCATOR},{vertical}");
    let tile = tile(&[("a.tfw", world), ("a.prj", &prj)]).unwrap();
    assert_eq!(tile.grid.values[7], 7.0 * 0.3048);
}
