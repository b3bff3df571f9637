//! The parameters of the model and the switches of processes.

use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, flag, invalid};
use crate::params::{OceanFloor, ParamError, ProcessSwitches, TectonicParams};
use crate::spawn::PlanetState;

pub(super) fn write(state: &PlanetState) -> Vec<u8> {
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

pub(super) fn read(bytes: &[u8]) -> Result<TectonicParams, SaveError> {
    let mut read = Decoder(bytes);
    let mut params = TectonicParams::default();
    read_numbers(&mut read, &mut params)?;
    read_switches(&mut read, &mut params)?;
    params.ocean_floor = match read.u8()? {
        0 => OceanFloor::Relaxing,
        1 => OceanFloor::Paper,
        other => return Err(invalid(format!("unknown law {other} of the ocean floor"))),
    };
    read.end()?;
    Ok(params)
}

/// Parameters by name, in the order of the table.
fn read_numbers(read: &mut Decoder, params: &mut TectonicParams) -> Result<(), SaveError> {
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
    Ok(())
}

/// Switches of processes by name.
fn read_switches(read: &mut Decoder, params: &mut TectonicParams) -> Result<(), SaveError> {
    if read.count(5)? != ProcessSwitches::NAMES.len() {
        return Err(invalid(
            "its processes are not those of this program".into(),
        ));
    }
    for _ in ProcessSwitches::NAMES {
        let name = read.text()?;
        *params.processes.get_mut(name).map_err(refused)? = flag(read.u8()?)?;
    }
    Ok(())
}

fn refused(error: ParamError) -> SaveError {
    invalid(error.to_string())
}
