//! Conservation: every change of continental area and volume has a booked cause, in each stage of
//! each step.
//!
//! Area and volume are measured from the columns alone. Area is exact: a resample may carry less
//! than half a sample to the next one, and says so. Volume agrees to 1e-6 of the whole.

use bevy_pangaea::crust::Cause;
use bevy_pangaea::prelude::*;
use pangaea_tests::probe::{Change, probe};
use pangaea_tests::shape::small;
use pangaea_tests::world::{get, heard, listen, planet_app, steps};

const SAMPLES: u32 = 8000;

/// Checks one stage against the account.
fn check(change: &Change, largest_sample: f64) {
    let (booked, measured) = change.account();
    let (area, volume) = change.before.continents;
    let name = format!("{} of step {}", change.stage.name(), change.step);
    // What a resample cannot place is carried, so that nothing is lost in the long run.
    let carried = change.after.ledger.carried_area - change.before.ledger.carried_area;
    let error = (measured.area + carried - booked.area).abs() / area;
    assert!(
        error < 1e-9,
        "{name}: area changed by {measured:?}, booked {booked:?}, carried {carried}"
    );
    assert!(
        change.after.ledger.carried_area.abs() <= 0.5 * largest_sample,
        "{name} carries too much"
    );
    if change.stage != Stage::Resample {
        assert_eq!(
            carried, 0.0,
            "{name} carries area, which only a resample may"
        );
    }
    let error = (measured.volume - booked.volume).abs() / volume;
    assert!(
        error < 1e-6,
        "{name}: volume changed by {measured:?}, booked {booked:?}: {error:e} of {volume:e}"
    );
}

/// 120 My with all processes, collisions and rifts; returns the final ledger.
fn history(seed: u64) -> Ledger {
    let mut recipe = small(seed, SAMPLES);
    recipe.params.rift_rate = 0.03;
    let (mut app, planet) = planet_app(&recipe);
    listen::<TerraneCollided>(&mut app);
    listen::<PlateRifted>(&mut app);
    listen::<CrustResampled>(&mut app);
    let areas = get::<Lattice>(&app, planet).areas().iter();
    let largest = areas.copied().fold(0.0, f64::max) * recipe.radius * recipe.radius;
    probe(&mut app, move |change| check(change, largest));
    steps(&mut app, planet, 60);
    assert!(!heard::<TerraneCollided>(&app).is_empty(), "no collision");
    assert!(!heard::<PlateRifted>(&app).is_empty(), "no rift");
    assert!(
        heard::<CrustResampled>(&app).len() >= 2,
        "too few resamples"
    );
    get::<Ledger>(&app, planet).clone()
}

#[test]
fn every_change_has_a_cause_in_every_stage() {
    for seed in [1, 2, 3] {
        let ledger = history(seed);
        // A sample of 8,000 is 3e-4 of the continents; half of one may be carried.
        assert!(ledger.unexplained_max < 4e-4, "{ledger:?}");
        assert!(ledger.unexplained_volume_max < 1e-6, "{ledger:?}");
        assert_signs(&ledger);
    }
}

/// Causes that change volumes alone.
const OF_VOLUME: [Cause; 5] = [
    Cause::Erosion,
    Cause::SubductionUplift,
    Cause::CollisionUplift,
    Cause::Noise,
    Cause::Delamination,
];

/// Asserts that each cause has changed only what it can, in the right direction.
fn assert_signs(ledger: &Ledger) {
    assert!(ledger.of(Cause::Erosion).volume < 0.0);
    assert!(ledger.of(Cause::SubductionUplift).volume > 0.0);
    assert!(ledger.of(Cause::CollisionUplift).volume > 0.0);
    for cause in OF_VOLUME {
        assert_eq!(
            ledger.of(cause).area,
            0.0,
            "{} changes no area",
            cause.name()
        );
    }
    for cause in [Cause::Stacking, Cause::ForcedSubduction] {
        let amount = ledger.of(cause);
        let keeps_volume = amount.area <= 0.0 && amount.volume == 0.0;
        assert!(
            keeps_volume,
            "{}: buried crust keeps its volume",
            cause.name()
        );
    }
}
