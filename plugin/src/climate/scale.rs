//! The size of the Earth.

/// Mean radius of the Earth in km. Lengths and discharges of climate and rivers are given on a
/// planet of this size.
pub const EARTH_RADIUS: f64 = 6370.0;
