//! A planet that grows for very long: everything stays finite, the ledger closed, memory flat.
//!
//! `PANGAEA_SOAK=1` makes it 10,000 steps of 60,000 samples; memory means something only where no
//! other test runs beside it (`--test-threads=1`).

use bevy::prelude::*;
use bevy_pangaea::math::TAU;
use bevy_pangaea::prelude::*;
use pangaea_tests::shape::small;
use pangaea_tests::soak;
use pangaea_tests::world::{get, planet_app, state, steps};

/// Bytes by which a process may grow between the first tenth of the steps and the last: what an
/// allocator keeps, and not a thousandth of what 9,000 leaks of one column would take.
const GROWTH: u64 = 32 << 20;

#[test]
fn a_planet_grows_for_long_and_takes_no_more_memory() {
    let samples = soak::count(2_000, 60_000) as u32;
    let tenth = soak::count(40, 1_000);
    let (mut app, planet) = planet_app(&small(17, samples));
    let mut early = None;
    for part in 0..10 {
        steps(&mut app, planet, tenth);
        assert_sound(&app, planet);
        if part == 0 {
            early = soak::memory("VmRSS");
        }
    }
    assert_eq!(get::<GeologicClock>(&app, planet).step, 10 * tenth);
    if soak::is_on() {
        let [early, late] = [early, soak::memory("VmRSS")].map(Option::unwrap_or_default);
        assert!(
            late < early + GROWTH,
            "from {} to {} MiB",
            early >> 20,
            late >> 20
        );
    }
}

/// Asserts that all numbers of a planet are finite and that its ledger is closed.
fn assert_sound(app: &App, planet: Entity) {
    let state = state(app, planet);
    assert_finite(&state.crust);
    for frame in state.frames.iter() {
        assert!(frame.rotation.is_normalized());
    }
    for (id, motion, _) in &state.plates {
        assert!(
            motion.speed.is_finite() && motion.axis.is_normalized(),
            "{id:?}"
        );
    }
    let ledger = &state.ledger;
    assert!(ledger.unexplained_volume_max < 1e-5, "{ledger:?}");
    // Coasts are moved by whole samples: up to half a sample of area waits for the next resample.
    let half_sample = 0.5 * TAU * 2.0 / state.crust.len() as f64;
    let continents = ledger.expected().area / state.planet.radius.powi(2);
    let rounding = 1.2 * half_sample / continents;
    assert!(ledger.unexplained_max < rounding, "{ledger:?}");
}

fn assert_finite(crust: &Crust) {
    for column in [
        &crust.thickness,
        &crust.elevation,
        &crust.ocean_age,
        &crust.orogeny_age,
    ] {
        assert!(column.iter().all(|x| x.is_finite()));
    }
    for column in [&crust.fold, &crust.ridge] {
        assert!(column.iter().all(|v| v.is_finite()));
    }
}
