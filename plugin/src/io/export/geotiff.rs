//! GeoTIFF (OGC 19-008r4): one band of f32 in m, in a coordinate system of its own: azimuthal
//! equidistant about the middle of the square, on a sphere of the planet's radius.

use super::ExportError;
use crate::query::{HeightGrid, MapSquare};
use std::io::Cursor;
use tiff::encoder::{TiffEncoder, colortype};
use tiff::tags::Tag;

/// "Defined here", as the value of a key.
const USER_DEFINED: u16 = 32_767;

/// Where a key's value is: in the key itself, among the doubles, among the letters.
enum Value<'a> {
    Short(u16),
    Double(f64),
    Text(&'a str),
}

pub(super) fn encode(square: &MapSquare, grid: &HeightGrid) -> Result<Vec<u8>, ExportError> {
    let refused = |error: tiff::TiffError| ExportError::Encode(error.to_string());
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes).map_err(refused)?;
    let side = square.pixels() as u32;
    let mut image = encoder
        .new_image::<colortype::Gray32Float>(side, side)
        .map_err(refused)?;
    let (pixel, half) = (square.pixel_m(), 0.5 * square.side_m());
    let (directory, doubles, text) = keys(square);
    let tags = image.encoder();
    tags.write_tag(Tag::ModelPixelScaleTag, &[pixel, pixel, 0.0][..])
        .map_err(refused)?;
    // The north west corner of the raster is half a side to the west and to the north of the
    // middle.
    tags.write_tag(
        Tag::ModelTiepointTag,
        &[0.0, 0.0, 0.0, -half, half, 0.0][..],
    )
    .map_err(refused)?;
    tags.write_tag(Tag::GeoKeyDirectoryTag, &directory[..])
        .map_err(refused)?;
    tags.write_tag(Tag::GeoDoubleParamsTag, &doubles[..])
        .map_err(refused)?;
    tags.write_tag(Tag::GeoAsciiParamsTag, text.as_str())
        .map_err(refused)?;
    image.write_data(&grid.values).map_err(refused)?;
    Ok(bytes.into_inner())
}

/// The directory of keys, ascending by number, and the doubles and letters that they point to.
fn keys(square: &MapSquare) -> (Vec<u16>, Vec<f64>, String) {
    use Value::{Double, Short, Text};
    let projection = square.projection();
    let (lat, lon) = projection.lat_lon();
    let entries = [
        // GTModelType: projected. GTRasterType: pixels are areas.
        (1024, Short(1)),
        (1025, Short(1)),
        (1026, Text("Azimuthal equidistant square|")),
        // GeographicType, citation, datum, prime meridian (Greenwich), angular unit (degree),
        // ellipsoid and its axes.
        (2048, Short(USER_DEFINED)),
        (2049, Text("Sphere of the planet's radius|")),
        (2050, Short(USER_DEFINED)),
        (2051, Short(8901)),
        (2054, Short(9102)),
        (2056, Short(USER_DEFINED)),
        (2057, Double(projection.radius_m())),
        (2058, Double(projection.radius_m())),
        // ProjectedCSType, citation, Projection, ProjCoordTrans (azimuthal equidistant), linear
        // unit (metre).
        (3072, Short(USER_DEFINED)),
        (3073, Text("Azimuthal equidistant|")),
        (3074, Short(USER_DEFINED)),
        (3075, Short(12)),
        (3076, Short(9001)),
        // False easting and northing; longitude and latitude of the centre.
        (3082, Double(0.0)),
        (3083, Double(0.0)),
        (3088, Double(lon)),
        (3089, Double(lat)),
        // VerticalUnits: metre.
        (4099, Short(9001)),
    ];
    let mut directory = vec![1, 1, 0, entries.len() as u16];
    let (mut doubles, mut text) = (Vec::new(), String::new());
    for (key, value) in entries {
        let (place, count, value) = match value {
            Short(value) => (0, 1, value),
            Double(value) => {
                doubles.push(value);
                (
                    Tag::GeoDoubleParamsTag.to_u16(),
                    1,
                    doubles.len() as u16 - 1,
                )
            }
            Text(value) => {
                let start = text.len() as u16;
                text.push_str(value);
                (Tag::GeoAsciiParamsTag.to_u16(), value.len() as u16, start)
            }
        };
        directory.extend([key, place, count, value]);
    }
    (directory, doubles, text)
}
