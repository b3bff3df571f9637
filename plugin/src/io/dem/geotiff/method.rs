//! Projections that a file defines itself by a method and its parameters (OGC 19-008r4, annex C),
//! as text for PROJ.

use super::keys::{self, KeyDirectory, unknown};
use crate::io::dem::error::DemError;
use core::fmt::Write;

/// Keys that hold parameters of PROJ, the first that a file has; angles, lengths, numbers.
const ANGLES: [(&str, &[u16]); 4] = [
    ("lon_0", &[3080, 3084, 3088, 3095]),
    ("lat_0", &[3081, 3085, 3089]),
    ("lat_1", &[3078]),
    ("lat_2", &[3079]),
];
const LENGTHS: [(&str, &[u16]); 2] = [("x_0", &[3082, 3086, 3090]), ("y_0", &[3083, 3087, 3091])];
const SCALES: &[u16] = &[3092, 3093];

/// PROJ's name of a method.
fn name(method: u16) -> Option<&'static str> {
    match method {
        1 => Some("tmerc"),
        7 => Some("merc"),
        8 | 9 => Some("lcc"),
        10 => Some("laea"),
        11 => Some("aea"),
        12 => Some("aeqd"),
        13 => Some("eqdc"),
        14 | 15 => Some("stere"),
        16 => Some("sterea"),
        17 => Some("eqc"),
        18 => Some("cass"),
        20 => Some("mill"),
        21 => Some("ortho"),
        22 => Some("poly"),
        23 => Some("robin"),
        24 => Some("sinu"),
        28 => Some("cea"),
        _ => None,
    }
}

/// Methods that are true to scale along a line through the region that they are made for, and not
/// among the above: oblique Mercators, the Swiss and the New Zealand grid.
const REGIONAL: core::ops::RangeInclusive<u16> = 2..=6;
const NEW_ZEALAND: u16 = 26;

/// The projection that a file defines; `None` if it names no method, or one of a region that is
/// true to scale there. `radii` are those of its ellipsoid, `unit_deg` and `unit_m` its units.
pub(super) fn projection(
    keys: &KeyDirectory,
    radii: [f64; 2],
    unit_deg: f64,
    unit_m: f64,
) -> Result<Option<String>, DemError> {
    let method = match keys.code(keys::PROJECTION_METHOD) {
        None | Some(0 | NEW_ZEALAND) => return Ok(None),
        Some(method) if REGIONAL.contains(&method) => return Ok(None),
        Some(method) => method,
    };
    let name = name(method).ok_or_else(|| unknown(keys::PROJECTION_METHOD, method))?;
    let mut text = format!("+proj={name} +a={} +b={} +no_defs", radii[0], radii[1]);
    for (parameter, value) in latitudes(method, keys) {
        put(&mut text, parameter, value, unit_deg);
    }
    for (parameter, of) in ANGLES {
        put(&mut text, parameter, first(keys, of), unit_deg);
    }
    for (parameter, of) in LENGTHS {
        put(&mut text, parameter, first(keys, of), unit_m);
    }
    put(&mut text, "k", first(keys, SCALES), 1.0);
    Ok(Some(text))
}

/// No parameter.
const NOTHING: (&str, Option<f64>) = ("", None);

/// Latitudes that PROJ names otherwise for some methods.
fn latitudes(method: u16, keys: &KeyDirectory) -> [(&'static str, Option<f64>); 2] {
    let [origin, parallel] = [first(keys, ANGLES[1].1), first(keys, ANGLES[2].1)];
    match method {
        // Of true scale.
        7 | 17 | 28 => [("lat_ts", parallel), NOTHING],
        // With one standard parallel.
        9 => [("lat_1", origin), NOTHING],
        // About the pole on whose side the latitude of true scale is.
        15 => {
            let pole = origin.map(|latitude| 90_f64.copysign(latitude));
            [("lat_ts", origin), ("lat_0", pole)]
        }
        _ => [NOTHING; 2],
    }
}

fn first(keys: &KeyDirectory, of: &[u16]) -> Option<f64> {
    of.iter().find_map(|key| keys.measure(*key))
}

/// Appends a parameter; of two of the same name the first counts.
fn put(text: &mut String, parameter: &str, value: Option<f64>, unit: f64) {
    let Some(value) = value.filter(|value| value.is_finite()) else {
        return;
    };
    // Writing to memory does not fail.
    let _ = write!(text, " +{parameter}={}", value * unit);
}
