//! The sections of a save file: what is in each, and what it must fulfil to be read.

mod account;
mod crust;
mod plates;

use super::codec::{Decoder, Encoder, floats, invalid, vectors};
use super::save::SaveError;
use crate::params::{OceanFloor, ProcessSwitches, TectonicParams};
use crate::planet::{GeologicClock, Planet, PlateNumbers};
use crate::spawn::PlanetState;
use account::{ledger, pending, read_ledger, read_pending, read_recording, recording};
use bevy::math::DVec3;
use crust::{carried, mesh, read_crust, read_mesh};
use plates::{
    frames, fronts, plates, polarity, read_frames, read_fronts, read_plates, read_polarity,
};

/// A part of the file.
pub(super) struct Section {
    pub(super) tag: &'static [u8; 4],
    pub(super) encode: fn(&PlanetState) -> Vec<u8>,
}

/// All sections in the order of the file.
pub(super) const SECTIONS: &[Section] = &[
    Section {
        tag: b"PLAN",
        encode: planet,
    },
    Section {
        tag: b"PARM",
        encode: params,
    },
    Section {
        tag: b"PLAT",
        encode: plates,
    },
    Section {
        tag: b"FRMS",
        encode: frames,
    },
    Section {
        tag: b"LEDG",
        encode: ledger,
    },
    Section {
        tag: b"RECO",
        encode: recording,
    },
    Section {
        tag: b"PEND",
        encode: pending,
    },
    Section {
        tag: b"POLA",
        encode: polarity,
    },
    Section {
        tag: b"FRON",
        encode: fronts,
    },
    Section {
        tag: b"MESH",
        encode: mesh,
    },
    Section {
        tag: b"FRAM",
        encode: |s| s.crust.frame.iter().flat_map(|f| f.to_le_bytes()).collect(),
    },
    Section {
        tag: b"KIND",
        encode: |s| s.crust.kind.iter().map(|&k| k as u8).collect(),
    },
    Section {
        tag: b"THIC",
        encode: |s| floats(&s.crust.thickness),
    },
    Section {
        tag: b"ELEV",
        encode: |s| floats(&s.crust.elevation),
    },
    Section {
        tag: b"OAGE",
        encode: |s| floats(&s.crust.ocean_age),
    },
    Section {
        tag: b"RIDG",
        encode: |s| vectors(&s.crust.ridge),
    },
    Section {
        tag: b"FAGE",
        encode: |s| floats(&s.crust.orogeny_age),
    },
    Section {
        tag: b"OROG",
        encode: |s| s.crust.orogeny.iter().map(|&o| o as u8).collect(),
    },
    Section {
        tag: b"FOLD",
        encode: |s| vectors(&s.crust.fold),
    },
];

/// Makes a planet of the contents of all sections. The mesh, which takes longest, comes last.
pub(super) fn decode(contents: &[&[u8]]) -> Result<PlanetState, SaveError> {
    let &[
        head,
        parm,
        plat,
        frms,
        ledg,
        reco,
        pend,
        pola,
        fron,
        mesh,
        ref columns @ ..,
    ] = contents
    else {
        return Err(SaveError::Truncated);
    };
    let (planet, clock, numbers) = read_planet(head)?;
    let params = read_params(parm)?;
    let (plates, stats) = read_plates(plat, numbers.next)?;
    let frames = read_frames(frms, numbers.next)?;
    let ledger = read_ledger(ledg)?;
    let recording = read_recording(reco)?;
    let pending = read_pending(pend)?;
    let polarity = read_polarity(pola)?;
    let samples = Decoder(mesh.get(1..).unwrap_or(&[])).u32()?;
    let crust = read_crust(columns, samples as usize, frames.len())?;
    carried(&crust, &frames, &plates)?;
    let fronts = read_fronts(fron, samples)?;
    let lattice = read_mesh(mesh)?;
    let fronts = fronts.field(&lattice);
    Ok(PlanetState {
        planet,
        lattice,
        crust,
        frames,
        plates,
        stats,
        clock,
        numbers,
        params,
        ledger,
        recording,
        pending,
        polarity,
        fronts,
    })
}

fn planet(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.f64(state.planet.radius);
    out.u64(state.planet.seed);
    out.f64(state.clock.time);
    out.u64(state.clock.step);
    out.u32(state.clock.since_resample);
    out.f64(state.clock.last_resample);
    out.u32(state.numbers.next);
    out.u8(u8::from(state.clock.resample_requested));
    out.0
}

fn read_planet(bytes: &[u8]) -> Result<(Planet, GeologicClock, PlateNumbers), SaveError> {
    let mut read = Decoder(bytes);
    let planet = Planet {
        radius: read.within("radius", 50.0, 100_000.0)?,
        seed: read.u64()?,
    };
    let mut clock = GeologicClock {
        time: read.within("time", 0.0, 1e9)?,
        step: read.u64()?,
        since_resample: read.u32()?,
        last_resample: read.within("time of the last resample", 0.0, 1e9)?,
        resample_requested: false,
    };
    let numbers = PlateNumbers { next: read.u32()? };
    clock.resample_requested = flag(read.u8()?)?;
    read.end()?;
    if clock.last_resample > clock.time {
        return Err(invalid("the last resample lies in the future".into()));
    }
    Ok((planet, clock, numbers))
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
        return Err(invalid(
            "its parameters are not those of this program".into(),
        ));
    }
    for info in TectonicParams::TABLE {
        let name = read.text()?;
        if name != info.name {
            return Err(invalid(format!(
                "unknown parameter `{}`",
                name.escape_debug()
            )));
        }
        params.set(name, read.f64()?).map_err(refused)?;
    }
    if read.count(5)? != ProcessSwitches::NAMES.len() {
        return Err(invalid(
            "its processes are not those of this program".into(),
        ));
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

fn unit(v: DVec3, what: &str) -> Result<DVec3, SaveError> {
    if (v.length_squared() - 1.0).abs() < 1e-6 {
        Ok(v)
    } else {
        Err(invalid(format!("the {what} has no unit length")))
    }
}
