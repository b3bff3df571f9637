//! The sections of a save file: the state that each holds, and the limits that it must keep to be
//! read.

mod account;
mod crust;
mod fronts;
mod params;
mod planet;
mod plates;

use super::SaveError;
use crate::crust::Crust;
use crate::spawn::PlanetState;

/// A part of the file.
struct SaveSection {
    tag: &'static [u8; 4],
    encode: fn(&PlanetState) -> Vec<u8>,
}

/// The sections before the columns of the crust, in the order of the file.
const SECTIONS: &[SaveSection] = &[
    section(b"PLAN", planet::write),
    section(b"PARM", params::write),
    section(b"PLAT", plates::write_plates),
    section(b"FRMS", plates::write_frames),
    section(b"LEDG", account::write_ledger),
    section(b"RECO", account::write_recording),
    section(b"PEND", account::write_pending),
    section(b"POLA", fronts::write_polarity),
    section(b"FRON", fronts::write_fronts),
    section(b"MESH", crust::write_mesh),
];

const fn section(tag: &'static [u8; 4], encode: fn(&PlanetState) -> Vec<u8>) -> SaveSection {
    SaveSection { tag, encode }
}

/// The tags of all sections in the order of the file.
pub(super) fn tags() -> impl Iterator<Item = &'static [u8; 4]> {
    let columns = Crust::COLUMNS.iter().map(|column| column.tag);
    SECTIONS.iter().map(|section| section.tag).chain(columns)
}

/// Tags and contents of all sections in the order of the file.
pub(super) fn encode(
    state: &PlanetState,
) -> impl Iterator<Item = (&'static [u8; 4], Vec<u8>)> + '_ {
    let tags = Crust::COLUMNS.iter().map(|column| column.tag);
    let columns = tags.zip(state.crust.encode_columns());
    (SECTIONS.iter())
        .map(|section| (section.tag, (section.encode)(state)))
        .chain(columns)
}

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
    let (planet, clock, numbers) = planet::read(head)?;
    let (plates, stats) = plates::read_plates(plat, numbers.next)?;
    let frames = plates::read_frames(frms, numbers.next)?;
    // Only the count is read of the mesh; it is made when all else is good.
    let samples = crust::sample_count(mesh)?;
    let crust = Crust::decode_columns(columns, samples as usize)?;
    crust::check_frames(&crust, &frames, &plates)?;
    let fronts = fronts::read_fronts(fron, samples)?;
    let params = params::read(parm)?;
    let ledger = account::read_ledger(ledg)?;
    let recording = account::read_recording(reco)?;
    let pending = account::read_pending(pend)?;
    let polarity = fronts::read_polarity(pola)?;
    let lattice = crust::read_mesh(mesh)?;
    let fronts = fronts.on_mesh(&lattice);
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
