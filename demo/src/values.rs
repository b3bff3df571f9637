//! Values of options: numbers with limits, coordinates, sizes and names. Every message names the
//! limits.

use bevy_pangaea::amplification::GroundColours;
use bevy_pangaea::overlay::Overlay;
use bevy_pangaea::query::{DegreeBox, LEVELS, TileBlock};
use std::fmt::Display;
use std::str::FromStr;

/// Where a camera stands and looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraSpec {
    /// Degrees north.
    pub lat: f64,
    /// Degrees east.
    pub lon: f64,
    /// Height above the sea in m.
    pub altitude_m: f64,
    /// Degrees clockwise from north.
    pub heading: f64,
    /// Degrees above the horizon; -90 looks straight down.
    pub pitch: f64,
}

/// A point of the planet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaceSpec {
    /// Degrees north.
    pub lat: f64,
    /// Degrees east.
    pub lon: f64,
}

/// A square of the planet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegionSpec {
    /// Its middle.
    pub middle: PlaceSpec,
    /// Its side in km.
    pub size_km: f64,
}

/// Pixels of a raster: to a side, or columns and rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PixelsSpec {
    /// To a side; columns, where the rows follow from them.
    Side(usize),
    /// Columns and rows.
    Size([usize; 2]),
}

/// Columns and rows of tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TilesSpec(pub [usize; 2]);

/// Heights of black and white in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RangeSpec(pub [f64; 2]);

/// South, west, north and east in degrees; the east is east of the west, beyond 180 if need be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxSpec(pub [f64; 4]);

/// A list of numbers of samples.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SampleCounts(pub Vec<u32>);

/// A whole number from `low` to `high`.
pub fn integer<T>(text: &str, low: T, high: T) -> Result<T, String>
where
    T: FromStr + PartialOrd + Display + Copy,
{
    match text.trim().parse() {
        Ok(value) if (low..=high).contains(&value) => Ok(value),
        _ => Err(format!("it must be a whole number from {low} to {high}")),
    }
}

/// A number from `low` to `high`.
pub fn number(text: &str, low: f64, high: f64) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if (low..=high).contains(&value) => Ok(value),
        _ => Err(format!("it must be a number from {low} to {high}")),
    }
}

/// A seed of random numbers.
pub fn seed(text: &str) -> Result<u64, String> {
    integer(text, 0, u64::MAX)
}

/// A number of samples of the sphere.
pub fn samples(text: &str) -> Result<u32, String> {
    integer(text, 100, 2_000_000)
}

/// A number of initial plates.
pub fn plates(text: &str) -> Result<u32, String> {
    integer(text, 2, 1000)
}

/// A share of land.
pub fn land(text: &str) -> Result<f64, String> {
    number(text, 0.0, 0.9)
}

/// A span of geological time in My.
pub fn time_span(text: &str) -> Result<f64, String> {
    number(text, 0.1, 10_000.0)
}

/// A number of threads.
pub fn threads(text: &str) -> Result<usize, String> {
    integer(text, 1, 1024)
}

/// A number of frames of the explorer.
pub fn frames(text: &str) -> Result<u32, String> {
    integer(text, 1, 1_000_000)
}

/// `N` or `COLUMNSxROWS`, pixels of a raster of the ground.
pub fn pixels(text: &str) -> Result<PixelsSpec, String> {
    match text.split_once(['x', 'X']) {
        Some((columns, rows)) => Ok(PixelsSpec::Size([
            integer(columns, 1, 16_384)?,
            integer(rows, 1, 16_384)?,
        ])),
        None => integer(text, 2, 16_384).map(PixelsSpec::Side),
    }
}

/// `COLUMNSxROWS` of tiles.
pub fn tiles(text: &str) -> Result<TilesSpec, String> {
    const MOST: usize = TileBlock::MAX_TILES;
    counted_tiles(text, MOST)
        .filter(|[columns, rows]| columns * rows <= MOST)
        .map(TilesSpec)
        .ok_or_else(|| format!("it must be COLUMNSxROWS, at most {MOST} tiles"))
}

/// Columns and rows of tiles, of which there may be so many.
fn counted_tiles(text: &str, most: usize) -> Option<[usize; 2]> {
    let (columns, rows) = text.split_once(['x', 'X'])?;
    let count = |text| integer(text, 1, most).ok();
    Some([count(columns)?, count(rows)?])
}

/// `LOW,HIGH`, a range of heights in m.
pub fn height_range(text: &str) -> Result<RangeSpec, String> {
    let [low, high] = text.split(',').collect::<Vec<_>>()[..] else {
        return Err("it must be LOW,HIGH in metres".into());
    };
    let low = named_number(low, "the lowest height", -1e6, 1e6)?;
    let high = named_number(high, "the highest height", -1e6, 1e6)?;
    if low >= high {
        return Err(format!("it must go up, not from {low} to {high}"));
    }
    Ok(RangeSpec([low, high]))
}

/// `SOUTH,WEST,NORTH,EAST`.
pub fn degree_box(text: &str) -> Result<BoxSpec, String> {
    let [south, west, north, east] = text.split(',').collect::<Vec<_>>()[..] else {
        return Err("it must be SOUTH,WEST,NORTH,EAST in degrees".into());
    };
    let (low, high) = (coordinates(south, west)?, coordinates(north, east)?);
    DegreeBox::unwrapped([low.lat, low.lon, high.lat, high.lon])
        .map(BoxSpec)
        .map_err(|error| error.to_string())
}

/// A level of detail of the ground.
pub fn level(text: &str) -> Result<u8, String> {
    integer(text, 0, LEVELS)
}

/// A number of sites of a class of relief.
pub fn sites(text: &str) -> Result<usize, String> {
    integer(text, 1, 20)
}

/// `LAT,LON,ALTITUDE_M[,HEADING,PITCH]`.
pub fn camera(text: &str) -> Result<CameraSpec, String> {
    let parts: Vec<&str> = text.split(',').collect();
    let (place, gaze) = match parts[..] {
        [lat, lon, altitude] => ([lat, lon, altitude], None),
        [lat, lon, altitude, heading, pitch] => ([lat, lon, altitude], Some([heading, pitch])),
        _ => {
            return Err("it must be LAT,LON,ALTITUDE_M or LAT,LON,ALTITUDE_M,HEADING,PITCH".into());
        }
    };
    let [lat, lon, altitude] = place;
    let (heading, pitch) = match gaze {
        Some([heading, pitch]) => (
            named_number(heading, "the heading", -360.0, 360.0)?,
            named_number(pitch, "the pitch", -90.0, 90.0)?,
        ),
        None => (0.0, -90.0),
    };
    let PlaceSpec { lat, lon } = coordinates(lat, lon)?;
    Ok(CameraSpec {
        lat,
        lon,
        altitude_m: named_number(altitude, "the altitude in m", 1.0, 1e9)?,
        heading,
        pitch,
    })
}

/// Colours of the ground.
pub fn colours(text: &str) -> Result<GroundColours, String> {
    match text {
        "natural" => Ok(GroundColours::Natural),
        "level" => Ok(GroundColours::Level),
        "kind" => Ok(GroundColours::Kind),
        _ => Err("it must be one of natural, level, kind".into()),
    }
}

/// Edges of the ground's triangles in pixels.
pub fn edge_pixels(text: &str) -> Result<f32, String> {
    number(text, 1.0, 64.0).map(|pixels| pixels as f32)
}

/// `LAT,LON`.
pub fn place(text: &str) -> Result<PlaceSpec, String> {
    match text.split(',').collect::<Vec<_>>()[..] {
        [lat, lon] => coordinates(lat, lon),
        _ => Err("it must be LAT,LON".into()),
    }
}

/// `LAT,LON,SIZE_KM`.
pub fn region(text: &str) -> Result<RegionSpec, String> {
    let [lat, lon, size] = text.split(',').collect::<Vec<_>>()[..] else {
        return Err("it must be LAT,LON,SIZE_KM".into());
    };
    let size_km = named_number(size, "the size in km", 1e-3, 1e5)?;
    Ok(RegionSpec {
        middle: coordinates(lat, lon)?,
        size_km,
    })
}

fn coordinates(lat: &str, lon: &str) -> Result<PlaceSpec, String> {
    Ok(PlaceSpec {
        lat: named_number(lat, "the latitude", -90.0, 90.0)?,
        lon: named_number(lon, "the longitude", -360.0, 360.0)?,
    })
}

/// A number from `low` to `high` that is a part of a value: the message calls it by its name.
fn named_number(text: &str, name: &str, low: f64, high: f64) -> Result<f64, String> {
    number(text, low, high).map_err(|problem| problem.replacen("it", name, 1))
}

/// `WIDTHxHEIGHT`.
pub fn size(text: &str) -> Result<(u32, u32), String> {
    text.split_once(['x', 'X'])
        .and_then(|(width, height)| Some((side(width)?, side(height)?)))
        .ok_or_else(|| "it must be WIDTHxHEIGHT, each from 16 to 8192 pixels".into())
}

/// A side of a picture in pixels.
fn side(text: &str) -> Option<u32> {
    integer(text, 16, 8192).ok()
}

/// The width of a map in pixels, which is half as high.
pub fn map_width(text: &str) -> Result<u32, String> {
    side(text)
        .filter(|width| width.is_multiple_of(2))
        .ok_or_else(|| "it must be an even number of pixels from 16 to 8192".into())
}

/// Numbers of samples, separated by commas.
pub fn sample_counts(text: &str) -> Result<SampleCounts, String> {
    let counts: Result<Vec<u32>, String> = text.split(',').map(samples).collect();
    counts
        .ok()
        .filter(|counts| counts.len() <= 20)
        .map(SampleCounts)
        .ok_or_else(|| {
            "it must be one to twenty whole numbers from 100 to 2000000, separated by commas".into()
        })
}

/// The name of an overlay.
pub fn overlay(text: &str) -> Result<Overlay, String> {
    Overlay::from_name(text).ok_or_else(|| {
        let names = Overlay::ALL.map(Overlay::name);
        format!("it must be one of {}", names.join(", "))
    })
}

#[cfg(test)]
#[path = "values_tests.rs"]
mod tests;
