//! Where a raster lies in its coordinate system (OGC 19-008r4, section 7.1.3), as GDAL reads it:
//! by ModelPixelScale and the first ModelTiepoint, else by ModelTransformation.

use super::keys::{self, KeyDirectory};
use super::structure::{Directory, TiffFile, refused};
use super::tag;
use crate::io::dem::error::{DemError, invalid};
use std::io::{Read, Seek};

/// The value of GTRasterTypeGeoKey by which coordinates are those of the middles of pixels.
const PIXEL_IS_POINT: u16 = 2;

/// An upright raster in model coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placement {
    /// Outer corner of the first pixel.
    origin: [f64; 2],
    /// From a column to the next, and from a row to the next.
    pub(super) step: [f64; 2],
}

impl Placement {
    /// The place of an image, if the file tells one.
    pub(super) fn read<R: Read + Seek>(
        file: &TiffFile<R>,
        directory: &Directory,
        keys: &KeyDirectory,
    ) -> Result<Option<Self>, DemError> {
        let scale = file.reals(directory, tag::MODEL_PIXEL_SCALE)?;
        let tie = file.reals(directory, tag::MODEL_TIEPOINT)?;
        let matrix = file.reals(directory, tag::MODEL_TRANSFORMATION)?;
        let placement = match (scale.as_slice(), matrix.as_slice()) {
            (&[across, down, ..], _) if across != 0.0 && down != 0.0 => {
                by_scale(across, down, &tie)?
            }
            (_, &[a, b, _, x, d, e, _, y, ..]) => by_matrix([a, b, d, e], [x, y])?,
            _ if !tie.is_empty() => return Err(only_points()),
            _ => return Ok(None),
        };
        let is_point = keys.code(keys::RASTER_TYPE) == Some(PIXEL_IS_POINT);
        Ok(Some(if is_point {
            placement.moved(-0.5)
        } else {
            placement
        }))
    }

    /// The place by six numbers in GDAL's order: the corner of the first pixel, and steps of a
    /// column and of a row, along each of two axes.
    pub(super) fn of([x, a, b, y, d, e]: [f64; 6]) -> Result<Self, DemError> {
        by_matrix([a, b, d, e], [x, y])
    }

    /// The same, some pixels further on.
    fn moved(self, pixels: f64) -> Self {
        let origin = [0, 1].map(|axis| self.origin[axis] + pixels * self.step[axis]);
        Self { origin, ..self }
    }

    /// Where the first and the last pixel end along an axis.
    pub(super) fn ends(&self, axis: usize, size: [u32; 2]) -> [f64; 2] {
        let start = self.origin[axis];
        [start, start + f64::from(size[axis]) * self.step[axis]]
    }

    /// The middle.
    pub(super) fn middle(&self, size: [u32; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.origin[axis] + 0.5 * f64::from(size[axis]) * self.step[axis])
    }

    /// Do columns go west, and rows north?
    pub(super) fn is_turned(&self) -> [bool; 2] {
        [self.step[0] < 0.0, self.step[1] > 0.0]
    }

    /// Does it only count pixels?
    pub(super) fn is_plain(&self) -> bool {
        self.origin == [0.0, 0.0] && self.step.map(f64::abs) == [1.0, 1.0]
    }
}

/// The error of points alone, which bend a raster in any way.
pub(super) fn only_points() -> DemError {
    invalid(
        "the file has ground control points (ModelTiepoint) only, which may bend it: rectify it \
         first, as with gdalwarp",
    )
}

/// By the size of a pixel and the place of one.
fn by_scale(across: f64, down: f64, tie: &[f64]) -> Result<Placement, DemError> {
    let &[column, row, _, x, y, ..] = tie else {
        return Err(invalid("the file has no ModelTiepoint"));
    };
    // A negative size is taken for a slip of the writer, as in GDAL: rows go south.
    let step = [across, -down.abs()];
    let origin = [x - column * step[0], y - row * step[1]];
    sound(Placement { origin, step }, tag::MODEL_PIXEL_SCALE)
}

/// By a matrix that turns columns and rows into coordinates.
fn by_matrix([a, b, d, e]: [f64; 4], origin: [f64; 2]) -> Result<Placement, DemError> {
    let upright = a.abs() + e.abs();
    if b.abs() + d.abs() > 1e-9 * upright {
        return Err(invalid(
            "ModelTransformation or a side file turns or shears the raster",
        ));
    }
    sound(
        Placement {
            origin,
            step: [a, e],
        },
        tag::MODEL_TRANSFORMATION,
    )
}

/// Refuses numbers that are no places.
fn sound(placement: Placement, tag: tag::Tag) -> Result<Placement, DemError> {
    let Placement { origin, step } = placement;
    let is_sound = origin.iter().chain(&step).all(|z| z.is_finite());
    if is_sound && step.iter().all(|z| *z != 0.0) {
        Ok(placement)
    } else {
        Err(refused(tag))
    }
}
