//! Convergence: polarity, uplift, slab pull.

use bevy::prelude::*;
use bevy_pangaea::crust::Cause;
use bevy_pangaea::math::{angle_between, lat_lon};
use bevy_pangaea::plate::PlateId;
use bevy_pangaea::plate::boundary::Rim;
use bevy_pangaea::plate::contact::{Contacts, Role};
use bevy_pangaea::plate::polarity::{Pair, PolarityMemory};
use bevy_pangaea::prelude::*;
use bevy_pangaea::sphere::SphereMesh;
use pangaea_tests::shape::{Floor, hemispheres, shaped, small};
use pangaea_tests::world::{get, planet_app, plates, spawn, steps, surface};
use std::collections::BTreeMap;

/// Two oceans of given ages that close at the meridian 0.
fn closing_oceans(west: f32, east: f32) -> (App, Entity) {
    let recipe = hemispheres(8000, 40.0, -40.0);
    spawn(shaped(&recipe, move |plate, _, _| {
        Floor::Ocean(if plate == 0 { west } else { east })
    }))
}

/// An Andean margin: the ocean of plate 0 moves towards the continent along the rim of plate 1.
fn andean_margin(samples: u32) -> (App, Entity) {
    let recipe = hemispheres(samples, 80.0, 0.0);
    spawn(shaped(&recipe, |plate, lat, lon| {
        if plate == 1 && lat.abs() < 45.0 && lon < 60.0 {
            Floor::Land(0.4)
        } else {
            Floor::Ocean(60.0)
        }
    }))
}

/// Number of samples of each plate that override and that go under.
fn roles(app: &App, planet: Entity) -> [[usize; 2]; 2] {
    let (rim, contacts) = (get::<Rim>(app, planet), get::<Contacts>(app, planet));
    let (crust, frames) = (get::<Crust>(app, planet), get::<Frames>(app, planet));
    let mut count = [[0; 2]; 2];
    for (&i, contact) in rim.samples.iter().zip(&contacts.0) {
        let plate = frames.plate(crust.frame[i as usize]).0 as usize;
        match contact.role {
            Role::Overriding => count[plate][0] += 1,
            Role::Subducting => count[plate][1] += 1,
            _ => {}
        }
    }
    count
}

#[test]
fn older_ocean_goes_under_younger() {
    for (west, east, under) in [(120.0, 40.0, 0), (40.0, 120.0, 1)] {
        let (mut app, planet) = closing_oceans(west, east);
        steps(&mut app, planet, 2);
        let count = roles(&app, planet);
        let over = 1 - under;
        assert!(count[over][0] > 20, "{count:?}");
        assert_eq!(
            (count[over][1], count[under][0]),
            (0, 0),
            "one polarity along the whole front: {count:?}"
        );
    }
}

#[test]
fn ocean_goes_under_a_continent_however_young() {
    let recipe = hemispheres(8000, 40.0, 0.0);
    let state = shaped(&recipe, |plate, _, lon| {
        if plate == 1 && lon < 90.0 {
            Floor::Land(0.4)
        } else {
            Floor::Ocean(if plate == 0 { 1.0 } else { 150.0 })
        }
    });
    let (mut app, planet) = spawn(state);
    steps(&mut app, planet, 2);
    let (rim, contacts) = (get::<Rim>(&app, planet), get::<Contacts>(&app, planet));
    let crust = get::<Crust>(&app, planet);
    let mut seen = 0;
    for (&i, contact) in rim.samples.iter().zip(&contacts.0) {
        let continental = crust.is_continental(i as usize);
        if continental != contact.other_continental
            && matches!(contact.role, Role::Overriding | Role::Subducting)
        {
            assert_eq!(contact.role == Role::Overriding, continental);
            seen += 1;
        }
    }
    assert!(seen > 20);
}

/// Steps at which each segment of a front turned over.
type Flips = BTreeMap<(Pair, u16), Vec<u64>>;

/// Notes the segments whose polarity is another one than before.
fn note_flips(flips: &mut Flips, last: &PolarityMemory, now: &PolarityMemory, step: u64) {
    let first_under: BTreeMap<_, _> = now
        .0
        .iter()
        .map(|segment| ((segment.pair, segment.bin), segment.first_under))
        .collect();
    for segment in &last.0 {
        let key = (segment.pair, segment.bin);
        if first_under
            .get(&key)
            .is_some_and(|&under| under != segment.first_under)
        {
            flips.entry(key).or_default().push(step);
        }
    }
}

#[test]
fn polarity_does_not_flicker() {
    let (mut app, planet) = planet_app(&small(2, 20_000));
    steps(&mut app, planet, 1);
    let mut flips = Flips::new();
    let mut last = get::<PolarityMemory>(&app, planet).clone();
    for step in 0..20 {
        steps(&mut app, planet, 1);
        let now = get::<PolarityMemory>(&app, planet).clone();
        note_flips(&mut flips, &last, &now, step);
        last = now;
    }
    let segments = last.0.len();
    assert!(segments > 50);
    // A segment may turn over when other floor arrives, but not back and forth from step to step.
    let is_hasty = |steps: &&Vec<u64>| steps.windows(2).any(|pair| pair[1] - pair[0] < 5);
    assert_eq!(flips.values().filter(is_hasty).count(), 0, "{flips:?}");
    let turned = flips.len();
    assert!(
        turned * 10 < segments,
        "{turned} of {segments} segments turned over"
    );
}

#[test]
fn mountains_rise_beside_the_trench() {
    let (mut app, planet) = andean_margin(20_000);
    steps(&mut app, planet, 9);
    let surface = surface(&mut app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let [mut highest, mut deepest] = [(0.0_f32, 0.0); 2];
    for (i, km) in near_the_margin(mesh) {
        let z = surface.elevation(i);
        if z > highest.0 {
            highest = (z, km);
        }
        if z < deepest.0 {
            deepest = (z, km);
        }
    }
    let is_range = highest.0 > 0.6 && (100.0..700.0).contains(&highest.1);
    assert!(is_range, "highest {highest:?}");
    let is_trench = deepest.0 < -8.5 && (-450.0..100.0).contains(&deepest.1);
    assert!(is_trench, "deepest {deepest:?}");
    let unbent = get::<Crust>(&app, planet)
        .elevation
        .iter()
        .copied()
        .fold(0.0, f32::min);
    assert!(unbent > -6.5, "the trench is no state: {unbent}");
}

/// Samples around the margin, each with its distance from the meridian 0 in km to the east.
fn near_the_margin(mesh: &SphereMesh) -> impl Iterator<Item = (usize, f64)> {
    let places = mesh.points().iter().map(|&p| lat_lon(p)).enumerate();
    places
        .filter(|(_, (lat, lon))| lat.abs() <= 30.0 && lon.abs() <= 80.0)
        .map(|(i, (lat, lon))| (i, lon * 111.2 * lat.to_radians().cos()))
}

#[test]
fn belts_of_subduction_are_andean_folded_and_near_the_front() {
    let (mut app, planet) = andean_margin(20_000);
    steps(&mut app, planet, 9);
    let surface = surface(&mut app, planet);
    let mesh = get::<Lattice>(&app, planet);
    let end = get::<TectonicParams>(&app, planet).uplift_end();
    let crust = &surface.crust;
    let belt = near_the_margin(mesh).filter(|&(i, _)| crust.orogeny[i] != Orogeny::None);
    for (i, km) in belt {
        assert_eq!(crust.orogeny[i], Orogeny::Andean);
        assert!(km < end + 200.0, "an Andean belt {km} km from the front");
        let (fold, up) = (crust.fold[i], mesh.points()[i].as_vec3());
        assert!(fold.length() > 0.01 && fold.dot(up).abs() < 1e-3);
    }
}

/// Volume in km³ that subduction alone adds to a continent in 4 steps at a speed in km/My.
fn uplift_at(speed: f64) -> f64 {
    let mut recipe = hemispheres(5000, speed, 0.0);
    recipe.params.processes = ProcessSwitches {
        drift: true,
        subduction: true,
        ..ProcessSwitches::all(false)
    };
    let state = shaped(&recipe, |plate, _, lon| {
        if plate == 1 && lon < 90.0 {
            Floor::Land(0.4)
        } else {
            Floor::Ocean(60.0)
        }
    });
    let (mut app, planet) = spawn(state);
    steps(&mut app, planet, 4);
    let ledger = get::<Ledger>(&app, planet);
    ledger.of(Cause::SubductionUplift).volume
}

#[test]
fn uplift_grows_with_the_speed_and_stops_at_rest() {
    let [still, slow, fast] = [0.0, 40.0, 80.0].map(uplift_at);
    assert_eq!(still, 0.0);
    assert!(slow > 0.0);
    // g is linear in the speed; the saturation at z_c takes a little of it.
    assert!((fast / slow - 2.0).abs() < 0.15, "{}", fast / slow);
}

/// An ocean whose plate 0 moves obliquely towards the continent of plate 1, with a strong slab pull.
fn oblique_margin() -> (App, Entity) {
    let mut recipe = hemispheres(5000, 0.0, 0.0);
    recipe.plates[0].pole = Some((30.0, 0.0));
    recipe.plates[0].speed = 60.0;
    recipe.params.slab_pull = 0.02;
    spawn(shaped(&recipe, |plate, lat, lon| {
        if plate == 1 && lat.abs() < 60.0 && lon < 60.0 {
            Floor::Land(0.4)
        } else {
            Floor::Ocean(60.0)
        }
    }))
}

#[test]
fn slab_pull_turns_the_plate_towards_its_front() {
    let (mut app, planet) = oblique_margin();
    // Plates younger than this are left alone, as fragments of a rift.
    const GRACE_STEPS: u64 = 10;
    steps(&mut app, planet, GRACE_STEPS);
    let start = plates(&app, planet).rows()[0].motion;
    let mut last = start;
    for _ in 0..5 {
        steps(&mut app, planet, 1);
        let motion = plates(&app, planet).get(PlateId(0)).unwrap().motion;
        // About the north pole the plate would head straight for its front.
        assert!(motion.axis.z > last.axis.z);
        assert!((motion.axis.length() - 1.0).abs() < 1e-12);
        assert_eq!(motion.speed, start.speed, "the speed stays");
        last = motion;
    }
    assert!(angle_between(start.axis, last.axis) > 0.03);
}

/// Oceans of which the older one goes under at 100 km/My, under arcs that rise much faster than
/// usual.
fn fast_arcs() -> (App, Entity) {
    let mut recipe = hemispheres(8000, 100.0, 0.0);
    recipe.params.uplift = 5.0;
    spawn(shaped(&recipe, |plate, _, _| {
        Floor::Ocean(if plate == 0 { 120.0 } else { 20.0 })
    }))
}

#[test]
fn arcs_that_rise_above_the_sea_become_land_and_are_booked() {
    let (mut app, planet) = fast_arcs();
    assert_eq!(get::<Ledger>(&app, planet).initial.area, 0.0);
    steps(&mut app, planet, 30);
    let grown = get::<Ledger>(&app, planet).of(Cause::ArcGrowth);
    assert!(grown.area > 1e5 && grown.volume > 0.0, "{grown:?}");
    let surface = surface(&mut app, planet);
    let crust = &surface.crust;
    let land: Vec<usize> = (0..crust.len())
        .filter(|&i| crust.is_continental(i))
        .collect();
    assert!(!land.is_empty());
    for i in land {
        assert_eq!(
            surface.plate[i],
            PlateId(1),
            "arcs stand on the overriding plate"
        );
        assert_eq!(crust.orogeny[i], Orogeny::Andean);
    }
}
