//! Samples and the columns of the crust.

use crate::crust::{Crust, Frames};
use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, invalid, unit};
use crate::planet::Lattice;
use crate::plate::{PlateId, PlateMotion};
use crate::spawn::PlanetState;
use crate::sphere::SphereMesh;
use std::sync::Arc;

/// Fibonacci samples are made again; other points are stored.
const FIBONACCI: u8 = 0;
const POINTS: u8 = 1;

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
