use super::*;
use crate::climate::{ClimateMaps, EquirectMap};
use crate::control::bake::{Bake, BakeError, BakeFrame, BakeRules, BakeSource};
use crate::hydrology::{NO_LAKE, TerrainMaps};
use crate::math;
use crate::noise::Noise;
use crate::query::{PlanetGround, Rules};
use crate::random::Purpose;
use std::sync::Arc;

/// Maps of a crust in km at a latitude and a longitude in degrees.
fn maps_of(crust: impl Fn(f64, f64) -> f32) -> TerrainMaps {
    TerrainMaps {
        crust: EquirectMap::from_fn(256, crust).unwrap(),
        age: None,
        plateau: None,
        hills: None,
    }
}

/// A rough planet's maps.
fn maps(seed: u64) -> TerrainMaps {
    let noise = Noise::new(seed, Purpose::Relief, 0);
    maps_of(|lat, lon| (5.0 * noise.fractal(math::direction(lat, lon), 1.7, 6)) as f32)
}

/// A bake of a planet from its maps.
fn bake(
    radius: f64,
    maps: &TerrainMaps,
    spacing: f64,
    climate: &ClimateMaps,
) -> Result<Bake, BakeError> {
    let frame = Arc::new(BakeFrame::new(1, spacing, None).unwrap());
    let source = BakeSource::Maps(maps);
    Bake::new(&frame, radius, &source, climate, &BakeRules::default())
}

fn rough(seed: u64, spacing: f64) -> Bake {
    let frame = Arc::new(BakeFrame::new(seed, spacing, None).unwrap());
    let (terrain, own) = (maps(seed), ClimateMaps::default());
    let source = BakeSource::Maps(&terrain);
    Bake::new(&frame, 6370.0, &source, &own, &BakeRules::default()).unwrap()
}

#[test]
fn water_never_runs_uphill_and_beds_fall_along_river_edges() {
    for seed in 1..4 {
        let bake = rough(seed, 0.015);
        let mut rivers = 0;
        let leaves = leaving(&bake);
        for edge in bake.control.edges.iter().filter(|e| e.river == 1) {
            let [a, b] = edge.vertices.map(|v| bake.control.vertices[v as usize]);
            assert!(a.water >= b.water, "{a:?} {b:?}");
            assert!(a.bed > b.bed, "{a:?} {b:?}");
            let parts = leaves[edge.vertices[0] as usize] > 1;
            assert!(a.flow > 0 && b.flow > 0, "{a:?} {b:?}");
            assert!(parts || b.flow >= a.flow, "{a:?} {b:?}");
            assert_eq!(a.kind, VertexKind::River as u8);
            rivers += 1;
        }
        assert!(rivers > 100, "{rivers}");
    }
}

/// Holds a vertex to its row of the table.
fn assert_row(v: &ControlVertex) {
    const TERRAIN: u8 = VertexKind::Terrain as u8;
    const SEA: u8 = VertexKind::Sea as u8;
    const COAST: u8 = VertexKind::Coast as u8;
    const RIVER: u8 = VertexKind::River as u8;
    assert!(v.crust >= v.height && v.water >= v.bed);
    match v.kind {
        TERRAIN => assert!(v.height == v.bed && v.bed == v.water && v.flow == 0),
        SEA => assert!(v.height == v.bed && v.bed < 0 && v.water == 0),
        COAST => assert_eq!([v.bed, v.water], [v.height, v.height.max(0)]),
        RIVER => assert!(v.height == v.water && v.bed < v.water),
        _ => assert!(v.height == v.bed && v.water > v.bed),
    }
}

#[test]
fn every_vertex_is_as_the_table_says() {
    let vertices = rough(4, 0.02).control.vertices;
    for kind in [VertexKind::Terrain, VertexKind::Coast, VertexKind::Sea] {
        let count = vertices.iter().filter(|v| v.kind == kind as u8).count();
        assert!(count > 50, "{kind:?}");
    }
    vertices.iter().for_each(assert_row);
}

#[test]
fn a_lake_has_one_level() {
    let bake = rough(4, 0.02);
    let profile = &bake.drainage.profile;
    for (v, &lake) in bake.control.vertices.iter().zip(&profile.lake) {
        if lake != NO_LAKE {
            assert_eq!(v.water, profile.lakes[lake as usize].level);
        }
    }
}

/// How many rivers leave each vertex.
fn leaving(bake: &Bake) -> Vec<u32> {
    let mut leaves = vec![0; bake.mesh().len()];
    for edge in bake.control.edges.iter().filter(|e| e.river == 1) {
        leaves[edge.vertices[0] as usize] += 1;
    }
    leaves
}

#[test]
fn rivers_join_and_part_at_deltas_alone() {
    let bake = rough(5, 0.015);
    for (i, (v, n)) in bake.control.vertices.iter().zip(leaving(&bake)).enumerate() {
        // A river ends at the sea; one on the coast may have no sea beside it.
        assert!(n > 0 || v.kind != VertexKind::River as u8 || v.height == 0);
        assert!(n < 2 || bake.drainage.shore[i] == ShoreClass::Coast);
    }
}

/// A wet continent of 60° before a shelf that falls 30 m on 1000 km.
fn shelf_planet() -> Bake {
    let noise = Noise::new(9, Purpose::Relief, 0);
    let maps = maps_of(|lat, lon| {
        let inland = 30.0 - (lat as f32).abs().max((lon as f32).abs() / 2.0);
        let rough = noise.fractal(math::direction(lat, lon), 2.0, 5) as f32;
        if inland > 0.0 {
            0.01 + inland * (0.03 + 0.02 * rough)
        } else {
            inland.max(-60.0) * 0.003
        }
    });
    let wet = ClimateMaps {
        rain: EquirectMap::from_fn(8, |_, _| 3000.0).ok(),
        ..ClimateMaps::default()
    };
    bake(6370.0, &maps, 0.015, &wet).unwrap()
}

#[test]
fn great_rivers_part_over_shallow_shelves() {
    let bake = shelf_planet();
    let leaves = leaving(&bake);
    let vertices = &bake.control.vertices;
    let mut deltas = 0;
    for (apex, _) in (0..).zip(&leaves).filter(|&(_, &n)| n > 1) {
        let from = vertices[apex as usize];
        assert_eq!(
            (from.kind, from.height),
            (VertexKind::River as u8, MIN_FALL / 2)
        );
        let is_arm = |e: &&ControlEdge| e.river == 1 && e.vertices[0] == apex;
        let arms: Vec<u32> = bake
            .control
            .edges
            .iter()
            .filter(is_arm)
            .map(|e| e.vertices[1])
            .collect();
        let square = |v: &ControlVertex| f64::from(v.flow) * f64::from(v.flow);
        let parts: f64 = arms.iter().map(|&v| square(&vertices[v as usize])).sum();
        let lost = parts / square(&from) - 1.0;
        assert!(lost.abs() < 1e-3, "{lost}");
        // Each runs on into the sea, and nothing of the sea is left beside the apex.
        assert!(arms.iter().all(|&v| leaves[v as usize] == 1));
        let is_sea = |&j: &u32| vertices[j as usize].kind == VertexKind::Sea as u8;
        assert_eq!(bake.mesh().ring(apex).iter().copied().find(is_sea), None);
        deltas += 1;
    }
    assert!(deltas > 5, "{deltas}");
}

#[test]
fn faces_keep_their_edges_when_rivers_turn_them() {
    let control = rough(6, 0.03).control;
    for (f, face) in (0..).zip(&control.faces) {
        for k in 0..3 {
            let edge = control.edges[face.edges[k] as usize];
            let side = edge.faces.iter().position(|&own| own == f).unwrap();
            let ends = [face.vertices[k], face.vertices[(k + 1) % 3]];
            assert_eq!(ends, [edge.vertices[side], edge.vertices[1 - side]]);
        }
    }
}

/// A bake on so many threads.
fn rough_on(threads: usize) -> Bake {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.unwrap().install(|| rough(7, 0.03))
}

#[test]
fn a_bake_is_the_same_on_any_number_of_threads() {
    let [one, three] = [1, 3].map(rough_on);
    assert_eq!(one.control, three.control);
    assert_eq!((one.climate, one.drainage), (three.climate, three.drainage));
}

#[test]
fn planets_without_a_size_are_not_baked() {
    for radius in [0.0, -6370.0, f64::NAN, f64::INFINITY, 1e6] {
        let refused = bake(radius, &maps(1), 0.2, &ClimateMaps::default()).map(|_| ());
        assert!(matches!(refused, Err(BakeError::Radius(_))), "{radius}");
    }
}

#[test]
fn maps_out_of_range_are_not_baked() {
    let metres = maps_of(|lat, _| (100.0 * lat) as f32);
    let refused = bake(6370.0, &metres, 0.2, &ClimateMaps::default()).map(|_| ());
    assert!(matches!(refused, Err(BakeError::Map(_))));
    let negative = ClimateMaps {
        rain: EquirectMap::from_fn(8, |_, _| -1.0).ok(),
        ..ClimateMaps::default()
    };
    let refused = bake(6370.0, &maps(1), 0.2, &negative).map(|_| ());
    assert!(matches!(refused, Err(BakeError::Map(_))));
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
        let bake = bake(radius, &maps(2), 0.08, &ClimateMaps::default()).unwrap();
        let ground = PlanetGround::of_bake(&bake, Rules::default());
        assert_eq!(ground.is_ok(), has_ground, "{radius} km");
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
    assert_eq!([0.5, 1.0, -1.0, f32::NAN].map(q16), [32_768, 65_535, 0, 0]);
    assert_eq!([10.0, 5000.0].map(age), [640, u16::MAX]);
    // Worn by half in half the time; ground that was never folded is like the oldest.
    assert_eq!(
        [0.0, 100.0, 200.0, f32::INFINITY].map(|my| q16(worn(my))),
        [0, 32_768, u16::MAX, u16::MAX]
    );
    assert_eq!(unit(Vec3::new(1.0, -1.0, 0.5)), [32_767, -32_767, 16_384]);
    // A quarter of the Amazon has half its flow.
    assert_eq!(
        [0.0, 50_000.0, 200_000.0, 1e9].map(flow),
        [0, 32_768, 65_536, 65_536]
    );
}
