//! A tile of real ground, and the checks that all formats share.

use super::error::{DemError, MAX_SIDE, invalid};
use super::voids;
use crate::math::{self, PI};
use crate::query::HeightGrid;

/// Mean radius of the Earth, m.
const EARTH_RADIUS_M: f64 = 6_371_008.8;

/// Greatest height or depth in m; no ground is that high, and beyond it f32 loses metres.
pub(super) const MAX_HEIGHT_M: f32 = 1e6;

/// A tile of real ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Dem {
    /// Heights in m without voids; of a file of more pixels than are held, the means of its blocks.
    pub grid: HeightGrid,
    /// Columns and rows of the file.
    pub pixels: [usize; 2],
    /// Latitude and longitude of the middle in degrees, if the file tells.
    pub centre: Option<(f64, f64)>,
    /// Number of voids that were filled.
    pub voids: usize,
}

impl Dem {
    /// A tile of heights with NaN for voids, which are filled.
    pub(super) fn new(
        [width, height]: [u32; 2],
        mut values: Vec<f32>,
        pixel_m: [f64; 2],
        centre: Option<(f64, f64)>,
    ) -> Result<Self, DemError> {
        let (width, height) = (width as usize, height as usize);
        if values.len() != width * height {
            return Err(invalid("the file does not hold as many values as it says"));
        }
        let [across, down] = pixel_m;
        if !pixel_m.iter().all(|side| (1e-3..=1e6).contains(side)) {
            return Err(invalid(format!(
                "a pixel of {across} x {down} m makes no sense"
            )));
        }
        for z in &mut values {
            // One NaN for all voids: filling them marks some by another.
            if z.is_nan() || z.abs() > MAX_HEIGHT_M {
                *z = f32::NAN;
            }
        }
        let voids = voids::fill(width, &mut values).ok_or(DemError::OnlyVoids)?;
        let grid = HeightGrid {
            width,
            height,
            values,
            pixel_m,
        };
        Ok(Self {
            grid,
            pixels: [width, height],
            centre,
            voids,
        })
    }

    /// Whether the grid has the means of the file's pixels instead of them.
    pub fn is_shrunk(&self) -> bool {
        self.pixels != [self.grid.width, self.grid.height]
    }
}

/// Refuses pictures of too many or too few pixels.
pub(super) fn check_size(width: u32, height: u32) -> Result<(), DemError> {
    let good = 2..=MAX_SIDE;
    if good.contains(&width) && good.contains(&height) {
        Ok(())
    } else {
        Err(DemError::Size(width, height))
    }
}

/// Size in m of a pixel of `size` degrees at `latitude` on the Earth.
pub(super) fn degrees_to_metres(size: [f64; 2], latitude: f64) -> Result<[f64; 2], DemError> {
    degrees_on_sphere(size, latitude, EARTH_RADIUS_M)
}

/// Size in m of a pixel of `size` degrees at `latitude` on a sphere of `radius_m`.
pub(super) fn degrees_on_sphere(
    [across, down]: [f64; 2],
    latitude: f64,
    radius_m: f64,
) -> Result<[f64; 2], DemError> {
    if !(-90.0..=90.0).contains(&latitude) {
        return Err(invalid(format!("latitude {latitude} is on no globe")));
    }
    let cos = math::cos(latitude.to_radians());
    let degree_m = radius_m * PI / 180.0;
    Ok([across * cos * degree_m, down * degree_m])
}
