//! Commands to plates: motion, rifts, crust.

use super::{accept, assert_ledger_closed, planet};
use bevy::prelude::*;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::math::{angle_between, direction, lat_lon};
use bevy_pangaea::plate::PlateRow;
use bevy_pangaea::prelude::*;
use pangaea_tests::order::{rift, set_crust, set_motion, set_param};
use pangaea_tests::world::{get, heard, listen, obey, plates, steps};
use std::sync::{Arc, Mutex};

#[test]
fn a_plate_takes_the_motion_it_is_given() {
    let pole = (35.0, -120.0);
    for (speed, sign) in [(75.0, 1.0), (-75.0, -1.0), (0.0, 1.0)] {
        let (mut app, planet) = planet();
        assert!(obey(&mut app, planet, set_motion(PlateId(4), pole, speed)));
        let motion = plates(&app, planet).get(PlateId(4)).unwrap().motion;
        assert!((motion.speed * 6370.0 - speed.abs()).abs() < 1e-9);
        assert!(angle_between(motion.axis, direction(pole.0, pole.1) * sign) < 1e-9);
        steps(&mut app, planet, 1);
    }
}

/// The largest plate, and the number of plates.
fn largest_plate(app: &App, planet: Entity) -> (PlateRow, usize) {
    let table = plates(app, planet);
    let by_area = |a: &&PlateRow, b: &&PlateRow| a.stats.area.total_cmp(&b.stats.area);
    let largest = *table.rows().iter().max_by(by_area).unwrap();
    (largest, table.rows().len())
}

#[test]
fn a_plate_rifts_at_random() {
    let (mut app, planet) = planet();
    let (largest, count) = largest_plate(&app, planet);
    let plates_after = count_after_rift(&mut app, planet, rift(largest.id, &[], 2));
    assert_eq!(plates_after, count + 1);
}

#[test]
fn a_plate_rifts_along_a_line() {
    let (mut app, planet) = planet();
    let (largest, count) = largest_plate(&app, planet);
    let (lat, lon) = lat_lon(largest.stats.centroid);
    let line = [
        ((lat - 5.0).max(-90.0), lon),
        ((lat + 5.0).min(90.0), lon + 1.0),
    ];
    let plates_after = count_after_rift(&mut app, planet, rift(largest.id, &line, 2));
    assert_eq!(plates_after, count + 1);
}

/// Carries out a rift and returns the number of plates at once; later steps may consume some.
fn count_after_rift(app: &mut App, planet: Entity, rift: TectonicCommand) -> usize {
    listen::<PlateRifted>(app);
    let counted = Arc::new(Mutex::new(0));
    let store = Arc::clone(&counted);
    app.add_observer(move |event: On<PlateRifted>, of: Query<&Plates>| {
        let plates = of
            .get(event.planet)
            .map_or(0, |plates| plates.iter().count());
        *store.lock().unwrap() = plates;
    });
    accept(app, planet, rift);
    assert_eq!(heard::<PlateRifted>(app).len(), 1);
    *counted.lock().unwrap()
}

#[test]
fn the_crust_of_a_plate_is_switched() {
    for (kind, share) in [(CrustKind::Continental, 1.0), (CrustKind::Oceanic, 0.0)] {
        let (mut app, planet) = planet();
        assert!(obey(&mut app, planet, set_crust(PlateId(2), kind)));
        let stats = plates(&app, planet).get(PlateId(2)).unwrap().stats;
        assert_eq!(stats.continental, share);
        assert_ledger_closed(&app, planet);
        assert_ne!(get::<Ledger>(&app, planet).of(Cause::Command).area, 0.0);
    }
    let (mut app, planet) = planet();
    accept(
        &mut app,
        planet,
        set_crust(PlateId(2), CrustKind::Continental),
    );
}

#[test]
fn plates_never_exceed_a_highest_speed_that_was_lowered() {
    let (mut app, planet) = planet();
    accept(&mut app, planet, set_param("max_speed", 5.0));
    let radius = get::<Planet>(&app, planet).radius;
    let table = plates(&app, planet);
    let is_slow = |row: &PlateRow| row.motion.speed * radius < 5.0 + 1e-9;
    assert!(table.rows().iter().all(is_slow));
}
