//! Projections, by PROJ's methods: how long a step on the map is on the ground, and which place a
//! point of the map is.
//!
//! Hardly a projection is true to scale: a step of Web Mercator at 60° N is twice as long as on the
//! ground. The scale is that in the middle of a raster, on the projection's own ellipsoid.

use crate::io::dem::error::{DemError, invalid};
use crate::math::{self, PI};
use proj4rs::Proj;
use proj4rs::adaptors::transform_vertex_2d;

/// A step on the map by which the scale is measured, as a share of the Earth's radius: short on the
/// ground, and long beside the errors of inverse projections.
const STEP: f64 = 1e-4;

/// Largest cosine of the angle between steps to the east and to the north.
const MAX_SHEAR: f64 = 0.05;

/// Maps whose scale is 1 up to this are taken for true to scale: those of grids that land is measured
/// on, such as UTM, whose scale goes from 0.9996 to 1.001.
const TRUE_TO_SCALE: f64 = 2e-3;

/// Datums that PROJ defines by grids, which are not at hand, and their ellipsoids.
const DATUMS_OF_GRIDS: [(&str, &str); 2] = [
    ("+datum=NAD27", "+ellps=clrk66"),
    ("+datum=nzgd49", "+ellps=intl"),
];

/// Parameters that are left out: coordinates are those on the projection's own datum, in m.
const GRIDS: [&str; 2] = ["towgs84", "nadgrids"];
const UNITS: [&str; 3] = ["units", "to_meter", "vunits"];

/// A map projection.
pub(super) struct Projection {
    plane: Proj,
    sphere: Proj,
    /// Half axes of the ellipsoid in m.
    radii: [f64; 2],
    /// Length in m of the unit of its coordinates, unless a file says otherwise.
    pub(super) unit_m: f64,
    /// Lengths in m of a degree along the equator and a meridian, and the place of 0° E, 0° N on the
    /// map; of equirectangular projections.
    pub(super) equirectangular: Option<[[f64; 2]; 2]>,
}

/// The ground about a point of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct GroundScale {
    /// Metres of ground to a metre of the map, along its two axes.
    pub(super) scale: [f64; 2],
    /// Latitude and longitude in degrees.
    pub(super) place: (f64, f64),
}

impl Projection {
    /// The projection that PROJ has a text for.
    pub(super) fn of(text: &str) -> Option<Self> {
        let mut text = text.to_string();
        for (datum, ellipsoid) in DATUMS_OF_GRIDS {
            text = text.replace(datum, ellipsoid);
        }
        let unit_m = Proj::from_proj_string(&without(&text, &GRIDS))
            .ok()?
            .to_meter();
        let metric = without(&without(&text, &GRIDS), &UNITS);
        let plane = Proj::from_proj_string(&metric).ok()?;
        let (a, b) = plane.ellipse_parameters();
        let sphere = Proj::from_proj_string(&format!("+proj=longlat +a={a} +b={b}")).ok()?;
        let mut projection = Self {
            plane,
            sphere,
            radii: [a, b],
            unit_m,
            equirectangular: None,
        };
        projection.equirectangular = projection.as_equirectangular();
        Some(projection)
    }

    /// Lengths of degrees and place of 0° E, 0° N, where they are the same all over the map.
    fn as_equirectangular(&self) -> Option<[[f64; 2]; 2]> {
        if self.plane.projname() != "eqc" {
            return None;
        }
        let origin = self.onto_map(0.0, 0.0)?;
        let one = self.onto_map(PI / 180.0, PI / 180.0)?;
        Some([[0, 1].map(|axis| one[axis] - origin[axis]), origin])
    }

    /// The point of the map at a longitude and latitude in radians.
    fn onto_map(&self, longitude: f64, latitude: f64) -> Option<[f64; 2]> {
        let place = (longitude, latitude);
        let (x, y) = transform_vertex_2d(&self.sphere, &self.plane, place).ok()?;
        (x.is_finite() && y.is_finite()).then_some([x, y])
    }

    /// Longitude and latitude in radians of a point of the map in m.
    fn onto_ground(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let (longitude, latitude) = transform_vertex_2d(&self.plane, &self.sphere, (x, y)).ok()?;
        let is_sound = longitude.is_finite() && latitude.abs() <= 0.5 * PI;
        is_sound.then_some([longitude, latitude])
    }

    /// The ground about a point of the map in m.
    pub(super) fn ground(&self, [x, y]: [f64; 2]) -> Result<GroundScale, DemError> {
        let outside = || invalid(format!("({x}, {y}) lies outside of the projection"));
        let step = STEP * self.radii[0];
        let [longitude, latitude] = self.onto_ground([x, y]).ok_or_else(outside)?;
        let east = self
            .steps([x, y], [step, 0.0], latitude)
            .ok_or_else(outside)?;
        let north = self
            .steps([x, y], [0.0, step], latitude)
            .ok_or_else(outside)?;
        let [across, down] = [east, north].map(|[u, v]| (u * u + v * v).sqrt());
        let shear = (east[0] * north[0] + east[1] * north[1]) / (across * down);
        if shear.is_nan() || shear.abs() > MAX_SHEAR {
            return Err(invalid(format!(
                "the projection shears the ground at ({x}, {y})"
            )));
        }
        Ok(GroundScale {
            scale: [across, down].map(|length| settled(0.5 * length / step)),
            place: (latitude.to_degrees(), longitude.to_degrees()),
        })
    }

    /// From a step before a point of the map to a step behind it, in m of ground.
    fn steps(&self, [x, y]: [f64; 2], [dx, dy]: [f64; 2], latitude: f64) -> Option<[f64; 2]> {
        let before = self.onto_ground([x - dx, y - dy])?;
        let after = self.onto_ground([x + dx, y + dy])?;
        Some(self.vector(before, after, latitude))
    }

    /// From one place to a near one in m, to the east and to the north.
    fn vector(&self, from: [f64; 2], to: [f64; 2], latitude: f64) -> [f64; 2] {
        let [a, b] = self.radii;
        let squared = 1.0 - (b / a) * (b / a);
        let (sin, cos) = math::sin_cos(latitude);
        let w = 1.0 - squared * sin * sin;
        // Radii of curvature across the meridian and along it.
        let across = a / w.sqrt();
        let along = across * (1.0 - squared) / w;
        let turn = math::sin(to[0] - from[0]).clamp(-1.0, 1.0);
        let longitude = math::asin(turn);
        [longitude * across * cos, (to[1] - from[1]) * along]
    }
}

/// The scale of a map that is made to be measured on is 1.
fn settled(scale: f64) -> f64 {
    if (scale - 1.0).abs() <= TRUE_TO_SCALE {
        1.0
    } else {
        scale
    }
}

/// The name of a parameter of PROJ's.
fn name_of(parameter: &str) -> &str {
    let name = parameter.trim_start_matches('+').split('=').next();
    name.unwrap_or_default()
}

/// A text of PROJ's without some parameters.
fn without(text: &str, parameters: &[&str]) -> String {
    let is_kept = |part: &&str| !parameters.contains(&name_of(part));
    let kept: Vec<&str> = text.split_whitespace().filter(is_kept).collect();
    kept.join(" ")
}
