//! Saved planets are read again, and go on as if they had never stopped.

use super::*;
use crate::authoring::Inbox;
use crate::io::{capture, digest};
use crate::planet::PlanetRecipe;
use crate::schedule::run_steps;
use bevy::prelude::*;

#[test]
fn a_planet_comes_back_with_the_same_bits() {
    let state = state();
    let saved = bytes(&state);
    let back = read_from(&saved).unwrap();
    assert_eq!(bytes(&back), saved);
    assert_eq!(back.planet, state.planet);
    assert_eq!(back.crust, state.crust);
    assert_eq!(back.frames, state.frames);
    assert_eq!(back.plates, state.plates);
    assert_eq!(back.stats, state.stats);
    assert_eq!(back.clock, state.clock);
    assert_eq!(back.params, state.params);
    assert_eq!(back.ledger, state.ledger);
    assert_eq!(back.recording, state.recording);
    assert_eq!(back.climate, state.climate);
    assert_eq!(back.terrain, state.terrain);
    assert_eq!(back.polarity, state.polarity);
    assert_eq!(back.lattice.points(), state.lattice.points());
}

#[test]
fn distances_to_fronts_are_found_again() {
    let fronts = state().fronts;
    let back = read_from(&bytes(&state())).unwrap().fronts;
    assert_eq!((back.stale, back.reach), (fronts.stale, fronts.reach));
    assert_eq!(back.front, fronts.front);
    assert_eq!(fronts.nearest(70).map(|(source, _)| source), Some(3));
    assert!((0..150).all(|i| back.nearest(i) == fronts.nearest(i)));
}

#[test]
fn a_mesh_of_other_points_comes_back() {
    let mut state = state();
    let turn = math::rotation(DVec3::X, 0.1);
    let points = state
        .lattice
        .points()
        .iter()
        .map(|&p| (turn * p).normalize())
        .collect();
    state.lattice = Lattice(Arc::new(SphereMesh::from_points(points).unwrap()));
    let back = read_from(&bytes(&state)).unwrap();
    assert_eq!(back.lattice.points(), state.lattice.points());
}

#[test]
fn the_digest_sees_the_last_bit_of_the_state() {
    let mut state = state();
    let first = digest(&state);
    assert_eq!(first.len(), 64);
    state.crust.elevation[3] = f32::from_bits(state.crust.elevation[3].to_bits() + 1);
    assert_ne!(digest(&state), first);
}

/// Saved and loaded at any step, a planet goes on as if it had never stopped: with frames that have
/// moved, just before a resample, just after it, and after a rift.
#[test]
fn a_loaded_planet_continues_to_the_same_digest() {
    let mut app = App::new();
    app.add_plugins(crate::PangaeaPlugins);
    let world = app.world_mut();
    let recipe = PlanetRecipe {
        samples: 1500,
        plate_count: 15,
        ..PlanetRecipe::default()
    };
    let planet = PlanetState::new(&recipe).unwrap().spawn(world);
    let mut saves = Vec::new();
    for step in 0..40 {
        if step == 15 {
            ask_for_rift(world, planet);
        }
        run_steps(world, planet, 1);
        if [1, 9, 10, 16, 21, 33].contains(&step) {
            saves.push((39 - step, captured(world, planet)));
        }
    }
    let uninterrupted = captured(world, planet);
    for (left, saved) in saves {
        let again = read_from(&saved).unwrap().spawn(world);
        assert!(
            captured(world, again) == saved,
            "{left} steps before the end"
        );
        run_steps(world, again, left);
        let continued = captured(world, again);
        assert!(continued == uninterrupted, "{left} steps before the end");
    }
}

fn ask_for_rift(world: &mut World, planet: Entity) {
    let rift = TectonicCommand::RiftPlate {
        plate: PlateId(0),
        line: vec![],
        fragments: 3,
    };
    world.get_mut::<Inbox>(planet).unwrap().0.push(rift);
}

/// The save of a planet in a world.
fn captured(world: &World, planet: Entity) -> Vec<u8> {
    bytes(&capture(world, planet).unwrap())
}

#[test]
fn files_are_replaced_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.pangaea");
    fs::write(&path, "old").unwrap();
    save(&state(), &path).unwrap();
    assert_eq!(digest(&load(&path).unwrap()), digest(&state()));
    let entries = fs::read_dir(&folder).unwrap();
    assert_eq!(entries.count(), 1, "no temporary file is left");
}

#[test]
fn a_failed_write_leaves_the_older_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.pangaea");
    save(&state(), &path).unwrap();
    let failed = write_atomically(&path, |out| {
        out.write_all(b"half")?;
        Err(io::ErrorKind::StorageFull.into())
    });
    assert!(failed.unwrap_err().to_string().contains("a.pangaea"));
    assert!(load(&path).is_ok());
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
}

#[test]
fn places_without_a_file_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let missing = load(&folder.path().join("none"));
    assert!(matches!(missing, Err(IoError::Read { .. })));
    for place in [folder.path().into(), folder.path().join("no/such/x")] {
        let refused = save(&state(), &place);
        assert!(matches!(refused, Err(IoError::Write { .. })));
    }
}
