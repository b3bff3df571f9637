//! The files that belong to a raster by their names, and change its numbers: GDAL's side file, its
//! external mask, a world file.
//!
//! ```text
//! NAME.EXT.aux.xml           nodata, scale, offset, unit, place and coordinate system
//! NAME.EXT.msk               which pixels are valid, as a TIFF
//! NAME.tfw, .pgw, .wld ..    place, of a file that tells none
//! NAME.prj                   coordinate system of that place
//! ```

use super::mask::MaskFile;
use super::pam::PamFile;
use super::placement::Placement;
use super::system::System;
use super::wkt::{self, SystemOfText};
use crate::io::IoError;
use crate::io::dem::error::{DemError, invalid};
use crate::io::dem::file::{extension, open, read_limited};
use crate::io::text;
use std::fs::File;
use std::path::{Path, PathBuf};

/// The files beside a raster.
#[derive(Default)]
pub(in crate::io) struct SideFiles {
    pub(in crate::io) pam: PamFile,
    pub(in crate::io) mask: Option<MaskFile<File>>,
    /// Corner of the first pixel and steps, by a world file.
    pub(in crate::io) world: Option<[f64; 6]>,
    /// The system of that place.
    world_system: Option<SystemOfText>,
}

impl SideFiles {
    /// Reads the files beside a raster.
    ///
    /// # Errors
    /// Names the one that cannot be read, or makes no sense.
    pub(in crate::io) fn load(raster: &Path) -> Result<Self, IoError> {
        let mut all = Self::default();
        if let Some(path) = beside(raster, ".aux.xml") {
            let pam = PamFile::parse(&read_limited(&path)?);
            all.pam = pam.map_err(|error| IoError::dem(&path, error))?;
        }
        if let Some(path) = beside(raster, ".msk") {
            let mask = MaskFile::open(open(&path)?);
            all.mask = Some(mask.map_err(|error| IoError::dem(&path, error))?);
        }
        if let Some(path) = world_file(raster) {
            let world = parse_world(&read_limited(&path)?);
            all.world = Some(world.map_err(|error| IoError::dem(&path, error))?);
            all.world_system = world_system(raster)?;
        }
        Ok(all)
    }

    /// The same for a format in which they cannot change numbers.
    ///
    /// # Errors
    /// Names a file that would.
    pub(in crate::io) fn load_place(raster: &Path) -> Result<Self, IoError> {
        let all = Self::load(raster)?;
        if all.mask.is_some() {
            return Err(refusal(raster, ".msk", "a mask"));
        }
        match all.pam.calibration() {
            Some(what) => Err(refusal(raster, ".aux.xml", what)),
            None => Ok(all),
        }
    }

    /// Degrees that a raster reaches over which has no place of its own: from west, to east, from
    /// south, to north.
    pub(in crate::io) fn extent_deg(&self, size: [u32; 2]) -> Result<Option<[f64; 4]>, DemError> {
        let Some(transform) = self.place(false) else {
            return Ok(None);
        };
        let told = self.pam.system.as_ref().or(self.world_system.as_ref());
        let system = told.map_or(&System::Unknown, |told| &told.system);
        system.extent_deg(&Placement::of(transform)?, size, 0)
    }

    /// The system of a file, or, if that tells none, the one beside a world file.
    pub(super) fn system(&mut self, own: System) -> SystemOfText {
        match (own, self.world_system.take()) {
            (System::Unknown, Some(beside)) => beside,
            (system, _) => SystemOfText {
                system,
                metres_per_unit: None,
            },
        }
    }

    /// Do its columns go west, and its rows north?
    pub(in crate::io) fn is_turned(&self) -> Result<[bool; 2], DemError> {
        let placement = self.place(false).map(Placement::of).transpose()?;
        Ok(placement.map_or([false; 2], |placement| placement.is_turned()))
    }

    /// Where the raster lies by the files beside it; a world file counts where the raster itself
    /// tells nothing.
    pub(in crate::io) fn place(&self, is_told: bool) -> Option<[f64; 6]> {
        self.pam.transform.or(self.world.filter(|_| !is_told))
    }
}

/// The files beside a raster that are read with it.
pub(in crate::io) fn files_beside(raster: &Path) -> impl Iterator<Item = PathBuf> {
    let by_name = [".aux.xml", ".msk"].map(|ending| beside(raster, ending));
    let place = [world_file(raster), system_file(raster)];
    by_name.into_iter().chain(place).flatten()
}

/// The file whose name is that of a raster and an ending.
fn beside(raster: &Path, ending: &str) -> Option<PathBuf> {
    let mut name = raster.file_name()?.to_os_string();
    name.push(ending);
    Some(raster.with_file_name(name)).filter(|path| path.is_file())
}

/// The world file of a raster: the first and the last letter of its extension and a w, or the
/// extension and a w, or wld; in either case.
fn world_file(raster: &Path) -> Option<PathBuf> {
    let extension = extension(raster)?;
    let mut letters = extension.chars();
    let short: String = [letters.next()?, letters.next_back()?, 'w']
        .into_iter()
        .collect();
    let endings = [short, format!("{extension}w"), "wld".into()];
    let both = endings
        .iter()
        .flat_map(|ending| [ending.clone(), ending.to_ascii_uppercase()]);
    let mut paths = both.map(|ending| raster.with_extension(ending));
    paths.find(|path| path.is_file())
}

/// Why a file beside a raster is not passed over, though no raster of its format has one.
fn refusal(raster: &Path, ending: &str, what: &str) -> IoError {
    let path = beside(raster, ending).unwrap_or_default();
    let kind = extension(raster).unwrap_or_default();
    let problem = format!("{what} is read beside .tif files, not beside .{kind} files");
    IoError::dem(&path, invalid(problem))
}

/// NAME.prj.
fn system_file(raster: &Path) -> Option<PathBuf> {
    let both = ["prj", "PRJ"].map(|ending| raster.with_extension(ending));
    both.into_iter().find(|path| path.is_file())
}

/// The system that NAME.prj tells.
fn world_system(raster: &Path) -> Result<Option<SystemOfText>, IoError> {
    let Some(path) = system_file(raster) else {
        return Ok(None);
    };
    let refused = |error| IoError::dem(&path, error);
    let bytes = read_limited(&path)?;
    let text = text::decode(&bytes).map_err(|error| refused(invalid(error.problem)))?;
    let told = wkt::system(text.trim_start_matches('\u{feff}'));
    told.map(Some).map_err(refused)
}

/// Six numbers in lines: steps of a column along both axes, of a row, and the middle of the first
/// pixel.
fn parse_world(bytes: &[u8]) -> Result<[f64; 6], DemError> {
    let text = String::from_utf8_lossy(bytes);
    let numbers: Result<Vec<f64>, _> = text.split_whitespace().map(str::parse).collect();
    let [a, d, b, e, x, y] = numbers
        .ok()
        .and_then(|all| all.try_into().ok())
        .ok_or_else(no_world)?;
    let corner = [x - 0.5 * (a + b), y - 0.5 * (d + e)];
    Ok([corner[0], a, b, corner[1], d, e])
}

fn no_world() -> DemError {
    invalid("a world file has six numbers in six lines")
}
