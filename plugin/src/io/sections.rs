//! The sections of a save file: what is in each, and what it must fulfil to be read.

use super::codec::{Decoder, Encoder, floats, invalid, read_floats, read_vectors, vectors};
use super::save::SaveError;
use crate::authoring::{Recording, TimedCommand};
use crate::crust::ledger::Amount;
use crate::crust::{Cause, Crust, CrustKind, Frame, Frames, Ledger, Orogeny};
use crate::params::{OceanFloor, ProcessSwitches, TectonicParams};
use crate::planet::{GeologicClock, Lattice, Planet};
use crate::plate::contact::PolarityMemory;
use crate::plate::polarity::Segment;
use crate::plate::{PlateId, PlateMotion};
use crate::process::front::FrontField;
use crate::spawn::PlanetState;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use std::sync::Arc;

/// A part of the file.
pub(super) struct Section {
    pub(super) tag: &'static [u8; 4],
    pub(super) encode: fn(&PlanetState) -> Vec<u8>,
}

/// All sections in the order of the file.
pub(super) const SECTIONS: &[Section] = &[
    Section { tag: b"PLAN", encode: planet },
    Section { tag: b"PARM", encode: params },
    Section { tag: b"PLAT", encode: plates },
    Section { tag: b"FRMS", encode: frames },
    Section { tag: b"LEDG", encode: ledger },
    Section { tag: b"RECO", encode: recording },
    Section { tag: b"POLA", encode: polarity },
    Section { tag: b"FRON", encode: fronts },
    Section { tag: b"MESH", encode: mesh },
    Section { tag: b"FRAM", encode: |s| s.crust.frame.iter().flat_map(|f| f.to_le_bytes()).collect() },
    Section { tag: b"KIND", encode: |s| s.crust.kind.iter().map(|&k| k as u8).collect() },
    Section { tag: b"THIC", encode: |s| floats(&s.crust.thickness) },
    Section { tag: b"ELEV", encode: |s| floats(&s.crust.elevation) },
    Section { tag: b"OAGE", encode: |s| floats(&s.crust.ocean_age) },
    Section { tag: b"RIDG", encode: |s| vectors(&s.crust.ridge) },
    Section { tag: b"FAGE", encode: |s| floats(&s.crust.orogeny_age) },
    Section { tag: b"OROG", encode: |s| s.crust.orogeny.iter().map(|&o| o as u8).collect() },
    Section { tag: b"FOLD", encode: |s| vectors(&s.crust.fold) },
];

/// Fibonacci samples are made again; other points are stored.
const FIBONACCI: u8 = 0;
const POINTS: u8 = 1;

/// Makes a planet of the contents of all sections. The mesh, which takes longest, comes last.
pub(super) fn decode(contents: &[&[u8]]) -> Result<PlanetState, SaveError> {
    let &[head, parm, plat, frms, ledg, reco, pola, fron, mesh, ref columns @ ..] = contents else {
        return Err(SaveError::Truncated);
    };
    let (planet, clock) = read_planet(head)?;
    let params = read_params(parm)?;
    let plates = read_plates(plat, clock.next_plate)?;
    let frames = read_frames(frms, clock.next_plate)?;
    let ledger = read_ledger(ledg)?;
    let recording = read_recording(reco)?;
    let polarity = read_polarity(pola)?;
    let samples = Decoder(mesh.get(1..).unwrap_or(&[])).u32()?;
    let crust = read_crust(columns, samples as usize, frames.len())?;
    carried(&crust, &frames, &plates)?;
    let fronts = read_fronts(fron, samples)?;
    let lattice = read_mesh(mesh)?;
    Ok(PlanetState { planet, lattice, crust, frames, plates, clock, params, ledger, recording, polarity, fronts })
}

fn planet(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.f64(state.planet.radius);
    out.u64(state.planet.seed);
    out.f64(state.clock.time);
    out.u64(state.clock.step);
    out.u32(state.clock.since_resample);
    out.f64(state.clock.last_resample);
    out.u32(state.clock.next_plate);
    out.u8(u8::from(state.clock.resample_requested));
    out.0
}

fn read_planet(bytes: &[u8]) -> Result<(Planet, GeologicClock), SaveError> {
    let mut read = Decoder(bytes);
    let planet = Planet { radius: read.within("radius", 50.0, 100_000.0)?, seed: read.u64()? };
    let clock = GeologicClock {
        time: read.within("time", 0.0, 1e9)?,
        step: read.u64()?,
        since_resample: read.u32()?,
        last_resample: read.within("time of the last resample", 0.0, 1e9)?,
        next_plate: read.u32()?,
        resample_requested: flag(read.u8()?)?,
        ..GeologicClock::default()
    };
    read.end()?;
    if clock.last_resample > clock.time {
        return Err(invalid("the last resample lies in the future".into()));
    }
    Ok((planet, clock))
}

fn params(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(TectonicParams::TABLE.len() as u32);
    for info in TectonicParams::TABLE {
        out.text(info.name);
        out.f64((info.get)(&state.params));
    }
    let mut switches = state.params.processes;
    out.u32(ProcessSwitches::NAMES.len() as u32);
    for name in ProcessSwitches::NAMES {
        out.text(name);
        out.u8(u8::from(switches.get_mut(name).is_ok_and(|on| *on)));
    }
    out.u8(state.params.ocean_floor as u8);
    out.0
}

fn read_params(bytes: &[u8]) -> Result<TectonicParams, SaveError> {
    let mut read = Decoder(bytes);
    let mut params = TectonicParams::default();
    let refused = |error: crate::params::ParamError| invalid(error.to_string());
    if read.count(12)? != TectonicParams::TABLE.len() {
        return Err(invalid("its parameters are not those of this program".into()));
    }
    for info in TectonicParams::TABLE {
        let name = read.text()?;
        if name != info.name {
            return Err(invalid(format!("unknown parameter `{}`", name.escape_debug())));
        }
        params.set(name, read.f64()?).map_err(refused)?;
    }
    if read.count(5)? != ProcessSwitches::NAMES.len() {
        return Err(invalid("its processes are not those of this program".into()));
    }
    for _ in ProcessSwitches::NAMES {
        let name = read.text()?;
        *params.processes.get_mut(name).map_err(refused)? = flag(read.u8()?)?;
    }
    params.ocean_floor = match read.u8()? {
        0 => OceanFloor::Relaxing,
        1 => OceanFloor::Paper,
        other => return Err(invalid(format!("unknown law {other} of the ocean floor"))),
    };
    read.end()?;
    Ok(params)
}

fn flag(byte: u8) -> Result<bool, SaveError> {
    match byte {
        0 => Ok(false),
        1 => Ok(true),
        _ => Err(invalid(format!("a switch is {byte}"))),
    }
}

fn plates(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(state.plates.len() as u32);
    for (id, motion, born) in &state.plates {
        out.u32(id.0);
        out.dvec3(motion.axis);
        out.f64(motion.speed);
        out.f64(*born);
    }
    out.0
}

fn read_plates(bytes: &[u8], next: u32) -> Result<Vec<(PlateId, PlateMotion, f64)>, SaveError> {
    let mut read = Decoder(bytes);
    let count = read.count(44)?;
    let mut plates: Vec<(PlateId, PlateMotion, f64)> = Vec::with_capacity(count);
    for _ in 0..count {
        let id = PlateId(read.u32()?);
        if plates.last().is_some_and(|&(last, ..)| last >= id) || id.0 >= next {
            return Err(invalid(format!("plate {} is out of order", id.0)));
        }
        let axis = unit(read.dvec3()?, "axis of a plate")?;
        let motion = PlateMotion { axis, speed: read.within("speed of a plate", 0.0, 100.0)? };
        plates.push((id, motion, read.within("birth of a plate", 0.0, 1e9)?));
    }
    read.end()?;
    if plates.is_empty() { Err(invalid("it has no plates".into())) } else { Ok(plates) }
}

fn unit(v: DVec3, what: &str) -> Result<DVec3, SaveError> {
    if (v.length_squared() - 1.0).abs() < 1e-6 { Ok(v) } else { Err(invalid(format!("the {what} has no unit length"))) }
}

fn frames(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(state.frames.len() as u32);
    for frame in state.frames.iter() {
        out.u32(frame.plate.0);
        out.dquat(frame.rotation);
        out.u8(u8::from(frame.terrane));
    }
    out.0
}

fn read_frames(bytes: &[u8], next: u32) -> Result<Frames, SaveError> {
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

/// Crust lies on plates that exist. Until the next resample there may be frames of plates that are gone,
/// but without samples.
fn carried(crust: &Crust, frames: &Frames, plates: &[(PlateId, PlateMotion, f64)]) -> Result<(), SaveError> {
    let gone: Vec<bool> = frames
        .iter()
        .map(|frame| plates.binary_search_by_key(&frame.plate, |&(id, ..)| id).is_err())
        .collect();
    match crust.frame.iter().find(|&&f| gone[usize::from(f)]) {
        Some(f) => Err(invalid(format!("a sample lies in frame {f}, whose plate does not exist"))),
        None => Ok(()),
    }
}

fn ledger(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    let ledger = &state.ledger;
    out.u32(ledger.booked.len() as u32);
    for amount in core::iter::once(&ledger.initial).chain(&ledger.booked) {
        out.f64(amount.area);
        out.f64(amount.volume);
    }
    out.f64(ledger.carried_area);
    out.f64(ledger.unexplained_max);
    out.f64(ledger.unexplained_volume_max);
    out.0
}

fn read_ledger(bytes: &[u8]) -> Result<Ledger, SaveError> {
    let mut read = Decoder(bytes);
    if read.count(16)? != Cause::ALL.len() {
        return Err(invalid("its ledger has other causes than this program".into()));
    }
    let mut ledger = Ledger::default();
    for amount in core::iter::once(&mut ledger.initial).chain(&mut ledger.booked) {
        *amount = Amount { area: read.f64()?, volume: read.f64()? };
    }
    ledger.carried_area = read.f64()?;
    ledger.unexplained_max = read.f64()?;
    ledger.unexplained_volume_max = read.f64()?;
    read.end()?;
    Ok(ledger)
}

fn recording(state: &PlanetState) -> Vec<u8> {
    // Plain lists of numbers and names always have a text.
    ron::to_string(&state.recording.0).unwrap_or_default().into_bytes()
}

fn read_recording(bytes: &[u8]) -> Result<Recording, SaveError> {
    let text = core::str::from_utf8(bytes).map_err(|_| invalid("the recording is no UTF-8".into()))?;
    let commands: Vec<TimedCommand> =
        ron::from_str(text).map_err(|error| invalid(format!("the recording: {}", error.code)))?;
    if commands.windows(2).any(|pair| pair[0].step > pair[1].step) {
        return Err(invalid("the recording is out of order".into()));
    }
    Ok(Recording(commands))
}

fn polarity(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(state.polarity.0.len() as u32);
    for segment in &state.polarity.0 {
        out.u32(segment.pair.0.0);
        out.u32(segment.pair.1.0);
        out.u16(segment.bin);
        out.u8(u8::from(segment.first_under));
    }
    out.0
}

fn read_polarity(bytes: &[u8]) -> Result<PolarityMemory, SaveError> {
    let mut read = Decoder(bytes);
    let count = read.count(11)?;
    let mut segments: Vec<Segment> = Vec::with_capacity(count);
    for _ in 0..count {
        let pair = (PlateId(read.u32()?), PlateId(read.u32()?));
        let segment = Segment { pair, bin: read.u16()?, first_under: flag(read.u8()?)? };
        let key = |s: &Segment| (s.pair, s.bin);
        if pair.0 >= pair.1 || segments.last().is_some_and(|last| key(last) >= key(&segment)) {
            return Err(invalid("the memory of polarity is out of order".into()));
        }
        segments.push(segment);
    }
    read.end()?;
    Ok(PolarityMemory(segments))
}

fn fronts(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u8(u8::from(state.fronts.stale));
    out.u32(state.fronts.seeds.len() as u32);
    state.fronts.seeds.iter().for_each(|&i| out.u32(i));
    out.0
}

fn read_fronts(bytes: &[u8], samples: u32) -> Result<FrontField, SaveError> {
    let mut read = Decoder(bytes);
    let stale = flag(read.u8()?)?;
    let count = read.count(4)?;
    let seeds = (0..count).map(|_| read.u32()).collect::<Result<Vec<_>, _>>()?;
    read.end()?;
    if seeds.windows(2).any(|pair| pair[0] >= pair[1]) || seeds.last().is_some_and(|&i| i >= samples) {
        return Err(invalid("the fronts are out of order".into()));
    }
    Ok(FrontField { seeds, stale, ..FrontField::default() })
}

fn mesh(state: &PlanetState) -> Vec<u8> {
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

fn read_mesh(bytes: &[u8]) -> Result<Lattice, SaveError> {
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

fn read_crust(columns: &[&[u8]], n: usize, frames: usize) -> Result<Crust, SaveError> {
    let &[frame, kind, thickness, elevation, ocean_age, ridge, orogeny_age, orogeny, fold] = columns else {
        return Err(SaveError::Truncated);
    };
    if frame.len() != 2 * n || kind.len() != n || orogeny.len() != n {
        return Err(invalid("the columns have not one entry per sample".into()));
    }
    let frame: Vec<u16> = frame.as_chunks::<2>().0.iter().map(|&b| u16::from_le_bytes(b)).collect();
    if let Some(f) = frame.iter().find(|&&f| usize::from(f) >= frames) {
        return Err(invalid(format!("a sample lies in frame {f} of {frames}")));
    }
    let unknown = |what: &str| invalid(format!("unknown {what} of a sample"));
    let kind: Option<Vec<_>> = kind.iter().map(|&k| CrustKind::from_u8(k)).collect();
    let orogeny: Option<Vec<_>> = orogeny.iter().map(|&o| Orogeny::from_u8(o)).collect();
    Ok(Crust {
        frame,
        kind: kind.ok_or_else(|| unknown("crust type"))?,
        thickness: read_floats(thickness, n, "thickness")?,
        elevation: read_floats(elevation, n, "elevation")?,
        ocean_age: read_floats(ocean_age, n, "ocean age")?,
        ridge: read_vectors(ridge, n, "ridge direction")?,
        orogeny_age: read_floats(orogeny_age, n, "orogeny age")?,
        orogeny: orogeny.ok_or_else(|| unknown("orogeny"))?,
        fold: read_vectors(fold, n, "fold direction")?,
    })
}
