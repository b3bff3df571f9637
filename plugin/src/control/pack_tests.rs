use super::*;
use crate::climate::{ClimateMaps, EquirectMap};
use crate::control::bake::{Bake, BakeError, BakeFrame, BakeRules, BakeSource};
use crate::hydrology::TerrainMaps;
use crate::noise::Noise;
use crate::query::{PlanetGround, Rules};
use crate::random::Purpose;
use std::sync::Arc;

/// A rough planet's maps.
fn maps(seed: u64) -> TerrainMaps {
    let noise = Noise::new(seed, Purpose::Relief, 0);
    let height =
        |lat: f64, lon: f64| (5.0 * noise.fractal(crate::math::direction(lat, lon), 1.7, 6)) as f32;
    let crust = EquirectMap::from_fn(256, height).unwrap();
    TerrainMaps {
        crust,
        age: None,
        plateau: None,
        hills: None,
    }
}

/// A bake of a planet from its maps.
fn bake(
    radius: f64,
    maps: &TerrainMaps,
    spacing: f64,
    rules: &BakeRules,
) -> Result<Bake, BakeError> {
    let frame = Arc::new(BakeFrame::new(1, spacing, None).unwrap());
    Bake::new(&frame, radius, &BakeSource::Maps(maps), rules)
}

fn rough(seed: u64, spacing: f64) -> Bake {
    let frame = Arc::new(BakeFrame::new(seed, spacing, None).unwrap());
    Bake::new(
        &frame,
        6370.0,
        &BakeSource::Maps(&maps(seed)),
        &BakeRules::default(),
    )
    .unwrap()
}

#[test]
fn water_never_runs_uphill_and_beds_fall_along_river_edges() {
    for seed in 1..4 {
        let bake = rough(seed, 0.015);
        let mut rivers = 0;
        for edge in bake.control.edges.iter().filter(|e| e.river == 1) {
            let [a, b] = edge.vertices.map(|v| bake.control.vertices[v as usize]);
            assert!(a.water >= b.water, "{a:?} {b:?}");
            assert!(a.bed > b.bed, "{a:?} {b:?}");
            assert!(a.flow > 0 && b.flow >= a.flow, "{a:?} {b:?}");
            assert_eq!(a.kind, VertexKind::River as u8);
            rivers += 1;
        }
        assert!(rivers > 100, "{rivers}");
    }
}

#[test]
fn every_vertex_is_as_the_table_says() {
    let bake = rough(4, 0.02);
    let of = |kind: VertexKind| move |v: &&ControlVertex| v.kind == kind as u8;
    let vertices = &bake.control.vertices;
    for kind in [VertexKind::Terrain, VertexKind::Coast, VertexKind::Sea] {
        assert!(vertices.iter().filter(of(kind)).count() > 50);
    }
    for v in vertices {
        assert!(v.crust >= v.height && v.water >= v.bed);
        match v.kind {
            k if k == VertexKind::Terrain as u8 => {
                assert!(v.height == v.bed && v.bed == v.water && v.flow == 0)
            }
            k if k == VertexKind::Sea as u8 => {
                assert!(v.height == v.bed && v.bed < 0 && v.water == 0)
            }
            k if k == VertexKind::Coast as u8 => assert_eq!((v.height, v.bed, v.water), (0, 0, 0)),
            k if k == VertexKind::River as u8 => assert!(v.height == v.water && v.bed < v.water),
            _ => assert!(v.height == v.bed && v.water > v.bed),
        }
    }
    // A lake has one level.
    let lakes = &bake.drainage.profile.lake;
    for (v, &lake) in vertices
        .iter()
        .zip(lakes)
        .filter(|(_, lake)| **lake != NONE)
    {
        assert_eq!(v.water, bake.drainage.profile.lakes[lake as usize].level);
    }
}

#[test]
fn rivers_join_and_never_split() {
    let bake = rough(5, 0.015);
    let mut leaves = vec![0; bake.mesh().len()];
    for edge in bake.control.edges.iter().filter(|e| e.river == 1) {
        leaves[edge.vertices[0] as usize] += 1;
    }
    assert!(leaves.iter().all(|&n| n <= 1));
    for (v, &n) in bake.control.vertices.iter().zip(&leaves) {
        // A river ends at the sea; one on the coast may have no sea beside it.
        assert!(n == 1 || v.kind != VertexKind::River as u8 || v.height == 0);
    }
}

#[test]
fn faces_keep_their_edges_when_rivers_turn_them() {
    let bake = rough(6, 0.03);
    let control = &bake.control;
    for (f, face) in control.faces.iter().enumerate() {
        for k in 0..3 {
            let edge = control.edges[face.edges[k] as usize];
            let side = edge
                .faces
                .iter()
                .position(|&own| own as usize == f)
                .unwrap();
            let ends = [face.vertices[k], face.vertices[(k + 1) % 3]];
            assert_eq!(ends, [edge.vertices[side], edge.vertices[1 - side]]);
        }
    }
}

#[test]
fn a_bake_is_the_same_on_any_number_of_threads() {
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| rough(7, 0.03))
    };
    let (one, three) = (on(1), on(3));
    assert_eq!(one.control, three.control);
    assert_eq!((one.climate, one.drainage), (three.climate, three.drainage));
}

#[test]
fn what_is_no_planet_is_not_baked() {
    let coarse =
        |radius, maps: &TerrainMaps, rules: &BakeRules| bake(radius, maps, 0.2, rules).map(|_| ());
    let (good, plain) = (maps(1), BakeRules::default());
    for radius in [0.0, -6370.0, f64::NAN, f64::INFINITY, 1e6] {
        assert!(
            matches!(coarse(radius, &good, &plain), Err(BakeError::Radius(_))),
            "{radius}"
        );
    }
    let crust = EquirectMap::from_fn(8, |lat, _| (100.0 * lat) as f32).unwrap();
    let metres = TerrainMaps { crust, ..maps(1) };
    assert!(matches!(
        coarse(6370.0, &metres, &plain),
        Err(BakeError::Map(_))
    ));
    let rain = EquirectMap::from_fn(8, |_, _| -1.0).ok();
    let dry = BakeRules {
        climate: ClimateMaps {
            rain,
            ..ClimateMaps::default()
        },
        ..plain.clone()
    };
    assert!(matches!(
        coarse(6370.0, &good, &dry),
        Err(BakeError::Map(_))
    ));
}

#[test]
fn planets_that_are_too_small_or_too_large_have_drainage_but_no_ground() {
    for (radius, has_ground) in [
        (0.0001, false),
        (49.9, false),
        (50.0, true),
        (10_000.0, true),
        (10_001.0, false),
        (1e5, false),
    ] {
        let bake = bake(radius, &maps(2), 0.08, &BakeRules::default()).unwrap();
        assert_eq!(
            PlanetGround::of_bake(&bake, Rules::default()).is_ok(),
            has_ground,
            "{radius} km"
        );
    }
}

#[test]
fn valleys_are_shaped_by_ice_plateaus_and_youth() {
    use ValleyShape::{FlatFloor, IceTrough, Terraced, V};
    // Temperature, rain, plateau, age.
    for (expected, temperature, rain, plateau, age) in [
        (IceTrough, -5.0, 900.0, 0.0, 10.0),
        (IceTrough, -5.0, 900.0, 0.9, 300.0),
        (V, -5.0, 100.0, 0.0, 10.0),
        (V, 15.0, 900.0, 0.2, 10.0),
        (Terraced, 15.0, 100.0, 0.9, 10.0),
        (FlatFloor, 15.0, 900.0, 0.2, 300.0),
        (FlatFloor, 15.0, 900.0, 0.0, f32::INFINITY),
    ] {
        let terrain = Terrain {
            plateau: vec![plateau],
            age: vec![age],
            ..Terrain::default()
        };
        let climate = Climate {
            temperature: vec![temperature],
            rain: vec![rain],
            ..Climate::default()
        };
        assert_eq!(valley_shape(&terrain, &climate, 0), expected);
    }
}

#[test]
fn units_are_those_of_the_contract() {
    assert_eq!(
        (q16(0.5), q16(1.0), q16(-1.0), q16(f32::NAN)),
        (32_768, 65_535, 0, 0)
    );
    assert_eq!(
        (age(10.0), age(f32::INFINITY), age(5000.0)),
        (640, u16::MAX, 65_534)
    );
    assert_eq!(unit(Vec3::new(1.0, -1.0, 0.5)), [32_767, -32_767, 16_384]);
    let flow = ((50_000.0_f64 / FULL_FLOW).sqrt() * 65_536.0) as u32;
    assert!((discharge_of_flow(flow) / 50_000.0 - 1.0).abs() < 1e-3);
}
