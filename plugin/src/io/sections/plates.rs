//! Plates, frames, and what is remembered of their fronts.

use super::{flag, unit};
use crate::crust::{Frame, Frames};
use crate::io::codec::{Decoder, Encoder, floats, invalid};
use crate::io::save::SaveError;
use crate::plate::contact::PolarityMemory;
use crate::plate::polarity::Segment;
use crate::plate::{PlateId, PlateMotion, PlateStats};
use crate::process::front::FrontField;
use crate::spawn::PlanetState;
use crate::sphere::spread::UNREACHED;

/// A plate as it is in a planet's state.
type Row = (PlateId, PlateMotion, f64);

pub(super) fn plates(state: &PlanetState) -> Vec<u8> {
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

pub(super) fn read_plates(bytes: &[u8], next: u32) -> Result<(Vec<Row>, Vec<PlateStats>), SaveError> {
    let mut read = Decoder(bytes);
    let count = read.count(96)?;
    let mut plates: Vec<Row> = Vec::with_capacity(count);
    let mut stats = Vec::with_capacity(count);
    for _ in 0..count {
        let id = PlateId(read.u32()?);
        if plates.last().is_some_and(|&(last, ..)| last >= id) || id.0 >= next {
            return Err(invalid(format!("plate {} is out of order", id.0)));
        }
        let axis = unit(read.dvec3()?, "axis of a plate")?;
        let motion = PlateMotion { axis, speed: read.within("speed of a plate", 0.0, 100.0)? };
        plates.push((id, motion, read.within("birth of a plate", 0.0, 1e9)?));
        stats.push(PlateStats {
            samples: read.u32()?,
            area: read.within("area of a plate", 0.0, 1e12)?,
            continental: read.within("continental share of a plate", 0.0, 1.0 + 1e-9)?,
            ocean_age: read.within("ocean age of a plate", 0.0, 1e9)?,
            centroid: unit(read.dvec3()?, "centroid of a plate")?,
        });
    }
    read.end()?;
    if plates.is_empty() { Err(invalid("it has no plates".into())) } else { Ok((plates, stats)) }
}

pub(super) fn frames(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(state.frames.len() as u32);
    for frame in state.frames.iter() {
        out.u32(frame.plate.0);
        out.dquat(frame.rotation);
        out.u8(u8::from(frame.terrane));
    }
    out.0
}

pub(super) fn read_frames(bytes: &[u8], next: u32) -> Result<Frames, SaveError> {
    let mut read = Decoder(bytes);
    let count = read.count(37)?;
    let mut frames = Vec::with_capacity(count);
    for _ in 0..count {
        let plate = PlateId(read.u32()?);
        if plate.0 >= next {
            return Err(invalid(format!("a frame belongs to plate {}, which never was", plate.0)));
        }
        let rotation = read.dquat()?;
        if (rotation.length_squared() - 1.0).abs() > 1e-6 {
            return Err(invalid("a rotation has no unit length".into()));
        }
        frames.push(Frame { plate, rotation, terrane: flag(read.u8()?)? });
    }
    read.end()?;
    Ok(Frames(frames))
}

pub(super) fn polarity(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(state.polarity.0.len() as u32);
    for segment in &state.polarity.0 {
        out.u32(segment.pair.0.0);
        out.u32(segment.pair.1.0);
        out.u16(segment.bin);
        out.u8(u8::from(segment.first_under));
        out.u16(segment.held);
    }
    out.0
}

pub(super) fn read_polarity(bytes: &[u8]) -> Result<PolarityMemory, SaveError> {
    let mut read = Decoder(bytes);
    let count = read.count(13)?;
    let mut segments: Vec<Segment> = Vec::with_capacity(count);
    for _ in 0..count {
        let pair = (PlateId(read.u32()?), PlateId(read.u32()?));
        let segment = Segment { pair, bin: read.u16()?, first_under: flag(read.u8()?)?, held: read.u16()? };
        let key = |s: &Segment| (s.pair, s.bin);
        if pair.0 >= pair.1 || segments.last().is_some_and(|last| key(last) >= key(&segment)) {
            return Err(invalid("the memory of polarity is out of order".into()));
        }
        segments.push(segment);
    }
    read.end()?;
    Ok(PolarityMemory(segments))
}

pub(super) fn fronts(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u8(u8::from(state.fronts.stale));
    state.fronts.source.iter().for_each(|&i| out.u32(i));
    out.0.extend(floats(&state.fronts.distance));
    out.0
}

pub(super) fn read_fronts(bytes: &[u8], samples: u32) -> Result<FrontField, SaveError> {
    let n = samples as usize;
    if bytes.len() != 1 + 8 * n {
        return Err(invalid("the distances to fronts have not one entry per sample".into()));
    }
    let mut read = Decoder(bytes);
    let stale = flag(read.u8()?)?;
    let (source, distance) = bytes[1..].split_at(4 * n);
    let source: Vec<u32> = source.as_chunks::<4>().0.iter().map(|&b| u32::from_le_bytes(b)).collect();
    let distance: Vec<f32> = distance.as_chunks::<4>().0.iter().map(|&b| f32::from_le_bytes(b)).collect();
    let sound = source.iter().zip(&distance).all(|(&source, &distance)| match source {
        UNREACHED => distance == f32::INFINITY,
        _ => source < samples && (0.0..4.0).contains(&distance),
    });
    if !sound {
        return Err(invalid("a distance to a front is no distance".into()));
    }
    Ok(FrontField { stale, source, distance, ..FrontField::new(0) })
}
