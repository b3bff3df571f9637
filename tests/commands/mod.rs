//! Commands: each does what it says, is recorded, and is refused as a whole or not at all.

mod paint;
mod plates;
mod refusals;
mod settings;

use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use pangaea_tests::measure::continents;
use pangaea_tests::shape::small;
use pangaea_tests::world::{get, heard, listen, obey, planet_app, steps};

/// Steps that the planet of these tests has taken.
const AGE: u64 = 3;

fn planet() -> (App, Entity) {
    let (mut app, planet) = planet_app(&small(21, 4000));
    listen::<CommandApplied>(&mut app);
    listen::<CommandRejected>(&mut app);
    steps(&mut app, planet, AGE);
    (app, planet)
}

/// Carries out a command that must be accepted, and checks that it is recorded with its time and
/// that the planet lives on.
fn accept(app: &mut App, planet: Entity, wanted: TectonicCommand) {
    let recorded = get::<Recording>(app, planet).0.len();
    let applied = heard::<CommandApplied>(app).len();
    let accepted = obey(app, planet, wanted.clone());
    assert!(
        accepted,
        "{wanted:?}: {:?}",
        heard::<CommandRejected>(app).last()
    );
    let recording = &get::<Recording>(app, planet).0;
    let timed = TimedCommand {
        step: AGE,
        command: wanted.clone(),
    };
    assert_eq!(recording[recorded..], [timed]);
    let events = heard::<CommandApplied>(app);
    assert_eq!(events.len(), applied + 1);
    assert_eq!(events[applied].command, wanted);
    assert_ledger_closed(app, planet);
    steps(app, planet, 2);
}

/// Asserts that continents are as large as the ledger expects.
fn assert_ledger_closed(app: &App, planet: Entity) {
    let (area, volume) = continents(get(app, planet), get::<Lattice>(app, planet), 6370.0);
    let expected = get::<Ledger>(app, planet).expected();
    assert!(
        (area - expected.area).abs() < 1.0,
        "{area} km² for {expected:?}"
    );
    let tolerance = 1e-6 * expected.volume.max(1e6);
    assert!(
        (volume - expected.volume).abs() < tolerance,
        "{volume} km³ for {expected:?}"
    );
}
