//! The one band of a file: its size and place, and its values, rows from the north and columns from
//! the west.

use super::heights;
use super::keys::{self, KeyDirectory, unknown};
use super::layout::{self, Layout};
use super::mask;
use super::metadata::Calibration;
use super::nodata::Nodata;
use super::placement::Placement;
use super::rows::each_row;
use super::structure::{Directory, TiffFile, unsupported};
use super::system::{self, System, mean_radius};
use super::tag;
use crate::io::dem::error::{DemError, invalid};
use crate::io::dem::tile::degrees_on_sphere;
use std::io::{Read, Seek};

/// A raster without a coordinate system counts in degrees if its pixels are less wide than this,
/// and lies on a globe of degrees: no ground is measured in such steps of a metre.
const LEAST_PIXEL_M: f64 = 0.1;

/// A file of one band.
pub(in crate::io) struct RasterFile<R> {
    file: TiffFile<R>,
    directory: Directory,
    layout: Layout,
    keys: KeyDirectory,
    system: System,
    placement: Option<Placement>,
    nodata: Nodata,
    calibration: Calibration,
}

impl<R: Read + Seek> RasterFile<R> {
    /// Opens a file, unless `check` refuses its size. No value is read yet.
    pub(in crate::io) fn open<E: From<DemError>>(
        source: R,
        check: impl FnOnce(u32, u32) -> Result<(), E>,
    ) -> Result<Self, E> {
        let mut file = TiffFile::open(source)?;
        let directory = file.directory(file.first)?;
        let [width, height] = layout::size(&mut file, &directory)?;
        check(width, height)?;
        Ok(Self::describe(file, directory)?)
    }

    /// Reads everything but values.
    fn describe(mut file: TiffFile<R>, directory: Directory) -> Result<Self, DemError> {
        check_kind(&mut file, &directory)?;
        mask::check_samples(&mut file, &directory)?;
        let layout = Layout::read(&mut file, &directory)?;
        let keys = KeyDirectory::read(&mut file, &directory)?;
        let nodata = file.text(&directory, tag::GDAL_NODATA)?;
        let metadata = file.text(&directory, tag::GDAL_METADATA)?;
        Ok(Self {
            system: System::of(&keys)?,
            placement: Placement::read(&mut file, &directory, &keys)?,
            nodata: Nodata::of(nodata.as_deref(), layout.sample_type)?,
            calibration: Calibration::of(metadata.as_deref())?,
            file,
            directory,
            layout,
            keys,
        })
    }

    /// Pixels to a row, and rows.
    pub(in crate::io) fn size(&self) -> [u32; 2] {
        self.layout.size
    }

    /// Length in m of the unit of heights.
    pub(super) fn metres_per_unit(&self) -> Result<f64, DemError> {
        heights::metres_per_unit(&self.keys, &self.calibration.unit)
    }

    /// All values in `unit`, NaN for voids, rows from the north.
    pub(in crate::io) fn values(&mut self, unit: f64) -> Result<Vec<f32>, DemError> {
        let [width, height] = self.size().map(|side| side as usize);
        let mut values = room(width * height)?;
        let (nodata, calibration) = (self.nodata, &self.calibration);
        let fill = nodata.fill;
        each_row(&mut self.file, &self.layout, 0, fill, |place, numbers| {
            for (value, &number) in values[place..].iter_mut().zip(numbers) {
                if !nodata.marks(number) {
                    *value = (calibration.apply(number) * unit) as f32;
                }
            }
        })?;
        mask::erase(&mut self.file, &self.directory, &self.layout, &mut values)?;
        if let Some(placement) = self.placement {
            turn_north_up(placement, width, &mut values);
        }
        Ok(values)
    }

    /// Size of a pixel in m on the ground in the middle, and the middle's latitude and longitude, if
    /// they are told.
    pub(super) fn ground(&self) -> Result<([f64; 2], Option<(f64, f64)>), DemError> {
        let Some(placement) = self.placement else {
            return Err(invalid("the file has no ModelPixelScale"));
        };
        let pixel = placement.step.map(f64::abs);
        let middle = placement.middle(self.size());
        match &self.system {
            System::Degrees {
                unit_deg,
                meridian_deg,
                radii,
            } => {
                let [lon, lat] = middle.map(|angle| angle * unit_deg);
                let degrees = pixel.map(|side| side * unit_deg);
                let metres = degrees_on_sphere(degrees, lat, mean_radius(*radii))?;
                Ok((metres, Some((lat, lon + meridian_deg))))
            }
            System::Lengths { unit_m, projection } => {
                let point = middle.map(|coordinate| coordinate * unit_m);
                let ground = system::ground(projection.as_deref(), point)?;
                let scale = ground.map_or([1.0; 2], |ground| ground.scale);
                let metres = [0, 1].map(|axis| pixel[axis] * unit_m * scale[axis]);
                Ok((metres, ground.map(|ground| ground.place)))
            }
            System::Unknown if pixel[0] < LEAST_PIXEL_M => Err(unknown(
                keys::MODEL_TYPE,
                "(none: degrees or metres are not told)",
            )),
            System::Unknown => Ok((pixel, None)),
        }
    }

    /// Degrees that the file reaches over: from west, to east, from south, to north; `None` if it
    /// has no place.
    ///
    /// # Errors
    /// A raster in a projection that is not equirectangular.
    pub(in crate::io) fn extent_deg(&self) -> Result<Option<[f64; 4]>, DemError> {
        let Some(placement) = self.placement else {
            return Ok(None);
        };
        let [scale, origin] = match &self.system {
            System::Degrees {
                unit_deg,
                meridian_deg,
                ..
            } => [[1.0 / unit_deg; 2], [-meridian_deg / unit_deg, 0.0]],
            System::Lengths { unit_m, projection } => {
                let map = projection.as_ref().and_then(|map| map.equirectangular);
                let map = map.ok_or_else(|| self.not_in_degrees())?;
                map.map(|point| point.map(|metres| metres / unit_m))
            }
            // Pixels are counted, no degrees.
            System::Unknown if placement.is_plain() => return Ok(None),
            System::Unknown => [[1.0; 2], [0.0; 2]],
        };
        let ends = [0, 1].map(|axis| placement.ends(axis, self.size()));
        let [[west, east], [south, north]] =
            [0, 1].map(|axis| sorted(ends[axis].map(|end| (end - origin[axis]) / scale[axis])));
        Ok(Some([west, east, south, north]))
    }

    /// The error of a map of a region in a projection.
    fn not_in_degrees(&self) -> DemError {
        let code = self.keys.code(keys::PROJECTED_SYSTEM).unwrap_or(0);
        unknown(
            keys::PROJECTED_SYSTEM,
            format!("{code} (a map of a whole planet is in degrees)"),
        )
    }
}

fn sorted([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

/// Refuses pictures: numbers that are colours or places in a palette.
fn check_kind<R: Read + Seek>(
    file: &mut TiffFile<R>,
    directory: &Directory,
) -> Result<(), DemError> {
    // Whether white is the least or the greatest number is how to paint them; they stay as they are.
    match file.number_or(directory, tag::PHOTOMETRIC, 1)? {
        0 | 1 => Ok(()),
        2 => Err(unsupported(tag::PHOTOMETRIC, "2 (colours)")),
        3 => Err(unsupported(tag::PHOTOMETRIC, "3 (a palette)")),
        other => Err(unsupported(tag::PHOTOMETRIC, other)),
    }
}

/// Room for values, all void.
fn room(count: usize) -> Result<Vec<f32>, DemError> {
    let mut values = Vec::new();
    let bytes = count as u64 * size_of::<f32>() as u64;
    values
        .try_reserve_exact(count)
        .map_err(|_| DemError::Memory(bytes))?;
    values.resize(count, f32::NAN);
    Ok(values)
}

/// Puts the north row first, and the west column.
fn turn_north_up(placement: Placement, width: usize, values: &mut [f32]) {
    let [east, north] = placement.step;
    if east < 0.0 {
        values.chunks_exact_mut(width).for_each(<[f32]>::reverse);
    }
    if north > 0.0 {
        let half = values.len() / width / 2 * width;
        let from_south = values.len() - half;
        let (upper, lower) = values.split_at_mut(from_south);
        let rows = upper.chunks_exact_mut(width);
        for (north, south) in rows.zip(lower.chunks_exact_mut(width).rev()) {
            north.swap_with_slice(south);
        }
    }
}
