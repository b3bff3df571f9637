//! Saves.

use super::{Trial, saved, tiny};
use bevy_pangaea::climate::EquirectMap;
use bevy_pangaea::io::save::read_from;
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::fuzz::{Format, fuzz};
use pangaea_tests::world::{command, spawn, state, steps};

/// Bytes of the hash at the end.
const HASH: usize = 32;

/// Tags of the sections, and names in them.
const WORDS: &[&str] = &[
    "PANGAEA\x1a",
    "PLAN",
    "PARM",
    "PLAT",
    "FRMS",
    "LEDG",
    "RECO",
    "PEND",
    "POLA",
    "FRON",
    "MESH",
    "FRAM",
    "KIND",
    "THIC",
    "ELEV",
    "OAGE",
    "RIDG",
    "FAGE",
    "OROG",
    "FOLD",
    "CLIM",
    "note",
    "erosion",
    "drift",
    "rain",
    "temperature",
];

/// A planet on which something has happened, with a command recorded, one to come, and maps of its
/// climate.
fn grown() -> PlanetState {
    let (mut app, planet) = spawn(tiny(2));
    let erosion = TectonicCommand::SetParam {
        name: "erosion".into(),
        value: 0.1,
    };
    command(&mut app, planet, erosion);
    steps(&mut app, planet, 12);
    command(&mut app, planet, TectonicCommand::Resample);
    let maps = ClimateMaps {
        rain: EquirectMap::from_fn(16, |lat, lon| (900.0 + lat + lon) as f32).ok(),
        wetness: EquirectMap::from_fn(32, |_, _| 0.5).ok(),
        ..ClimateMaps::default()
    };
    app.world_mut().entity_mut(planet).insert(maps);
    state(&app, planet)
}

#[test]
fn damaged_saves_are_refused() {
    let format = Format {
        name: "saves",
        good: vec![saved(&tiny(1)), saved(&grown())],
        words: WORDS,
    };
    fuzz(&format, |bytes| {
        if let Ok(state) = read_from(bytes) {
            assert!(saved(&state) == bytes, "only whole saves are accepted");
        }
    });
}

#[test]
fn saves_of_other_content_are_refused_or_live_on() {
    let mut trial = Trial::new();
    let format = Format {
        name: "contents of saves",
        good: [tiny(1), grown()]
            .iter()
            .map(|state| {
                let mut bytes = saved(state);
                bytes.truncate(bytes.len() - HASH);
                bytes
            })
            .collect(),
        words: WORDS,
    };
    fuzz(&format, |content| {
        // A liar would write the right hash.
        let hash = blake3::hash(content);
        let bytes = [content, hash.as_bytes()].concat();
        if let Ok(state) = read_from(&bytes) {
            trial.lives_on(state);
        }
    });
}
