//! Tests of the save file on a small planet with every kind of state.

use super::*;
use crate::authoring::{
    Brush, Inbox, PaintTarget, Recording, Scenario, TectonicCommand, TimedCommand,
};
use crate::crust::{Cause, Crust, CrustKind, Frame, Frames, Ledger, Orogeny};
use crate::io::{capture, digest};
use crate::math;
use crate::params::TectonicParams;
use crate::planet::{GeologicClock, Lattice, Planet, PlanetRecipe};
use crate::plate::front::FrontField;
use crate::plate::polarity::{FrontSegment, PolarityMemory};
use crate::plate::{PlateId, PlateMotion, PlateStats};
use crate::random::{Purpose, Stream};
use crate::schedule::run_steps;
use crate::sphere::SphereMesh;
use bevy::math::DVec3;
use bevy::prelude::App;
use rayon::prelude::*;
use std::sync::Arc;

fn stats(continental: f64) -> PlateStats {
    PlateStats {
        samples: 75,
        area: 2.5e8,
        continental,
        ocean_age: 60.0,
        centroid: DVec3::Y,
    }
}

fn state() -> PlanetState {
    let mesh = Arc::new(SphereMesh::fibonacci(150).unwrap());
    let mut params = TectonicParams {
        erosion: 0.07,
        ..TectonicParams::default()
    };
    params.processes.noise = false;
    let mut crust = Crust::ocean(mesh.len(), &params);
    for i in 0..mesh.len() {
        let x = i as f32;
        crust.frame[i] = (i % 3) as u16;
        crust.kind[i] = if i % 4 == 0 {
            CrustKind::Continental
        } else {
            CrustKind::Oceanic
        };
        crust.orogeny[i] = [Orogeny::None, Orogeny::Andean, Orogeny::Himalayan][i % 3];
        (crust.thickness[i], crust.elevation[i]) = (7.0 + 0.1 * x, -6.0 + 0.013 * x);
        (crust.ocean_age[i], crust.orogeny_age[i]) = (x, 2.0 * x);
        crust.ridge[i] = mesh.point(i as u32).as_vec3();
        crust.fold[i] = -crust.ridge[i];
    }
    let mut ledger = Ledger::default();
    ledger.book(Cause::ArcGrowth, 1.25e5, 3.5e6);
    let moved = Frame {
        rotation: math::rotation(DVec3::Y, 0.3),
        ..Frame::at_rest(PlateId(1))
    };
    let motion = PlateMotion {
        axis: DVec3::X,
        speed: 0.01,
    };
    let paint = TectonicCommand::PaintCrust {
        target: PaintTarget::Disc {
            center: (10.5, -20.25),
            radius: 900.0,
        },
        brush: Brush::Raise(0.1),
    };
    let fronts = FrontField {
        reach: 0.25,
        front: vec![(3, 0), (7, 2)],
        ..FrontField::new(150)
    };
    fronts
        .nearest
        .set(70, 3, mesh.point(70).distance_squared(mesh.point(3)) as f32);
    PlanetState {
        planet: Planet {
            radius: 6370.0,
            seed: 42,
        },
        lattice: Lattice(mesh),
        crust,
        frames: Frames(vec![
            Frame::at_rest(PlateId(0)),
            moved,
            Frame {
                terrane: true,
                ..moved
            },
        ]),
        plates: vec![
            (PlateId(0), PlateMotion::REST, 0.0),
            (PlateId(1), motion, 12.0),
        ],
        stats: vec![stats(0.25), stats(0.5)],
        clock: GeologicClock {
            time: 20.0,
            step: 10,
            next_plate: 2,
            resample_requested: true,
            ..GeologicClock::default()
        },
        params,
        ledger,
        recording: Recording(vec![TimedCommand {
            step: 4,
            command: paint.clone(),
        }]),
        pending: Scenario(vec![TimedCommand {
            step: 40,
            command: paint,
        }]),
        polarity: PolarityMemory(vec![FrontSegment {
            pair: (PlateId(0), PlateId(1)),
            bin: 17,
            first_under: true,
            held: 7,
        }]),
        fronts,
    }
}

fn bytes(state: &PlanetState) -> Vec<u8> {
    let mut out = Vec::new();
    write_to(state, &mut out).unwrap();
    out
}

/// Makes the checksum right again, so that what comes after it is tested.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let content = bytes.len().saturating_sub(HASH);
    let hash = blake3::hash(&bytes[..content]);
    bytes.truncate(content);
    bytes.extend(hash.as_bytes());
    bytes
}

#[test]
fn a_planet_comes_back_with_the_same_bits() {
    let state = state();
    let saved = bytes(&state);
    let back = read_from(&saved).unwrap();
    assert_eq!(bytes(&back), saved);
    assert_eq!(back.crust, state.crust);
    assert_eq!(
        (back.planet, back.plates, back.frames),
        (state.planet, state.plates, state.frames)
    );
    assert_eq!(back.stats, state.stats);
    assert_eq!(
        (back.clock, back.params, back.ledger),
        (state.clock, state.params, state.ledger)
    );
    assert_eq!(
        (back.recording, back.polarity),
        (state.recording, state.polarity)
    );
    assert_eq!(
        (back.fronts.stale, back.fronts.reach),
        (state.fronts.stale, state.fronts.reach)
    );
    assert_eq!(back.fronts.front, state.fronts.front);
    assert!(
        state
            .fronts
            .nearest(70)
            .is_some_and(|(source, _)| source == 3)
    );
    assert!((0..150).all(|i| back.fronts.nearest(i) == state.fronts.nearest(i)));
    assert_eq!(back.lattice.points(), state.lattice.points());
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
fn the_digest_is_that_of_the_state_and_not_of_the_clock_on_the_wall() {
    let mut state = state();
    let first = digest(&state);
    assert_eq!(first.len(), 64);
    state.clock.paused = true;
    state.clock.speed = 99.0;
    assert_eq!(digest(&state), first);
    state.crust.elevation[3] = f32::from_bits(state.crust.elevation[3].to_bits() + 1);
    assert_ne!(digest(&state), first);
}

#[test]
fn older_and_newer_versions_are_named() {
    let mut saved = bytes(&state());
    saved[8] = VERSION as u8 + 1;
    let error = read_from(&saved).err().unwrap();
    assert_eq!(error, SaveError::Version { found: VERSION + 1 });
    assert!(error.to_string().contains("newer"), "{error}");
    saved[8] = VERSION as u8 - 1;
    assert!(
        read_from(&saved)
            .err()
            .unwrap()
            .to_string()
            .contains("no longer")
    );
}

#[test]
fn every_truncation_and_every_flipped_bit_is_seen() {
    let saved = bytes(&state());
    for end in 0..saved.len() {
        assert!(read_from(&saved[..end]).is_err(), "{end}");
    }
    let mut longer = saved.clone();
    longer.push(0);
    assert_eq!(read_from(&longer).err(), Some(SaveError::Checksum));
    let stream = Stream::new(1, Purpose::Coast, 0);
    for k in 0..100_000 {
        let mut damaged = saved.clone();
        let bit = stream.bits(k) as usize % (8 * saved.len());
        damaged[bit / 8] ^= 1 << (bit % 8);
        assert!(read_from(&damaged).is_err(), "bit {bit}");
    }
}

/// A forger who repairs the checksum gets an error or a planet that lives, but no panic and no huge
/// allocation.
#[test]
fn resealed_mutations_do_no_harm() {
    let saved = bytes(&state());
    let loaded = (0..100_000_u64).into_par_iter().filter_map(|k| {
        let planet = read_from(&sealed(forge(&saved, k))).ok()?;
        // One in a hundred is brought to life.
        Some((k % 101 == 0).then_some(planet))
    });
    let loaded: Vec<_> = loaded.collect();
    assert!((1000..80_000).contains(&loaded.len()), "{}", loaded.len());
    let mut app = App::new();
    app.add_plugins(crate::PangaeaPlugins);
    for state in loaded.into_iter().flatten() {
        assert!(state.crust.elevation.iter().all(|z| z.abs() <= 100.0));
        let planet = state.spawn(app.world_mut());
        run_steps(app.world_mut(), planet, 3);
        app.world_mut().despawn(planet);
    }
}

/// The bytes of a save with up to four changes, without its old hash.
fn forge(saved: &[u8], k: u64) -> Vec<u8> {
    let stream = Stream::new(2, Purpose::Coast, 0);
    let random = |k: u64, below: usize| stream.bits(k) as usize % below;
    let mut forged = saved.to_vec();
    for m in 0..1 + random(100 * k, 4) as u64 {
        let at = HEAD + random(100 * k + 10 * m + 1, forged.len() - HEAD);
        match random(100 * k + 10 * m + 2, 4) {
            0 => forged[at] ^= 1 << random(100 * k + 10 * m + 3, 8),
            1 => forged[at] = [0, 1, 127, 128, 255][random(100 * k + 10 * m + 3, 5)],
            2 => drop(forged.remove(at)),
            _ => forged.truncate(at.max(HEAD + HASH)),
        }
    }
    forged
}

#[test]
fn states_that_make_no_planet_are_refused() {
    let cases: [(&str, fn(&mut PlanetState)); 18] = [
        ("number", |s| s.crust.elevation[0] = f32::NAN),
        ("number", |s| s.crust.fold[0].x = f32::INFINITY),
        ("length", |s| s.crust.kind.truncate(149)),
        ("frame", |s| s.crust.frame[0] = 3),
        ("plate", |s| s.plates.swap(0, 1)),
        ("plate", |s| s.plates[1].0 = PlateId(0)),
        ("axis", |s| s.plates[0].1.axis = DVec3::ZERO),
        ("speed", |s| s.plates[1].1.speed = -1.0),
        ("frame's plate", |s| s.frames.0[0].plate = PlateId(9)),
        ("plate of crust", |s| s.plates.truncate(1)),
        ("front", |s| s.fronts.nearest.set(70, 150, 0.1)),
        ("front", |s| s.fronts.reach = f64::NAN),
        ("front", |s| s.fronts.front.swap(0, 1)),
        ("front", |s| s.fronts.front[0].1 = 4),
        ("front", |s| s.fronts = FrontField::new(149)),
        ("parameter", |s| s.params.uplift = 1e9),
        ("clock", |s| s.clock.time = f64::NAN),
        ("no plates", |s| s.plates.clear()),
    ];
    for (what, spoil) in cases {
        let mut state = state();
        spoil(&mut state);
        let error = read_from(&bytes(&state)).err();
        assert!(
            matches!(error, Some(SaveError::Invalid(_))),
            "{what}: {error:?}"
        );
        assert!(!error.unwrap().to_string().contains('\n'));
    }
}

#[test]
fn a_frame_without_samples_may_outlive_its_plate() {
    let mut state = state();
    state.crust.frame.fill(0);
    state.plates.pop();
    assert!(read_from(&bytes(&state)).is_ok());
}

/// Saved and loaded at any step, a planet goes on as if it had never stopped: with frames that have
/// moved, just before a resample, just after it, and after a rift.
#[test]
fn a_loaded_planet_continues_to_the_same_digest() {
    let recipe = PlanetRecipe {
        samples: 1500,
        plate_count: 15,
        ..PlanetRecipe::default()
    };
    let mut app = App::new();
    app.add_plugins(crate::PangaeaPlugins);
    let world = app.world_mut();
    let planet = PlanetState::new(&recipe).unwrap().spawn(world);
    let mut saves = Vec::new();
    for step in 0..40 {
        if step == 15 {
            let rift = TectonicCommand::RiftPlate {
                plate: PlateId(0),
                line: vec![],
                fragments: 3,
            };
            world.get_mut::<Inbox>(planet).unwrap().0.push(rift);
        }
        run_steps(world, planet, 1);
        if [1, 9, 10, 16, 21, 33].contains(&step) {
            saves.push((39 - step, bytes(&capture(world, planet).unwrap())));
        }
    }
    let uninterrupted = digest(&capture(world, planet).unwrap());
    for (left, saved) in saves {
        let again = read_from(&saved).unwrap().spawn(world);
        assert_eq!(
            bytes(&capture(world, again).unwrap()),
            saved,
            "{left} steps before the end"
        );
        run_steps(world, again, left);
        assert_eq!(
            digest(&capture(world, again).unwrap()),
            uninterrupted,
            "{left} steps before the end"
        );
    }
}

#[test]
fn files_are_replaced_whole() {
    let folder = std::env::temp_dir().join(format!("pangaea-save-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("a.pangaea");
    fs::write(&path, "old").unwrap();
    save(&state(), &path).unwrap();
    assert_eq!(digest(&load(&path).unwrap()), digest(&state()));
    assert_eq!(
        fs::read_dir(&folder).unwrap().count(),
        1,
        "no temporary file is left"
    );
    let failed = write_atomically(&path, |out| {
        out.write_all(b"half")?;
        Err(io::ErrorKind::StorageFull.into())
    });
    assert!(failed.unwrap_err().to_string().contains("a.pangaea"));
    assert!(load(&path).is_ok(), "the older file is untouched");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
    assert!(matches!(
        load(&folder.join("none")),
        Err(IoError::Read { .. })
    ));
    assert!(matches!(
        save(&state(), &folder),
        Err(IoError::Write { .. })
    ));
    assert!(matches!(
        save(&state(), &folder.join("no/such/x")),
        Err(IoError::Write { .. })
    ));
    fs::remove_dir_all(&folder).unwrap();
}
