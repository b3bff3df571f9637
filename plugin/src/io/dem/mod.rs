//! Elevation models of real ground.
//!
//! ```text
//! hgt       *.hgt: SRTM's big-endian i16, named by the south west corner
//! geotiff/  *.tif, *.tiff: one band of numbers, in any units
//! picture   greys of a PNG, in whatever form it holds them
//! grey      *.png: greys with a sidecar NAME.json
//! file      files by their names, and their content
//! archive   *.hgt.zip, *.hgt.gz: one .hgt file
//! voids     missing values, filled from their neighbours
//! tile      a tile of ground, and the checks that all formats share
//! means     means of cells
//! shrink    rasters of more pixels than are held
//! ```
//!
//! A file may be a copy that a browser or `wget` made and put a number behind: `N44W072.hgt (1)`,
//! `N44W072.hgt.1`.
//!
//! Heights come out in m, rows from the north; those of more than 2^24 pixels as means of blocks.
//! Degrees of an .hgt file have the lengths of the Earth's, those of a GeoTIFF the lengths on the
//! ellipsoid that it names, or the Earth's.
//!
//! Files beside a raster that change its numbers are read, too: GDAL's NAME.EXT.aux.xml and
//! NAME.EXT.msk, and world files; where a format cannot have them, they are refused.

mod error;

mod file;

mod voids;

mod tile;

mod means;

mod shrink;

pub(super) mod geotiff;

pub(super) mod picture;

mod grey;

mod hgt;

mod archive;

pub use error::DemError;
pub(super) use error::MAX_SIDE;
pub(super) use file::{extension, open, read_limited};
pub(super) use means::CellMeans;
pub use tile::Dem;

use super::IoError;
use super::limited::read_at_most;
use super::sidecar::{self, Sidecar};
use error::invalid;
use geotiff::SideFiles;
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// The files in a folder whose extensions are those of elevation models, packed ones included,
/// ordered by name; not those in folders within it. Not each has to be one: pictures may be
/// previews, hidden files the remains of another system.
///
/// # Errors
/// [`IoError::Read`] if the folder cannot be read.
pub fn dem_files(folder: &Path) -> Result<Vec<PathBuf>, IoError> {
    let entries = fs::read_dir(folder).map_err(|source| IoError::read(folder, source))?;
    let mut files = Vec::new();
    for entry in entries {
        let entry = entry.map_err(|source| IoError::read(folder, source))?;
        let path = entry.path();
        // Pipes would be waited for; links that lead nowhere are named when they are read.
        let is_file = path.metadata().map_or(true, |metadata| metadata.is_file());
        if (DemFormat::of(&path).is_ok() || is_packed(&path)) && is_file {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// The files that are read with an elevation model or a map: itself, the sidecar of a picture, and
/// whatever beside it belongs to it by its name. A command that writes over one of them changes what
/// it was given.
pub fn raster_files(raster: &Path) -> Vec<PathBuf> {
    let sidecar = sidecar::beside(raster);
    let is_picture = extension(raster).as_deref() == Some("png");
    let sidecar = Some(sidecar).filter(|path| is_picture && path.is_file());
    let others = sidecar.into_iter().chain(geotiff::files_beside(raster));
    core::iter::once(raster.to_path_buf())
        .chain(others)
        .collect()
}

/// Reads an elevation model; its extension says of which kind.
///
/// ```
/// # #[cfg(feature = "export")]
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use bevy_pangaea::io::{load_dem, png::grey_png};
///
/// # let folder = tempfile::tempdir()?;
/// let picture = folder.path().join("hill.png");
/// let sidecar = folder.path().join("hill.json");
/// std::fs::write(&picture, grey_png(3, [0, 1, 0, 1, 9, 1, 0, 1, 0].into_iter())?)?;
/// std::fs::write(&sidecar, r#"{"metres_per_pixel": 30, "metres_per_unit": 10}"#)?;
///
/// let hill = load_dem(&picture)?;
/// assert_eq!(hill.grid.range(), Some([0.0, 90.0]));
/// # Ok(())
/// # }
/// # #[cfg(not(feature = "export"))]
/// # fn main() {}
/// ```
///
/// # Errors
/// [`IoError::Read`] if the file, or a picture's sidecar, cannot be read; [`IoError::Dem`] if it
/// makes no sense.
pub fn load_dem(path: &Path) -> Result<Dem, IoError> {
    let refused = |source| IoError::dem(path, source);
    let dem = match DemFormat::of(path).map_err(refused)? {
        DemFormat::Hgt => {
            hgt::check_void(&SideFiles::load_place(path)?.pam).map_err(refused)?;
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let file = open(path)?;
            hgt::read(&name, length(path, &file)?, BufReader::new(file))
        }
        DemFormat::PackedHgt => {
            let bytes = read_at_most(path, archive::MOST_BYTES)?;
            archive::read(path, &bytes.ok_or_else(|| refused(DemError::TooLarge))?)
        }
        DemFormat::GeoTiff => geotiff::read(open(path)?, SideFiles::load(path)?),
        DemFormat::Grey => {
            let beside = SideFiles::load_place(path)?;
            let scale = load_sidecar(path)?;
            grey::read(BufReader::new(open(path)?), &scale, beside.pam.void())
        }
    };
    dem.map_err(refused)
}

/// The sidecar of a picture.
fn load_sidecar(picture: &Path) -> Result<Sidecar, IoError> {
    let path = sidecar::beside(picture);
    if !path.exists() {
        let problem = format!(
            "a picture of heights needs a sidecar {} with its scale, {{\"metres_per_pixel\": .., \
             \"metres_per_unit\": ..}}",
            path.display()
        );
        return Err(IoError::dem(picture, invalid(problem)));
    }
    grey::parse_sidecar(&read_limited(&path)?).map_err(|source| IoError::dem(&path, source))
}

/// Bytes of a file.
fn length(path: &Path, file: &File) -> Result<u64, IoError> {
    let facts = file
        .metadata()
        .map_err(|source| IoError::read(path, source))?;
    Ok(facts.len())
}

/// Is it an elevation model in an archive that is not read, such as tile.tif.zip? It is named.
fn is_packed(path: &Path) -> bool {
    let is_archive = matches!(DemFormat::of(path), Err(DemError::Archive));
    is_archive && DemFormat::of(&path.with_extension("")).is_ok()
}

fn is_hgt(name: Option<&OsStr>) -> bool {
    name.is_some_and(|name| extension(Path::new(name)).as_deref() == Some("hgt"))
}

/// The formats of elevation models.
#[derive(Clone, Copy)]
enum DemFormat {
    Hgt,
    PackedHgt,
    GeoTiff,
    Grey,
}

impl DemFormat {
    /// The format that a file's extension names.
    fn of(path: &Path) -> Result<Self, DemError> {
        match extension(path).as_deref() {
            Some("hgt") => Ok(Self::Hgt),
            Some("tif" | "tiff") => Ok(Self::GeoTiff),
            Some("png") => Ok(Self::Grey),
            Some("zip" | "gz") if is_hgt(path.file_stem()) => Ok(Self::PackedHgt),
            Some("zip" | "gz") => Err(DemError::Archive),
            _ => Err(DemError::Extension),
        }
    }
}

#[cfg(all(test, feature = "export"))]
mod tests;
