//! A plate that goes under as a whole is gone, and says so.

use bevy_pangaea::prelude::*;
use pangaea_tests::shape::{Floor, given, shaped};
use pangaea_tests::world::{heard, listen, plates, spawn, steps, surface};

#[test]
fn a_small_ocean_plate_goes_under_a_continent_and_is_gone() {
    // Plate 0, from pole to pole, lies between the continental plate 1 in the east and plate 2 in
    // the west, which follows it.
    let pole = (90.0, 0.0);
    let recipe = given(
        8000,
        &[
            ((0.0, 0.0), pole, 100.0),
            ((0.0, 20.0), pole, 0.0),
            ((0.0, -20.0), pole, 100.0),
        ],
    );
    let land = |plate, lon| plate == 1 && lon < 60.0;
    let state = shaped(&recipe, |plate, _, lon| {
        if land(plate, lon) {
            Floor::Land(0.5)
        } else {
            Floor::Ocean(80.0)
        }
    });
    let (mut app, planet) = spawn(state);
    listen::<PlateConsumed>(&mut app);
    // 20 degrees of the equator are 2,200 km: 22 My, and a resample sees that nothing is left.
    let mut gone_at = None;
    for step in 1..=40 {
        steps(&mut app, planet, 1);
        if gone_at.is_none() && !heard::<PlateConsumed>(&app).is_empty() {
            gone_at = Some(step);
        }
    }
    let heard: Vec<PlateId> = heard::<PlateConsumed>(&app)
        .iter()
        .map(|event| event.plate)
        .collect();
    assert_eq!(heard, [PlateId(0)]);
    assert!(
        gone_at.is_some_and(|step| step >= 10),
        "after {gone_at:?} steps: before it can be"
    );
    assert!(plates(&app, planet).get(PlateId(0)).is_none());
    assert_eq!(plates(&app, planet).rows().len(), 2);
    let surface = surface(&mut app, planet);
    assert!(
        surface.plate.iter().all(|plate| *plate != PlateId(0)),
        "what stood on it has other owners"
    );
}
