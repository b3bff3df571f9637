//! Every fast path against its slow one, on planets that have grown: the same question, asked in two
//! ways, has one answer.
//!
//! | fast | slow |
//! |---|---|
//! | rims and statistics carried along by collisions and rifts | found anew from the state |
//! | terranes that drift and grow | counted anew from the crust |
//! | distances to fronts, followed from step to step | spread anew from the same front |
//! | heights and samples in batches, on all threads | one by one |
//! | a raster | its pixels one by one |
//! | the leaf at a point | the whole refinement around it |
//! | a bake on the base mesh of the last one | a bake with a base mesh of its own |
//!
//! Threads against one thread, slices against whole steps and saves against no save are in
//! `determinism.rs`.

use bevy::math::DVec3;
use bevy::prelude::*;
use bevy_pangaea::control::{BakeSettings, PlanetBake, bake_now};
use bevy_pangaea::plate::Terrane;
use bevy_pangaea::plate::boundary::Rim;
use bevy_pangaea::plate::census::TerraneCensus;
use bevy_pangaea::plate::contact::{Contact, Contacts, Role};
use bevy_pangaea::plate::front::{FrontField, FrontInput};
use bevy_pangaea::prelude::*;
use bevy_pangaea::query::{
    AzimuthalEquidistant, Ground, MapSquare, PlanetGround, Rules, direction_at,
};
use bevy_pangaea::random::{Purpose, Stream};
use bevy_pangaea::spawn::PlanetState;
use bevy_pangaea::sphere::SphereMesh;
use pangaea_shaders::amplify::fixed::ONE;
use pangaea_shaders::amplify::ground::{Caps, refine};
use pangaea_shaders::amplify::mark::View;
use pangaea_shaders::amplify::topology::SplitMark;
use pangaea_shaders::amplify::vertex::Vertex;
use pangaea_tests::shape::small;
use pangaea_tests::world::{get, heard, listen, planet_app, plates, state, steps};
use std::sync::Arc;

/// A planet on which plates break and collide.
fn lively(seed: u64) -> (App, Entity) {
    let mut recipe = small(seed, 5000);
    recipe.params.rift_rate = 0.02;
    planet_app(&recipe)
}

#[test]
fn rims_carried_along_are_those_found_anew() {
    let (mut app, planet) = lively(4);
    listen::<TerraneCollided>(&mut app);
    listen::<PlateRifted>(&mut app);
    for step in 0..40 {
        steps(&mut app, planet, 1);
        let rim = get::<Rim>(&app, planet);
        let anew = Rim::new(
            get::<Lattice>(&app, planet),
            &get::<Crust>(&app, planet).frame,
            get::<Frames>(&app, planet),
        );
        assert_eq!(rim.samples, anew.samples, "step {step}");
        assert_eq!(
            (&rim.normal, &rim.index),
            (&anew.normal, &anew.index),
            "step {step}"
        );
    }
    assert!(!heard::<TerraneCollided>(&app).is_empty() && !heard::<PlateRifted>(&app).is_empty());
}

/// Samples of every plate and their area in km², by looking at every sample.
fn areas_of_plates(state: &PlanetState) -> Vec<(PlateId, u32, f64)> {
    let radius = state.planet.radius;
    let ids = state.plates.iter().map(|&(id, ..)| id);
    ids.map(|id| {
        let crust = 0..state.crust.len();
        let own = crust.filter(|&i| state.frames.plate(state.crust.frame[i]) == id);
        let areas: Vec<f64> = own.map(|i| state.lattice.areas()[i]).collect();
        (
            id,
            areas.len() as u32,
            areas.iter().sum::<f64>() * radius * radius,
        )
    })
    .collect()
}

#[test]
fn statistics_of_plates_carried_along_are_those_counted_anew() {
    let (mut app, planet) = lively(5);
    for step in 0..40 {
        steps(&mut app, planet, 1);
        let table = plates(&app, planet);
        for (id, samples, area) in areas_of_plates(&state(&app, planet)) {
            let stats = table.get(id).expect("a plate of the state").stats;
            assert_eq!(stats.samples, samples, "{id:?} in step {step}");
            assert!(
                (stats.area / area - 1.0).abs() < 1e-9,
                "{id:?} in step {step}"
            );
        }
    }
}

/// Terranes without the numbers that their history gave them, from one end of the planet's axes to
/// the other.
fn unnumbered(terranes: impl Iterator<Item = Terrane>) -> Vec<Terrane> {
    let mut terranes: Vec<Terrane> = terranes
        .map(|terrane| Terrane {
            number: 0,
            ..terrane
        })
        .collect();
    let place = |terrane: &Terrane| terrane.centroid.to_array();
    terranes.sort_by(|a, b| place(a).partial_cmp(&place(b)).expect("a direction"));
    terranes
}

#[test]
fn terranes_that_grow_and_drift_are_those_counted_anew() {
    let (mut app, planet) = lively(4);
    let mut grown = 0;
    for step in 0..60 {
        let before = get::<TerraneCensus>(&app, planet).clone();
        steps(&mut app, planet, 1);
        let census = get::<TerraneCensus>(&app, planet);
        assert!(!census.stale && census.grown.is_empty() && census.moved.is_empty());
        grown += usize::from(*census != before);
        let anew = TerraneCensus::new(get::<Lattice>(&app, planet), get::<Crust>(&app, planet));
        let anew: Vec<Terrane> = anew.terranes(get::<Frames>(&app, planet), 6370.0).collect();
        let mut entities = app.world_mut().query::<&Terrane>();
        let entities = unnumbered(entities.iter(app.world()).cloned());
        assert_eq!(entities, unnumbered(anew.into_iter()), "step {step}");
    }
    assert!(grown > 10, "{grown} steps changed a terrane");
}

/// Distances from the samples that are nearest to themselves, which are those of the front, spread
/// on an empty field.
fn spread_anew(app: &App, planet: Entity, reach: f64) -> FrontField {
    let mesh = get::<Lattice>(app, planet);
    let followed = get::<FrontField>(app, planet);
    let is_front = |i: u32| followed.nearest(i).is_some_and(|(source, _)| source == i);
    let samples: Vec<u32> = (0..mesh.len() as u32).filter(|&i| is_front(i)).collect();
    let overriding = Contact {
        role: Role::Overriding,
        ..default()
    };
    let contacts = Contacts(vec![overriding; samples.len()]);
    let mut anew = FrontField::new(mesh.len());
    let done = anew.follow(
        &FrontInput {
            mesh,
            frame: &get::<Crust>(app, planet).frame,
            rim: &Rim {
                samples,
                ..default()
            },
            contacts: &contacts,
            reach,
        },
        || false,
    );
    assert!(done, "nobody told it to stop");
    anew
}

/// Number of samples on whose distance two fields agree, and of those on which they do not.
fn compare(mesh: &SphereMesh, reach: f64, fields: [&FrontField; 2]) -> [usize; 2] {
    let [mut same, mut different] = [0; 2];
    for i in 0..mesh.len() as u32 {
        // Beyond the reach of one step a field may still hold what an earlier one has found.
        let distances = fields.map(|field| {
            let distance = field.nearest(i).map(|(_, distance)| f64::from(distance));
            distance.filter(|&distance| distance < 0.99 * reach)
        });
        match distances {
            [Some(a), Some(b)] => {
                // A source cut off by others may be missed by a sample's width, in either way.
                assert!((a - b).abs() < 0.3 * mesh.spacing(), "{a} and {b}");
                same += usize::from((a - b).abs() < 1e-6);
                different += usize::from((a - b).abs() >= 1e-6);
            }
            [None, None] => {}
            _ => different += 1,
        }
    }
    [same, different]
}

#[test]
fn distances_to_fronts_are_followed_as_if_they_were_found_anew() {
    let (mut app, planet) = lively(6);
    let mut agreed = 0;
    for step in 0..30 {
        steps(&mut app, planet, 1);
        let followed = get::<FrontField>(&app, planet);
        if followed.stale {
            continue;
        }
        let params = get::<TectonicParams>(&app, planet);
        let reach = params.subduction_distance * params.subduction_reach / 6370.0;
        let anew = spread_anew(&app, planet, reach);
        let mesh = get::<Lattice>(&app, planet);
        let [same, different] = compare(mesh, reach, [followed, &anew]);
        assert!(
            50 * different <= same,
            "step {step}: {different} differ, {same} agree"
        );
        agreed += same;
    }
    assert!(agreed > 1000, "{agreed} samples");
}

/// A grown planet with a small bake.
fn baked(seed: u64) -> (App, Entity) {
    let (mut app, planet) = lively(seed);
    steps(&mut app, planet, 25);
    bake(&mut app, planet);
    (app, planet)
}

fn bake(app: &mut App, planet: Entity) {
    bevy_pangaea::resample::project_now(app.world_mut(), planet);
    let settings = BakeSettings {
        spacing: 0.04,
        ..default()
    };
    app.world_mut().entity_mut(planet).insert(settings);
    bake_now(app.world_mut(), planet).expect("a bake of a grown planet");
}

fn ground(app: &App, planet: Entity) -> PlanetGround {
    PlanetGround::of_bake(get::<PlanetBake>(app, planet), Rules::default()).expect("a ground")
}

fn directions(count: u64) -> Vec<DVec3> {
    let stream = Stream::new(3, Purpose::ReliefSites, 0);
    (0..count).map(|i| stream.direction(2 * i)).collect()
}

#[test]
fn batches_have_the_answers_of_single_questions() {
    let (app, planet) = baked(7);
    let (batch, single) = (ground(&app, planet), ground(&app, planet));
    let directions = directions(1200);
    let mut heights = vec![0.0; directions.len()];
    for level in [5, 12, 17] {
        batch.heights(&directions, level, &mut heights).unwrap();
        let found = batch.samples(&directions, level).unwrap();
        for (k, &direction) in directions.iter().enumerate().step_by(3) {
            let one = single.sample(direction, level).unwrap();
            assert_eq!(found[k], one, "{direction} at level {level}");
            assert_eq!(heights[k].to_bits(), one.height_m.to_bits());
        }
    }
}

#[test]
fn a_raster_has_the_heights_of_its_pixels() {
    let (app, planet) = baked(8);
    let (whole, single) = (ground(&app, planet), ground(&app, planet));
    let about = AzimuthalEquidistant::new(20.0, 30.0, whole.radius_m()).unwrap();
    let square = MapSquare::new(about, 40_000.0, 60).unwrap();
    let grid = square.heights(&whole, square.level()).unwrap();
    for row in (0..60).step_by(7) {
        for column in (0..60).step_by(5) {
            let height = single
                .height(square.direction(column, row), square.level())
                .unwrap();
            assert_eq!(
                grid.row(row)[column].to_bits(),
                height.to_bits(),
                "{column} {row}"
            );
        }
    }
}

/// The corners of all leaves of a level in the whole refinement around a point.
fn leaves_around(ground: &PlanetGround, direction: DVec3, level: u8) -> Vec<[Vertex; 3]> {
    let at = (direction * f64::from(ONE))
        .round()
        .to_array()
        .map(|x| x as i32);
    let radius_m = (200_000 >> level).max(2);
    let view = View::disc(at, radius_m, u32::from(level));
    let refined = refine(ground.base(), ground.rules(), &view, &Caps::default());
    let faces = refined.levels[usize::from(level)].faces();
    faces
        .filter(|(_, split)| split.mark != SplitMark::Split)
        .map(|(face, _)| face.vertices.map(|v| refined.vertices[v as usize]))
        .collect()
}

#[test]
fn a_point_has_a_leaf_of_the_refinement_around_it() {
    let (app, planet) = baked(9);
    let ground = ground(&app, planet);
    for (lat, lon, level) in [
        (1.0, 2.0, 3),
        (40.0, -100.0, 6),
        (-70.0, 20.0, 9),
        (12.0, 77.0, 11),
    ] {
        let direction = direction_at(lat, lon).unwrap();
        let leaf = ground.leaf(direction, level).unwrap();
        let leaves = leaves_around(&ground, direction, level);
        assert!(
            leaves.contains(&leaf.vertices),
            "no such leaf at {lat} {lon}, level {level}"
        );
    }
}

#[test]
fn a_bake_on_the_old_base_mesh_is_one_with_a_new_one() {
    let (mut app, planet) = baked(10);
    steps(&mut app, planet, 6);
    bake(&mut app, planet);
    let again = get::<PlanetBake>(&app, planet).0.clone();
    // Without a bake to take it from, the base mesh is made anew.
    app.world_mut().entity_mut(planet).remove::<PlanetBake>();
    bake(&mut app, planet);
    let first = get::<PlanetBake>(&app, planet).0.clone();
    assert!(!Arc::ptr_eq(&again.frame, &first.frame));
    assert!(again.control == first.control, "another control mesh");
    assert_eq!(again.climate.rain, first.climate.rain);
    assert_eq!(again.drainage.discharge, first.drainage.discharge);
}
