//! Files of older and newer programs: what is missing has its default, what is unknown is passed
//! over or refused by name.

use super::*;
use crate::io::codec::Encoder;
use crate::io::digest;
use crate::params::{OceanFloor, ProcessSwitches};

/// The tags and contents of a file, as the format is documented.
pub(super) fn parts(file: &[u8]) -> Vec<(SectionTag, Vec<u8>)> {
    let mut rest = &file[HEADER_BYTES..file.len() - HASH_BYTES];
    let mut parts = Vec::new();
    while let Some((head, more)) = rest.split_at_checked(12) {
        let length = u64::from_le_bytes(head[4..].try_into().unwrap()) as usize;
        parts.push((head[..4].try_into().unwrap(), more[..length].to_vec()));
        rest = &more[length..];
    }
    parts
}

/// Whether the file of a planet has a section.
pub(super) fn has_section(state: &PlanetState, tag: SectionTag) -> bool {
    let parts = parts(&bytes(state));
    parts.into_iter().any(|(other, _)| other == tag)
}

/// A file of that version with these sections and the right hash.
pub(super) fn file(version: u32, parts: &[(SectionTag, Vec<u8>)]) -> Vec<u8> {
    let mut file = [&MAGIC[..], &version.to_le_bytes()].concat();
    for (tag, content) in parts {
        file.extend(tag);
        file.extend((content.len() as u64).to_le_bytes());
        file.extend(content);
    }
    let hash = blake3::hash(&file);
    file.extend(hash.as_bytes());
    file
}

/// The sections of a file with another content in one of them.
pub(super) fn replaced(
    file: &[u8],
    tag: SectionTag,
    content: Vec<u8>,
) -> Vec<(SectionTag, Vec<u8>)> {
    let mut parts = parts(file);
    let part = parts.iter_mut().find(|part| part.0 == tag);
    part.unwrap().1 = content;
    parts
}

/// The parameters and switches of a planet, by name.
#[derive(Clone)]
struct NamedParams {
    numbers: Vec<(&'static str, f64)>,
    switches: Vec<(&'static str, bool)>,
}

impl NamedParams {
    /// Those of the planet of these tests.
    fn new() -> Self {
        let TectonicParams { processes, .. } = TectonicParams::default();
        let params = params();
        let mut switches = params.processes;
        assert_ne!(switches, processes);
        Self {
            numbers: TectonicParams::TABLE
                .iter()
                .map(|info| (info.name, (info.get)(&params)))
                .collect(),
            switches: ProcessSwitches::NAMES
                .map(|name| (name, *switches.get_mut(name).unwrap()))
                .to_vec(),
        }
    }

    /// A file with these parameters.
    fn file(&self) -> Vec<u8> {
        let mut out = Encoder::default();
        out.u32(self.numbers.len() as u32);
        for &(name, value) in &self.numbers {
            out.text(name);
            out.f64(value);
        }
        out.u32(self.switches.len() as u32);
        for &(name, on) in &self.switches {
            out.text(name);
            out.u8(u8::from(on));
        }
        out.u8(OceanFloor::Relaxing as u8);
        file(VERSION, &replaced(&bytes(&state()), *b"PARM", out.0))
    }

    fn set(&mut self, name: &str, value: f64) {
        let number = self.numbers.iter_mut().find(|number| number.0 == name);
        number.unwrap().1 = value;
    }
}

#[test]
fn a_parameter_that_the_file_lacks_has_its_default() {
    let mut named = NamedParams::new();
    named.set("uplift", 0.9);
    named.numbers.retain(|&(name, _)| name != "erosion");
    named.switches.retain(|&(name, _)| name != "noise");
    let loaded = read_from(&named.file()).unwrap().params;
    let expected = TectonicParams {
        uplift: 0.9,
        ..TectonicParams::default()
    };
    assert_eq!(loaded, expected);
}

#[test]
fn parameters_may_come_in_any_order() {
    let mut named = NamedParams::new();
    named.numbers.reverse();
    named.switches.reverse();
    assert_eq!(read_from(&named.file()).unwrap().params, params());
}

#[test]
fn a_parameter_that_is_unknown_is_named() {
    let mut numbers = NamedParams::new();
    numbers.numbers.push(("volcanism", 0.5));
    let mut switches = NamedParams::new();
    switches.switches.insert(0, ("volcanism", true));
    for named in [numbers, switches] {
        let error = refusal(&named.file());
        assert_eq!(error, SaveError::unknown("parameter", "volcanism"));
        let line = error.to_string();
        assert!(
            line.contains("`volcanism`") && line.contains("newer"),
            "{line}"
        );
    }
}

#[test]
fn parameters_out_of_their_limits_and_out_of_order_are_refused() {
    let mut high = NamedParams::new();
    high.set("uplift", 5.5);
    let mut deep = NamedParams::new();
    deep.set("abyss_elevation", -9.0);
    deep.set("trench_elevation", -6.0);
    let mut twice = NamedParams::new();
    twice.numbers.push(("erosion", 0.07));
    for (named, name) in [(high, "uplift"), (deep, "trench"), (twice, "erosion")] {
        let error = refusal(&named.file());
        assert!(matches!(error, SaveError::Invalid(_)), "{error:?}");
        assert!(error.to_string().contains(name), "{error}");
    }
}

#[test]
fn files_of_version_3_are_read() {
    let mut state = state();
    state.climate = ClimateMaps::default();
    state.terrain = None;
    let old = file(3, &parts(&bytes(&state)));
    let back = read_from(&old).unwrap();
    assert_eq!(bytes(&back), bytes(&state));
    // Version 3 had no digests but the hashes of its files.
    let hash = &old[old.len() - HASH_BYTES..];
    let hexadecimal: String = hash.iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(digest(&state), hexadecimal);
}

#[test]
fn the_version_of_a_file_is_told_from_its_beginning() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.pangaea");
    fs::write(&path, file(3, &[])).unwrap();
    assert_eq!(version_of(&path).unwrap(), 3);
    fs::write(&path, "PANGAE").unwrap();
    assert!(version_of(&path).is_err());
}

/// A file with one section more.
fn with_section(tag: &SectionTag) -> Vec<u8> {
    let mut parts = parts(&bytes(&state()));
    parts.insert(3, (*tag, b"of a newer program".to_vec()));
    file(VERSION, &parts)
}

#[test]
fn unknown_sections_are_passed_over_or_named() {
    let back = read_from(&with_section(b"note")).unwrap();
    assert_eq!(bytes(&back), bytes(&state()));
    let error = refusal(&with_section(b"NOTE"));
    assert_eq!(error, SaveError::unknown("section", "NOTE"));
}

/// Maps that few planets have, and directions that are zero where they are not known.
const MAY_BE_MISSING: [SectionTag; 4] = [*b"CLIM", *b"TERR", *b"RIDG", *b"FOLD"];

/// As a file is from before its program knew the column.
#[test]
fn a_file_without_a_column_has_its_default_and_all_else() {
    let mut state = state();
    assert_ne!(state.crust.fold, [Vec3::ZERO; 150]);
    let mut parts = parts(&bytes(&state));
    parts.retain(|(tag, _)| tag != b"FOLD");
    let back = read_from(&file(VERSION, &parts)).unwrap();
    state.crust.fold.fill(Vec3::ZERO);
    assert_eq!(bytes(&back), bytes(&state));
}

#[test]
fn sections_may_come_in_any_order_but_must_be_there_once() {
    let mut parts = parts(&bytes(&state()));
    parts.reverse();
    let back = read_from(&file(VERSION, &parts)).unwrap();
    assert_eq!(bytes(&back), bytes(&state()));
    for k in 0..parts.len() {
        let (tag, content) = parts[k].clone();
        let name = tag.escape_ascii().to_string();
        let mut twice = parts.clone();
        twice.push((tag, content));
        let error = refusal(&file(VERSION, &twice)).to_string();
        assert!(error.contains(&name), "{error}");
        let mut without = parts.clone();
        without.remove(k);
        let read = read_from(&file(VERSION, &without));
        let missing = read
            .err()
            .is_some_and(|error| error.to_string().contains(&name));
        assert_eq!(missing, !MAY_BE_MISSING.contains(&tag), "{name}");
    }
}

/// A ledger of the planet of these tests with so many causes more, or fewer.
fn with_causes(more: i32) -> Vec<u8> {
    const AMOUNT_BYTES: usize = 16;
    let state = state();
    let count = Cause::ALL.len();
    let parts = parts(&bytes(&state));
    let mut ledger = parts
        .iter()
        .find(|part| part.0 == *b"LEDG")
        .unwrap()
        .1
        .clone();
    let changed = (count as i32 + more) as usize;
    ledger[..4].copy_from_slice(&(changed as u32).to_le_bytes());
    // The amount at the beginning comes first.
    let end = 4 + AMOUNT_BYTES * (1 + count);
    let common = 4 + AMOUNT_BYTES * (1 + count.min(changed));
    let added = vec![0; AMOUNT_BYTES * changed.saturating_sub(count)];
    let ledger = [&ledger[..common], &added, &ledger[end..]].concat();
    file(VERSION, &replaced(&bytes(&state), *b"LEDG", ledger))
}

#[test]
fn older_ledgers_are_read_and_newer_ones_refused() {
    let back = read_from(&with_causes(-2)).unwrap();
    assert_eq!(back.ledger, state().ledger);
    let error = refusal(&with_causes(1));
    assert!(matches!(error, SaveError::Unknown { .. }), "{error:?}");
}
