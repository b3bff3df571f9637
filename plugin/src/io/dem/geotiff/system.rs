//! The coordinate system of a raster: degrees, or metres of a projection (OGC 19-008r4).
//!
//! Systems of EPSG's are those of the crate `crs-definitions` and of `epsg`. A code that neither has
//! is refused, unless other keys define the projection; so is a grid of which only that it is true
//! to scale is known, unless the file has the unit, too.

use super::epsg;
use super::keys::{self, KeyDirectory, USER_DEFINED, unknown};
use super::method;
use super::placement::Placement;
use super::projection::{GroundScale, Projection};
use super::units;
use crate::io::dem::error::{DemError, invalid};

/// Model types.
const PROJECTED: u16 = 1;
pub(super) const GEOGRAPHIC: u16 = 2;

/// Codes of projections (ProjectionGeoKey) that are true to scale: zones of state planes, but for
/// Alaska's Albers, of UTM and of Gauss and Kruger.
const ZONES: [core::ops::RangeInclusive<u16>; 3] =
    [10_101..=15_010, 15_031..=15_304, 16_001..=16_399];

/// Half axes of the Earth in m (WGS 84).
pub(super) const EARTH: [f64; 2] = [6_378_137.0, 6_356_752.314_245];

/// EPSG's systems whose unit is the grad, all of the Paris meridian.
const IN_GRADS: [u16; 8] = [4807, 4810, 4811, 4816, 4819, 4821, 4901, 4902];

/// Longitude of Paris in degrees (EPSG 8903: 2.5969213 grads).
const PARIS_DEG: f64 = 2.337_229_17;

/// A coordinate system.
pub(super) enum System {
    /// Longitudes and latitudes.
    Degrees {
        /// Size of the unit in degrees.
        unit_deg: f64,
        /// Longitude of the meridian 0.
        meridian_deg: f64,
        /// Half axes of the globe in m.
        radii: [f64; 2],
    },
    /// Lengths on a map.
    Lengths {
        /// Length of the unit in m.
        unit_m: f64,
        /// The projection; if it is not told, the map is true to scale.
        projection: Option<Box<Projection>>,
    },
    /// The file does not tell.
    Unknown,
}

impl System {
    /// The system that the keys describe.
    pub(super) fn of(keys: &KeyDirectory) -> Result<Self, DemError> {
        match keys.code(keys::MODEL_TYPE) {
            Some(PROJECTED) => projected(keys),
            Some(GEOGRAPHIC) => geographic(keys),
            None | Some(0) if keys.code(keys::PROJECTED_SYSTEM).is_some() => projected(keys),
            None | Some(0) if keys.code(keys::GEODETIC_SYSTEM).is_some() => geographic(keys),
            // GDAL writes so what it has a text for, too.
            Some(USER_DEFINED) if keys.definition(keys::PROJECTED_SYSTEM).is_some() => {
                projected(keys)
            }
            Some(USER_DEFINED) if keys.definition(keys::GEODETIC_SYSTEM).is_some() => {
                geographic(keys)
            }
            // Keys may tell no more than where in a pixel its value is.
            None => Ok(Self::Unknown),
            Some(other) => Err(unknown(keys::MODEL_TYPE, other)),
        }
    }
}

impl System {
    /// Degrees that a raster reaches over: from west, to east, from south, to north; `None` if it
    /// only counts pixels.
    ///
    /// # Errors
    /// A raster in a projection that is not equirectangular, by its `code`.
    pub(super) fn extent_deg(
        &self,
        placement: &Placement,
        size: [u32; 2],
        code: u16,
    ) -> Result<Option<[f64; 4]>, DemError> {
        let [scale, origin] = match self {
            Self::Degrees {
                unit_deg,
                meridian_deg,
                ..
            } => [[1.0 / unit_deg; 2], [-meridian_deg / unit_deg, 0.0]],
            Self::Lengths { unit_m, projection } => {
                let map = projection.as_ref().and_then(|map| map.equirectangular);
                let map = map.ok_or_else(|| not_in_degrees(code))?;
                map.map(|point| point.map(|metres| metres / unit_m))
            }
            Self::Unknown if placement.is_plain() => return Ok(None),
            Self::Unknown => [[1.0; 2], [0.0; 2]],
        };
        let ends = [0, 1].map(|axis| placement.ends(axis, size));
        let [[west, east], [south, north]] =
            [0, 1].map(|axis| sorted(ends[axis].map(|end| (end - origin[axis]) / scale[axis])));
        Ok(Some([west, east, south, north]))
    }
}

fn sorted([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

/// The error of a map of a region in a projection.
fn not_in_degrees(code: u16) -> DemError {
    let problem = format!("{code} (a map of a whole planet is in degrees)");
    unknown(keys::PROJECTED_SYSTEM, problem)
}

/// The system of longitudes and latitudes.
fn geographic(keys: &KeyDirectory) -> Result<System, DemError> {
    let code = keys.code(keys::GEODETIC_SYSTEM);
    let is_in_grads = code.is_some_and(|code| IN_GRADS.contains(&code));
    let usual = if is_in_grads { 0.9 } else { 1.0 };
    let unit_deg = units::angular(keys)?.unwrap_or(usual);
    let paris = if is_in_grads { PARIS_DEG } else { 0.0 };
    let meridian = keys.measure(keys::PRIME_MERIDIAN.number);
    Ok(System::Degrees {
        unit_deg,
        meridian_deg: meridian.map_or(paris, |longitude| longitude * unit_deg),
        radii: radii(keys),
    })
}

/// Half axes of the ellipsoid in m: those that the file gives, or the Earth's.
fn radii(keys: &KeyDirectory) -> [f64; 2] {
    let good = |radius: &f64| (1e3..=1e9).contains(radius);
    let Some(a) = keys.measure(keys::SEMI_MAJOR_AXIS.number).filter(good) else {
        return EARTH;
    };
    let minor = keys.measure(keys::SEMI_MINOR_AXIS.number);
    let flattening = keys.measure(keys::INVERSE_FLATTENING.number);
    // An inverse of 0 stands for a sphere.
    let flattened = flattening.filter(|f| *f > 1.0).map(|f| a * (1.0 - 1.0 / f));
    let b = minor.filter(good).or(flattened).unwrap_or(a);
    [a, b]
}

/// The system of a projection.
fn projected(keys: &KeyDirectory) -> Result<System, DemError> {
    let told = units::linear(keys)?;
    let has_method = keys
        .code(keys::PROJECTION_METHOD)
        .is_some_and(|code| code != 0);
    let own = || own(keys, told.unwrap_or(1.0));
    let projection = match keys.code(keys::PROJECTED_SYSTEM) {
        None | Some(0) => own()?,
        Some(USER_DEFINED) if has_method || is_of_zone(keys) => own()?,
        Some(USER_DEFINED) => return Err(undefined()),
        Some(code) => match known(code, told.is_some()) {
            Err(_) if has_method => own()?,
            known => known?,
        },
    };
    let usual = projection.as_ref().map_or(1.0, |known| known.unit_m);
    Ok(System::Lengths {
        unit_m: told.unwrap_or(usual),
        projection,
    })
}

fn is_of_zone(keys: &KeyDirectory) -> bool {
    let code = keys.code(keys::PROJECTION);
    code.is_some_and(|code| ZONES.iter().any(|zones| zones.contains(&code)))
}

/// The error of a system that the file does not define.
fn undefined() -> DemError {
    let problem = format!("{USER_DEFINED} without {}", keys::PROJECTION_METHOD.name);
    unknown(keys::PROJECTED_SYSTEM, problem)
}

/// The projection that EPSG has given a code; `None` for a grid that is true to scale.
pub(super) fn known(code: u16, has_unit: bool) -> Result<Option<Box<Projection>>, DemError> {
    let older = crs_definitions::from_code(code).map(|found| found.proj4);
    let definition = older.or_else(|| epsg::definition(code));
    let projection = definition.and_then(Projection::of);
    if projection.is_none() && !(has_unit && epsg::is_true_to_scale(code)) {
        return Err(unknown(keys::PROJECTED_SYSTEM, code));
    }
    Ok(projection.map(Box::new))
}

/// The projection that a file defines.
fn own(keys: &KeyDirectory, unit_m: f64) -> Result<Option<Box<Projection>>, DemError> {
    let unit_deg = units::angular(keys)?.unwrap_or(1.0);
    let Some(text) = method::projection(keys, radii(keys), unit_deg, unit_m)? else {
        return Ok(None);
    };
    let own = Projection::of(&text).ok_or_else(|| {
        let name = keys::PROJECTION_METHOD.name;
        invalid(format!("{name} with parameters that make no sense"))
    })?;
    Ok(Some(Box::new(own)))
}

/// Mean radius of an ellipsoid.
pub(super) fn mean_radius([a, b]: [f64; 2]) -> f64 {
    (2.0 * a + b) / 3.0
}

/// The ground about a point of a map in m; without a projection it is true to scale.
pub(super) fn ground(
    projection: Option<&Projection>,
    point: [f64; 2],
) -> Result<Option<GroundScale>, DemError> {
    projection
        .map(|projection| projection.ground(point))
        .transpose()
}
