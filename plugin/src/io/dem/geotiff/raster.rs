//! The one band of a file: its size and place, and its values, rows from the north and columns from
//! the west.

use super::citation;
use super::heights;
use super::keys::{self, KeyDirectory, unknown};
use super::layout::{self, Layout};
use super::mask::{self, InvalidPixels};
use super::metadata::Calibration;
use super::nodata::Nodata;
use super::placement::{Placement, only_points};
use super::rows::each_row;
use super::side_files::SideFiles;
use super::structure::{Directory, TiffFile, unsupported};
use super::system::{self, System, mean_radius};
use super::tag;
use super::wkt::SystemOfText;
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
    beside: SideFiles,
    /// Length in m of the unit of heights by a system that is told as text.
    metres_told: Option<f64>,
}

impl<R: Read + Seek> RasterFile<R> {
    /// Opens a file with those beside it, unless `check` refuses its size. No value is read yet.
    pub(in crate::io) fn open<E: From<DemError>>(
        source: R,
        beside: SideFiles,
        check: impl FnOnce(u32, u32) -> Result<(), E>,
    ) -> Result<Self, E> {
        let file = TiffFile::open(source)?;
        let directory = file.directory(file.first)?;
        let [width, height] = layout::size(&file, &directory)?;
        check(width, height)?;
        Ok(Self::describe(file, directory, beside)?)
    }

    /// Reads everything but values.
    fn describe(
        file: TiffFile<R>,
        directory: Directory,
        mut beside: SideFiles,
    ) -> Result<Self, DemError> {
        check_kind(&file, &directory)?;
        mask::check_samples(&file, &directory)?;
        let layout = Layout::read(&file, &directory)?;
        let keys = KeyDirectory::read(&file, &directory)?;
        let own = file.text(&directory, tag::GDAL_NODATA)?;
        let nodata = beside.pam.nodata.clone().or(own);
        let metadata = file.text(&directory, tag::GDAL_METADATA)?;
        let told = system(&keys, &mut beside)?;
        Ok(Self {
            system: told.system,
            metres_told: told.metres_per_unit,
            placement: placement(&file, &directory, &keys, &beside)?,
            nodata: Nodata::of(nodata.as_deref(), layout.sample_type)?,
            calibration: Calibration::of(metadata.as_deref())?.with(&beside.pam),
            file,
            directory,
            layout,
            keys,
            beside,
        })
    }

    /// Pixels to a row, and rows.
    pub(in crate::io) fn size(&self) -> [u32; 2] {
        self.layout.size
    }

    /// Length in m of the unit of heights, if it is told.
    pub(in crate::io) fn metres_per_unit(&self) -> Result<Option<f64>, DemError> {
        match self.metres_told {
            Some(metres) => heights::agreed(metres, &self.calibration.unit).map(Some),
            None => heights::metres_per_unit(&self.keys, &self.calibration.unit),
        }
    }

    /// The unit of values as it is written; empty if it is not.
    pub(in crate::io) fn unit(&self) -> &str {
        &self.calibration.unit
    }

    /// Hands on all values `z` as `factor z + summand`, NaN for voids: rows of blocks as they come
    /// in the file, with the number of their first pixel.
    pub(in crate::io) fn for_each_row(
        &mut self,
        [factor, summand]: [f64; 2],
        mut take: impl FnMut(usize, &[f32]),
    ) -> Result<(), DemError> {
        let (file, layout) = (&self.file, &self.layout);
        let (nodata, calibration) = (self.nodata, &self.calibration);
        let mask = self.beside.mask.as_ref();
        let mut invalid = InvalidPixels::find(file, &self.directory, layout, mask)?;
        let mut values = Vec::new();
        for row in 0..layout.blocks_a_side()[1] {
            let rows = layout.rows_in(row..row + 1);
            each_row(file, layout, 0, row, nodata.fill, |place, numbers| {
                // The rows of a strip come one after the other, those of tiles again and again.
                let y = (place / layout.size[0] as usize) as u32;
                invalid.load(if layout.is_of_strips() {
                    y..y + 1
                } else {
                    rows.clone()
                })?;
                values.clear();
                values.extend((place..).zip(numbers).map(|(pixel, &number)| {
                    if nodata.marks(number) || invalid.has(pixel) {
                        return f32::NAN;
                    }
                    (calibration.apply(number) * factor + summand) as f32
                }));
                take(place, &values);
                Ok(())
            })?;
        }
        Ok(())
    }

    /// Do columns go west, and rows north?
    pub(in crate::io) fn is_turned(&self) -> [bool; 2] {
        self.placement
            .map_or([false; 2], |placement| placement.is_turned())
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
            // So are pictures written that have no place at all.
            System::Unknown if placement.is_plain() => Err(invalid(
                "the file tells no size of its pixels: its ModelTransformation or ModelPixelScale \
                 counts them",
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
        let code = self.keys.code(keys::PROJECTED_SYSTEM).unwrap_or(0);
        self.system.extent_deg(&placement, self.size(), code)
    }
}

/// The coordinate system: that of a side file, else that of a citation, of the keys, or of a .prj file.
fn system(keys: &KeyDirectory, beside: &mut SideFiles) -> Result<SystemOfText, DemError> {
    if let Some(told) = beside.pam.system.take() {
        return Ok(told);
    }
    match citation::system(keys)? {
        Some(told) => Ok(told),
        None => Ok(beside.system(System::of(keys)?)),
    }
}

/// The place of an image: that of a side file, its own, or that of a world file.
fn placement<R: Read + Seek>(
    file: &TiffFile<R>,
    directory: &Directory,
    keys: &KeyDirectory,
    beside: &SideFiles,
) -> Result<Option<Placement>, DemError> {
    if let Some(transform) = beside.pam.transform {
        return Placement::of(transform).map(Some);
    }
    let own = match Placement::read(file, directory, keys) {
        // Of points and a world file, GDAL takes the world file.
        Err(_) if beside.world.is_some() => None,
        own => own?,
    };
    match (own, beside.place(own.is_some())) {
        (None, Some(transform)) => Placement::of(transform).map(Some),
        (None, None) if beside.pam.has_points => Err(only_points()),
        (own, _) => Ok(own),
    }
}

/// Refuses pictures: numbers that are colours or places in a palette.
fn check_kind<R: Read + Seek>(file: &TiffFile<R>, directory: &Directory) -> Result<(), DemError> {
    // Whether white is the least or the greatest number is how to paint them; they stay as they are.
    match file.number_or(directory, tag::PHOTOMETRIC, 1)? {
        0 | 1 => Ok(()),
        2 => Err(unsupported(tag::PHOTOMETRIC, "2 (colours)")),
        3 => Err(unsupported(tag::PHOTOMETRIC, "3 (a palette)")),
        other => Err(unsupported(tag::PHOTOMETRIC, other)),
    }
}
