//! Plates and frames.

use crate::crust::{Frame, Frames};
use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, flag, invalid, unit};
use crate::plate::{PlateId, PlateMotion, PlateStats};
use crate::spawn::PlanetState;

/// A plate of a planet's state: number, motion, time of birth in My.
type SavedPlate = (PlateId, PlateMotion, f64);

pub(super) fn write_plates(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(state.plates.len() as u32);
    for (k, (id, motion, born)) in state.plates.iter().enumerate() {
        out.u32(id.0);
        out.dvec3(motion.axis);
        out.f64(motion.speed);
        out.f64(*born);
        let stats = state.stats.get(k).copied().unwrap_or_default();
        out.u32(stats.samples);
        out.f64(stats.area);
        out.f64(stats.continental);
        out.f64(stats.ocean_age);
        out.dvec3(stats.centroid);
    }
    out.0
}

/// Plates in ascending order of their numbers, all below `next`.
pub(super) fn read_plates(
    bytes: &[u8],
    next: u32,
) -> Result<(Vec<SavedPlate>, Vec<PlateStats>), SaveError> {
    let mut read = Decoder(bytes);
    let count = read.count(96)?;
    let mut plates: Vec<SavedPlate> = Vec::with_capacity(count);
    let mut stats = Vec::with_capacity(count);
    for _ in 0..count {
        let id = PlateId(read.u32()?);
        if plates.last().is_some_and(|&(last, ..)| last >= id) || id.0 >= next {
            return Err(invalid(format!("plate {} is out of order", id.0)));
        }
        let motion = read_motion(&mut read)?;
        plates.push((id, motion, read.within("birth of a plate", 0.0, 1e9)?));
        stats.push(read_stats(&mut read)?);
    }
    read.end()?;
    if plates.is_empty() {
        Err(invalid("it has no plates".into()))
    } else {
        Ok((plates, stats))
    }
}

fn read_motion(read: &mut Decoder) -> Result<PlateMotion, SaveError> {
    Ok(PlateMotion {
        axis: unit(read.dvec3()?, "axis of a plate")?,
        speed: read.within("speed of a plate", 0.0, 100.0)?,
    })
}

fn read_stats(read: &mut Decoder) -> Result<PlateStats, SaveError> {
    Ok(PlateStats {
        samples: read.u32()?,
        area: read.within("area of a plate", 0.0, 1e12)?,
        continental: read.within("continental share of a plate", 0.0, 1.0 + 1e-9)?,
        ocean_age: read.within("ocean age of a plate", 0.0, 1e9)?,
        centroid: unit(read.dvec3()?, "centroid of a plate")?,
    })
}

pub(super) fn write_frames(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(state.frames.len() as u32);
    for frame in state.frames.iter() {
        out.u32(frame.plate.0);
        out.dquat(frame.rotation);
        out.u8(u8::from(frame.terrane));
    }
    out.0
}

/// Frames of plates whose numbers are below `next`.
pub(super) fn read_frames(bytes: &[u8], next: u32) -> Result<Frames, SaveError> {
    let mut read = Decoder(bytes);
    let count = read.count(37)?;
    let mut frames = Vec::with_capacity(count);
    for _ in 0..count {
        let plate = PlateId(read.u32()?);
        if plate.0 >= next {
            return Err(invalid(format!(
                "a frame belongs to plate {}, which never was",
                plate.0
            )));
        }
        let rotation = read.dquat()?;
        if (rotation.length_squared() - 1.0).abs() > 1e-6 {
            return Err(invalid("a rotation has no unit length".into()));
        }
        frames.push(Frame {
            plate,
            rotation,
            terrane: flag(read.u8()?)?,
        });
    }
    read.end()?;
    Ok(Frames(frames))
}
