//! GeoTIFF (OGC 19-008r4): one band of f32 in m, in a coordinate system of its own: azimuthal
//! equidistant about the middle of the square, on a sphere of the planet's radius.

use super::error::{ExportError, cannot_encode};
use crate::query::{HeightGrid, MapSquare};
use std::io::Cursor;
use tiff::encoder::{TiffEncoder, colortype};
use tiff::tags::Tag;
use tiff::{TiffError, TiffResult};

/// The file of a square.
pub(super) fn encode(square: &MapSquare, grid: &HeightGrid) -> Result<Vec<u8>, ExportError> {
    write(square, grid).map_err(|error: TiffError| cannot_encode(error))
}

fn write(square: &MapSquare, grid: &HeightGrid) -> TiffResult<Vec<u8>> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes)?;
    let side = square.pixels() as u32;
    let mut image = encoder.new_image::<colortype::Gray32Float>(side, side)?;
    let (pixel, half) = (square.pixel_m(), 0.5 * square.side_m());
    let scale = [pixel, pixel, 0.0];
    // The north west corner of the raster is half a side to the west and to the north of the
    // middle.
    let tie = [0.0, 0.0, 0.0, -half, half, 0.0];
    let keys = GeoKeys::new(square);
    let tags = image.encoder();
    tags.write_tag(Tag::ModelPixelScaleTag, &scale[..])?;
    tags.write_tag(Tag::ModelTiepointTag, &tie[..])?;
    tags.write_tag(Tag::GeoKeyDirectoryTag, &keys.directory[..])?;
    tags.write_tag(Tag::GeoDoubleParamsTag, &keys.doubles[..])?;
    tags.write_tag(Tag::GeoAsciiParamsTag, keys.text.as_str())?;
    image.write_data(&grid.values)?;
    Ok(bytes.into_inner())
}

/// "Defined here", as the value of a key.
const USER_DEFINED: u16 = 32_767;

/// The directory of keys, ascending by number, and the doubles and letters that they point to.
#[derive(Default)]
struct GeoKeys {
    directory: Vec<u16>,
    doubles: Vec<f64>,
    text: String,
}

impl GeoKeys {
    /// The coordinate system of a square.
    fn new(square: &MapSquare) -> Self {
        let projection = square.projection();
        let (lat, lon) = projection.lat_lon();
        let mut keys = Self::default();
        keys.add_model();
        keys.add_sphere(projection.radius_m());
        keys.add_projection(lat, lon);
        // VerticalUnits: metre.
        keys.short(4099, 9001);
        // Version 1, revision 1.0, number of keys.
        let count = keys.directory.len() as u16 / 4;
        keys.directory.splice(..0, [1, 1, 0, count]);
        keys
    }

    /// GTModelType: projected; GTRasterType: pixels are areas; citation.
    fn add_model(&mut self) {
        self.short(1024, 1);
        self.short(1025, 1);
        self.citation(1026, "Azimuthal equidistant square|");
    }

    /// GeographicType, citation, datum, prime meridian (Greenwich), angular unit (degree),
    /// ellipsoid and its axes.
    fn add_sphere(&mut self, radius_m: f64) {
        self.short(2048, USER_DEFINED);
        self.citation(2049, "Sphere of the planet's radius|");
        self.short(2050, USER_DEFINED);
        self.short(2051, 8901);
        self.short(2054, 9102);
        self.short(2056, USER_DEFINED);
        self.double(2057, radius_m);
        self.double(2058, radius_m);
    }

    /// ProjectedCSType, citation, Projection, ProjCoordTrans (azimuthal equidistant), linear unit
    /// (metre), false easting and northing, longitude and latitude of the centre.
    fn add_projection(&mut self, lat: f64, lon: f64) {
        self.short(3072, USER_DEFINED);
        self.citation(3073, "Azimuthal equidistant|");
        self.short(3074, USER_DEFINED);
        self.short(3075, 12);
        self.short(3076, 9001);
        self.double(3082, 0.0);
        self.double(3083, 0.0);
        self.double(3088, lon);
        self.double(3089, lat);
    }

    /// A key whose value stands in the directory.
    fn short(&mut self, key: u16, value: u16) {
        self.directory.extend([key, 0, 1, value]);
    }

    /// A key whose value stands among the doubles.
    fn double(&mut self, key: u16, value: f64) {
        let place = self.doubles.len() as u16;
        let tag = Tag::GeoDoubleParamsTag.to_u16();
        self.directory.extend([key, tag, 1, place]);
        self.doubles.push(value);
    }

    /// A key whose value stands among the letters.
    fn citation(&mut self, key: u16, value: &str) {
        let (length, place) = (value.len() as u16, self.text.len() as u16);
        let tag = Tag::GeoAsciiParamsTag.to_u16();
        self.directory.extend([key, tag, length, place]);
        self.text.push_str(value);
    }
}
