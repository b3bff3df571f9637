//! Elevation models of real ground.
//!
//! ```text
//! hgt       *.hgt: SRTM's big-endian i16, named by the south west corner
//! geotiff   *.tif, *.tiff: one band of i16, u16, i32, f32 or f64, in degrees or metres
//! grey      *.png: 16-bit grey with a sidecar NAME.json
//! voids     missing values, filled from their neighbours
//! ```
//!
//! Heights come out in m, rows from the north. Lengths of degrees are those of the Earth.

pub(super) mod geotiff;

pub(super) mod grey;

mod hgt;

mod voids;

pub use grey::Sidecar;

use super::IoError;
use crate::math::{self, PI};
use crate::query::HeightGrid;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// A tile of real ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Dem {
    /// Heights in m without voids.
    pub grid: HeightGrid,
    /// Latitude and longitude of the middle in degrees, where the file tells.
    pub centre: Option<(f64, f64)>,
    /// Number of voids that were filled.
    pub voids: usize,
}

/// Why bytes are no elevation model.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum DemError {
    /// The name's extension is none of those that are read.
    #[error("elevation models are .hgt, .tif, .tiff or .png files")]
    Extension,
    /// The file is larger than any that is read.
    #[error("the file is larger than {MAX_BYTES} bytes")]
    TooLarge,
    /// An .hgt file of another size than 1201² or 3601² values.
    #[error("an .hgt file has 1201 x 1201 or 3601 x 3601 values of two bytes, not {0} bytes")]
    HgtSize(usize),
    /// An .hgt file whose name is no corner.
    #[error("an .hgt file is named by its south west corner, like N44W072.hgt")]
    HgtName,
    /// More, or fewer, pixels than are read.
    #[error("the picture has {0} x {1} pixels; it must have from 2 to {MAX_SIDE} a side")]
    Size(u32, u32),
    /// The file's content makes no sense.
    #[error("{0}")]
    Invalid(String),
    /// Nothing but voids.
    #[error("the file has no heights, only voids")]
    OnlyVoids,
}

/// Most pixels to a side.
const MAX_SIDE: u32 = 10_000;

/// Largest file.
const MAX_BYTES: u64 = 1 << 30;

/// Length of a degree on a sphere of the Earth's mean radius, m.
const DEGREE_M: f64 = 6_371_008.8 * PI / 180.0;

/// The elevation models in a folder, ordered by name.
///
/// # Errors
/// [`IoError::Read`] if the folder cannot be read.
pub fn dem_files(folder: &Path) -> Result<Vec<PathBuf>, IoError> {
    let entries = fs::read_dir(folder).map_err(|source| IoError::read(folder, source))?;
    let mut files = Vec::new();
    for entry in entries {
        let path = entry
            .map_err(|source| IoError::read(folder, source))?
            .path();
        if Format::of(&path).is_ok() && path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// Reads an elevation model; its extension says of which kind.
///
/// # Errors
/// [`IoError::Read`] if the file, or a picture's sidecar, cannot be read; [`IoError::Dem`] if it
/// makes no sense.
pub fn load_dem(path: &Path) -> Result<Dem, IoError> {
    let refused = |source: DemError| IoError::Dem {
        path: path.to_path_buf(),
        source,
    };
    let format = Format::of(path).map_err(refused)?;
    let bytes = read_limited(path)?;
    match format {
        Format::Hgt => hgt::read(
            &path.file_stem().unwrap_or_default().to_string_lossy(),
            &bytes,
        )
        .map_err(refused),
        Format::GeoTiff => geotiff::read(&bytes).map_err(refused),
        Format::Grey => {
            let side = path.with_extension("json");
            let sidecar = Sidecar::parse(&read_limited(&side)?).map_err(|source| IoError::Dem {
                path: side.clone(),
                source,
            })?;
            grey::read(&bytes, &sidecar).map_err(refused)
        }
    }
}

#[derive(Clone, Copy)]
enum Format {
    Hgt,
    GeoTiff,
    Grey,
}

impl Format {
    fn of(path: &Path) -> Result<Self, DemError> {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("hgt") => Ok(Self::Hgt),
            Some("tif" | "tiff") => Ok(Self::GeoTiff),
            Some("png") => Ok(Self::Grey),
            _ => Err(DemError::Extension),
        }
    }
}

/// The bytes of a file that is not too large.
pub(super) fn read_limited(path: &Path) -> Result<Vec<u8>, IoError> {
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes))
        .map_err(|source| IoError::read(path, source))?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(IoError::Dem {
            path: path.to_path_buf(),
            source: DemError::TooLarge,
        });
    }
    Ok(bytes)
}

/// Refuses pictures of too many or too few pixels.
fn check_size(width: u32, height: u32) -> Result<(), DemError> {
    let good = 2..=MAX_SIDE;
    if good.contains(&width) && good.contains(&height) {
        Ok(())
    } else {
        Err(DemError::Size(width, height))
    }
}

/// Size in m of a pixel of `size` degrees at `latitude`, or why it has none.
fn degrees_to_metres([across, down]: [f64; 2], latitude: f64) -> Result<[f64; 2], DemError> {
    if !(-90.0..=90.0).contains(&latitude) {
        return Err(DemError::Invalid(format!(
            "latitude {latitude} is not on the Earth"
        )));
    }
    let cos = math::cos(latitude.to_radians());
    Ok([across * cos * DEGREE_M, down * DEGREE_M])
}

/// A tile of heights with not-a-number for voids.
fn filled(
    width: u32,
    height: u32,
    mut values: Vec<f32>,
    pixel_m: [f64; 2],
    centre: Option<(f64, f64)>,
) -> Result<Dem, DemError> {
    let (width, height) = (width as usize, height as usize);
    if values.len() != width * height {
        return Err(DemError::Invalid(
            "the file does not hold as many values as it says".into(),
        ));
    }
    if !pixel_m.iter().all(|pixel| (1e-3..=1e6).contains(pixel)) {
        return Err(DemError::Invalid(format!(
            "a pixel of {} x {} m makes no sense",
            pixel_m[0], pixel_m[1]
        )));
    }
    // No ground is that high; beyond it, f32 loses metres.
    for z in &mut values {
        if z.is_infinite() || z.abs() > 1e6 {
            *z = f32::NAN;
        }
    }
    let voids = voids::fill(width, &mut values).ok_or(DemError::OnlyVoids)?;
    Ok(Dem {
        grid: HeightGrid {
            width,
            height,
            values,
            pixel_m,
        },
        centre,
        voids,
    })
}

#[cfg(test)]
mod tests;
