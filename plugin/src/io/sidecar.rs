//! The sidecar NAME.json of a picture of heights: `{"metres_per_pixel", "metres_per_unit"}` for
//! real ground, or `{"metres_per_pixel", "min_m", "max_m"}` as `export` writes it.

use bevy::prelude::*;

/// Scale and position of a picture of heights. A value v is `min_m + v / 65535 (max_m - min_m)`, or
/// `v metres_per_unit`.
#[derive(Clone, Copy, Debug, PartialEq, Reflect, serde::Serialize, serde::Deserialize)]
pub struct Sidecar {
    /// Height of black in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min_m: Option<f64>,
    /// Height of white in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_m: Option<f64>,
    /// Height of one step of grey in m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub metres_per_unit: Option<f64>,
    /// Side of a pixel in m.
    pub metres_per_pixel: f64,
    /// Latitude of the middle in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lat: Option<f64>,
    /// Longitude of the middle in degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lon: Option<f64>,
}
