//! Files beside a raster, which GDAL writes and reads: its own side file, a world file, a system of
//! coordinates, a mask.

use super::elevations::read;
use super::pictures::{Place, TIFF_WORDS, geotiffs, placeless};
use pangaea_tests::fuzz::{Format, fuzz};
use std::fs;

const SIZE: [u32; 2] = [9, 7];

const DEGREES: Place = Place {
    pixel: 0.001,
    corner: [7.0, 46.0],
    is_geographic: true,
};

/// Metres of a Mercator by an old text, of a stereographic view by a new one, and degrees.
const SYSTEMS: [&str; 3] = [
    "PROJCS[\"UTM 33\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",\
     SPHEROID[\"WGS 84\",6378137,298.257223563]],PRIMEM[\"Greenwich\",0],\
     UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],\
     PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_meridian\",15],\
     PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],\
     PARAMETER[\"false_northing\",0],UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"32633\"]]",
    "PROJCRS[\"ice\",BASEGEOGCRS[\"g\",DATUM[\"d\",ELLIPSOID[\"s\",6371000,0]]],\
     CONVERSION[\"c\",METHOD[\"Polar Stereographic (variant B)\"],\
     PARAMETER[\"Latitude of standard parallel\",71,ANGLEUNIT[\"degree\",0.0174532925199433]],\
     PARAMETER[\"Longitude of origin\",-45]],CS[Cartesian,2],LENGTHUNIT[\"metre\",1]]",
    "GEOGCS[\"m\",DATUM[\"m\",SPHEROID[\"m\",1737400,0]],UNIT[\"degree\",0.0174532925199433]]",
];

const WORDS: &[&str] = &[
    "[",
    "]",
    "\"",
    ",",
    "<",
    ">",
    "/>",
    "&#0;",
    "<!--",
    "nan",
    "-inf",
    "1e308",
    "0",
    "90",
    "-1",
    "EPSG",
    "4326",
    "3857",
    "PROJCS[",
    "PARAMETER[\"",
    "Lambert_Conformal_Conic",
    "Albers_Conic_Equal_Area",
    "Lambert Azimuthal Equal Area",
    "Hotine_Oblique_Mercator",
    "UNIT[\"foot\",0.3048]",
    "le_hex_equiv=\"000000000000F07F\"",
    "é",
    "\u{feff}",
];

/// Tries damaged texts beside a good raster, in a file of this name and ending.
fn beside(name: &str, ending: &str, good: &[String], others: &[(&str, &str)]) {
    let folder = tempfile::tempdir().unwrap();
    let raster = folder.path().join("tile.tif");
    // A raster without a place asks its side files for one.
    fs::write(&raster, placeless(SIZE)).unwrap();
    for (ending, text) in others {
        fs::write(folder.path().join(format!("tile{ending}")), text).unwrap();
    }
    let path = folder.path().join(format!("tile{ending}"));
    let good = good.iter().map(|text| text.as_bytes().to_vec()).collect();
    let format = Format {
        name,
        good,
        words: WORDS,
    };
    fuzz(&format, |bytes| {
        fs::write(&path, bytes).unwrap();
        read(&raster);
    });
}

#[test]
fn damaged_side_files_are_refused_or_tell_a_place() {
    let place = "<GeoTransform> 4e5, 30.0, 0.0, 5e6, 0.0, -30.0</GeoTransform>";
    let band = r#"<PAMRasterBand band="1"><NoDataValue le_hex_equiv="0000000000001440">5</NoDataValue>
        <UnitType>ft</UnitType><Scale>2</Scale><Offset>-1</Offset></PAMRasterBand>"#;
    let good =
        SYSTEMS.map(|system| format!("<PAMDataset><SRS>{system}</SRS>{place}{band}</PAMDataset>"));
    let plain = format!("<PAMDataset>{place}{band}</PAMDataset>");
    beside(
        "side files",
        ".tif.aux.xml",
        &[&good[..], &[plain]].concat(),
        &[],
    );
}

#[test]
fn damaged_world_files_are_refused_or_tell_a_place() {
    let good = ["30\n0\n0\n-30\n400015\n4999985\n", "0.001 0 0 -0.001 7 46"];
    let good = good.map(String::from);
    beside("world files", ".tfw", &good, &[(".prj", SYSTEMS[0])]);
}

#[test]
fn damaged_systems_are_refused_or_tell_a_place() {
    let good = SYSTEMS.map(String::from);
    let world = [(".tfw", "30\n0\n0\n-30\n400015\n4999985\n")];
    beside("systems of coordinates", ".prj", &good, &world);
}

#[test]
fn damaged_masks_are_refused_or_tell_voids() {
    let folder = tempfile::tempdir().unwrap();
    let raster = folder.path().join("tile.tif");
    fs::write(&raster, &geotiffs(SIZE, DEGREES)[0]).unwrap();
    let path = folder.path().join("tile.tif.msk");
    let format = Format {
        name: "masks",
        good: geotiffs(SIZE, DEGREES),
        words: TIFF_WORDS,
    };
    fuzz(&format, |bytes| {
        fs::write(&path, bytes).unwrap();
        read(&raster);
    });
}
