//! The ledger, the recording of commands, and the commands to come.

use crate::authoring::{Recording, Scenario, TimedCommand};
use crate::crust::ledger::Amount;
use crate::crust::{Cause, Ledger};
use crate::io::SaveError;
use crate::io::codec::{Decoder, Encoder, invalid};
use crate::spawn::PlanetState;

pub(super) fn write_ledger(state: &PlanetState) -> Vec<u8> {
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

pub(super) fn read_ledger(bytes: &[u8]) -> Result<Ledger, SaveError> {
    let mut read = Decoder(bytes);
    // Causes are known by their place: new ones come last, and older files book nothing to them.
    let causes = read.count(16)?;
    if causes > Cause::ALL.len() {
        let name = causes.to_string();
        return Err(SaveError::unknown("cause of the ledger, number", &name));
    }
    let mut ledger = Ledger::default();
    let booked = ledger.booked.iter_mut().take(causes);
    for amount in core::iter::once(&mut ledger.initial).chain(booked) {
        *amount = Amount {
            area: read.f64()?,
            volume: read.f64()?,
        };
    }
    ledger.carried_area = read.f64()?;
    ledger.unexplained_max = read.f64()?;
    ledger.unexplained_volume_max = read.f64()?;
    read.end()?;
    Ok(ledger)
}

pub(super) fn write_recording(state: &PlanetState) -> Vec<u8> {
    commands(&state.recording.0)
}

pub(super) fn read_recording(bytes: &[u8]) -> Result<Recording, SaveError> {
    let commands = read_commands(bytes, "recording")?;
    if commands.windows(2).any(|pair| pair[0].step > pair[1].step) {
        return Err(invalid("the recording is out of order".into()));
    }
    Ok(Recording(commands))
}

pub(super) fn write_pending(state: &PlanetState) -> Vec<u8> {
    commands(&state.pending.0)
}

pub(super) fn read_pending(bytes: &[u8]) -> Result<Scenario, SaveError> {
    read_commands(bytes, "list of commands to come").map(Scenario)
}

/// Commands as RON, as in a scenario.
fn commands(list: &[TimedCommand]) -> Vec<u8> {
    // Plain lists of numbers and names always have a text.
    ron::to_string(list).unwrap_or_default().into_bytes()
}

/// Reads commands; `what` list they are is said in errors.
fn read_commands(bytes: &[u8], what: &str) -> Result<Vec<TimedCommand>, SaveError> {
    let text =
        core::str::from_utf8(bytes).map_err(|_| invalid(format!("the {what} is no UTF-8")))?;
    let commands: Vec<TimedCommand> =
        ron::from_str(text).map_err(|error| invalid(format!("the {what}: {}", error.code)))?;
    match commands
        .iter()
        .find_map(|timed| timed.command.check().err())
    {
        Some(problem) => Err(invalid(format!("the {what}: {problem}"))),
        None => Ok(commands),
    }
}
