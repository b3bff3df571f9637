//! Maps that a planet is made of come back, and maps that no planet is made of are refused.

use super::format::{file, has_section, replaced};
use super::*;
use crate::io::codec::Encoder;
use crate::io::digest;

const TERRAIN: [u8; 4] = *b"TERR";

#[test]
fn a_planet_that_was_grown_has_no_section_for_terrain() {
    let mut state = state();
    assert!(has_section(&state, TERRAIN));
    let mapped = digest(&state);
    state.terrain = None;
    assert!(!has_section(&state, TERRAIN));
    assert_ne!(digest(&state), mapped);
    assert_eq!(read_from(&bytes(&state)).unwrap().terrain, None);
}

/// Why a file is refused whose planet is made of maps of 8 such values.
fn refusal_of(maps: &[(&str, f32)]) -> String {
    let mut out = Encoder::default();
    out.u32(maps.len() as u32);
    for &(name, value) in maps {
        let packed = crate::io::planes::pack(&[value; 8]);
        out.text(name);
        out.u32(4);
        out.u32(2);
        out.u64(packed.len() as u64);
        out.0.extend(packed);
    }
    let parts = replaced(&bytes(&state()), TERRAIN, out.0);
    refusal(&file(VERSION, &parts)).to_string()
}

#[test]
fn maps_that_no_planet_is_made_of_are_refused() {
    for (maps, words) in [
        (&[("age", 30.0)][..], "no map of the elevation"),
        (&[("elevation", 1.0), ("elevation", 1.0)], "two maps"),
        (&[("elevation", 1.0), ("swamps", 0.5)], "`swamps`"),
        (&[("elevation", 16.0)], "15 km"),
        (&[("elevation", 1.0), ("hills", 1.5)], "hills"),
        (&[("elevation", 1.0), ("age", -1.0)], "age"),
    ] {
        let problem = refusal_of(maps);
        assert!(problem.contains(words), "{problem}");
    }
}
