//! The planet and its clock.

use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, flag, invalid};
use crate::planet::{GeologicClock, Planet, PlateNumbers};
use crate::spawn::PlanetState;

pub(super) fn write(state: &PlanetState) -> Vec<u8> {
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

pub(super) fn read(bytes: &[u8]) -> Result<(Planet, GeologicClock, PlateNumbers), SaveError> {
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
