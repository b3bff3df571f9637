//! The sections of a save file: the state that each holds, and the limits that it must keep to be
//! read.

mod split;

mod maps;

mod account;
mod climate;
mod crust;
mod fronts;
mod params;
mod planet;
mod plates;
mod terrain;

pub(super) use maps::check_pixels;
use split::FileSections;
pub(super) use split::SectionTag;

use super::SaveError;
use crate::crust::Crust;
use crate::spawn::PlanetState;

/// A part of the file that every planet has.
struct SaveSection {
    tag: &'static SectionTag,
    encode: fn(&PlanetState) -> Vec<u8>,
}

/// The section that only planets with maps of their climate have.
const CLIMATE: SectionTag = *b"CLIM";

/// The section that only planets of maps have.
const TERRAIN: SectionTag = *b"TERR";

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

const fn section(tag: &'static SectionTag, encode: fn(&PlanetState) -> Vec<u8>) -> SaveSection {
    SaveSection { tag, encode }
}

/// The tags of all sections that this program knows.
fn tags() -> impl Iterator<Item = SectionTag> {
    let columns = Crust::COLUMNS.iter().map(|column| *column.tag);
    let always = SECTIONS.iter().map(|section| *section.tag).chain(columns);
    always.chain([CLIMATE, TERRAIN])
}

/// Tags and contents of the sections that every planet has, in the order of the file.
pub(super) fn encode(state: &PlanetState) -> impl Iterator<Item = (SectionTag, Vec<u8>)> + '_ {
    let tags = Crust::COLUMNS.iter().map(|column| *column.tag);
    let columns = tags.zip(state.crust.encode_columns());
    (SECTIONS.iter())
        .map(|section| (*section.tag, (section.encode)(state)))
        .chain(columns)
}

/// The bytes before a section's content: its tag and its length.
pub(super) fn head(tag: SectionTag, content: &[u8]) -> [u8; 12] {
    let mut head = [0; 12];
    head[..4].copy_from_slice(&tag);
    head[4..].copy_from_slice(&(content.len() as u64).to_le_bytes());
    head
}

/// Tags and contents of the sections of a user's maps, where there are any.
pub(super) fn encode_maps(state: &PlanetState) -> impl Iterator<Item = (SectionTag, Vec<u8>)> + '_ {
    let some = state.climate.iter().next().is_some();
    let climate = some.then(|| (CLIMATE, climate::write(&state.climate)));
    let terrain = state.terrain.as_ref();
    let terrain = terrain.map(|terrain| (TERRAIN, maps::write(terrain.iter())));
    climate.into_iter().chain(terrain)
}

/// Makes a planet of all sections. The mesh, which takes longest, comes last.
pub(super) fn decode(bytes: &[u8]) -> Result<PlanetState, SaveError> {
    let file = FileSections::split(bytes, tags())?;
    let (planet, clock, numbers) = planet::read(file.require(*b"PLAN")?)?;
    let (plates, stats) = plates::read_plates(file.require(*b"PLAT")?, numbers.next)?;
    let frames = plates::read_frames(file.require(*b"FRMS")?, numbers.next)?;
    // Only the count is read of the mesh; it is made when all else is good.
    let mesh = file.require(*b"MESH")?;
    let samples = crust::sample_count(mesh)?;
    let crust = read_columns(&file, samples)?;
    crust::check_frames(&crust, &frames, &plates)?;
    let fronts = fronts::read_fronts(file.require(*b"FRON")?, samples)?;
    let params = params::read(file.require(*b"PARM")?)?;
    let ledger = account::read_ledger(file.require(*b"LEDG")?)?;
    let recording = account::read_recording(file.require(*b"RECO")?)?;
    let pending = account::read_pending(file.require(*b"PEND")?)?;
    let polarity = fronts::read_polarity(file.require(*b"POLA")?)?;
    let climate = file.get(CLIMATE).map(climate::read).transpose()?;
    let terrain = file.get(TERRAIN).map(terrain::read).transpose()?;
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
        climate: climate.unwrap_or_default(),
        terrain,
    })
}

/// The crust of so many samples, each column from the section of its tag; those that a file may leave
/// out have their defaults.
fn read_columns(file: &FileSections, samples: u32) -> Result<Crust, SaveError> {
    let mut columns = Vec::with_capacity(Crust::COLUMNS.len());
    for column in Crust::COLUMNS {
        // Here, so that the message names the section.
        if column.is_required {
            file.require(*column.tag)?;
        }
        columns.push(file.get(*column.tag));
    }
    Ok(Crust::decode_columns(&columns, samples as usize)?)
}
