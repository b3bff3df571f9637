//! Rivers of whole planets: Horton's and Hack's laws, the Earth's great rivers, and bakes that
//! follow a simulation.

use bevy::prelude::*;
use bevy_pangaea::control::{
    Bake, BakeFinished, BakeFrame, BakeRules, BakeSettings, BakeSource, PlanetBake, bake_now,
};
use bevy_pangaea::hydrology::BASE_SPACING;
use bevy_pangaea::hydrology::{Drainage, HydrologyStats, NO_VERTEX, ShoreClass, TerrainMaps};
use bevy_pangaea::math::{angle_between, direction};
use bevy_pangaea::prelude::*;
use pangaea_tests::earth::earth;
use pangaea_tests::shape::small;
use pangaea_tests::world::{digest, get, heard, listen, planet_app, steps, surface};
use std::sync::Arc;

/// Asserts the laws that rivers of the Earth keep.
fn assert_river_laws(bake: &Bake) {
    let stats = HydrologyStats::new(bake.mesh(), &bake.climate, &bake.drainage);
    eprintln!("Hack {:.3}, {:?}", stats.hack_exponent, stats.horton);
    assert!((3.0..=5.0).contains(&stats.horton.rb), "{stats:?}");
    assert!((1.5..=3.5).contains(&stats.horton.rl), "{stats:?}");
    assert!((3.0..=6.0).contains(&stats.horton.ra), "{stats:?}");
    // Hack found 0.57 to 0.6; measured as here the relief of the Earth has 0.614.
    assert!((0.57..=0.63).contains(&stats.hack_exponent), "{stats:?}");
    assert_no_drop_is_lost(&bake.drainage);
}

/// Asserts that the ends of all ways down have what rain supplies.
fn assert_no_drop_is_lost(drainage: &Drainage) {
    let supply: u64 = drainage.supply.iter().sum();
    let ends = (0..drainage.len()).filter(|&i| drainage.routes.receiver[i] == NO_VERTEX);
    let arrived: u64 = ends.map(|i| drainage.discharge[i]).sum();
    assert_eq!(supply, arrived);
}

fn grown(seed: u64, count: u64) {
    let (mut app, planet) = planet_app(&small(seed, 20_000));
    steps(&mut app, planet, count);
    surface(&mut app, planet);
    let before = digest(&app, planet);
    bake_now(app.world_mut(), planet).expect("a bake");
    assert_eq!(before, digest(&app, planet), "a bake touches nothing");
    assert_river_laws(&get::<PlanetBake>(&app, planet).0);
}

#[test]
fn rivers_of_planet_2_keep_the_laws() {
    grown(2, 60);
}

#[test]
fn rivers_of_planet_3_keep_the_laws() {
    grown(3, 90);
}

#[test]
fn rivers_of_planet_4_keep_the_laws() {
    grown(4, 75);
}

/// The Earth, baked from its relief.
fn baked_earth() -> Option<Bake> {
    let maps = TerrainMaps {
        crust: earth()?,
        age: None,
        plateau: None,
        hills: None,
    };
    let frame = Arc::new(BakeFrame::new(1, BASE_SPACING, None).expect("a base mesh"));
    let (source, own) = (BakeSource::Maps(&maps), ClimateMaps::default());
    let bake = Bake::new(&frame, 6370.0, &source, &own, &BakeRules::default());
    Some(bake.expect("a bake"))
}

/// Places on great rivers, and the rivers' mouths.
const RIVERS: [(&str, (f64, f64), (f64, f64)); 6] = [
    ("Manaus", (-3.1, -60.0), (0.0, -50.0)),
    ("Kinshasa", (-4.3, 15.3), (-6.0, 12.4)),
    ("St. Louis", (38.6, -90.2), (29.2, -89.3)),
    ("Surgut", (61.25, 73.4), (66.5, 71.5)),
    ("Rosario", (-32.95, -60.6), (-34.5, -58.2)),
    ("Aswan", (24.1, 32.9), (31.4, 31.0)),
];

#[test]
fn rivers_of_the_earth_keep_the_laws_and_reach_their_mouths() {
    let Some(bake) = baked_earth() else { return };
    assert_river_laws(&bake);
    let mut missed = Vec::new();
    for (name, place, mouth) in RIVERS {
        let site = bake.mesh().nearest(direction(place.0, place.1)) as usize;
        let end = bake.drainage.basin[site];
        let is_coast = end != NO_VERTEX && bake.drainage.shore[end as usize] == ShoreClass::Coast;
        assert!(is_coast, "{name} never reaches the sea");
        let mouth = direction(mouth.0, mouth.1);
        let way = 6370.0 * angle_between(bake.mesh().point(end), mouth);
        eprintln!("{name} drains to a coast {way:.0} km from its mouth");
        if way > 300.0 {
            missed.push(name);
        }
    }
    // The Ob ends at its delta at the head of a gulf 800 km long and 60 km wide: less than two
    // edges of the base mesh, which therefore closes it. Its river ends at the gulf's open end.
    assert_eq!(missed, ["Surgut"]);
}

/// Runs frames of a game until there is a bake of the surface as it is now, whose version is
/// returned.
fn wait_for_bake(app: &mut App, planet: Entity) -> u64 {
    let wanted = surface(app, planet).version;
    for _ in 0..6000 {
        app.update();
        let bake = app.world().get::<PlanetBake>(planet);
        if bake.is_some_and(|bake| bake.version == wanted) {
            return wanted;
        }
        std::thread::sleep(core::time::Duration::from_millis(10));
    }
    panic!("no bake of version {wanted} within a minute");
}

#[test]
fn a_bake_follows_a_planet_and_says_so() {
    let (mut app, planet) = planet_app(&small(5, 2000));
    listen::<BakeFinished>(&mut app);
    let settings = BakeSettings {
        spacing: 0.03,
        ..default()
    };
    app.world_mut().entity_mut(planet).insert(settings);
    app.world_mut()
        .get_mut::<ClockControls>(planet)
        .expect("controls")
        .paused = true;
    let first = wait_for_bake(&mut app, planet);
    let frame = get::<PlanetBake>(&app, planet).frame.clone();
    steps(&mut app, planet, 3);
    let second = wait_for_bake(&mut app, planet);
    assert!(second > first);
    let followed = get::<PlanetBake>(&app, planet).0.clone();
    assert!(
        Arc::ptr_eq(&frame, &followed.frame),
        "the base mesh is built once"
    );
    let events = heard::<BakeFinished>(&app);
    for version in [first, second] {
        assert!(events.iter().any(|event| event.version == version));
    }
    assert_eq!(events.last().map(|event| event.planet), Some(planet));
    // In the background as in the foreground.
    bake_now(app.world_mut(), planet).expect("a bake");
    assert_eq!(followed.control, get::<PlanetBake>(&app, planet).control);
}
