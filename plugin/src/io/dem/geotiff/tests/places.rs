//! Where rasters lie, which way up, and how large their pixels are on the ground.

use super::writer::Values;
use super::{RasterFile, SideFiles, fields, plain, read, refusal, values, with};
use crate::io::dem::error::DemError;
use crate::io::dem::tile::Dem;
use std::io::Cursor;

/// Tags of a place: the size of a pixel, and that the corner of the first one lies at `x`, `y`.
fn at(size: [f64; 2], x: f64, y: f64) -> Vec<(u16, Values)> {
    vec![
        (33_550, Values::Double(vec![size[0], size[1], 0.0])),
        (33_922, Values::Double(vec![0.0, 0.0, 0.0, x, y, 0.0])),
    ]
}

/// A file of 2 x 2 pixels, 1 to 4, at a place, with keys and their doubles.
fn file(place: Vec<(u16, Values)>, keys: &[u16], doubles: &[f64]) -> Vec<u8> {
    let keys = [&[1, 1, 0, 0], keys].concat();
    let mut tags = with(
        fields([2, 2], 8, 1, 1),
        [
            (34_735, Values::Short(keys)),
            (34_736, Values::Double(doubles.to_vec())),
        ],
    );
    tags.extend(place);
    plain(tags, vec![1, 2, 3, 4])
}

fn dem(place: Vec<(u16, Values)>, keys: &[u16], doubles: &[f64]) -> Result<Dem, DemError> {
    let file = file(place, keys, doubles);
    read(Cursor::new(file), SideFiles::default())
}

/// Keys of a projected and of a geographic system.
const PROJECTED: [u16; 4] = [1024, 0, 1, 1];
const GEOGRAPHIC: [u16; 4] = [1024, 0, 1, 2];

fn keys<const N: usize>(model: [u16; 4], more: [u16; N]) -> Vec<u16> {
    [&model[..], &more].concat()
}

/// A place by a matrix.
fn matrix(a: f64, b: f64, e: f64, x: f64, y: f64) -> Vec<(u16, Values)> {
    let rows = [
        [a, b, 0.0, x],
        [b, e, 0.0, y],
        [0.0; 4],
        [0.0, 0.0, 0.0, 1.0],
    ];
    vec![(34_264, Values::Double(rows.concat()))]
}

fn close(found: [f64; 2], right: [f64; 2], share: f64) {
    for (found, right) in found.iter().zip(right) {
        assert!(
            (found / right - 1.0).abs() < share,
            "{found} is not {right}"
        );
    }
}

#[test]
fn the_north_comes_first_and_the_west() {
    let metres = keys(PROJECTED, []);
    for (place, right) in [
        (at([1.0, 1.0], 0.0, 0.0), [1.0, 2.0, 3.0, 4.0]),
        // GDAL takes a negative size for a slip.
        (at([1.0, -1.0], 0.0, 0.0), [1.0, 2.0, 3.0, 4.0]),
        (matrix(1.0, 0.0, -1.0, 0.0, 0.0), [1.0, 2.0, 3.0, 4.0]),
        (matrix(1.0, 0.0, 1.0, 0.0, 0.0), [3.0, 4.0, 1.0, 2.0]),
        (matrix(-1.0, 0.0, -1.0, 0.0, 0.0), [2.0, 1.0, 4.0, 3.0]),
    ] {
        assert_eq!(values(&file(place, &metres, &[])), Ok(right.to_vec()));
    }
    let turned = file(matrix(1.0, 0.5, 1.0, 0.0, 0.0), &metres, &[]);
    assert!(refusal(&turned).contains("ModelTransformation"));
}

#[test]
fn rasters_without_a_sound_place_are_refused() {
    let metres = keys(PROJECTED, []);
    let mut no_tie = at([1.0, 1.0], 0.0, 0.0);
    no_tie.truncate(1);
    assert!(refusal(&file(no_tie, &metres, &[])).contains("ModelTiepoint"));
    let endless = at([f64::INFINITY, 1.0], 0.0, 0.0);
    assert!(refusal(&file(endless, &metres, &[])).contains("ModelPixelScale"));
    let nowhere = dem(vec![], &metres, &[]).unwrap_err();
    assert!(nowhere.to_string().contains("ModelPixelScale"));
    let unknown = dem(at([1e-3, 1e-3], 7.0, 46.0), &[], &[]).unwrap_err();
    assert!(unknown.to_string().contains("GTModelTypeGeoKey"));
    // As GDAL's drivers and painting programs write what has no place.
    for counted in [at([1.0; 2], 0.0, 0.0), matrix(1.0, 0.0, 1.0, 0.0, 0.0)] {
        let no_size = dem(counted, &[], &[]).unwrap_err();
        assert!(no_size.to_string().contains("no size"), "{no_size}");
    }
}

#[test]
fn units_of_maps_are_known() {
    let own = [3076, 0, 1, 32_767, 3077, 34_736, 1, 0];
    for (keys, metres) in [
        (keys(PROJECTED, [3076, 0, 1, 9001]), 10.0),
        (keys(PROJECTED, [3076, 0, 1, 9002]), 3.048),
        (keys(PROJECTED, [3076, 0, 1, 9003]), 12_000.0 / 3937.0),
        (keys(PROJECTED, [3076, 0, 1, 9036]), 10_000.0),
        (keys(PROJECTED, own), 20.0),
    ] {
        let tile = dem(at([10.0, 10.0], 0.0, 0.0), &keys, &[2.0]).unwrap();
        close(tile.grid.pixel_m, [metres; 2], 1e-12);
    }
    for (more, word) in [
        ([3076, 0, 1, 9999], "ProjLinearUnitsGeoKey 9999"),
        ([3072, 0, 1, 54_009], "ProjectedCSTypeGeoKey 54009"),
        ([1024, 0, 1, 3], "GTModelTypeGeoKey 3"),
    ] {
        let model = if more[0] == 1024 { more } else { PROJECTED };
        let refused = dem(at([10.0, 10.0], 0.0, 0.0), &keys(model, more), &[]);
        let text = refused.unwrap_err().to_string();
        assert!(text.contains(word), "{word}: {text}");
    }
}

/// NAD83 / New York Long Island counts in US survey feet, though only its code says so.
#[test]
fn codes_of_projections_tell_their_unit() {
    let keys = keys(PROJECTED, [3072, 0, 1, 2263]);
    let tile = dem(at([100.0, 100.0], 1e6, 2e5), &keys, &[]).unwrap();
    close(tile.grid.pixel_m, [120_000.0 / 3937.0; 2], 1e-12);
    let (lat, lon) = tile.centre.unwrap();
    assert!(
        (lat - 40.7).abs() < 0.05 && (lon + 73.94).abs() < 0.1,
        "{lat} {lon}"
    );
}

/// A step of Mercator's projection is longer than on the ground by the secant of the latitude.
#[test]
fn pixels_of_mercators_maps_are_those_of_the_ground() {
    const SIXTY_NORTH: f64 = 8_399_737.889_818;
    let web = keys(PROJECTED, [3072, 0, 1, 3857]);
    let tile = dem(at([400.0, 400.0], 1_113_000.0, SIXTY_NORTH), &web, &[]).unwrap();
    close(tile.grid.pixel_m, [200.0; 2], 1e-4);
    // The same, as a file defines it: method 7 on a sphere, pixels of 1 km.
    let own = [
        3072, 0, 1, 32_767, 3075, 0, 1, 7, 3076, 0, 1, 9036, 2057, 34_736, 1, 0, 2058, 34_736, 1, 0,
    ];
    let place = at([0.4, 0.4], 1113.0, SIXTY_NORTH / 1e3);
    let tile = dem(place, &keys(PROJECTED, own), &[6_378_137.0]).unwrap();
    close(tile.grid.pixel_m, [200.0; 2], 1e-4);
    // Unknown methods are no projections that are true to scale.
    let unknown = keys(PROJECTED, [3072, 0, 1, 32_767, 3075, 0, 1, 25]);
    let text = dem(at([1.0, 1.0], 0.0, 0.0), &unknown, &[])
        .unwrap_err()
        .to_string();
    assert!(text.contains("ProjCoordTransGeoKey 25"), "{text}");
}

/// Its scale is 0.9996 on the central meridian: a metre of UTM is one on the ground.
#[test]
fn utm_is_true_to_scale() {
    let keys = keys(PROJECTED, [3072, 0, 1, 32_633]);
    let tile = dem(at([30.0, 30.0], 5e5, 5e6), &keys, &[]).unwrap();
    assert_eq!(tile.grid.pixel_m, [30.0; 2]);
    let (lat, lon) = tile.centre.unwrap();
    assert!(
        (lon - 15.0).abs() < 1e-3 && (lat - 45.15).abs() < 0.01,
        "{lat} {lon}"
    );
}

#[test]
fn degrees_have_units_and_a_globe() {
    const DEGREE_M: f64 = 111_195.08;
    let seconds = keys(GEOGRAPHIC, [2054, 0, 1, 9104]);
    let tile = dem(at([3.6, 3.6], 0.0, 3.6), &seconds, &[]).unwrap();
    close(tile.grid.pixel_m, [1e-3 * DEGREE_M; 2], 1e-6);
    let grads = keys(GEOGRAPHIC, [2054, 0, 1, 9105]);
    let tile = dem(at([1e-3, 1e-3], 0.0, 1e-3), &grads, &[]).unwrap();
    close(tile.grid.pixel_m, [0.9e-3 * DEGREE_M; 2], 1e-6);
    let moon = keys(GEOGRAPHIC, [2057, 34_736, 1, 0, 2059, 34_736, 1, 1]);
    let tile = dem(at([1e-3, 1e-3], 0.0, 1e-3), &moon, &[1_737_400.0, 0.0]).unwrap();
    close(tile.grid.pixel_m, [30.323_35; 2], 1e-6);
}

/// Degrees that a raster reaches over.
fn extent(place: Vec<(u16, Values)>, keys: &[u16]) -> Result<Option<[f64; 4]>, DemError> {
    let file = Cursor::new(file(place, keys, &[]));
    RasterFile::open(file, SideFiles::default(), |_, _| Ok::<(), DemError>(()))?.extent_deg()
}

#[test]
fn rasters_know_their_extent() {
    let degrees = keys(GEOGRAPHIC, []);
    let whole = Ok(Some([-180.0, 180.0, -90.0, 90.0]));
    assert_eq!(extent(at([180.0, 90.0], -180.0, 90.0), &degrees), whole);
    assert_eq!(
        extent(matrix(180.0, 0.0, 90.0, -180.0, -90.0), &degrees),
        whole
    );
    assert_eq!(extent(at([180.0, 90.0], -180.0, 90.0), &[]), whole);
    assert_eq!(extent(at([1.0, 1.0], 0.0, 0.0), &[]), Ok(None));
    assert_eq!(extent(vec![], &degrees), Ok(None));
    // Coordinates of the middles of pixels, and a tie point at the second column and row.
    let points = keys(GEOGRAPHIC, [1025, 0, 1, 2]);
    assert_eq!(extent(at([180.0, 90.0], -90.0, 45.0), &points), whole);
    let inner = vec![
        (33_550, Values::Double(vec![180.0, 90.0, 0.0])),
        (33_922, Values::Double(vec![1.0, 1.0, 0.0, 0.0, 0.0, 0.0])),
    ];
    assert_eq!(extent(inner, &degrees), whole);
}

#[test]
fn of_projections_only_plate_carree_has_an_extent_in_degrees() {
    const HALF: f64 = 20_037_508.342_789_244;
    let plate_carree = keys(PROJECTED, [3072, 0, 1, 4087]);
    let found = extent(at([HALF, HALF / 2.0], -HALF, HALF / 2.0), &plate_carree);
    let [west, east, south, north] = found.unwrap().unwrap();
    close([west, east], [-180.0, 180.0], 1e-9);
    close([south, north], [-90.0, 90.0], 1e-9);
    for code in [32_633, 3857] {
        let refused = extent(
            at([100.0, 100.0], 0.0, 0.0),
            &keys(PROJECTED, [3072, 0, 1, code]),
        );
        let text = refused.unwrap_err().to_string();
        assert!(text.contains("ProjectedCSTypeGeoKey"), "{text}");
    }
}
