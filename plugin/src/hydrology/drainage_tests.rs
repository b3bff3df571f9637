use super::*;
use crate::climate::{ClimateMaps, EquirectMap};
use crate::hydrology::TerrainMaps;
use crate::hydrology::profile::GREATEST_LAKE_DEPTH;
use crate::math;
use crate::noise::Noise;
use crate::random::Purpose;

/// The terrain of a crust in km at a latitude and a longitude in degrees.
fn terrain(base: &BaseMesh, crust: impl Fn(f64, f64) -> f32) -> Terrain {
    let maps = TerrainMaps {
        crust: EquirectMap::from_fn(128, crust).unwrap(),
        age: None,
        plateau: None,
        hills: None,
    };
    Terrain::from_maps(base, &maps)
}

fn climate(base: &BaseMesh, terrain: &Terrain, maps: &ClimateMaps) -> Climate {
    Climate::new(&base.mesh, &base.winds, &terrain.elevation_km(), maps)
}

/// The drainage of a rough planet of a radius in km.
fn rough(seed: u64, radius: f64, dry: bool) -> Drainage {
    let base = BaseMesh::new(seed, 0.025).unwrap();
    let noise = Noise::new(seed, Purpose::Relief, 0);
    let terrain = terrain(&base, |lat, lon| {
        (5.0 * noise.fractal(math::direction(lat, lon), 1.7, 6)) as f32
    });
    let maps = ClimateMaps {
        rain: dry.then(|| EquirectMap::from_fn(4, |_, _| 150.0).unwrap()),
        ..ClimateMaps::default()
    };
    let climate = climate(&base, &terrain, &maps);
    Drainage::new(&base, radius, &terrain, &climate, RiverNetwork::Drainage)
}

/// The laws that every drainage keeps.
fn assert_lawful(drainage: &Drainage) {
    assert_conserved(drainage);
    assert_lakes_have_one_kind(drainage);
    assert_lakes_are_level(drainage);
    for i in 0..drainage.len() {
        if drainage.shore[i] == ShoreClass::Land {
            assert_arrives(drainage, i);
            assert_downhill(drainage, i);
        } else {
            assert_eq!(drainage.routes.receiver[i], NO_VERTEX);
        }
    }
}

/// Not a unit of water is lost.
fn assert_conserved(drainage: &Drainage) {
    let ends = (0..drainage.len()).filter(|&i| drainage.routes.receiver[i] == NO_VERTEX);
    let arrived: u64 = ends.map(|i| drainage.discharge[i]).sum();
    assert_eq!(arrived, drainage.supply.iter().sum::<u64>());
}

/// Every lake has one kind, which says where its water ends.
fn assert_lakes_have_one_kind(drainage: &Drainage) {
    let profile = &drainage.profile;
    let mut kinds = vec![None; profile.lakes.len()];
    for i in 0..drainage.len() {
        let Some(kind) = drainage.lake_kind(i) else {
            assert!(!drainage.is_lake(i));
            continue;
        };
        assert_eq!(drainage.is_endorheic(i), kind != LakeKind::Draining);
        let lake = profile.lake[i] as usize;
        let is_closed = profile.lakes[lake].outlet == NO_VERTEX;
        assert_eq!(is_closed, kind == LakeKind::Closed);
        let first = *kinds[lake].get_or_insert(kind);
        assert_eq!(first, kind, "lake {lake} has two kinds");
    }
}

/// A lake covers its vertices up to one level, and not too deep.
fn assert_lakes_are_level(drainage: &Drainage) {
    let profile = &drainage.profile;
    let mut vertices = vec![0; profile.lakes.len()];
    for i in (0..drainage.len()).filter(|&i| drainage.is_lake(i)) {
        let id = profile.lake[i] as usize;
        vertices[id] += 1;
        let lake = &profile.lakes[id];
        let depth = lake.level - profile.bed[i];
        assert_eq!(profile.level[i], lake.level);
        assert!(depth > 0 && depth <= GREATEST_LAKE_DEPTH);
    }
    let counted = profile.lakes.iter().map(|lake| lake.vertices);
    assert!(counted.eq(vertices));
}

/// Water of vertex `i` ends, without loops, at a coast or in a lake without an outlet.
fn assert_arrives(drainage: &Drainage, i: usize) {
    let mut at = i;
    let mut steps = 0;
    while drainage.routes.receiver[at] != NO_VERTEX {
        at = drainage.routes.receiver[at] as usize;
        steps += 1;
        assert!(steps <= drainage.len(), "a loop at {i}");
    }
    assert_eq!(drainage.basin[i], at as u32);
    let is_closed = drainage.lake_kind(at) == Some(LakeKind::Closed);
    assert!(drainage.shore[at] == ShoreClass::Coast || is_closed, "{i}");
}

/// From vertex `i` the river grows, and neither water nor bed rises.
fn assert_downhill(drainage: &Drainage, i: usize) {
    let profile = &drainage.profile;
    let to = drainage.routes.receiver[i];
    if to == NO_VERTEX {
        return;
    }
    let r = to as usize;
    assert!(drainage.discharge[r] >= drainage.discharge[i] && drainage.strahler[i] > 0);
    assert!(profile.level[i] >= profile.level[r], "uphill at {i}");
    assert!(profile.level[i] >= profile.bed[i]);
    match (profile.lake[i], profile.lake[r]) {
        (NO_LAKE, below) => {
            assert!(profile.level[i] > profile.level[r]);
            let falls = profile.bed[i] > profile.bed[r];
            assert!(below != NO_LAKE || falls, "bed at {i}");
        }
        (lake, NO_LAKE) => {
            let lake = &profile.lakes[lake as usize];
            assert_eq!((lake.outlet, lake.level), (to, profile.level[r]));
        }
        (lake, below) => assert_eq!(lake, below),
    }
}

#[test]
fn every_planet_keeps_the_laws() {
    for seed in 0..12 {
        assert_lawful(&rough(seed, 6370.0, seed % 3 == 0));
    }
}

/// Discharge of the greatest river in m³/s.
fn strongest(drainage: &Drainage) -> f64 {
    let all = (0..drainage.len()).map(|i| drainage.earth_like_discharge(i));
    all.fold(0.0, f64::max)
}

#[test]
fn small_planets_have_the_rivers_of_large_ones() {
    let small = rough(11, 50.0, false);
    assert_lawful(&small);
    let ratio = strongest(&small) / strongest(&rough(11, 6370.0, false));
    assert!((0.98..1.02).contains(&ratio), "{ratio}");
}

#[test]
fn dry_planets_have_closed_basins() {
    let dry = rough(12, 6370.0, true);
    assert_lawful(&dry);
    let lakes = dry.profile.lakes.iter();
    let closed = lakes.filter(|lake| lake.outlet == NO_VERTEX).count();
    assert!(closed > 3, "{closed} closed lakes on a dry planet");
    assert!((0..dry.len()).any(|i| dry.is_endorheic(i)));
}

#[test]
fn a_planet_without_land_or_without_sea_drains() {
    let base = BaseMesh::new(1, 0.08).unwrap();
    for level in [-3.0, 2.0] {
        let terrain = terrain(&base, |_, _| level);
        let climate = climate(&base, &terrain, &ClimateMaps::default());
        for network in [RiverNetwork::Drainage, RiverNetwork::Grown] {
            let drainage = Drainage::new(&base, 6370.0, &terrain, &climate, network);
            let is_land = |class: &&ShoreClass| **class == ShoreClass::Land;
            let land = drainage.shore.iter().filter(is_land).count();
            assert_eq!(drainage.routes.order.len(), land);
        }
    }
}
