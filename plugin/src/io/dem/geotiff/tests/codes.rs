//! Systems by their codes, and by Esri's texts among the keys.

use super::writer::Values;
use super::{SideFiles, fields, plain, read, with};
use crate::io::Dem;
use std::io::Cursor;

/// The keys of a projected system.
const PROJECTED: [u16; 4] = [1024, 0, 1, 1];
const METRES: [u16; 4] = [3076, 0, 1, 9001];

/// Four pixels of 100 units about a point of a map, of 100 units of height.
fn tile(keys: &[&[u16]], text: &'static str, [x, y]: [f64; 2]) -> Result<Dem, String> {
    let keys = [&[1, 1, 0, 0][..], &keys.concat()].concat();
    let place = vec![0.0, 0.0, 0.0, x - 100.0, y + 100.0, 0.0];
    let tags = [
        (33_550, Values::Double(vec![100.0, 100.0, 0.0])),
        (33_922, Values::Double(place)),
        (34_735, Values::Short(keys)),
        (34_737, Values::Text(text)),
    ];
    let file = plain(with(fields([2, 2], 8, 1, 1), tags), vec![100; 4]);
    read(Cursor::new(file), SideFiles::default()).map_err(|error| error.to_string())
}

/// Its pixels in a system with a code, and the unit beside it or not.
fn pixel(code: u16, unit: &[u16], place: [f64; 2]) -> Result<[f64; 2], String> {
    let tile = tile(&[&PROJECTED, &[3072, 0, 1, code], unit], "", place)?;
    Ok(tile.grid.pixel_m)
}

fn assert_close(found: [f64; 2], right: [f64; 2]) {
    let is_close = |axis: usize| (found[axis] / right[axis] - 1.0).abs() < 1e-4;
    assert!([0, 1].into_iter().all(is_close), "{found:?}, not {right:?}");
}

/// Scales by PROJ (`proj -S`) far from the middles of maps.
#[test]
fn systems_newer_than_the_table_have_their_scale() {
    for (code, place, right) in [
        // 50° S, 0° E.
        (9354, [0.0, 4_433_435.009], [92.6565, 92.6565]),
        // 20° N, 97.5° W.
        (27_705, [8_264_722.177, 1_316_541.057], [94.9033, 100.0]),
        // 10° N, 100° W.
        (10_598, [0.0, -4_347_379.318], [94.0523, 106.3238]),
        // 12° S, 132° E.
        (9473, [0.0, -1_264_277.358], [98.0621, 101.9761]),
        // 25° N, 100° W.
        (9311, [0.0, -2_212_624.122], [98.4808, 101.5427]),
        // 20° S, 175° E.
        (9191, [0.0, 2_209_684.424], [96.4260, 103.7065]),
    ] {
        for unit in [&METRES[..], &[]] {
            assert_close(pixel(code, unit, place).unwrap(), right);
        }
    }
}

#[test]
fn nothing_is_assumed_of_codes_that_nobody_knows() {
    for code in [1999, 7082, 27_708] {
        for unit in [&METRES[..], &[]] {
            let problem = pixel(code, unit, [5e5, 5e6]).unwrap_err();
            let named = format!("ProjectedCSTypeGeoKey {code} is not read");
            assert_eq!(problem, named);
        }
    }
}

/// Of zones of GSK-2011 and of Canada's UTM, New Zealand's, Madagascar's and Greenland's grids no more
/// is known.
#[test]
fn grids_that_are_true_to_scale_are_read() {
    for code in [20_910, 22_717, 27_200, 29_701, 2221] {
        assert_eq!(pixel(code, &METRES, [5e5, 5e6]), Ok([100.0; 2]), "{code}");
    }
    assert!(
        pixel(20_910, &[], [5e5, 5e6]).is_err(),
        "the unit is not told"
    );
}

#[test]
fn a_datum_that_is_a_grid_is_no_hindrance() {
    let utm: &[u16] = &[3072, 0, 1, 27_259];
    let tile = tile(&[&PROJECTED, utm], "", [5e5, 5e6]).unwrap();
    assert_eq!(tile.grid.pixel_m, [100.0; 2]);
    assert!((tile.centre.unwrap().1 - 171.0).abs() < 1e-6);
}

#[test]
fn a_file_may_define_what_its_code_does_not() {
    // Mercator's projection of a sphere at 60° N.
    let own: [u16; 8] = [2057, 0, 1, 6000, 3075, 0, 1, 7];
    let keys: [&[u16]; 4] = [&PROJECTED, &[3072, 0, 1, 27_708], &METRES, &own];
    let tile = tile(&keys, "", [0.0, 6000.0 * 1.316_957_897]).unwrap();
    assert_close(tile.grid.pixel_m, [50.0; 2]);
}

#[test]
fn a_system_of_a_users_own_must_be_defined() {
    let own: &[u16] = &[3072, 0, 1, 32_767];
    let problem = tile(&[&PROJECTED, own, &METRES], "", [5e5, 5e6]).unwrap_err();
    let named = "ProjectedCSTypeGeoKey 32767 without ProjCoordTransGeoKey is not read";
    assert_eq!(problem, named);
    // UTM zone 33 as a projection alone.
    let zone: &[u16] = &[3074, 0, 1, 16_033];
    let tile = tile(&[&PROJECTED, own, zone, &METRES], "", [5e5, 5e6]).unwrap();
    assert_eq!(tile.grid.pixel_m, [100.0; 2]);
}

#[test]
fn a_code_is_read_though_the_model_is_a_users_own() {
    let model: &[u16] = &[1024, 0, 1, 32_767];
    let utm: &[u16] = &[3072, 0, 1, 32_633];
    assert!(tile(&[model], "", [5e5, 5e6]).is_err());
    let tile = tile(&[model, utm], "", [5e5, 5e6]).unwrap();
    assert_eq!(tile.grid.pixel_m, [100.0; 2]);
    assert!((tile.centre.unwrap().1 - 15.0).abs() < 1e-6);
}

/// A text of Esri's with a method and more systems behind it.
macro_rules! esri {
    ($method:literal, $more:literal) => {
        concat!(
            "ESRI PE String = PROJCS[\"mine\",GEOGCS[\"g\",DATUM[\"d\",",
            "SPHEROID[\"s\",6378137.0,298.257223563]],PRIMEM[\"Greenwich\",0.0],",
            "UNIT[\"Degree\",0.0174532925199433]],PROJECTION[\"",
            $method,
            "\"],PARAMETER[\"Central_Meridian\",0.0],UNIT[\"Meter\",1.0]]",
            $more,
            "|after|"
        )
    };
}

const SIXTY_NORTH: [f64; 2] = [0.0, 8_399_737.889_818];

/// That tile with a text of Esri's in the citation of a key.
fn cited(key: u16, text: &'static str) -> Result<Dem, String> {
    let length = text.len() as u16 - "after|".len() as u16;
    let citation: &[u16] = &[key, 34_737, length, 0];
    let own: &[u16] = &[3072, 0, 1, 32_767];
    tile(&[&PROJECTED, own, citation, &METRES], text, SIXTY_NORTH)
}

#[test]
fn esris_texts_in_citations_are_read() {
    for key in [3073, 1026] {
        let tile = cited(key, esri!("Mercator_Auxiliary_Sphere", "")).unwrap();
        assert_close(tile.grid.pixel_m, [50.0; 2]);
        assert_eq!(tile.grid.values[0], 100.0);
        let problem = cited(key, esri!("Nobody", "")).unwrap_err();
        assert!(problem.contains("\"mine\" is not read"), "{problem}");
    }
}

#[test]
fn heights_of_esris_texts_have_their_unit() {
    let in_feet = esri!(
        "Mercator_Auxiliary_Sphere",
        ",VERTCS[\"v\",VDATUM[\"v\"],PARAMETER[\"Direction\",1.0],UNIT[\"Foot\",0.3048]]"
    );
    assert_eq!(cited(3073, in_feet).unwrap().grid.values[0], 30.48);
    let down = esri!(
        "Mercator_Auxiliary_Sphere",
        ",VERTCS[\"v\",VDATUM[\"v\"],PARAMETER[\"Direction\",-1.0],UNIT[\"Meter\",1.0]]"
    );
    assert!(cited(3073, down).unwrap_err().contains("depths"));
}
