//! The planet and its clock.

use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, flag, invalid};
use crate::planet::{GeologicClock, Planet};
use crate::spawn::PlanetState;

pub(super) fn write(state: &PlanetState) -> Vec<u8> {
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

pub(super) fn read(bytes: &[u8]) -> Result<(Planet, GeologicClock), SaveError> {
    let mut read = Decoder(bytes);
    let planet = Planet {
        radius: read.within("radius", 50.0, 100_000.0)?,
        seed: read.u64()?,
    };
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
