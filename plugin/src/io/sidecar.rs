//! The sidecar NAME.json of a picture of heights: `{"metres_per_pixel", "metres_per_unit"}` for
//! real ground, or `{"metres_per_pixel", "min_m", "max_m"}` as `export` writes it.

use bevy::prelude::*;
#[cfg(feature = "dem")]
use std::path::{Path, PathBuf};

/// Scale and position of a picture of heights. The grey that lies v steps over black, where white
/// lies n steps over it (65,535 in 16 bits), is `min_m + v / n (max_m - min_m)`, or
/// `v metres_per_unit`.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
pub struct Sidecar {
    /// Height of black in m; `min` in a file means the same.
    #[serde(default, alias = "min", skip_serializing_if = "Option::is_none")]
    pub min_m: Option<f64>,
    /// Height of white in m; `max` in a file means the same.
    #[serde(default, alias = "max", skip_serializing_if = "Option::is_none")]
    pub max_m: Option<f64>,
    /// Height of one step of grey in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub metres_per_unit: Option<f64>,
    /// Side of a pixel in m.
    pub metres_per_pixel: f64,
    /// Side of a pixel from west to east in m, if it is another.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub metres_per_pixel_across: Option<f64>,
    /// Latitude of the middle in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lat: Option<f64>,
    /// Longitude of the middle in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lon: Option<f64>,
}

/// The place of a picture's sidecar: NAME.json, or NAME.JSON if that is there alone.
#[cfg(feature = "dem")]
pub(super) fn beside(picture: &Path) -> PathBuf {
    let [usual, upper_case] = ["json", "JSON"].map(|extension| picture.with_extension(extension));
    if !usual.exists() && upper_case.exists() {
        upper_case
    } else {
        usual
    }
}
