//! Pictures of heights: grey PNGs, whose scale a sidecar tells.

use super::error::{DemError, invalid};
use super::picture::{Grey, fold_rows};
use super::shrink::ShrunkRaster;
use super::tile::{Dem, check_size};
use crate::io::sidecar::Sidecar;
use crate::io::text;
use std::io::{BufRead, Seek};

/// Reads the sidecar of a picture of heights.
///
/// # Errors
/// [`DemError::Invalid`] for JSON that tells no finite scale.
pub(super) fn parse_sidecar(bytes: &[u8]) -> Result<Sidecar, DemError> {
    let sidecar = text::parse_json(bytes).map_err(invalid)?;
    GreyScale::of(&sidecar)?;
    Ok(sidecar)
}

/// The heights in m that greys stand for.
enum GreyScale {
    /// Black is at 0; the height of one step of grey.
    Step(f64),
    /// Heights of black and white.
    Range(f64, f64),
}

impl GreyScale {
    fn of(sidecar: &Sidecar) -> Result<Self, DemError> {
        let (scale, numbers) = match (sidecar.metres_per_unit, sidecar.min_m, sidecar.max_m) {
            (Some(step), ..) => (Self::Step(step), [0.0, step]),
            (None, Some(min), Some(max)) => (Self::Range(min, max), [min, max - min]),
            _ => {
                return Err(invalid(
                    "the sidecar has neither metres_per_unit nor min_m and max_m",
                ));
            }
        };
        let mut numbers = numbers.into_iter().chain([sidecar.metres_per_pixel]);
        if numbers.all(f64::is_finite) {
            Ok(scale)
        } else {
            Err(invalid("the sidecar's numbers are not finite"))
        }
    }

    fn height(&self, grey: Grey) -> f32 {
        match *self {
            Self::Step(step) => (step * f64::from(grey.level)) as f32,
            Self::Range(black, white) => grey.between(black, white),
        }
    }
}

/// Reads a picture of heights; `void` is the level of voids.
pub(super) fn read(
    source: impl BufRead + Seek,
    sidecar: &Sidecar,
    void: Option<f64>,
) -> Result<Dem, DemError> {
    let scale = GreyScale::of(sidecar)?;
    let height = |grey: Grey| grey.unless(void).map(|grey| scale.height(grey));
    let height = |grey| height(grey).unwrap_or(f32::NAN);
    let raster = fold_rows(source, begin, height, ShrunkRaster::add)?;
    let down = sidecar.metres_per_pixel;
    let pixel_m = [sidecar.metres_per_pixel_across.unwrap_or(down), down];
    raster.finish(pixel_m, sidecar.lat.zip(sidecar.lon))
}

/// A raster of so many pixels, before its first row.
fn begin(pixels: [u32; 2]) -> Result<ShrunkRaster, DemError> {
    check_size(pixels[0], pixels[1])?;
    ShrunkRaster::new(pixels, [false; 2])
}
