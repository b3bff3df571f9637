//! The memory of fronts: which plate goes under, and how far the overriding plates' samples are
//! from their front.

use crate::crust::{decode_column, encode_column};
use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, flag, invalid};
use crate::plate::PlateId;
use crate::plate::front::{FrontField, STEPS_ON_FRONT};
use crate::plate::polarity::{FrontSegment, PolarityMemory};
use crate::spawn::PlanetState;
use crate::sphere::SphereMesh;
use crate::sphere::nearest_source::UNREACHED;

pub(super) fn write_polarity(state: &PlanetState) -> Vec<u8> {
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
        let ascends = (segments.last()).is_none_or(|last| key(last) < key(&segment));
        if pair.0 >= pair.1 || !ascends {
            return Err(invalid("the memory of polarity is out of order".into()));
        }
        segments.push(segment);
    }
    read.end()?;
    Ok(PolarityMemory(segments))
}

/// Distances are not stored: they follow from the sources.
pub(super) fn write_fronts(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u8(u8::from(state.fronts.stale));
    out.f64(state.fronts.reach);
    out.u32(state.fronts.front.len() as u32);
    for &(sample, age) in &state.fronts.front {
        out.u32(sample);
        out.u8(age);
    }
    let nearest = &state.fronts.nearest;
    let sources: Vec<u32> = (0..nearest.len() as u32)
        .map(|i| nearest.source(i))
        .collect();
    out.0.extend(encode_column(&sources));
    out.0
}

/// Fronts as they are saved: distances need a mesh.
pub(super) struct SavedFronts {
    stale: bool,
    reach: f64,
    front: Vec<(u32, u8)>,
    source: Vec<u32>,
}

/// Fronts on a mesh of so many samples.
pub(super) fn read_fronts(bytes: &[u8], samples: u32) -> Result<SavedFronts, SaveError> {
    let mut read = Decoder(bytes);
    let stale = flag(read.u8()?)?;
    let reach = read.within("reach of fronts", 0.0, 4.0)?;
    let front = read_front(&mut read, samples)?;
    let any = f32::MIN..=f32::MAX;
    let source: Vec<u32> = decode_column(read.0, samples as usize, "nearest front", any)?;
    let unknown = |&source: &u32| source != UNREACHED && source >= samples;
    if let Some(source) = source.iter().copied().find(unknown) {
        return Err(invalid(format!(
            "there is no sample {source} for a front to be at"
        )));
    }
    Ok(SavedFronts {
        stale,
        reach,
        front,
        source,
    })
}

/// Samples of the front in ascending order, and how long each has been held.
fn read_front(read: &mut Decoder, samples: u32) -> Result<Vec<(u32, u8)>, SaveError> {
    let count = read.count(5)?;
    let mut front: Vec<(u32, u8)> = Vec::with_capacity(count);
    for _ in 0..count {
        let (sample, age) = (read.u32()?, read.u8()?);
        let ascends = front.last().is_none_or(|&(last, _)| last < sample);
        if sample >= samples || age >= STEPS_ON_FRONT || !ascends {
            return Err(invalid("a front is out of order".into()));
        }
        front.push((sample, age));
    }
    Ok(front)
}

impl SavedFronts {
    /// The field of distances on its mesh.
    pub(super) fn on_mesh(self, mesh: &SphereMesh) -> FrontField {
        let field = FrontField {
            stale: self.stale,
            reach: self.reach,
            front: self.front,
            ..FrontField::new(mesh.len())
        };
        let reached = (0..)
            .zip(self.source)
            .filter(|&(_, source)| source != UNREACHED);
        for (i, source) in reached {
            let chord2 = mesh.point(i).distance_squared(mesh.point(source));
            field.nearest.set(i, source, chord2 as f32);
        }
        field
    }
}
