//! A plate that goes under as a whole is gone, and says so.

use bevy::prelude::*;
use bevy_pangaea::prelude::*;
use bevy_pangaea::spawn::PlanetState;
use pangaea_tests::shape::{Floor, given, shaped};
use pangaea_tests::world::{heard, listen, plates, spawn, steps, surface};

/// Plate 0, from pole to pole, lies between the continental plate 1 in the east and plate 2 in the
/// west, which follows it.
fn narrowing_ocean() -> PlanetState {
    let pole = (90.0, 0.0);
    let recipe = given(
        8000,
        &[
            ((0.0, 0.0), pole, 100.0),
            ((0.0, 20.0), pole, 0.0),
            ((0.0, -20.0), pole, 100.0),
        ],
    );
    shaped(&recipe, |plate, _, lon| {
        if plate == 1 && lon < 60.0 {
            Floor::Land(0.5)
        } else {
            Floor::Ocean(80.0)
        }
    })
}

/// The plates that were consumed so far.
fn consumed(app: &App) -> Vec<PlateId> {
    let events = heard::<PlateConsumed>(app);
    events.iter().map(|event| event.plate).collect()
}

#[test]
fn a_small_ocean_plate_goes_under_a_continent_and_is_gone() {
    let (mut app, planet) = spawn(narrowing_ocean());
    listen::<PlateConsumed>(&mut app);
    // 20 degrees of the equator are 2,200 km: 22 My, and a resample sees that nothing is left.
    steps(&mut app, planet, 9);
    assert!(consumed(&app).is_empty(), "before it can be");
    steps(&mut app, planet, 31);
    assert_eq!(consumed(&app), [PlateId(0)]);
    assert!(plates(&app, planet).get(PlateId(0)).is_none());
    assert_eq!(plates(&app, planet).rows().len(), 2);
    let surface = surface(&mut app, planet);
    let is_gone = surface.plate.iter().all(|plate| *plate != PlateId(0));
    assert!(is_gone, "its crust has other owners");
}
