//! Bytes and states that make no planet are refused.

use super::*;
use crate::random::{Purpose, Stream};
use crate::schedule::run_steps;
use bevy::prelude::App;
use rayon::prelude::*;

/// Makes the checksum right again, so that what comes after it is tested.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let content = bytes.len().saturating_sub(HASH_BYTES);
    let hash = blake3::hash(&bytes[..content]);
    bytes.truncate(content);
    bytes.extend(hash.as_bytes());
    bytes
}

#[test]
fn older_and_newer_versions_are_named() {
    let mut saved = bytes(&state());
    saved[8] = VERSION as u8 + 1;
    let newer = SaveError::Version {
        found: VERSION + 1,
        oldest: OLDEST_VERSION,
        newest: VERSION,
    };
    assert_eq!(refusal(&saved), newer);
    assert!(newer.to_string().contains("newer"), "{newer}");
    saved[8] = OLDEST_VERSION as u8 - 1;
    let older = refusal(&saved).to_string();
    assert!(older.contains("no longer"), "{older}");
}

#[test]
fn every_truncation_is_seen() {
    let saved = bytes(&state());
    for end in 0..saved.len() {
        assert!(read_from(&saved[..end]).is_err(), "{end}");
    }
    let mut longer = saved;
    longer.push(0);
    assert_eq!(refusal(&longer), SaveError::Checksum);
}

#[test]
fn every_flipped_bit_is_seen() {
    let saved = bytes(&state());
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
        let at = HEADER_BYTES + random(100 * k + 10 * m + 1, forged.len() - HEADER_BYTES);
        match random(100 * k + 10 * m + 2, 4) {
            0 => forged[at] ^= 1 << random(100 * k + 10 * m + 3, 8),
            1 => forged[at] = [0, 1, 127, 128, 255][random(100 * k + 10 * m + 3, 5)],
            2 => drop(forged.remove(at)),
            _ => forged.truncate(at.max(HEADER_BYTES + HASH_BYTES)),
        }
    }
    forged
}

/// A change that makes a state no planet, and its name.
type Fault = (&'static str, fn(&mut PlanetState));

fn assert_refused(faults: &[Fault]) {
    for (name, spoil) in faults {
        let mut state = state();
        spoil(&mut state);
        let error = refusal(&bytes(&state));
        let invalid = matches!(error, SaveError::Invalid(_));
        assert!(invalid, "{name}: {error:?}");
        assert!(!error.to_string().contains('\n'));
    }
}

#[test]
fn crust_that_cannot_be_is_refused() {
    assert_refused(&[
        ("number", |s| s.crust.elevation[0] = f32::NAN),
        ("number", |s| s.crust.fold[0].x = f32::INFINITY),
        ("length", |s| s.crust.kind.truncate(149)),
        ("frame", |s| s.crust.frame[0] = 3),
        ("plate of crust", |s| s.plates.truncate(1)),
    ]);
}

#[test]
fn plates_that_cannot_be_are_refused() {
    assert_refused(&[
        ("order", |s| s.plates.swap(0, 1)),
        ("number", |s| s.plates[1].0 = PlateId(0)),
        ("axis", |s| s.plates[0].1.axis = DVec3::ZERO),
        ("speed", |s| s.plates[1].1.speed = -1.0),
        ("frame's plate", |s| s.frames.0[0].plate = PlateId(9)),
        ("no plates", |s| s.plates.clear()),
    ]);
}

#[test]
fn fronts_clocks_and_parameters_that_cannot_be_are_refused() {
    assert_refused(&[
        ("nearest front", |s| s.fronts.nearest.set(70, 150, 0.1)),
        ("reach", |s| s.fronts.reach = f64::NAN),
        ("order of fronts", |s| s.fronts.front.swap(0, 1)),
        ("age of a front", |s| s.fronts.front[0].1 = 4),
        ("length of fronts", |s| s.fronts = FrontField::new(149)),
        ("parameter", |s| s.params.uplift = 1e9),
        ("depths", |s| {
            s.params.trench_elevation = -6.0;
            s.params.abyss_elevation = -9.0;
        }),
        ("clock", |s| s.clock.time = f64::NAN),
    ]);
}

#[test]
fn maps_of_impossible_climates_are_refused() {
    assert_refused(&[
        ("kelvin", |s| s.climate.temperature = uniform(288.0)),
        ("negative rain", |s| s.climate.rain = uniform(-1.0)),
        ("wetness", |s| s.climate.wetness = uniform(1.5)),
    ]);
}

#[test]
fn a_frame_without_samples_may_outlive_its_plate() {
    let mut state = state();
    state.crust.frame.fill(0);
    state.plates.pop();
    assert!(read_from(&bytes(&state)).is_ok());
}
