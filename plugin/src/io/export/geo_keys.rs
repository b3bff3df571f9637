//! The keys of a GeoTIFF (OGC 19-008r4): the coordinate system of a grid, on a sphere of the
//! planet's radius.

use crate::query::{AzimuthalEquidistant, GridPoint, GridProjection, MapGrid};
use tiff::tags::Tag;

/// "Defined here", as the value of a key.
const USER_DEFINED: u16 = 32_767;

/// The directory of keys, ascending by number, and the doubles and letters that they point to.
#[derive(Default)]
pub(super) struct GeoKeys {
    pub(super) directory: Vec<u16>,
    pub(super) doubles: Vec<f64>,
    pub(super) text: String,
}

impl GeoKeys {
    /// The coordinate system of a grid.
    pub(super) fn new(grid: &MapGrid) -> Self {
        let mut keys = Self::default();
        match grid.projection() {
            GridProjection::Azimuthal(about) => keys.add_projected(grid, about),
            GridProjection::PlateCarree { radius_m } => keys.add_geographic(grid, *radius_m),
        }
        // VerticalUnits: metre.
        keys.short(4099, 9001);
        // Version 1, revision 1.0, number of keys.
        let count = keys.directory.len() as u16 / 4;
        keys.directory.splice(..0, [1, 1, 0, count]);
        keys
    }

    fn add_projected(&mut self, grid: &MapGrid, about: &AzimuthalEquidistant) {
        let (lat, lon) = about.lat_lon();
        self.add_model(1, grid.point_kind(), "Azimuthal equidistant|");
        self.add_sphere(about.radius_m());
        self.add_projection(lat, lon);
    }

    fn add_geographic(&mut self, grid: &MapGrid, radius_m: f64) {
        self.add_model(2, grid.point_kind(), "Latitude and longitude|");
        self.add_sphere(radius_m);
    }

    /// GTModelType: 1 projected, 2 geographic; GTRasterType: pixels are areas or points; citation.
    fn add_model(&mut self, model: u16, point: GridPoint, citation: &str) {
        self.short(1024, model);
        self.short(1025, if point == GridPoint::Vertex { 2 } else { 1 });
        self.citation(1026, citation);
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
