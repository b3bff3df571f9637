//! 16-bit greys: PNG, and raw values as engines import them; and the sidecar that decodes them.

use super::encoding::Encoding;
use crate::io::Sidecar;
use crate::io::png::write_grey_png;
use crate::math;
use crate::query::{DegreeBox, GridProjection, MapGrid};
use serde_json::{Value, json};
use std::io::{self, Write};

/// The heights that black and white stand for.
#[derive(Clone, Copy)]
pub(super) struct GreyRange {
    /// Height of black in m.
    pub(super) low: f64,
    /// Height of white in m.
    pub(super) high: f64,
}

impl GreyRange {
    /// The grey of a height, rounded; beyond the range black or white.
    fn grey(self, z: f32) -> u16 {
        // Casts saturate.
        (self.exact_grey(f64::from(z)) + 0.5) as u16
    }

    /// The same before it is rounded, with 0 and 65,535 as bounds of the range alone.
    pub(super) fn exact_grey(self, z: f64) -> f64 {
        (z - self.low) * self.steps_per_metre()
    }

    /// Level ground is black, and its range is empty.
    fn steps_per_metre(self) -> f64 {
        if self.high > self.low {
            65_535.0 / (self.high - self.low)
        } else {
            0.0
        }
    }
}

/// A grey PNG.
pub(super) fn write_png(
    source: &Encoding,
    range: GreyRange,
    out: &mut dyn Write,
) -> io::Result<()> {
    let size = [source.grid.columns(), source.grid.rows()].map(|n| n as u32);
    write_grey_png(out, size, |out| {
        write_greys(source, range, out, u16::to_be_bytes)
    })
}

/// Greys without a header, little endian.
pub(super) fn write_raw(
    source: &Encoding,
    range: GreyRange,
    out: &mut dyn Write,
) -> io::Result<()> {
    write_greys(source, range, out, u16::to_le_bytes)
}

fn write_greys(
    source: &Encoding,
    range: GreyRange,
    out: &mut dyn Write,
    bytes_of: fn(u16) -> [u8; 2],
) -> io::Result<()> {
    source.for_each_band(|band| {
        let greys = band.iter().flat_map(|&z| bytes_of(range.grey(z)));
        out.write_all(&greys.collect::<Vec<u8>>())
    })
}

/// The sidecar of a square or a tile.
pub(super) fn square_sidecar(grid: &MapGrid, range: GreyRange) -> Value {
    let (lat, lon) = middle(grid);
    json!(Sidecar {
        min_m: Some(range.low),
        max_m: Some(range.high),
        metres_per_unit: None,
        metres_per_pixel: grid.step().x,
        metres_per_pixel_across: None,
        lat: Some(lat),
        lon: Some(lon),
    })
}

/// The sidecar of a box: it tells degrees, and metres to a pixel in the middle.
pub(super) fn box_sidecar(degrees: &DegreeBox, range: GreyRange) -> Value {
    let [south, west, north, east] = degrees.bounds();
    let grid = degrees.grid();
    let (lat, lon) = middle(&grid);
    let degree_m = grid.projection().radius_m() * math::PI / 180.0;
    let [across, down] = grid.step().to_array().map(|step| step * degree_m);
    json!({
        "min_m": range.low,
        "max_m": range.high,
        "metres_per_pixel": down,
        "metres_per_pixel_across": across * math::cos(lat.to_radians()),
        "lat": lat,
        "lon": lon,
        "degrees_per_pixel": degrees.grid().step().to_array(),
        "south": south,
        "west": west,
        "north": north,
        "east": east,
    })
}

/// Latitude and longitude of the middle of a grid in degrees.
pub(super) fn middle(grid: &MapGrid) -> (f64, f64) {
    let plane = grid.plane_middle();
    match grid.projection() {
        // As they were given, not as they come out of a direction.
        GridProjection::Azimuthal(about) if plane.length() == 0.0 => about.lat_lon(),
        projection => math::lat_lon(projection.direction(plane)),
    }
}
