//! The parameters of the model and the switches of processes, each with its name: a file from
//! before one was added has the default of it, and one that this program does not know is refused.

use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, flag, invalid};
use crate::params::{OceanFloor, ParamError, ProcessSwitches, TectonicParams};
use crate::spawn::PlanetState;

pub(super) fn write(state: &PlanetState) -> Vec<u8> {
    let mut out = Encoder::default();
    out.u32(state.params.written().count() as u32);
    for (name, value) in state.params.written() {
        out.text(name);
        out.f64(value);
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

pub(super) fn read(bytes: &[u8]) -> Result<TectonicParams, SaveError> {
    let mut read = Decoder(bytes);
    let mut params = TectonicParams::default();
    read_named(&mut read, size_of::<f64>(), |name, read| {
        params.set(name, read.f64()?).map_err(refused)
    })?;
    read_named(&mut read, size_of::<u8>(), |name, read| {
        *params.processes.get_mut(name).map_err(refused)? = flag(read.u8()?)?;
        Ok(())
    })?;
    params.ocean_floor = match read.u8()? {
        0 => OceanFloor::Relaxing,
        1 => OceanFloor::Paper,
        other => return Err(invalid(format!("unknown law {other} of the ocean floor"))),
    };
    read.end()?;
    // A default may not go with the values that the file gives.
    params.validate().map_err(refused)?;
    Ok(params)
}

/// A list of names with a value of `size` bytes each, in any order. `take` reads the value of a
/// name and refuses names that it does not know.
fn read_named<'a>(
    read: &mut Decoder<'a>,
    size: usize,
    mut take: impl FnMut(&'a str, &mut Decoder<'a>) -> Result<(), SaveError>,
) -> Result<(), SaveError> {
    const LENGTH_BYTES: usize = 4;
    let mut names = Vec::new();
    for _ in 0..read.count(LENGTH_BYTES + size)? {
        let name = read.text()?;
        take(name, read)?;
        if names.contains(&name) {
            return Err(invalid(format!("it gives `{name}` twice")));
        }
        names.push(name);
    }
    Ok(())
}

fn refused(error: ParamError) -> SaveError {
    match error {
        ParamError::Unknown(name) => SaveError::unknown("parameter", &name),
        other => invalid(other.to_string()),
    }
}
