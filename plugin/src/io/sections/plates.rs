//! Plates, frames, and what is remembered of their fronts.

use super::{flag, unit};
use crate::crust::{Frame, Frames};
use crate::io::codec::{Decoder, Encoder, invalid};
use crate::io::save::SaveError;
use crate::plate::front::{FrontField, STEPS_ON_FRONT};
use crate::plate::polarity::{FrontSegment, PolarityMemory};
use crate::plate::{PlateId, PlateMotion, PlateStats};
use crate::spawn::PlanetState;
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::UNREACHED;

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

pub(super) fn read_plates(
    bytes: &[u8],
    next: u32,
) -> Result<(Vec<Row>, Vec<PlateStats>), SaveError> {
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
        let motion = PlateMotion {
            axis,
            speed: read.within("speed of a plate", 0.0, 100.0)?,
        };
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
    if plates.is_empty() {
        Err(invalid("it has no plates".into()))
    } else {
        Ok((plates, stats))
    }
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
    let mut segments: Vec<FrontSegment> = Vec::with_capacity(count);
    for _ in 0..count {
        let pair = (PlateId(read.u32()?), PlateId(read.u32()?));
        let segment = FrontSegment {
            pair,
            bin: read.u16()?,
            first_under: flag(read.u8()?)?,
            held: read.u16()?,
        };
        let key = |s: &FrontSegment| (s.pair, s.bin);
        if pair.0 >= pair.1
            || segments
                .last()
                .is_some_and(|last| key(last) >= key(&segment))
        {
            return Err(invalid("the memory of polarity is out of order".into()));
        }
        segments.push(segment);
    }
    read.end()?;
    Ok(PolarityMemory(segments))
}

/// Distances are not stored: they follow from the sources.
pub(super) fn fronts(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u8(u8::from(state.fronts.stale));
    out.f64(state.fronts.reach);
    out.u32(state.fronts.front.len() as u32);
    for &(sample, age) in &state.fronts.front {
        out.u32(sample);
        out.u8(age);
    }
    (0..state.fronts.nearest.len() as u32).for_each(|i| out.u32(state.fronts.nearest.source(i)));
    out.0
}

/// What is read needs a mesh before it is a field.
pub(super) struct SavedFronts {
    stale: bool,
    reach: f64,
    front: Vec<(u32, u8)>,
    source: Vec<u32>,
}

pub(super) fn read_fronts(bytes: &[u8], samples: u32) -> Result<SavedFronts, SaveError> {
    let mut read = Decoder(bytes);
    let stale = flag(read.u8()?)?;
    let reach = read.within("reach of fronts", 0.0, 4.0)?;
    let count = read.count(5)?;
    let mut front: Vec<(u32, u8)> = Vec::with_capacity(count);
    for _ in 0..count {
        let (sample, age) = (read.u32()?, read.u8()?);
        if sample >= samples
            || age >= STEPS_ON_FRONT
            || front.last().is_some_and(|&(last, _)| last >= sample)
        {
            return Err(invalid("a front is out of order".into()));
        }
        front.push((sample, age));
    }
    if read.0.len() != 4 * samples as usize {
        return Err(invalid(
            "the distances to fronts have not one entry per sample".into(),
        ));
    }
    let source: Vec<u32> = read
        .0
        .as_chunks::<4>()
        .0
        .iter()
        .map(|&b| u32::from_le_bytes(b))
        .collect();
    if source
        .iter()
        .any(|&source| source != UNREACHED && source >= samples)
    {
        return Err(invalid("a front lies at a sample that is not there".into()));
    }
    Ok(SavedFronts {
        stale,
        reach,
        front,
        source,
    })
}

impl SavedFronts {
    /// The field on its mesh.
    pub(super) fn field(self, mesh: &SphereMesh) -> FrontField {
        let Self {
            stale,
            reach,
            front,
            ..
        } = self;
        let field = FrontField {
            stale,
            reach,
            front,
            ..FrontField::new(mesh.len())
        };
        for (i, source) in (0..)
            .zip(self.source)
            .filter(|&(_, source)| source != UNREACHED)
        {
            let chord2 = mesh.point(i).distance_squared(mesh.point(source));
            field.nearest.set(i, source, chord2 as f32);
        }
        field
    }
}
