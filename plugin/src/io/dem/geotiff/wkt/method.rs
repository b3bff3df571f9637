//! Methods of projections and their parameters, by the names that WKT 1 (GDAL's and Esri's) and
//! WKT 2 give them, as texts of PROJ's.

use super::node::WktNode;
use crate::math::PI;
use core::fmt::Write;

/// PROJ's names of the methods.
const METHODS: [(&str, &str); 33] = [
    ("transverse_mercator", "tmerc"),
    ("gauss_kruger", "tmerc"),
    ("mercator", "merc"),
    ("mercator_1sp", "merc"),
    ("mercator_2sp", "merc"),
    ("mercator_(variant_a)", "merc"),
    ("mercator_(variant_b)", "merc"),
    ("mercator_auxiliary_sphere", "merc"),
    ("popular_visualisation_pseudo_mercator", "merc"),
    ("lambert_conformal_conic", "lcc"),
    ("lambert_conformal_conic_1sp", "lcc"),
    ("lambert_conformal_conic_2sp", "lcc"),
    ("lambert_conic_conformal_(1sp)", "lcc"),
    ("lambert_conic_conformal_(2sp)", "lcc"),
    ("lambert_azimuthal_equal_area", "laea"),
    ("albers", "aea"),
    ("albers_conic_equal_area", "aea"),
    ("albers_equal_area", "aea"),
    ("azimuthal_equidistant", "aeqd"),
    ("modified_azimuthal_equidistant", "aeqd"),
    ("polar_stereographic", "stere"),
    ("polar_stereographic_(variant_a)", "stere"),
    ("polar_stereographic_(variant_b)", "stere"),
    ("stereographic_north_pole", "stere"),
    ("stereographic_south_pole", "stere"),
    ("oblique_stereographic", "sterea"),
    ("equirectangular", "eqc"),
    ("plate_carree", "eqc"),
    ("equidistant_cylindrical", "eqc"),
    ("cylindrical_equal_area", "cea"),
    ("lambert_cylindrical_equal_area", "cea"),
    ("mollweide", "moll"),
    ("sinusoidal", "sinu"),
];

/// Methods that are computed on the sphere of the half axis.
const ON_SPHERES: [&str; 2] = [
    "mercator_auxiliary_sphere",
    "popular_visualisation_pseudo_mercator",
];

/// Parameters that change nothing here.
const PASSED_OVER: [&str; 1] = ["auxiliary_sphere_type"];

/// PROJ's names of the parameters; of latitudes, unless the method has another.
const PARAMETERS: [(&str, &str); 25] = [
    ("central_meridian", "lon_0"),
    ("longitude_of_center", "lon_0"),
    ("longitude_of_origin", "lon_0"),
    ("longitude_of_natural_origin", "lon_0"),
    ("longitude_of_false_origin", "lon_0"),
    ("longitude_of_projection_centre", "lon_0"),
    ("latitude_of_origin", "lat_0"),
    ("latitude_of_center", "lat_0"),
    ("latitude_of_natural_origin", "lat_0"),
    ("latitude_of_false_origin", "lat_0"),
    ("latitude_of_projection_centre", "lat_0"),
    ("standard_parallel_1", "lat_1"),
    ("latitude_of_1st_standard_parallel", "lat_1"),
    ("latitude_of_standard_parallel", "lat_ts"),
    ("standard_parallel_2", "lat_2"),
    ("latitude_of_2nd_standard_parallel", "lat_2"),
    ("scale_factor", "k"),
    ("scale_factor_at_natural_origin", "k"),
    ("false_easting", "x_0"),
    ("easting_at_false_origin", "x_0"),
    ("easting_at_projection_centre", "x_0"),
    ("false_northing", "y_0"),
    ("northing_at_false_origin", "y_0"),
    ("northing_at_projection_centre", "y_0"),
    ("straight_vertical_longitude_from_pole", "lon_0"),
];

/// PROJ's text of the projection of a projected system whose ellipsoid has these half axes, and
/// whose unit has this length; `None` for a method or a parameter that is not known.
pub(super) fn text(system: &WktNode, [a, b]: [f64; 2], unit_m: f64) -> Option<String> {
    // In WKT 2 the method stands among its parameters.
    let conversion = system.child(&["CONVERSION", "DERIVINGCONVERSION"]);
    let parameters = conversion.unwrap_or(system);
    let method = plain(parameters.child(&["PROJECTION", "METHOD"])?.title());
    let b = if ON_SPHERES.contains(&method.as_str()) {
        a
    } else {
        b
    };
    let name = named(&METHODS, &method)?;
    let mut text = format!("+proj={name} +a={a} +b={b} +no_defs");
    let is_parameter = |node: &&WktNode| node.name == "PARAMETER";
    for node in parameters.nodes.iter().filter(is_parameter) {
        let parameter = plain(node.title());
        if PASSED_OVER.contains(&parameter.as_str()) {
            continue;
        }
        put(&mut text, &method, &parameter, value(node, unit_m)?)?;
    }
    Some(text)
}

/// In small letters, with a line for every blank.
fn plain(title: &str) -> String {
    title.trim().to_lowercase().replace(' ', "_")
}

fn named(names: &[(&str, &'static str)], searched: &str) -> Option<&'static str> {
    let found = names.iter().find(|(name, _)| *name == searched);
    found.map(|(_, name)| *name)
}

/// The value of a parameter in degrees, m or 1; without a unit of its own, angles are in degrees, as
/// nearly all are, and lengths in the unit of the system.
fn value(node: &WktNode, unit_m: f64) -> Option<f64> {
    let value = *node.numbers.first()?;
    if let Some(radians) = node.child(&["ANGLEUNIT"]).and_then(|_| node.unit()) {
        return Some(value * radians * 180.0 / PI);
    }
    let is_length =
        named(&PARAMETERS, &plain(node.title())).is_some_and(|name| matches!(name, "x_0" | "y_0"));
    let usual = if is_length { unit_m } else { 1.0 };
    Some(value * node.unit().unwrap_or(usual))
}

/// Appends a parameter by PROJ's name of it.
fn put(text: &mut String, method: &str, parameter: &str, value: f64) -> Option<()> {
    let name = match named(&PARAMETERS, parameter)? {
        "lat_0" if has_true_latitude(method) => "lat_ts",
        "lat_1" if of_one_latitude(method) => "lat_ts",
        name => name,
    };
    // Writing to memory does not fail.
    let _ = write!(text, " +{name}={value}");
    let is_polar = named(&METHODS, method) == Some("stere");
    if name == "lat_ts" && is_polar {
        let _ = write!(text, " +lat_0={}", 90_f64.copysign(value));
    }
    if name == "lat_0" && method.contains("1sp") {
        let _ = write!(text, " +lat_1={value}");
    }
    Some(())
}

/// Is the latitude of the origin one of true scale?
fn has_true_latitude(method: &str) -> bool {
    method == "polar_stereographic"
}

/// Is the first standard parallel the latitude of true scale?
fn of_one_latitude(method: &str) -> bool {
    matches!(
        named(&METHODS, method),
        Some("merc" | "eqc" | "cea" | "stere")
    )
}
