//! Samples and the columns of the crust.

use super::unit;
use crate::crust::{Crust, CrustKind, Frames, Orogeny};
use crate::io::codec::{Decoder, Encoder, invalid, read_floats, read_vectors};
use crate::io::save::SaveError;
use crate::planet::Lattice;
use crate::plate::{PlateId, PlateMotion};
use crate::spawn::PlanetState;
use crate::sphere::SphereMesh;
use std::sync::Arc;

/// Fibonacci samples are made again; other points are stored.
const FIBONACCI: u8 = 0;
const POINTS: u8 = 1;

/// What crust can be: km, km, My.
const THICKNESS: (f32, f32) = (-1.0, 1000.0);
const ELEVATION: (f32, f32) = (-100.0, 100.0);
const AGE: (f32, f32) = (0.0, 1e6);

pub(super) fn mesh(state: &PlanetState) -> Vec<u8> {
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

pub(super) fn read_crust(columns: &[&[u8]], n: usize, frames: usize) -> Result<Crust, SaveError> {
    let &[
        frame,
        kind,
        thickness,
        elevation,
        ocean_age,
        ridge,
        orogeny_age,
        orogeny,
        fold,
    ] = columns
    else {
        return Err(SaveError::Truncated);
    };
    if frame.len() != 2 * n || kind.len() != n || orogeny.len() != n {
        return Err(invalid("the columns have not one entry per sample".into()));
    }
    let frame: Vec<u16> = frame
        .as_chunks::<2>()
        .0
        .iter()
        .map(|&b| u16::from_le_bytes(b))
        .collect();
    if let Some(f) = frame.iter().find(|&&f| usize::from(f) >= frames) {
        return Err(invalid(format!("a sample lies in frame {f} of {frames}")));
    }
    let unknown = |what: &str| invalid(format!("unknown {what} of a sample"));
    let kind: Option<Vec<_>> = kind.iter().map(|&k| CrustKind::from_u8(k)).collect();
    let orogeny: Option<Vec<_>> = orogeny.iter().map(|&o| Orogeny::from_u8(o)).collect();
    Ok(Crust {
        frame,
        kind: kind.ok_or_else(|| unknown("crust type"))?,
        thickness: read_floats(thickness, n, "thickness", THICKNESS)?,
        elevation: read_floats(elevation, n, "elevation", ELEVATION)?,
        ocean_age: read_floats(ocean_age, n, "ocean age", AGE)?,
        ridge: read_vectors(ridge, n, "ridge direction")?,
        orogeny_age: read_floats(orogeny_age, n, "orogeny age", AGE)?,
        orogeny: orogeny.ok_or_else(|| unknown("orogeny"))?,
        fold: read_vectors(fold, n, "fold direction")?,
    })
}

/// Crust lies on plates that exist. Until the next resample there may be frames of plates that are
/// gone, but without samples.
pub(super) fn carried(
    crust: &Crust,
    frames: &Frames,
    plates: &[(PlateId, PlateMotion, f64)],
) -> Result<(), SaveError> {
    let gone: Vec<bool> = frames
        .iter()
        .map(|frame| {
            plates
                .binary_search_by_key(&frame.plate, |&(id, ..)| id)
                .is_err()
        })
        .collect();
    match crust.frame.iter().find(|&&f| gone[usize::from(f)]) {
        Some(f) => Err(invalid(format!(
            "a sample lies in frame {f}, whose plate does not exist"
        ))),
        None => Ok(()),
    }
}
