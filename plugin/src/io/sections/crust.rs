//! Samples and the columns of the crust.

use crate::crust::{Crust, Frames};
use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, invalid, unit};
use crate::io::column::{any, between, read_column, within_unit, write_column};
use crate::planet::Lattice;
use crate::plate::{PlateId, PlateMotion};
use crate::spawn::PlanetState;
use crate::sphere::SphereMesh;
use std::sync::Arc;

/// Fibonacci samples are made again; other points are stored.
const FIBONACCI: u8 = 0;
const POINTS: u8 = 1;

/// A column of the crust as a section of the file.
pub(super) struct ColumnSection {
    pub(super) tag: &'static [u8; 4],
    pub(super) write: fn(&Crust) -> Vec<u8>,
    /// Reads the column into the crust, for so many samples.
    read: fn(&mut Crust, &[u8], usize) -> Result<(), SaveError>,
}

/// A row per column: its tag, its field, its name in errors, and which values may be read.
macro_rules! column_sections {
    ($($tag:literal $column:ident $what:literal $allowed:expr;)*) => {
        &[$(ColumnSection {
            tag: $tag,
            write: |crust| write_column(&crust.$column),
            read: |crust, bytes, samples| {
                crust.$column = read_column(bytes, samples, $what, $allowed)?;
                Ok(())
            },
        }),*]
    };
}

/// The columns in the order of the file.
pub(super) const COLUMNS: &[ColumnSection] = column_sections! {
    b"FRAM" frame       "frame"           any;
    b"KIND" kind        "crust type"      any;
    b"THIC" thickness   "thickness"       between(-1.0, 1000.0);
    b"ELEV" elevation   "elevation"       between(-100.0, 100.0);
    b"OAGE" ocean_age   "ocean age"       between(0.0, OLDEST);
    b"RIDG" ridge       "ridge direction" within_unit;
    b"FAGE" orogeny_age "orogeny age"     between(0.0, OLDEST);
    b"OROG" orogeny     "orogeny"         any;
    b"FOLD" fold        "fold direction"  within_unit;
};

/// Greatest age of crust or folding in My.
const OLDEST: f32 = 1e6;

/// Reads all columns for so many samples.
pub(super) fn read_columns(contents: &[&[u8]], samples: usize) -> Result<Crust, SaveError> {
    let mut crust = Crust::default();
    for (column, bytes) in COLUMNS.iter().zip(contents) {
        (column.read)(&mut crust, bytes, samples)?;
    }
    Ok(crust)
}

/// Samples lie in frames that exist, and their frames on plates that exist. Until the next resample
/// there may be frames of plates that are gone, but without samples.
pub(super) fn check_frames(
    crust: &Crust,
    frames: &Frames,
    plates: &[(PlateId, PlateMotion, f64)],
) -> Result<(), SaveError> {
    let is_plate = |id| plates.binary_search_by_key(&id, |&(id, ..)| id).is_ok();
    let carried: Vec<bool> = frames.iter().map(|frame| is_plate(frame.plate)).collect();
    for &f in &crust.frame {
        match carried.get(usize::from(f)) {
            Some(true) => {}
            Some(false) => {
                let problem = format!("a sample lies in frame {f}, whose plate does not exist");
                return Err(invalid(problem));
            }
            None => {
                let problem = format!("a sample lies in frame {f} of {}", carried.len());
                return Err(invalid(problem));
            }
        }
    }
    Ok(())
}

pub(super) fn write_mesh(state: &PlanetState) -> Vec<u8> {
    let mesh = &state.lattice.0;
    let mut out = Encoder::default();
    let fibonacci = mesh.is_fibonacci();
    out.u8(if fibonacci { FIBONACCI } else { POINTS });
    out.u32(mesh.len() as u32);
    if !fibonacci {
        mesh.points().iter().for_each(|&p| out.dvec3(p));
    }
    out.0
}

/// The number of samples that a mesh says it has.
pub(super) fn sample_count(bytes: &[u8]) -> Result<u32, SaveError> {
    Decoder(bytes.get(1..).unwrap_or(&[])).u32()
}

/// Makes the mesh.
pub(super) fn read_mesh(bytes: &[u8]) -> Result<Lattice, SaveError> {
    let mut read = Decoder(bytes);
    let refused = |error: crate::sphere::SphereError| invalid(error.to_string());
    let mesh = match read.u8()? {
        FIBONACCI => {
            let samples = read.u32()?;
            read.end()?;
            SphereMesh::fibonacci(samples).map_err(refused)?
        }
        POINTS => {
            let count = read.count(24)?;
            let points = (0..count).map(|_| unit(read.dvec3()?, "position of a sample"));
            let points = points.collect::<Result<Vec<_>, _>>()?;
            read.end()?;
            SphereMesh::from_points(points).map_err(refused)?
        }
        other => return Err(invalid(format!("unknown kind {other} of mesh"))),
    };
    Ok(Lattice(Arc::new(mesh)))
}
