//! Files of maps, read.

use super::doubt;
use super::error::MapFileError;
use super::regrid::{MapMeans, Regrid};
use super::units::{Conversion, MapQuantity};
use crate::climate::EquirectMap;
use crate::io::dem::geotiff::{RasterFile, SideFiles};
use crate::io::dem::picture::{self, fold_rows};
use crate::io::dem::{DemError, MAX_SIDE, extension, open, read_limited};
use crate::io::{IoError, sidecar, text};
use std::io::{BufRead, BufReader, Read, Seek};
use std::path::Path;

/// A map, and what its reader should know of it.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedMap {
    /// The map.
    pub map: EquirectMap,
    /// Doubts of its unit, a sentence each.
    pub warnings: Vec<String>,
}

/// Reads a map; its extension says of which kind. `grey` are the values of black and white of a
/// picture that has no sidecar.
///
/// ```
/// # #[cfg(feature = "export")]
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use bevy_pangaea::io::{load_map, png::grey_png};
///
/// # let folder = tempfile::tempdir()?;
/// let path = folder.path().join("rain.png");
/// let greys = [0, 65_535, 0, 65_535, 0, 0, 0, 0];
/// std::fs::write(&path, grey_png(4, greys.into_iter())?)?;
///
/// let rain = load_map(&path, Some([0.0, 2000.0]))?;
/// assert_eq!(rain.size(), [4, 2]);
/// # Ok(())
/// # }
/// # #[cfg(not(feature = "export"))]
/// # fn main() {}
/// ```
///
/// # Errors
/// [`IoError::Read`] if the file cannot be read, [`IoError::Map`] if it is no map of a whole
/// planet.
pub fn load_map(path: &Path, grey: Option<[f32; 2]>) -> Result<EquirectMap, IoError> {
    Ok(load_map_of(path, MapQuantity::Number, grey)?.map)
}

/// The same of a quantity: values in a unit that the file tells are converted, and where it tells
/// none those that look like another unit's are doubted.
///
/// # Errors
/// As [`load_map`], and [`MapFileError::Unit`] for a unit that is not one of the quantity.
pub fn load_map_of(
    path: &Path,
    quantity: MapQuantity,
    grey: Option<[f32; 2]>,
) -> Result<LoadedMap, IoError> {
    let refused = |source| IoError::map(path, source);
    match extension(path).as_deref() {
        Some("tif" | "tiff") => {
            let beside = SideFiles::load(path)?;
            geotiff(open(path)?, beside, quantity).map_err(refused)
        }
        Some("png") => {
            let beside = SideFiles::load_place(path)?;
            let sidecar = black_and_white(path, grey)?;
            let picture = BufReader::new(open(path)?);
            let map = greys(picture, &sidecar, &beside, quantity).map_err(refused)?;
            // A scale that was given is of the right unit.
            let warnings = Vec::new();
            Ok(LoadedMap { map, warnings })
        }
        _ => Err(refused(MapFileError::Extension)),
    }
}

/// The values of black and white of a picture: those of its sidecar, which knows best, or the
/// caller's.
fn black_and_white(picture: &Path, grey: Option<[f32; 2]>) -> Result<MapSidecar, IoError> {
    let sidecar = sidecar::beside(picture);
    if sidecar.exists() {
        return MapSidecar::load(&sidecar);
    }
    let missing = || MapFileError::NoScale(sidecar.display().to_string());
    let told = grey.map(|[min, max]| MapSidecar {
        min,
        max,
        ..MapSidecar::default()
    });
    told.ok_or_else(|| IoError::map(picture, missing()))
}

/// Values of black and white; and of a picture that `export` wrote, which part of a planet it shows:
/// of a box its edges, of a square its middle alone.
#[derive(Default, serde::Deserialize)]
struct MapSidecar {
    #[serde(alias = "min_m")]
    min: f32,
    #[serde(alias = "max_m")]
    max: f32,
    west: Option<f64>,
    east: Option<f64>,
    south: Option<f64>,
    north: Option<f64>,
    lat: Option<f64>,
}

impl MapSidecar {
    /// Reads a sidecar.
    fn load(path: &Path) -> Result<Self, IoError> {
        let refused = |problem| IoError::map(path, problem);
        let sidecar: Option<Self> = text::parse_json(&read_limited(path)?).ok();
        let sidecar = sidecar
            .filter(|s| s.min.is_finite() && s.max.is_finite() && s.min != s.max)
            .ok_or_else(|| refused(MapFileError::Sidecar))?;
        if sidecar.lat.is_some() && sidecar.extent_deg().is_none() {
            return Err(refused(MapFileError::Square));
        }
        Ok(sidecar)
    }

    /// Degrees from west, to east, from south, to north.
    fn extent_deg(&self) -> Option<[f64; 4]> {
        Some([self.west?, self.east?, self.south?, self.north?])
    }
}

/// Refuses more pixels than are read.
fn check_size(width: u32, height: u32) -> Result<(), MapFileError> {
    let good = 1..=MAX_SIDE;
    if good.contains(&width) && good.contains(&height) {
        return Ok(());
    }
    Err(MapFileError::Raster(DemError::Size(width, height)))
}

/// Reads a raster of values.
fn geotiff(
    source: impl Read + Seek,
    beside: SideFiles,
    quantity: MapQuantity,
) -> Result<LoadedMap, MapFileError> {
    let mut raster = RasterFile::open(source, beside, check_size)?;
    let told = conversion(&raster, quantity)?;
    let grid = Regrid::new(raster.size(), raster.extent_deg()?, raster.is_turned())?;
    let mut means = grid.map(quantity.possible())?;
    raster.for_each_row(told.unwrap_or([1.0, 0.0]), |place, row| {
        means.add(place, row)
    })?;
    let map = means.finish()?;
    let doubt = if told.is_none() {
        doubt::of(&map, quantity)
    } else {
        None
    };
    Ok(LoadedMap {
        map,
        warnings: doubt.into_iter().collect(),
    })
}

/// How the values of a raster become those of a quantity, if it tells its unit.
fn conversion<R: Read + Seek>(
    raster: &RasterFile<R>,
    quantity: MapQuantity,
) -> Result<Option<Conversion>, MapFileError> {
    if let MapQuantity::Elevation(metres) = quantity {
        let told = raster.metres_per_unit()?;
        return Ok(told.map(|of_file| [of_file / metres, 0.0]));
    }
    let unit = raster.unit();
    if unit.is_empty() || quantity == MapQuantity::Number {
        return Ok(None);
    }
    let short: String = unit.chars().take(40).collect();
    let known = quantity.conversion(unit).ok_or(MapFileError::Unit(short))?;
    Ok(Some(known))
}

/// Reads a picture with these values of black and white.
fn greys(
    source: impl BufRead + Seek,
    sidecar: &MapSidecar,
    beside: &SideFiles,
    quantity: MapQuantity,
) -> Result<EquirectMap, MapFileError> {
    let [black, white] = [sidecar.min, sidecar.max].map(f64::from);
    let void = beside.pam.void();
    let value = |grey: picture::Grey| grey.unless(void).map(|grey| grey.between(black, white));
    let value = |grey| value(grey).unwrap_or(f32::NAN);
    let start = |size| begin(size, sidecar, beside, quantity);
    Ok(fold_rows(source, start, value, MapMeans::add)?.finish()?)
}

/// The map of a picture of so many pixels, before its first row.
fn begin(
    size: [u32; 2],
    sidecar: &MapSidecar,
    beside: &SideFiles,
    quantity: MapQuantity,
) -> Result<MapMeans, MapFileError> {
    check_size(size[0], size[1])?;
    let grid = match sidecar.extent_deg() {
        told @ Some(_) => Regrid::new(size, told, [false; 2])?,
        None => Regrid::new(size, beside.extent_deg(size)?, beside.is_turned()?)?,
    };
    Ok(grid.map(quantity.possible())?)
}

#[cfg(all(test, feature = "export"))]
#[path = "tests.rs"]
mod tests;
